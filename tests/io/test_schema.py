"""The schema that ships, against what the program writes and what it refuses."""

import json

import pytest
from hypothesis import given
from jsonschema import Draft202012Validator

from plusedit.geometry.bases import families
from plusedit.io.basis_fields import said_of
from plusedit.io.files import load
from plusedit.io.formats.json_document import dumps
from plusedit.io.schema import schema_text
from plusedit.resources import example_files
from tests.designs import DOCUMENT, designs
from tests.io.test_sentences import WRONG

SCHEMA = json.loads(schema_text())
VALIDATOR = Draft202012Validator(SCHEMA)

# What a schema can't say: counts that fit together, ids that are unique, kinds of sentences.
BEYOND = (
    "row 2 has 3 numbers, row 0",
    "row 2 has 1 number, row 0",
    "control lines, got 5",
    "basis_u: order",
    "row 1 has 2 points, row 0",
    "beyond 1e+100",
    "order: expected a whole number, got 4.0",
    "entries for",
    "two shapes",
    "knots: expected 8",
    "stands twice",
    "must increase",
    "has no vertex",
    "there is no vertex",
    "there is no face",
    "parameters: row 1",
    "finite",
)


def test_the_schema_is_a_schema():
    Draft202012Validator.check_schema(SCHEMA)


@given(designs)
def test_every_written_design_conforms(design):
    VALIDATOR.validate(json.loads(dumps(design)))


def cut(tree, most=60):
    """The same with at most so many entries of every list: the schema says the same of all."""
    if isinstance(tree, dict):
        return {key: cut(value, most) for key, value in tree.items()}
    return [cut(value, most) for value in tree[:most]] if isinstance(tree, list) else tree


@pytest.mark.parametrize("path", example_files(), ids=lambda path: path.name)
def test_every_shipped_design_conforms_and_so_does_what_is_written_of_it(path):
    VALIDATOR.validate(cut(json.loads(path.read_bytes())))
    VALIDATOR.validate(cut(json.loads(dumps(load(path).design))))


def test_a_file_with_every_kind_of_shape_conforms():
    VALIDATOR.validate(json.loads(DOCUMENT))


@pytest.mark.parametrize(
    ("right", "wrong"),
    [row[:2] for row in WRONG if not any(words in row[2] for words in BEYOND)],
)
def test_what_is_refused_does_not_conform(right, wrong):
    assert not VALIDATOR.is_valid(json.loads(DOCUMENT.replace(right, wrong, 1)))


def test_the_schema_knows_every_family_and_every_field():
    definitions = SCHEMA["$defs"]
    assert sorted(definitions["basis"]["properties"]["family"]["enum"]) == list(families)
    for name, family in families.items():
        keys = {said.key for said in said_of(family)}
        assert keys == set(definitions.get(name, {}).get("properties", {}))
