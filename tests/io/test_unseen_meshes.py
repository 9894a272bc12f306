"""Whatever mesh comes along becomes a surface close to it, or is refused in a sentence."""

import numpy as np
import pytest

from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_import import ImportOptions, smoothed
from tests.geometry.mesh.bodies import cube, ribbon, sheet, together, torus
from tests.geometry.mesh.mapped_bodies import ball, tube
from tests.geometry.mesh.unseen_bodies import (
    ONE_SIDED,
    SMOOTH,
    WITHOUT_AREA,
    klein_bottle,
    polygon,
    shaken,
)

ROUGH = {
    "tangle": 0.1,
    "dense tangle": 0.1,
    "spiky ball": 0.05,
    "chain of three handles": 0.06,
    "many handles": 0.06,
}
"""How far off those are whose faces are hardly ever neighbors, or 30 times as long as others, and
coarse ones that had to be cut open"""


def imported(mesh, uv=None, **options):
    """The surfaces of a mesh, and the report."""
    return smoothed(MeshFile(mesh, uv), "body.obj", ImportOptions(**options))


def refused(mesh):
    """Why nothing can be made of a mesh."""
    with pytest.raises(FormatError) as told:
        imported(mesh)
    assert str(told.value).startswith("body.obj: ")
    return str(told.value).removeprefix("body.obj: ")


def assert_sound(part):
    """No triangle is turned over, and the surface is finite wherever the mesh is, and between."""
    surface = part.surface
    assert part.report.flips == 0
    places = surface.parameters[surface.mesh.triangulation.corners]
    assert np.isfinite(surface.at(places[:400, 0])).all()
    assert np.isfinite(surface.at(places[:400].mean(axis=1))).all()


@pytest.mark.parametrize("name", SMOOTH)
def test_every_mesh_becomes_a_surface_close_to_it(name):
    found = imported(SMOOTH[name], measure=True)
    for part in found.parts[:3]:
        assert_sound(part)
        far = part.report.deviation
        assert far.to_surface.rms < ROUGH.get(name, 0.03) * far.diagonal
        assert far.to_mesh.rms < ROUGH.get(name, 0.03) * far.diagonal
    handles = max(part.report.handles for part in found.parts)
    assert any("the map is rough" in note for note in found.report.notes) == (handles > 1)


@pytest.mark.parametrize("name", SMOOTH)
def test_every_mesh_becomes_a_surface_as_it_is(name):
    found = imported(SMOOTH[name], refine=False, smoothness=0.3, area_weights=True)
    for part in found.parts[:3]:
        assert part.surface.mesh.face_count == part.report.face_count
        assert_sound(part)


def test_the_deviation_of_needles_is_a_number():
    (part,) = imported(SMOOTH["thinnest slivers"], refine=False, measure=True).parts
    far = part.report.deviation
    assert np.isfinite(far.from_mesh).all()
    assert np.isfinite(far.from_surface).all()


@pytest.mark.parametrize("name", ONE_SIDED)
def test_one_sided_meshes_are_refused(name):
    assert refused(ONE_SIDED[name]).startswith("the mesh is one-sided like a Moebius strip")


def test_a_klein_bottle_is_closed():
    mesh = klein_bottle()
    # Every edge has two faces, whichever way these run along it.
    edges = np.sort(np.stack([mesh.corners, mesh.corners[mesh.following]]), axis=0)
    assert (np.unique(edges, axis=1, return_counts=True)[1] == 2).all()
    assert mesh.vertex_count - len(mesh.corners) // 2 + mesh.face_count == 0


@pytest.mark.parametrize("name", WITHOUT_AREA)
def test_meshes_without_area_are_refused(name):
    assert refused(WITHOUT_AREA[name]) in {
        "no face has three different corners",
        "the faces have no area: the corners of each lie on one line",
        "there are no faces",
    }


def test_what_is_one_sided_or_without_area_is_left_out_beside_others():
    line = PolygonMesh.of([(0, 0, 0), (1, 1, 1), (2, 2, 2)], [(0, 1, 2)])
    found = imported(together(cube(), ribbon(1), line, torus(12, 8)))
    assert [part.report.map_name for part in found.parts] == ["torus", "pillow"]
    assert {
        "1 part is one-sided like a Moebius strip and was left out",
        "1 part without any area was left out",
    } < set(found.report.notes)


def test_meshes_of_a_thousand_crumbs_are_cut_short():
    found = imported(together(*[polygon(3)] * 300, apart=2.5))
    assert len(found.parts) == 256
    assert found.report.notes == ("44 smaller parts beside 256 were left out",)


# Texture coordinates that will not do ---------------------------------------------------------

BODIES = {"ball": ball(2), "torus": torus(14, 9), "tube": tube(9, 6), "noisy": shaken(ball(2), 0.1)}


def textures(mesh):
    """By what is wrong with them, texture coordinates by corner."""
    random = np.random.default_rng(0)
    x, y, _ = mesh.vertices[mesh.corners].T
    return {
        "random": random.uniform(size=(len(x), 2)),
        "overlapping": np.stack([x, y], axis=1),
        "turned over": np.stack([y, x], axis=1),
        "at one place": np.zeros((len(x), 2)),
        "on one line": np.stack([x, 2.0 * x], axis=1),
        "huge": 1e14 * random.normal(size=(len(x), 2)),
        "tiny": 1e-300 * random.normal(size=(len(x), 2)),
        "by face": np.tile([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], (len(x), 1))[: len(x)],
    }


@pytest.mark.parametrize("wrong", textures(cube()))
@pytest.mark.parametrize("name", BODIES)
def test_bad_texture_coordinates_make_no_difference(name, wrong):
    mesh = BODIES[name]
    (found,), (without,) = imported(mesh, textures(mesh)[wrong]).parts, imported(mesh).parts
    assert found.report.map_name == without.report.map_name
    np.testing.assert_array_equal(found.surface.parameters, without.surface.parameters)


# Damage of all kinds --------------------------------------------------------------------------


def damaged(mesh, random):
    """The mesh with faces lost, turned, repeated and wrongly joined, and vertices moved."""
    faces = [list(face) for face in mesh.faces]
    for _ in range(int(random.integers(1, 12))):
        kind, at = int(random.integers(6)), int(random.integers(len(faces)))
        if kind == 0 and len(faces) > 4:
            faces.pop(at)
        elif kind == 1:
            faces[at] = faces[at][::-1]
        elif kind == 2:
            faces.append(faces[at])
        elif kind == 3:
            faces[at] = [faces[at][0], *faces[at]]
        elif kind == 4:
            faces[at][0] = int(random.integers(mesh.vertex_count))
        else:
            faces.append(random.choice(mesh.vertex_count, 3, replace=False).tolist())
    points = mesh.vertices.copy()
    moved = random.choice(len(points), 5, replace=False)
    points[moved] = points[random.permutation(moved)] * random.choice([1.0, 1.0 + 1e-12, -1.0, 5.0])
    return PolygonMesh.of(points, faces)


@pytest.mark.parametrize("seed", range(24))
def test_damaged_bodies_become_sound_surfaces_or_are_refused(seed):
    random = np.random.default_rng(seed)
    bodies = (ball(1), ball(2), cube(), torus(8, 6), sheet(5, 6), tube(7, 4))
    mesh = damaged(bodies[seed % len(bodies)], random)
    try:
        found = imported(mesh)
    except FormatError as error:
        assert str(error).startswith("body.obj: ")
    else:
        for part in found.parts:
            assert_sound(part)
