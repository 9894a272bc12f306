"""What is said of a file that is wrong: file, shape, key, what was expected and what came."""

import pytest

from plusedit.io.formats import FormatError
from plusedit.io.formats.json_document import loads
from tests.designs import DOCUMENT

TOP = 'bow.json: shape "wing": '
SAIL = 'bow.json: shape "sail": '
WRONG = [
    (b"[3, 2]", b"[3, 2, 1]", TOP + "points: row 2 has 3 numbers, row 0 has 2"),
    (b"[3, 2]", b"[3]", TOP + "points: row 2 has 1 number, row 0 has 2"),
    (b"[0, 0]", b"[0]", TOP + "points: row 0 has 1 number, expected 2 or 3"),
    (b"[3, 2]", b"3", TOP + "points: row 2: expected a list of numbers, got 3"),
    (b"[3, 2]", b"[3, NaN]", TOP + "points: row 2: expected finite numbers, got NaN"),
    (b"[3, 2]", b"[3, 1e999]", TOP + "points: row 2: expected finite numbers, got Infinity"),
    (b"[3, 2]", b"[-1e999, 2]", TOP + "points: row 2: expected finite numbers, got -Infinity"),
    (b"[3, 2]", b"[3, true]", TOP + "points: row 2: expected finite numbers, got true"),
    (b"[3, 2]", b'["3", 2]', TOP + 'points: row 2: expected finite numbers, got "3"'),
    (b"[0, 0], [1, 2], [3, 2], [4, 0]", b"", TOP + "points: is empty"),
    (b", [1, 2], [3, 2], [4, 0]", b"", TOP + "points: has 1 row, a curve needs 2 or more"),
    (b'"order": 4', b'"order": 4.0', TOP + "basis: order: expected a whole number, got 4.0"),
    (b'"order": 4', b'"order": true', TOP + "basis: order: expected a whole number, got true"),
    (b'"order": 4', b'"degree": 3', TOP + "basis: order: is missing"),
    (
        b'"order": 4',
        b'"order": 5',
        TOP + "basis: order: expected 2 to 4, the number of control lines, got 5",
    ),
    (b'"hint": 3', b'"closed": 1', TOP + "basis: closed: expected true or false, got 1"),
    (b'"hint": 3', b'"knots": null', TOP + "basis: knots: expected a list, got null"),
    (b'"hint": 3', b'"knots": [0, 1]', TOP + "basis: knots: expected 8 numbers, got 2"),
    (b'"family": "bspline", ', b"", TOP + "basis: family: is missing"),
    (
        b'"bspline"',
        b'"nurbs"',
        TOP + 'basis: family: expected one of "bezier", "bspline", "rag", got "nurbs"',
    ),
    (b'"s": 2.5, ', b"", TOP + "s: is missing"),
    (b'"s": 2.5', b'"s": "2.5"', TOP + 's: expected a finite number, got "2.5"'),
    (b'"s": 2.5', b'"s": 1, "s": 2', TOP + '"s" stands twice in one object'),
    (b'"kind": "curve"', b'"kind": "blob"', TOP + "kind: expected"),
    (b"null, [0.6, 0.8]", b"[0.6, 0.8]", TOP + "directions: has 3 entries for 4 points"),
    (b"[0.6, 0.8]", b"[0.6]", TOP + "directions: row 1 has 1 number, rows of points have 2"),
    (b"1, 1, 2, 1", b"1, 0, 2, 1", TOP + "weights: must be positive, number 1 is 0"),
    (b"1, 1, 2, 1", b"1, 1, 2", TOP + "weights: has 3 entries for 4 points"),
    (b'"#aabbcc"', b'"red"', TOP + 'style: color: expected "#rrggbb"'),
    (b'"width": 3', b'"width": "3"', TOP + "style: width: expected a finite number"),
    (b'"bow"', b'"wing"', 'bow.json: shape "wing": id: two shapes have it'),
    (b'"id": "bow", ', b"", "bow.json: shapes: entry 1: id: is missing"),
    (b'"id": "bow"', b'"id": 7', "bow.json: shapes: entry 1: id: expected a string, got 7"),
    (b'"visible": false', b'"visible": 0', 'bow.json: shape "bow": visible: expected true or'),
    (b'"sigma": [0.1', b'"sigma": [-0.1', 'bow.json: shape "bow": basis: sigma: must be'),
    (
        b'"sigma": [0.1, 0.2, 0.1]',
        b'"sigma": "wide"',
        'bow.json: shape "bow": basis: sigma: expected a finite number or a list of them, got',
    ),
    (b"[0, 0.25, 1]", b"[0, 0, 1]", 'bow.json: shape "bow": basis: nodes: must increase'),
    (b', "s": 1.2', b"", SAIL + "s: is missing"),
    (b'"s": 1.2', b'"s": 1e999', SAIL + "s: expected a finite number, got Infinity"),
    (b'{"family": "bezier"}', b"{}", SAIL + "basis_u: family: is missing"),
    (b'"basis_u": {"family": "bezier"},', b"", SAIL + "basis_u: is missing"),
    (b'"order": 3,', b'"order": 1,', SAIL + "basis_v: order: expected"),
    (b'{"family": "bezier"}', b'{"family": "bspline", "order": 4}', SAIL + "basis_u: order: exp"),
    (b'"ply": 2', b'"ply": NaN', SAIL + "basis_v: ply: expected finite numbers, got NaN"),
    (b'"points": [[[0, 0, 1]', b'"dots": [[[0, 0, 1]', SAIL + "points: is missing"),
    (b"[1, 0, 2.5], ", b"", SAIL + "points: row 1 has 2 points, row 0 has 3"),
    (b"[1, 0, 2.5]", b"[1, 0]", SAIL + "points: row 1: point 1 has 2 numbers, expected 3"),
    (b"[1, 0, 2.5]", b"[1, 0, 2, 5]", SAIL + "points: row 1: point 1 has 4 numbers, expected 3"),
    (b"[1, 0, 2.5]", b"null", SAIL + "points: row 1: point 1: expected a list of numbers, got"),
    (b"[1, 0, 2.5]", b"[1, 0, NaN]", SAIL + "points: row 1: point 1: expected finite numbers"),
    (b"[1, 0, 2.5]", b"[1, 0, [2]]", SAIL + "points: row 1: point 1: expected finite numbers"),
    (b"[1, 0, 2.5]", b"[1, 0, 1e101]", SAIL + "points: has a value beyond 1e+100"),
    (b"[[0, 0, 2], [1, 0, 2.5], [1, 1, 2]]", b"[]", SAIL + "points: row 1: is empty"),
    (b"[[0, 0, 2], [1, 0, 2.5], [1, 1, 2]]", b"7", SAIL + "points: row 1: expected a list, got 7"),
    (
        b", [[0, 0, 2], [1, 0, 2.5], [1, 1, 2]]",
        b"",
        SAIL + "points: has 1 row, a surface needs 2 or more",
    ),
    (
        b"[[[0, 0, 1], [1, 0, 1], [1, 1, 1]], [[0, 0, 2], [1, 0, 2.5], [1, 1, 2]]]",
        b"[[[0, 0, 1]], [[0, 0, 2]]]",
        SAIL + "points: each row has 1 point, a surface needs 2 or more",
    ),
    (b"[1, 2, 3]", b"[1, 2]", SAIL + "weights: row 0: has 2 entries for 3 points"),
    (b"[1, 2, 3], ", b"", SAIL + "weights: has 1 entry for 2 rows of points"),
    (b"[1, 2, 3]", b"[1, 0, 3]", SAIL + "weights: row 0: must be positive, number 1 is 0"),
    (b"[1, 2, 3]", b"[1, [2], 3]", SAIL + "weights: row 0: expected finite numbers, got a list"),
    (b"[null, null, null]", b"null", SAIL + "directions_u: row 1: expected a list, got null"),
    (b", [null, null, null]", b"", SAIL + "directions_u: has 1 entry for 2 rows of points"),
    (b"[null, null, null]", b"[null]", SAIL + "directions_u: row 1: has 1 entry for 3 points"),
    (
        b"[null, [1, 0, 0], null]",
        b"[null, [1, 0], null]",
        SAIL + "directions_u: row 0: entry 1 has 2 numbers, expected 3",
    ),
    (
        b"[null, [1, 0, 0], null]",
        b'[null, "up", null]',
        SAIL + 'directions_u: row 0: entry 1: expected a list of numbers, got "up"',
    ),
    (b'{"seam": "red"}', b'{"color": "red"}', SAIL + 'style: color: expected "#rrggbb"'),
    (b'"sail"', b'"bow"', 'bow.json: shape "bow": id: two shapes have it'),
    (b"[3, 2, 4]", b"[3, 2, 5]", 'bow.json: shape "knee": faces: face 1: there is no vertex 5'),
    (b"[3, 2, 4]", b"[3, 2]", 'bow.json: shape "knee": faces: face 1: has 2 corners, expected'),
    (b', "height": 2', b"", 'bow.json: shape "knee": domain: height: is missing'),
    (b"[0, 1], [1, 1], [1, 2]", b"[0, 1]", 'bow.json: shape "knee": parameters: row 1: has 1'),
    (b'"1": {', b'"2": {', 'bow.json: shape "knee": planes: there is no face "2"'),
    (b'"smoothness": 0.7', b'"smoothness": 0', 'bow.json: shape "knee": smoothness: expected a'),
    (b'"hint": 3', b'"hint": [1e999]', TOP + "basis: hint: expected finite numbers, got Infinity"),
    (b'"fabric": "dacron"', b'"fabric": NaN', 'bow.json: shape "sail": fabric: expected finite'),
    (b'"center": [0, 1]', b'"center": [0, NaN]', "bow.json: view: expected finite numbers"),
    (b'"name": "Ada"', b'"age": Infinity', "bow.json: author: expected finite numbers"),
    (b'"version": 1', b'"version": true', "bow.json: version: expected a whole number from 1"),
    (b'"version": 1, ', b"", "bow.json: version: is missing"),
    (b"plusedit-design", b"gltf", 'bow.json: format: is no PlusEdit design: expected "plusedit'),
]


@pytest.mark.parametrize(("right", "wrong", "sentence"), WRONG, ids=[row[2] for row in WRONG])
def test_it_names_file_shape_key_and_what_came(right, wrong, sentence):
    assert DOCUMENT.count(right) >= 1
    with pytest.raises(FormatError) as told:
        loads(DOCUMENT.replace(right, wrong, 1), "bow.json")
    assert str(told.value).startswith(sentence)


def test_an_id_with_a_line_break_leaves_the_sentence_on_one_line():
    wrong = DOCUMENT.replace(b'"wing"', b'"wi\\nng\\u001b[2J"').replace(b'"s": 2.5', b'"s": []')
    with pytest.raises(FormatError) as told:
        loads(wrong, "bow.json")
    assert str(told.value).isprintable()


def test_a_long_value_is_shortened():
    wrong = DOCUMENT.replace(b'"s": 2.5', b'"s": "' + b"x" * 10_000 + b'"')
    with pytest.raises(FormatError) as told:
        loads(wrong, "bow.json")
    assert len(str(told.value)) < 200
