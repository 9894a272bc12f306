"""`plusedit sample`: numbers for scripts, or one line that says why not."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.__main__ import main
from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.io.files import load, save
from tests.designs import BOW, DOCUMENT, KNEE, SAIL, WING, a_design
from tests.geometry.definition import surface_definition
from tests.geometry.surfaces import PAIRS, random_surface

SMOOTH = [pair for pair in PAIRS if "staircase" not in pair]  # that one magnifies every rounding
SURFACE_KEYS = ("position", "du", "dv", "duu", "duv", "dvv")


@pytest.fixture
def bow(tmp_path):
    """A file with the curves wing and bow."""
    save(a_design(), tmp_path / "bow.json")
    return tmp_path / "bow.json"


@pytest.fixture
def sampled(capsys):
    """What `plusedit sample` says, as a tree."""

    def run(*words):
        assert main(["sample", *map(str, words)]) == 0
        return json.loads(capsys.readouterr().out)["shapes"]

    return run


@pytest.fixture
def refused(capsys):
    """Why `plusedit sample` refuses."""

    def run(*words):
        assert main(["sample", *map(str, words)]) == 2
        out, complaint = capsys.readouterr()
        assert out == ""
        assert complaint.count("\n") == 1
        return complaint.strip()

    return run


@pytest.fixture
def at(tmp_path):
    """A file of parameters."""

    def write(tree):
        path = tmp_path / "at.json"
        path.write_text(tree if isinstance(tree, str) else json.dumps(tree))
        return path

    return write


def test_every_curve_is_sampled_evenly(bow, sampled):
    shapes = sampled(bow, "--count", 5)
    assert set(shapes) == {WING, BOW}
    assert shapes[WING]["u"] == [0.0, 0.25, 0.5, 0.75, 1.0]
    assert np.shape(shapes[WING]["position"]) == (5, 2)


def test_numbers_are_those_of_the_library_to_the_last_bit(bow, sampled):
    found = sampled(bow, "--count", 33)[WING]
    curve = load(bow).design.curve(WING)
    for key, values in zip(("position", "d1", "d2"), curve.derivatives(found["u"]), strict=True):
        assert_array_equal(found[key], values)


@pytest.mark.parametrize(
    ("highest", "keys"),
    [(0, {"u", "position"}), (1, {"u", "position", "d1"}), (2, {"u", "position", "d1", "d2"})],
)
def test_derivatives_are_written_up_to_the_highest(bow, sampled, highest, keys):
    assert set(sampled(bow, "--derivatives", highest)[WING]) == keys


def test_parameters_can_be_named_and_the_rest_is_left_out(bow, sampled, at):
    shapes = sampled(bow, "--at", at({"wing": {"u": [0.5, 0, 1]}}))
    assert list(shapes) == [WING]
    assert shapes[WING]["u"] == [0.5, 0.0, 1.0]


def test_parameters_outside_are_clamped_on_open_curves(bow, sampled, at):
    wing = sampled(bow, "--at", at({"wing": {"u": [-3, 0, 1, 7.5]}}))[WING]
    assert wing["position"][0] == wing["position"][1]
    assert wing["position"][2] == wing["position"][3]


def test_parameters_outside_wrap_on_closed_curves(tmp_path, sampled, at):
    closed = DOCUMENT.replace(b'"hint": 3', b'"closed": true')
    (tmp_path / "ring.json").write_bytes(closed)
    ring = sampled(tmp_path / "ring.json", "--at", at({"wing": {"u": [-0.75, 0.25, 2.25]}}))[WING]
    assert_allclose(ring["position"], [ring["position"][1]] * 3, rtol=1e-13)


def test_the_output_can_be_a_file(bow, sampled, tmp_path, capsys):
    on_screen = sampled(bow)
    assert main(["sample", str(bow), "-o", str(tmp_path / "out.json")]) == 0
    assert capsys.readouterr().out == ""
    assert json.loads((tmp_path / "out.json").read_bytes())["shapes"] == on_screen


def test_a_mesh_is_sampled_once_at_every_vertex(document, sampled):
    knee, surface = sampled(document)["knee"], load(document).design.mesh(KNEE)
    assert list(knee) == ["uv", "position", "du", "dv"]
    assert_array_equal(knee["uv"], surface.vertex_places)
    for key, values in zip(
        ("position", "du", "dv"), surface.derivatives(surface.vertex_places), strict=True
    ):
        assert_array_equal(knee[key], values)


def test_a_mesh_is_sampled_where_asked_even_far_outside(document, sampled, at):
    places = [[0.25, 0.5], [-17.75, 8.5], [1e12, -3.5]]
    knee = sampled(document, "--at", at({"knee": {"uv": places}}), "--derivatives", 0)["knee"]
    assert list(knee) == ["uv", "position"]
    assert knee["uv"] == places
    assert_allclose(knee["position"][1], knee["position"][0])
    assert np.isfinite(knee["position"]).all()


@pytest.mark.parametrize(
    ("parameters", "why"),
    [
        ({"u": [0.5]}, '"u": a mesh has "uv" alone'),
        ({}, "uv: is missing"),
        ({"uv": []}, "uv: is empty"),
        ({"uv": [[0, 1], [0]]}, "uv: row 1 has 1 number, row 0 has 2"),
        ({"uv": [[0, 1, 2]]}, "uv: row 0 has 3 numbers, expected 2"),
        ({"uv": [0.5, 1]}, "uv: row 0: expected a list of numbers, got 0.5"),
    ],
)
def test_wrong_parameters_of_a_mesh_are_told(document, refused, at, parameters, why):
    told = refused(document, "--at", at({"knee": parameters}))
    assert told == f'at.json: shape "knee": {why}'


def test_every_surface_is_sampled_evenly_each_way(document, sampled):
    sail = sampled(document, "--count", 3)["sail"]
    assert sail["u"] == sail["v"] == [0.0, 0.5, 1.0]
    assert all(np.shape(sail[key]) == (3, 3, 3) for key in SURFACE_KEYS)


def test_points_of_a_surface_run_along_v_in_rows_along_u(document, sampled, at):
    sail = sampled(document, "--at", at({"sail": {"u": [0, 0.3], "v": [0, 0.5, 0.9]}}))["sail"]
    [[alone]] = sampled(document, "--at", at({"sail": {"u": [0.3], "v": [0.9]}}))["sail"]["duv"]
    assert np.shape(sail["duv"]) == (2, 3, 3)
    assert_allclose(sail["duv"][1][2], alone, rtol=1e-12)


@pytest.mark.parametrize(
    ("highest", "keys"),
    [(0, SURFACE_KEYS[:1]), (1, SURFACE_KEYS[:3]), (2, SURFACE_KEYS)],
)
def test_derivatives_of_a_surface_are_written_up_to_the_highest(document, sampled, highest, keys):
    sail = sampled(document, "--count", 2, "--derivatives", highest)["sail"]
    assert list(sail) == ["u", "v", *keys]


@pytest.mark.parametrize("kinds", SMOOTH, ids="-".join)
@pytest.mark.parametrize("contrast", [None, 3.0], ids=["plain", "weighted"])
def test_numbers_of_a_surface_are_those_of_the_definition(tmp_path, sampled, at, kinds, contrast):
    surface = random_surface(*kinds, shape=(4, 5), contrast=contrast, seed=7)
    save(Design({SAIL: Shape(surface, "sail")}), tmp_path / "sail.json")
    u, v = [0.0, 0.137, 0.5], [0.71, 1.0]
    found = sampled(tmp_path / "sail.json", "--at", at({"sail": {"u": u, "v": v}}))[SAIL]
    by_the_book = np.array([[surface_definition(surface, x, y) for y in v] for x in u])
    for k, key in enumerate(SURFACE_KEYS):
        wanted = by_the_book[:, :, k].astype(float)
        assert_allclose(found[key], wanted, rtol=0, atol=1e-12 * max(1.0, abs(wanted).max()))


def test_parameters_outside_are_clamped_where_a_surface_is_open_and_wrap_where_it_is_closed(
    document, sampled, at
):
    sail = sampled(document, "--at", at({"sail": {"u": [-3, 0], "v": [-0.75, 0.25, 2.25]}}))[SAIL]
    assert_allclose(sail["position"], [[sail["position"][1][1]] * 3] * 2, rtol=1e-13)


@pytest.mark.parametrize(
    ("tree", "why"),
    [
        ({"u": [0]}, "v: is missing"),
        ({"v": [0]}, "u: is missing"),
        ({"u": [0], "v": []}, "v: is empty"),
        ({"u": [0], "v": [None]}, "v: expected finite numbers, got null"),
        ({"u": [0], "v": [0], "w": [0]}, '"w": a surface has "u" and "v" alone'),
        ({"uv": [[0, 0]]}, '"uv": a surface has "u" and "v" alone'),
    ],
)
def test_wrong_parameters_of_a_surface_are_told(document, refused, at, tree, why):
    told = refused(document, "--at", at({"sail": tree}))
    assert told == f'at.json: shape "sail": {why}'


def test_more_pairs_than_can_be_written_are_refused_at_once(document, refused, at):
    many = at({"sail": {"u": [0] * 2000, "v": [0] * 2000}})
    assert "2000 x 2000 parameters are too many" in refused(document, "--at", many)
    assert "1001 x 1001 parameters are too many" in refused(document, "--count", 1001)


@pytest.mark.parametrize(
    ("tree", "why"),
    [
        ({"sail": {"u": [0]}}, 'shape "sail": the design has no such shape'),
        ({"wing": {}}, 'shape "wing": u: is missing'),
        ({"wing": {"u": []}}, 'shape "wing": u: is empty'),
        ({"wing": {"u": [0, "1"]}}, 'shape "wing": u: expected finite numbers, got "1"'),
        ({"wing": {"u": 0.5}}, 'shape "wing": u: expected a list, got 0.5'),
        ({"wing": {"u": [0], "v": [0]}}, 'shape "wing": "v": a curve has the parameter "u" alone'),
        ({"wing": [0]}, 'shape "wing": parameters: expected an object, got a list of 1'),
        ([0], "parameters: expected an object, got a list of 1"),
        ('{"wing": {"u": [1e999]}}', 'shape "wing": u: expected finite numbers, got Infinity'),
        ('{"wing": {"u": [0]}', "is cut off: something begun is not ended at line 1, column 20"),
        ("", "is empty"),
    ],
)
def test_wrong_parameters_are_told(bow, refused, at, tree, why):
    assert refused(bow, "--at", at(tree)) == f"at.json: {why}"


@pytest.mark.parametrize("count", ["0", "-1", "x", "1.5", "1000001", "9" * 30, ""])
def test_a_count_is_a_sensible_number(bow, refused, count):
    assert "argument --count: expected a whole number from 1" in refused(bow, "--count", count)


def test_nothing_is_written_where_something_is_wrong(document, refused, tmp_path):
    document.write_bytes(DOCUMENT.replace(b"[3, 2]", b"[3]"))
    told = refused(document, "-o", tmp_path / "out.json")
    assert told == 'bow.json: shape "wing": points: row 2 has 1 number, row 0 has 2'
    assert not (tmp_path / "out.json").exists()


def test_a_result_beyond_a_double_is_told(tmp_path, refused):
    basis = {"family": "bspline", "order": 2, "knots": [0, 0, 1e-300, 1, 1]}
    shape = {"id": "steep", "kind": "curve", "s": 0, "basis": basis}
    shape["points"] = [[0, 0], [1e99, 0], [0, 1]]
    design = {"format": "plusedit-design", "version": 1, "shapes": [shape]}
    (tmp_path / "bow.json").write_text(json.dumps(design))
    told = refused(tmp_path / "bow.json", "-o", tmp_path / "out.json")
    assert told.startswith('bow.json: shape "steep": d1: is beyond a double at u = 0')
    assert not (tmp_path / "out.json").exists()


@pytest.mark.parametrize("name", ["nope.json", ".", "bow.xyz"])
def test_a_design_that_can_not_be_read_is_told(refused, tmp_path, name):
    (tmp_path / "bow.xyz").write_bytes(b"")
    refused(tmp_path / name)


def test_the_design_is_not_written_over(bow, refused, at):
    before = bow.read_bytes()
    assert "is read from" in refused(bow, "-o", bow)
    parameters = at({"wing": {"u": [0]}})
    assert "is read from" in refused(bow, "--at", parameters, "-o", parameters)
    assert bow.read_bytes() == before
