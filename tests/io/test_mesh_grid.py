"""Surfaces of meshes on even grids, in files."""

import io

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.rectangle import rectangle
from plusedit.geometry.mesh.repair import repaired
from plusedit.io.export_pieces import Fineness, even_cells
from plusedit.io.exporting import export_design
from plusedit.io.exports import exports
from plusedit.io.formats import FormatError
from plusedit.io.mesh_grid import gridded
from plusedit.io.mesh_reading import read_mesh
from tests.geometry.mesh.bodies import cube, sheet, torus
from tests.geometry.mesh.mapped_bodies import tube
from tests.io.mesh_files import READERS

every_export = pytest.mark.parametrize("kind", list(exports))
EVEN = Fineness(cells=even_cells)


def smooth(mesh):
    found = mapped(mesh)
    return MeshSurface(mesh, found.domain, found.parameters)


def hills():
    """A sheet with hills, seen from above."""
    mesh = sheet(12, 8)
    x, y, _ = mesh.vertices.T
    return smooth(mesh.with_vertices(np.stack([x, y, np.sin(x) * np.cos(y)], axis=1)))


SURFACES = {"hills": hills(), "tube": smooth(tube(16, 10)), "ring": smooth(torus(24, 12))}
every_surface = pytest.mark.parametrize("name", SURFACES)


def on_grid(surface, cells=(20, 15), **wishes):
    return gridded(surface, rectangle(surface), cells, **wishes)


def read_back(kind, surface, cells=(20, 15)):
    export, stream = exports[kind], io.BytesIO()
    export.write(stream, [on_grid(surface, cells, numbers=export.numbers)], [])
    [part] = READERS[kind](stream.getvalue())
    return part


def sides_of(part):
    faces = [tuple(map(tuple, part.at(face).tolist())) for face in part.faces]
    return [(face[k - 1], face[k]) for face in faces for k in range(len(face))]


@every_surface
def test_points_are_those_of_the_surface(name):
    surface = SURFACES[name]
    u, v = rectangle(surface).lines((20, 15))
    grid = on_grid(surface)
    for i, j in ((0, 0), (7, 3), (19, 14), (20, 15)):
        assert_allclose(grid.points[i, j], surface.at([[u[i], v[j]]])[0], atol=1e-9)


@every_surface
@every_export
def test_normals_have_length_one_and_look_where_faces_do(kind, name):
    part = read_back(kind, SURFACES[name])
    if part.normals is None or kind == "stl":
        return
    assert_allclose(np.linalg.norm(part.normals, axis=1), 1.0, rtol=1e-5)
    for face, corners in zip(part.faces, part.corners, strict=True):
        a, b, c = part.at(face[:3])
        assert (part.normals[list(corners)] @ np.cross(b - a, c - a) > 0.0).all()


@every_surface
@every_export
def test_parameters_fill_the_unit_square(kind, name):
    part = read_back(kind, SURFACES[name])
    if part.parameters is not None:
        assert_array_equal(part.parameters.min(axis=0), 0.0)
        assert_array_equal(part.parameters.max(axis=0), 1.0)


@every_export
def test_a_ring_is_closed_and_a_tube_open_at_its_rims_only(kind):
    ring, open_tube = (sides_of(read_back(kind, SURFACES[n])) for n in ("ring", "tube"))
    assert {(b, a) for a, b in ring} == set(ring)
    rims = [(a, b) for a, b in open_tube if (b, a) not in set(open_tube)]
    assert len(rims) == 2 * 20


def test_our_own_readers_find_what_was_written(tmp_path):
    for kind, export in exports.items():
        path = tmp_path / f"ring{export.suffixes[0]}"
        design = Design({"ring": Shape(SURFACES["ring"], "Ring")})
        report = export_design(design, path, fineness=Fineness(cells=lambda *_: (30, 20)))
        [part] = repaired(read_mesh(path).mesh).parts
        mesh = part.mesh
        assert mesh.face_count == report.faces, kind
        assert mesh.topology.components[0].boundaries == 0
        assert mesh.topology.components[0].handles == 1


def test_a_mirrored_map_turns_faces_and_normals_to_the_front():
    mesh = sheet(6, 6)
    places = mesh.vertices[mesh.corners, :2] * [-1.0, 1.0]
    grid = on_grid(MeshSurface(mesh, PlaneDomain(), places))
    assert_allclose(grid.normals[..., 2], 1.0, atol=1e-6)
    a, b, c = grid.scaled[next(iter(grid.faces())).quads[0, :3]]
    assert np.cross(b - a, c - a)[2] > 0.0


def test_meshes_without_a_rectangle_are_written_by_their_faces_which_is_told(tmp_path):
    ball = smooth(cube().subdivided(2).mesh)
    design = Design({"hills": Shape(hills(), "Hills"), "ball": Shape(ball, "Ball")})
    report = export_design(design, tmp_path / "out.obj", fineness=EVEN)
    (remark,) = report.left_out
    assert remark.startswith('"Ball" has its faces, not a grid')
    assert report.meshes == 2
    with pytest.raises(FormatError, match="fill a rectangle"):
        export_design(design, tmp_path / "ball.obj", ["ball"], fineness=EVEN)
    assert not (tmp_path / "ball.obj").exists()


def test_a_grid_of_too_many_points_is_refused():
    with pytest.raises(ValueError, match="is more than"):
        on_grid(hills(), (100_000, 100_000))


class GivenUpError(Exception):
    pass


@pytest.mark.parametrize("fineness", [EVEN, Fineness(times=lambda mesh: 1), Fineness()])
@pytest.mark.parametrize("words", ["Evaluating the surface", "Writing the file", "Done"])
def test_an_export_that_is_given_up_leaves_the_old_file(tmp_path, fineness, words):
    path = tmp_path / "out.ply"
    path.write_bytes(b"old")

    def tell(share, what):
        assert 0.0 <= share <= 1.0
        if what == words:
            raise GivenUpError

    with pytest.raises(GivenUpError):
        export_design(Design({"a": Shape(hills(), "A")}), path, fineness=fineness, tell=tell)
    assert path.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [path]


@every_surface
@every_export
def test_the_size_of_a_file_is_known_before(kind, name):
    export, stream = exports[kind], io.BytesIO()
    grid = on_grid(SURFACES[name], (120, 90), numbers=export.numbers)
    export.write(stream, [grid], [])
    written = len(stream.getvalue())
    assert export.size(len(grid), grid.triangle_count) == pytest.approx(written, rel=0.2)
