"""Surfaces of meshes in exported files: where their points are, how faces run, and normals."""

import io

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io import export_pieces, mesh_piece
from plusedit.io.exporting import Tolerance, export_design
from plusedit.io.exports import exports
from plusedit.io.formats import FormatError
from plusedit.io.mesh_piece import pieced, times_within
from tests.designs import a_mesh
from tests.geometry.mesh.bodies import cube, sheet
from tests.io.mesh_files import READERS

every_export = pytest.mark.parametrize("kind", list(exports))


def a_ball(times=2):
    """A cube split some times and blown up to a sphere, as a surface without a rim."""
    mesh = cube().subdivided(times).mesh
    middle = mesh.vertices - mesh.vertices.mean(axis=0)
    mesh = mesh.with_vertices(middle / np.linalg.norm(middle, axis=1, keepdims=True))
    found = mapped(mesh)
    return MeshSurface(mesh, found.domain, found.parameters)


def a_pentagon():
    """A flat polygon of five corners beside a triangle."""
    vertices = [[0, 0, 0], [2, 0, 0], [3, 1, 0], [1, 2, 0], [-1, 1, 0], [4, -1, 0]]
    mesh = PolygonMesh.of(vertices, [[0, 1, 2, 3, 4], [1, 5, 2]])
    return MeshSurface(mesh, PlaneDomain(), mesh.vertices[mesh.corners, :2])


def written(kind, surface, times=0):
    """The parts that a reader finds in the file of a surface."""
    export, stream = exports[kind], io.BytesIO()
    piece = pieced(surface, times, name="a", numbers=export.numbers, has_polygons=export.has_quads)
    export.write(stream, [piece], [])
    return READERS[kind](stream.getvalue())


def normals_of(points, faces):
    """By every face's first three corners."""
    a, b, c = (points[[face[k] for face in faces]] for k in range(3))
    across = np.cross(b - a, c - a)
    return across / np.linalg.norm(across, axis=1, keepdims=True)


def test_points_are_those_of_the_surface_at_its_vertices():
    surface = a_ball()
    piece = pieced(surface)
    left, places = piece.welded
    assert_array_equal(piece.points[left], surface.at(surface.vertex_places))
    assert_array_equal(piece.points[left][places], piece.points)


def test_points_between_are_those_of_the_surface_too():
    surface = a_mesh()
    piece = pieced(surface, 2)
    assert_allclose(piece.points, surface.at(piece.parameters(slice(None))), atol=1e-12)
    assert piece.face_count == 4 * (4 + 3 + 1)


def test_a_point_has_all_parameters_that_faces_see_it_at():
    surface = a_ball()
    piece = pieced(surface)
    pairs = np.column_stack([surface.mesh.corners, surface.parameters])
    assert len(piece) == len(np.unique(pairs, axis=0)) > surface.mesh.vertex_count
    assert len(piece.welded[0]) == surface.mesh.vertex_count
    corners = np.concatenate([faces.quads for faces in piece.faces()])
    assert_array_equal(piece.parameters(slice(None))[corners].reshape(-1, 2), surface.parameters)


def test_normals_are_of_length_one_and_point_outward_even_at_cone_points():
    piece = pieced(a_ball(3))
    assert_allclose(np.linalg.norm(piece.normals, axis=1), 1.0, rtol=1e-6)
    outward = piece.points / np.linalg.norm(piece.points, axis=1, keepdims=True)
    assert (np.einsum("nd,nd->n", piece.normals, outward) > 0.95).all()


def test_normals_point_to_the_front_of_faces_where_the_map_is_a_mirror_image():
    mesh = sheet(4, 3)
    mirrored = MeshSurface(mesh, PlaneDomain(), mesh.vertices[mesh.corners, :2] * [-1.0, 1.0])
    assert_allclose(pieced(mirrored).normals[:, 2], 1.0)


def test_where_nothing_tells_a_normal_there_is_one_all_the_same():
    mesh = PolygonMesh.of(np.zeros((3, 3)), [[0, 1, 2]])
    flat = MeshSurface(mesh, PlaneDomain(), np.array([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]))
    assert_array_equal(pieced(flat).normals, [[0.0, 0.0, 1.0]] * 3)


@every_export
def test_every_file_of_a_closed_surface_is_closed_and_its_normals_look_outward(kind):
    [part] = written(kind, a_ball())
    faces = [tuple(map(tuple, part.at(face).tolist())) for face in part.faces]
    sides = [(face[k - 1], face[k]) for face in faces for k in range(len(face))]
    assert len(set(sides)) == len(sides)
    assert {(b, a) for a, b in sides} == set(sides)
    middles = np.array([np.mean(face, axis=0) for face in faces])
    flat = normals_of(part.points, part.faces)
    sense = np.einsum("fd,fd->f", flat, middles)
    # GLB is turned as a whole, which changes no side.
    assert (sense > 0.0).all()


def test_polygons_stay_polygons_in_obj_and_are_cut_elsewhere():
    [part] = written("obj", a_pentagon())
    assert sorted(map(len, part.faces)) == [3, 5]
    [cut] = written("ply", a_pentagon())
    assert [len(face) for face in cut.faces] == [3] * 4


@every_export
def test_it_is_written_piece_by_piece(kind, monkeypatch):
    whole = written(kind, a_ball())
    monkeypatch.setattr(mesh_piece, "BLOCK", 7)
    [pieces] = written(kind, a_ball())
    assert_array_equal(pieces.points, whole[0].points)
    assert pieces.faces == whole[0].faces


def test_a_design_of_meshes_curves_and_surfaces_is_exported_together(tmp_path):
    design = Design({"a": Shape(a_ball(), "A"), "b": Shape(a_mesh(), "B")})
    report = export_design(design, tmp_path / "out.obj")
    assert (report.meshes, report.surfaces, report.curves) == (2, 0, 0)
    assert str(report).startswith("2 meshes: ")
    assert ", within " in str(report)
    assert [part.name for part in READERS["obj"]((tmp_path / "out.obj").read_bytes())] == ["A", "B"]


def test_a_finer_tolerance_takes_more_faces():
    surface = a_ball()
    coarse, error = times_within(surface, 1.0, 10**6)
    assert (coarse, error < 1.0) == (0, True)
    times, reached = times_within(surface, error / 50.0, 10**6)
    assert times >= 3
    assert reached <= error / 50.0
    assert times_within(surface, error / 50.0, surface.mesh.vertex_count)[0] == 0


def test_a_tolerance_is_kept_between_the_vertices():
    surface = a_ball()
    times, _ = times_within(surface, 1e-3, 10**6)
    piece = pieced(surface, times)
    corners = np.concatenate([faces.quads for faces in piece.faces()])
    one, other = corners[:, 0], corners[:, 1]
    uv = piece.parameters(slice(None))
    middles = surface.at(0.5 * (uv[one] + uv[other]))
    chords = 0.5 * (piece.points[one] + piece.points[other])
    assert np.linalg.norm(middles - chords, axis=1).max() < 1.5e-3


def test_what_is_coarser_than_asked_is_told(tmp_path, monkeypatch):
    monkeypatch.setattr(export_pieces, "MOST", 10)
    design = Design({"a": Shape(a_ball(), "A")})
    report = export_design(design, tmp_path / "a.stl", tolerance=Tolerance(1e-9))
    assert report.left_out == ('"A" is coarser than asked: no more than 10 points are made',)


def test_splitting_beyond_all_memory_is_refused():
    with pytest.raises(ValueError, match="2 faces split 20 times would have more than"):
        pieced(a_mesh(), 20)


def test_points_that_the_file_can_not_hold_are_refused(tmp_path):
    surface = a_mesh().transformed(np.eye(3) * 1e60, np.zeros(3))
    with pytest.raises(FormatError, match=r'out.stl: shape "A": a point is beyond the numbers'):
        export_design(Design({"a": Shape(surface, "A")}), tmp_path / "out.stl")
    assert list(tmp_path.iterdir()) == []
