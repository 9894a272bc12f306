"""Bytes that mean harm, or mean nothing: one sentence, no time, no memory."""

import json
import resource
import sys

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.io import json_text
from plusedit.io.formats import FormatError
from plusedit.io.formats.json_document import dumps, loads
from tests.designs import DOCUMENT, json_values


def sentence(data):
    """Why the bytes are refused."""
    with pytest.raises(FormatError) as told:
        loads(data, "bow.json")
    assert str(told.value).startswith("bow.json: ")
    assert str(told.value).isprintable()
    return str(told.value).removeprefix("bow.json: ")


def with_key(value):
    return DOCUMENT.replace(b'"hint": 3', b'"hint": ' + value)


@pytest.mark.parametrize("data", [b"", b"\n  \t"])
def test_nothing_is_empty(data):
    assert sentence(data) == "is empty"


@pytest.mark.parametrize("length", [1, 20, 90, 300, 700, len(DOCUMENT) - 3])
def test_a_truncated_file_is_cut_off(length):
    assert sentence(DOCUMENT[:length]).startswith("is cut off: ")


@pytest.mark.parametrize("data", [b"[]", b"null", b"1", b'"x"', b"[{}]"])
def test_something_else_than_an_object_is_no_design(data):
    assert sentence(data).startswith("expected an object, got ")


@pytest.mark.parametrize(
    ("encoding", "words"),
    [("utf-8-sig", "byte order mark"), ("utf-16", "UTF-16"), ("utf-16-be", "not JSON")],
)
def test_other_encodings_are_named(encoding, words):
    assert words in sentence(DOCUMENT.decode().encode(encoding))


@pytest.mark.parametrize("wrong", [b"\xff", b"\xc3(", b"\xed\xa0\x80", b"\xf8\x88\x80\x80\x80"])
def test_invalid_utf_8_is_refused(wrong):
    assert sentence(DOCUMENT.replace(b"dacron", wrong)).startswith("is not UTF-8 text: byte ")


@pytest.mark.parametrize("wrong", [b"'a'", b"01", b"+1", b".5", b"1.", b"[1,]", b"{,}", b"//"])
def test_almost_json_is_not_json(wrong):
    assert sentence(with_key(wrong)).startswith("is not JSON: ")


def test_more_after_the_end_is_refused():
    assert sentence(DOCUMENT + b"{}").startswith("is not JSON: extra data")


@pytest.mark.parametrize("digits", [309, 400, 4_299, 5_000, 1_000_000])
def test_a_number_beyond_a_double_is_refused_however_many_digits_it_has(digits):
    assert "got Infinity" in sentence(with_key(b"9" * digits))
    assert "got -Infinity" in sentence(with_key(b"-" + b"9" * digits))


def test_a_key_that_stands_twice_among_many_is_found():
    many = b",".join(b'"%d": 0' % i for i in range(200_000))
    assert sentence(with_key(b"{%b, " % many + b'"199999": 1}')).startswith('"199999" stands twice')


def test_a_million_decimals_are_a_number_like_any():
    assert loads(with_key(b"0." + b"1" * 1_000_000), "bow.json")


@pytest.mark.parametrize("order", [b"1" + b"0" * 300, b"9007199254740993", b"100000"])
def test_an_absurd_order_is_refused(order):
    closed = DOCUMENT.replace(b'"order": 4', b'"closed": true, "order": ' + order)
    assert "order: " in sentence(closed)


@pytest.mark.parametrize("depth", [100, 900, 100_000])
@pytest.mark.parametrize(("opening", "closing"), [(b"[", b"]"), (b'{"a":', b"}")])
def test_deep_nesting_is_refused(depth, opening, closing):
    assert "nested" in sentence(with_key(opening * depth + b"0" + closing * depth))


@pytest.mark.parametrize("depth", [1, 50, 100, 900])
def test_a_point_that_is_nested_is_refused(depth):
    nested = b"[" * depth + b"2.5" + b"]" * depth
    told = sentence(DOCUMENT.replace(b"[1, 0, 2.5]", b"[1, 0, %b]" % nested))
    assert told.startswith('shape "sail": points: row 1: point 1: expected finite numbers')


@pytest.mark.parametrize("rows", [1, 3, 200_000])
def test_counts_of_rows_that_fit_nothing_are_refused(rows):
    many = b"[" + b",".join([b"[1, 1, 1]"] * rows) + b"]"
    told = sentence(DOCUMENT.replace(b"[[1, 2, 3], [1, 1, 1]]", many))
    assert told.startswith('shape "sail": weights: has ')


def test_nesting_that_is_not_ended_is_refused():
    assert sentence(b"[" * 100_000) == "is nested too deeply"


def memory():
    """The most that this process has used so far, in MB."""
    used = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return used / (2**20 if sys.platform == "darwin" else 2**10)


@pytest.mark.parametrize("piece", [b"[", b"[],", b'{"":', b"{},", b"0,", b'"",', b"[[[0],"])
def test_two_hundred_megabytes_of_next_to_nothing_are_refused_before_they_are_read(piece):
    data = b"[" + piece * (200_000_000 // len(piece))
    before = memory()
    assert sentence(data) == "holds more values than can be read"
    assert memory() - before < 50


def test_a_file_beyond_the_largest_is_refused(monkeypatch):
    monkeypatch.setattr(json_text, "LARGEST", 100)
    assert "more than 100 are not read" in sentence(DOCUMENT)


@given(st.data())
def test_flipped_bytes_are_read_or_refused(data):
    place = data.draw(st.integers(0, len(DOCUMENT) - 1))
    byte = data.draw(st.integers(0, 255))
    harmed = DOCUMENT[:place] + bytes([byte]) + DOCUMENT[place + 1 :]
    _read_or_refused(harmed)


@given(st.data(), json_values)
def test_any_value_in_any_place_is_read_or_refused(data, value):
    tree = json.loads(DOCUMENT)
    holder, key = data.draw(st.sampled_from(list(_places(tree))))
    holder[key] = value
    _read_or_refused(json.dumps(tree).encode())


@given(st.data())
def test_a_missing_value_is_read_or_refused(data):
    tree = json.loads(DOCUMENT)
    holder, key = data.draw(st.sampled_from(list(_places(tree))))
    del holder[key]
    _read_or_refused(json.dumps(tree).encode())


@given(st.binary(max_size=50))
def test_noise_is_refused(noise):
    sentence(noise)


def _places(value):
    """Every object or list of a tree, with each of its keys or indices."""
    entries = value.items() if isinstance(value, dict) else enumerate(value)
    for key, entry in entries:
        yield value, key
        if isinstance(entry, dict | list):
            yield from _places(entry)


def _read_or_refused(data):
    try:
        design = loads(data, "bow.json").design
    except FormatError as error:
        assert str(error).startswith("bow.json: ")
    else:
        once = dumps(design)
        assert dumps(loads(once, "again").design) == once
