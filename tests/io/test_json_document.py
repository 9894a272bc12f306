"""The design file: what is written comes back, and what is wrong is said."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.io.formats import FormatError
from plusedit.io.formats.json_document import dumps, loads
from tests.designs import (
    BOW,
    DOCUMENT,
    KNEE,
    SAIL,
    WING,
    a_curve,
    contents,
    designs,
    json_values,
    words,
)

OLD_FILES = sorted((Path(__file__).parents[1] / "data/documents").glob("v*/*.json"))


def read(data=DOCUMENT):
    return loads(data, "bow.json").design


def tree_of(design):
    return json.loads(dumps(design))


def one_shape(shape):
    return Design({WING: shape})


@given(designs)
def test_what_is_written_is_read_again_to_the_last_bit(design):
    assert contents(read(dumps(design))) == contents(design)


def test_a_file_read_and_written_says_what_it_said():
    assert tree_of(read()) == json.loads(DOCUMENT)


def test_writing_twice_gives_the_same_bytes():
    once = dumps(read())
    assert dumps(read(once)) == once


@given(st.dictionaries(words, json_values, max_size=3))
def test_unknown_keys_are_kept_at_every_level(unknown):
    strange = {f"x-{key}": value for key, value in unknown.items()}
    tree = json.loads(DOCUMENT)
    wing, _, sail, _ = tree["shapes"]
    nested = (wing["basis"], wing["style"], sail["basis_u"], sail["basis_v"], sail["style"])
    for place in (tree, *tree["shapes"], *nested):
        place.update(strange)
    assert tree_of(read(json.dumps(tree).encode())) == tree


def test_unknown_keys_of_an_edited_curve_are_kept():
    design = read()
    edited = design.with_shape(WING, design[WING].with_curve(a_curve()))
    shape = tree_of(edited)["shapes"][0]
    assert (shape["tag"], shape["basis"]["hint"]) == (["a", None], 3)


def test_unknown_keys_of_an_edited_surface_are_kept():
    design = read()
    sail = design.surface(SAIL)
    edited = design.with_shape(SAIL, design[SAIL].with_plus(replace(sail, s=9.0)))
    shape = tree_of(edited)["shapes"][2]
    assert (shape["fabric"], shape["basis_v"]["ply"], shape["s"]) == ("dacron", 2, 9.0)


def test_a_key_of_another_family_does_not_come_to_life():
    tree = json.loads(DOCUMENT)
    tree["shapes"][0]["basis"] = {"family": "bezier", "closed": True}
    design = read(json.dumps(tree).encode())
    curve = design.curve(WING)
    open_again = PlusCurve(BSpline(4), curve.lines, curve.s)
    saved = tree_of(design.with_curve(WING, open_again))["shapes"][0]["basis"]
    assert saved == {"family": "bspline", "order": 4}


def test_a_mesh_can_be_renamed_and_hidden():
    design = read()
    hidden = replace(design[KNEE], name="Knie", visible=False)
    tree = tree_of(design.with_shape(KNEE, hidden))["shapes"][3]
    assert (tree["name"], tree["visible"], tree["smoothness"]) == ("Knie", False, 0.7)


def test_defaults_are_not_written():
    shape = Shape(PlusCurve(Bernstein(2), ControlLines.of([[0, 0], [1, 1]])), "wing")
    assert tree_of(one_shape(shape)) == {
        "format": "plusedit-design",
        "version": 1,
        "shapes": [
            {
                "id": "wing",
                "kind": "curve",
                "s": 1.0,
                "basis": {"family": "bezier"},
                "points": [[0.0, 0.0], [1.0, 1.0]],
            }
        ],
    }


def test_automatic_directions_are_null():
    tree = tree_of(one_shape(Shape(a_curve(), "wing")))
    assert tree["shapes"][0]["directions"] == [None, [0.6, 0.8], None, None]


def test_automatic_directions_of_a_surface_are_null_and_all_of_them_go_unsaid():
    sail = tree_of(read())["shapes"][2]
    assert sail["directions_u"] == [[None, [1.0, 0.0, 0.0], None], [None, None, None]]
    assert "directions_v" not in sail


def test_points_run_along_v_in_rows_along_u():
    planes = read().surface(SAIL).planes
    assert planes.shape == (2, 3)
    assert planes.points[1, 2].tolist() == [1.0, 1.0, 2.0]
    assert planes.given[0, 0, 1].tolist() == [1.0, 0.0, 0.0]
    assert planes.weights[0].tolist() == [1.0, 2.0, 3.0]


def test_all_defaults_of_a_surface_go_unsaid():
    planes = ControlPlanes.of([[[0, 0, 0], [0, 1, 0]], [[1, 0, 0], [1, 1, 1]]])
    surface = PlusSurface(Bernstein(2), BSpline(2, 2), planes)
    [tree] = tree_of(one_shape(Shape(surface, "wing")))["shapes"]
    assert set(tree) == {"id", "kind", "s", "basis_u", "basis_v", "points"}
    assert read(dumps(one_shape(Shape(surface, "wing")))).surface(WING).planes.weights is None


def test_a_direction_of_zero_is_not_automatic():
    lines = ControlLines.of([[0, 0], [1, 1]], [[0.0, 0.0], None])
    design = one_shape(Shape(PlusCurve(Bernstein(2), lines), "wing"))
    assert read(dumps(design)).curve(WING).lines.automatic.tolist() == [False, True]


def test_weights_of_one_are_weights():
    lines = ControlLines.of([[0, 0], [1, 1]], weights=[1, 1])
    design = one_shape(Shape(PlusCurve(Bernstein(2), lines), "wing"))
    assert read(dumps(design)).curve(WING).lines.weights is not None


def test_the_name_is_the_id_where_none_is_given():
    assert (read()[WING].name, read()[BOW].name) == ("wing", "Bow")


def test_an_empty_design_can_be_written_and_read():
    assert len(read(dumps(Design()))) == 0


def test_a_design_without_shapes_may_leave_the_key_out():
    assert len(read(b'{"format": "plusedit-design", "version": 1}')) == 0


def test_whole_numbers_and_decimals_are_the_same_numbers():
    decimal = DOCUMENT.replace(b"[3, 2], [4, 0]", b"[3.0, 2e0], [0.4e1, 0.0]")
    assert decimal != DOCUMENT
    assert contents(Design({WING: read(decimal)[WING]})) == contents(Design({WING: read()[WING]}))


def test_a_negative_zero_stays_negative():
    x = read(DOCUMENT.replace(b"[[0, 0], [1, 2], [3, 2], [", b"[[-0, -0.0], [1, 2], [3, 2], ["))
    assert str(x.curve(WING).lines.points[0].tolist()) == "[-0.0, -0.0]"


def test_short_rows_stand_on_one_line():
    lines = dumps(read()).decode().splitlines()
    assert '      "points": [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]],' in lines


def test_many_points_stand_one_a_line():
    lines = ControlLines.of([[i, i] for i in range(50)])
    text = dumps(one_shape(Shape(PlusCurve(BSpline(50), lines), "wing"))).decode()
    assert "\n        [7.0, 7.0],\n" in text
    assert max(map(len, text.splitlines())) <= 100


@pytest.mark.parametrize("name", ["\ud800", "\udc00\ud800", "\x00\n\u2028\x7f", "日本", '"\\'])
def test_any_string_can_be_a_name(name):
    design = one_shape(Shape(a_curve(), name))
    assert read(dumps(design))[WING].name == name


def test_a_view_that_is_no_json_is_refused():
    with pytest.raises(FormatError, match="can't be written as JSON"):
        dumps(Design(view={"x": float("nan")}))
    with pytest.raises(FormatError, match="can't be written as JSON"):
        dumps(Design(view={"x": object()}))


@pytest.mark.parametrize("path", OLD_FILES, ids=lambda path: f"{path.parent.name}/{path.name}")
def test_every_file_ever_released_opens(path):
    design = loads(path.read_bytes(), path.name).design
    assert len(design) > 0
    assert json.loads(dumps(design))["version"] == 1


def test_a_newer_version_is_refused_with_both_numbers():
    with pytest.raises(FormatError, match=r"^bow.json: version: is 7; this program reads up to 1$"):
        read(DOCUMENT.replace(b'"version": 1', b'"version": 7'))
