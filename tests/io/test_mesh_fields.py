"""Meshes in design files: to the last bit, as the format says, and refused in one sentence."""

import json

import numpy as np
import pytest
from hypothesis import given
from numpy.testing import assert_array_equal

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.domains import PillowDomain, PlaneDomain, TorusDomain
from plusedit.geometry.mesh.mesh_surface import EditedPlane, MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io import json_text
from plusedit.io.formats import FormatError
from plusedit.io.formats.json_document import dumps, loads
from tests.designs import KNEE, a_mesh, bits, meshes

KNEE_TREE = {
    "id": "knee",
    "kind": "mesh",
    "vertices": [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1], [2, 0.5, 0.5]],
    "faces": [[0, 1, 2, 3], [1, 4, 2]],
    "domain": {"kind": "pillow", "width": 1.5},
    "parameters": [[[0, 0], [1, 0], [1, 1], [0, 1]], [[1, 0], [2, 0.5], [1, 1]]],
    "smoothness": 0.7,
}


def document(**changes):
    tree = {key: value for key, value in {**KNEE_TREE, **changes}.items() if value is not None}
    return json.dumps({"format": "plusedit-design", "version": 1, "shapes": [tree]}).encode()


def read(**changes):
    return loads(document(**changes), "bow.json").design


def tree_of(design):
    return json.loads(dumps(design))["shapes"][0]


def refused(**changes):
    with pytest.raises(FormatError) as told:
        read(**changes)
    said = str(told.value)
    assert said.isprintable()
    return said.removeprefix('bow.json: shape "knee": ')


def pairs(*rows):
    return [[list(pair) for pair in row] for row in rows]


@given(meshes())
def test_a_mesh_comes_back_to_the_last_bit(surface):
    design = Design({KNEE: Shape(surface, "Knee")})
    assert bits(loads(dumps(design), "a.json").design.mesh(KNEE)) == bits(surface)


def test_what_may_be_missing_is_as_the_format_says():
    surface = read().mesh(KNEE)
    assert (surface.s, surface.area_weights, surface.factors) == (1.0, False, None)
    assert not surface.edited
    assert surface.domain == PillowDomain(1.5)


def test_everything_that_a_mesh_has_is_read():
    planes = {"1": {"point": [1, 2, 3], "gradient_v": [0, 0, 1]}, "0": {}}
    surface = read(planes=planes, s=0.5, area_weights=True, local_smoothness={"1": 2.5}).mesh(KNEE)
    assert (surface.s, surface.area_weights, surface.smoothness) == (0.5, True, 0.7)
    assert_array_equal(surface.edited[1].point, [1.0, 2.0, 3.0])
    assert surface.edited[1].gradient_u is None
    assert surface.edited[0].point is None
    assert_array_equal(surface.factors, [1.0, 2.5])
    assert surface.mesh.faces == [(0, 1, 2, 3), (1, 4, 2)]


def test_only_planes_that_were_edited_are_written_and_of_these_only_what_was():
    surface = a_mesh().with_edited({1: EditedPlane(gradient_u=np.ones(3))})
    tree = tree_of(Design({KNEE: Shape(surface, "knee")}))
    assert tree["planes"] == {"1": {"gradient_u": [1.0, 1.0, 1.0]}}
    plain = tree_of(Design({KNEE: Shape(a_mesh().with_edited({}), "knee")}))
    assert "planes" not in plain
    assert "source" not in plain


def test_local_smoothness_is_written_where_it_is_not_one():
    surface = a_mesh().with_factors([1.0, 0.25])
    tree = tree_of(Design({KNEE: Shape(surface, "knee")}))
    assert tree["local_smoothness"] == {"1": 0.25}


@pytest.mark.parametrize(
    ("domain", "tree"),
    [
        (PlaneDomain(), {"kind": "plane"}),
        (TorusDomain(0.75), {"kind": "torus", "height": 0.75}),
        (PillowDomain(2.0), {"kind": "pillow", "width": 2.0}),
    ],
)
def test_domains_are_written_as_the_format_says(domain, tree):
    mesh = a_mesh().mesh
    surface = MeshSurface(mesh, domain, a_mesh().parameters)
    assert tree_of(Design({KNEE: Shape(surface, "knee")}))["domain"] == tree


def test_unknown_keys_are_kept_wherever_they_stand():
    unknown = {
        "domain": {"kind": "pillow", "width": 1.5, "cones": [1, 2]},
        "planes": {"1": {"point": [0, 0, 0], "by": "hand"}},
        "source": {"file": "a.obj", "sha256": "00", "url": None},
        "origin": {"scanner": 7},
    }
    tree = tree_of(read(**unknown))
    for key, value in unknown.items():
        assert tree[key] == value
    again = tree_of(loads(dumps(read(**unknown)), "b.json").design)
    assert again == tree


def test_what_is_kept_of_a_plane_goes_with_the_plane():
    design = read(planes={"1": {"point": [0, 0, 0], "by": "hand"}})
    shape = design[KNEE]
    plain = design.with_shape(KNEE, shape.with_mesh(shape.mesh.with_edited({})))
    assert "planes" not in tree_of(plain)


def test_a_mesh_of_many_faces_has_a_line_for_each():
    text = dumps(Design({KNEE: Shape(a_mesh(), "Knee")})).decode()
    lines = [line.strip() for line in text.splitlines()]
    assert "[0, 1, 2, 3]," in lines
    assert "[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]]," in lines


def test_numbers_of_every_size_come_back():
    vertices = np.array([[0.1, -0.0, 5e-324], [1e90, 1 / 3, -1e-300], [2.0**-1022, 7, 1e-5]])
    mesh = PolygonMesh.of(vertices, [[0, 1, 2]])
    surface = MeshSurface(mesh, PlaneDomain(), np.array([[0, -0.0], [1 / 3, 0], [0, 0.1]]))
    back = loads(dumps(Design({KNEE: Shape(surface, "a")})), "a.json").design.mesh(KNEE)
    assert back.mesh.vertices.tobytes() == vertices.tobytes()
    assert back.parameters.tobytes() == surface.parameters.tobytes()


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"vertices": None}, "vertices: is missing"),
        ({"vertices": []}, "vertices: is empty"),
        ({"vertices": {}}, "vertices: expected a list, got an object"),
        ({"vertices": [[0, 0, 0], 3]}, "vertices: row 1: expected a list of numbers, got 3"),
        ({"vertices": [[0, 0], [1, 0]]}, "vertices: row 0 has 2 numbers, expected 3"),
        ({"vertices": [[0, 0, 0], [1, 0]]}, "vertices: row 1 has 2 numbers, row 0 has 3"),
        ({"vertices": [[0, 0, True]]}, "vertices: row 0: expected finite numbers, got true"),
        ({"vertices": [[0, 0, "1"]]}, 'vertices: row 0: expected finite numbers, got "1"'),
        ({"faces": None}, "faces: is missing"),
        ({"faces": []}, "faces: is empty"),
        ({"faces": [[0, 1, 2, 3], []]}, "faces: face 1: is empty"),
        ({"faces": [[0, 1], [1, 4, 2]]}, "faces: face 0: has 2 corners, expected 3 or more"),
        (
            {"faces": [[0, 1, 2, 3], [1, 4, 5]]},
            "faces: face 1: there is no vertex 5; there are 5, from 0 on",
        ),
        (
            {"faces": [[0, 1, 2, -1], [1, 4, 2]]},
            "faces: face 0: there is no vertex -1; there are 5, from 0 on",
        ),
        ({"faces": [[0, 1, 2.0], [1, 4, 2]]}, "faces: face 0: expected a whole number, got 2.0"),
        ({"faces": [[0, 1, True], [1, 4, 2]]}, "faces: face 0: expected a whole number, got true"),
        (
            {"faces": [[0, 1, 10**300], [1, 4, 2]]},
            f"faces: face 0: expected a whole number, got 1{'0' * 58}…",
        ),
        ({"parameters": None}, "parameters: is missing"),
        ({"parameters": pairs([(0, 0)] * 4)}, "parameters: has 1 entry for 2 faces"),
        (
            {"parameters": pairs([(0, 0)] * 4, [(0, 0)] * 4)},
            "parameters: row 1: has 4 entries for 3 corners",
        ),
        (
            {"parameters": pairs([(0, 0)] * 4, [(0, 0), (1,), (0, 1)])},
            "parameters: row 1 has 1 number, expected 2",
        ),
        (
            {"parameters": pairs([(0, 0)] * 4, [(0, 0), (1, None), (0, 1)])},
            "parameters: row 1: expected finite numbers, got null",
        ),
        (
            {"parameters": pairs([(1, 2)] * 4, [(3, 4)] * 3)},
            "parameters: no face has any extent in them, so there is no surface",
        ),
        (
            {"parameters": pairs([(0, 0), (1e-200, 0), (0, 1e-200), (0, 0)], [(0, 0)] * 3)},
            "parameters: are so close together, or vertices so far apart, that control planes are"
            " beyond what can be calculated with",
        ),
        ({"domain": None}, "domain: is missing"),
        ({"domain": "plane"}, 'domain: expected an object, got "plane"'),
        ({"domain": {}}, "kind: is missing"),
        (
            {"domain": {"kind": "sphere"}},
            'domain: kind: expected one of "plane", "cylinder", "torus", "pillow", got "sphere"',
        ),
        ({"domain": {"kind": "torus"}}, "domain: height: is missing"),
        (
            {"domain": {"kind": "pillow", "width": 0}},
            "domain: width: expected a positive number, got 0",
        ),
        ({"smoothness": None}, "smoothness: is missing"),
        ({"smoothness": -1}, "smoothness: expected a positive number, got -1"),
        ({"s": "1"}, 's: expected a finite number, got "1"'),
        ({"area_weights": 1}, "area_weights: expected true or false, got 1"),
        ({"planes": []}, "planes: expected an object, got a list of 0"),
        ({"planes": {"2": {}}}, 'planes: there is no face "2"; there are 2, from 0 on'),
        ({"planes": {"01": {}}}, 'planes: there is no face "01"; there are 2, from 0 on'),
        ({"planes": {"-1": {}}}, 'planes: there is no face "-1"; there are 2, from 0 on'),
        (
            {"planes": {"9" * 40: {}}},
            f'planes: there is no face "{"9" * 40}"; there are 2, from 0 on',
        ),
        ({"planes": {"1": 3}}, "planes: face 1: expected an object, got 3"),
        (
            {"planes": {"1": {"point": [0, 0]}}},
            "planes: face 1: point has 2 numbers, expected 3",
        ),
        (
            {"local_smoothness": {"1": 0}},
            "local_smoothness: face 1: expected a positive number, got 0",
        ),
        (
            {"local_smoothness": {"x": 1}},
            'local_smoothness: there is no face "x"; there are 2, from 0 on',
        ),
        ({"source": {"file": 3}}, "source: file: expected a string, got 3"),
    ],
)
def test_what_is_wrong_is_told_in_one_sentence(changes, why):
    assert refused(**changes) == why


@pytest.mark.parametrize("word", [b"NaN", b"Infinity", b"-Infinity", b"1e999"])
@pytest.mark.parametrize(("old", "key"), [(b"1.5}", "domain"), (b"0.7", "smoothness")])
def test_numbers_that_are_not_finite_are_refused(word, old, key):
    data = document().replace(old, word + (b"}" if old.endswith(b"}") else b""))
    with pytest.raises(FormatError, match=rf'shape "knee": {key}'):
        loads(data, "bow.json")


def test_vertices_and_parameters_that_are_not_finite_are_refused():
    for old, why in [
        (b"[2, 0.5, 0.5]", "vertices: row 4: expected finite numbers"),
        (b"[2, 0.5]", "parameters: row 1: expected finite numbers"),
    ]:
        data = document().replace(old, old.replace(b"2", b"1e999"))
        with pytest.raises(FormatError, match=why):
            loads(data, "bow.json")


def test_a_mesh_that_could_not_be_read_again_is_not_written(monkeypatch):
    design = Design({KNEE: Shape(a_mesh(), "Knee")})
    monkeypatch.setattr(json_text, "MOST_BRACKETS", 10)
    with pytest.raises(FormatError, match="more values than can be read"):
        dumps(design)
