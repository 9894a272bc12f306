"""Meshes for the tests, real ones and such as are put together by hand."""

import json
from pathlib import Path

import numpy as np
import pytest

from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.mesh_reading import read_mesh

FOLDER = Path(__file__).parents[3].parent / "shared" / "data"
FACTS_FILE = FOLDER / "expected_mesh_facts.json"
FACTS = json.loads(FACTS_FILE.read_text()) if FACTS_FILE.is_file() else {}
NAMES = sorted(name for name, facts in FACTS.items() if "error" not in facts)

every_real_mesh = pytest.mark.parametrize(
    "name", NAMES or [pytest.param("", marks=pytest.mark.skip(reason="no real meshes here"))]
)


def real_mesh(name):
    """The mesh of a file, or its test skipped where there is none."""
    path = FOLDER / "mesh" / name
    if not path.is_file():
        pytest.skip("no real meshes here")
    return read_mesh(path).mesh


def cube():
    """The unit cube of six quads that face outward."""
    corners = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
    return PolygonMesh.of(corners, faces)


def sheet(rows, columns):
    """Unit quads in the plane z = 0, seen from above."""
    points = [(x, y, 0.0) for y in range(rows + 1) for x in range(columns + 1)]
    return PolygonMesh.of(points, grid_faces(rows, columns, columns + 1))


def grid_faces(rows, columns, stride):
    """Quads between the points of a grid in rows of `stride`."""
    starts = [row * stride + column for row in range(rows) for column in range(columns)]
    return [(at, at + 1, at + stride + 1, at + stride) for at in starts]


def torus(around, across):
    """Quads of a ring of radius 2 and thickness 1, closed both ways, facing outward."""
    u, v = np.meshgrid(*(np.arange(n) * 2.0 * np.pi / n for n in (around, across)), indexing="ij")
    radius = 2.0 + np.cos(v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), np.sin(v)], axis=-1)
    number = np.arange(around * across).reshape(around, across)
    after, up = np.roll(number, -1, axis=0), np.roll(number, -1, axis=1)
    quads = np.stack([number, after, np.roll(after, -1, axis=1), up], axis=-1)
    return PolygonMesh.of(points.reshape(-1, 3), quads.reshape(-1, 4))


def ribbon(turns, count=12):
    """A closed strip of quads that is twisted by so many half turns."""
    angle = np.linspace(0.0, 2.0 * np.pi, count, endpoint=False)
    tilt = 0.5 * turns * angle
    rims = [
        np.stack([r * np.cos(angle), r * np.sin(angle), side * np.sin(tilt)], axis=1)
        for side in (-0.3, 0.3)
        for r in [1.0 + side * np.cos(tilt)]
    ]
    quads = [(i, i + 1, count + i + 1, count + i) for i in range(count - 1)]
    ends = (0, count) if turns % 2 == 0 else (count, 0)
    quads.append((count - 1, ends[0], ends[1], 2 * count - 1))
    return PolygonMesh.of(np.concatenate(rims), quads)


def cylinder(sides, height):
    """A closed cylinder of radius 1: two triangles a side and fans at both ends."""
    angle = np.arange(sides) * 2.0 * np.pi / sides
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(sides)], axis=1)
    top = ring + np.array([0.0, 0.0, height])
    points = np.concatenate([ring, top, [[0.0, 0.0, 0.0], [0.0, 0.0, height]]])
    i, low, high = np.arange(sides), np.full(sides, 2 * sides), np.full(sides, 2 * sides + 1)
    j = np.roll(i, -1)
    rows = [(i, j, j + sides), (i, j + sides, i + sides), (j, i, low), (i + sides, j + sides, high)]
    return PolygonMesh.of(points, np.concatenate([np.stack(row, axis=1) for row in rows]))


def together(*meshes, apart=10.0):
    """All faces in one mesh, each mesh that far from the one before along x."""
    offsets = np.cumsum([0, *(mesh.vertex_count for mesh in meshes)])
    faces = [
        tuple(int(offset) + vertex for vertex in face)
        for mesh, offset in zip(meshes, offsets, strict=False)
        for face in mesh.faces
    ]
    points = [mesh.vertices + np.array([apart * i, 0.0, 0.0]) for i, mesh in enumerate(meshes)]
    return PolygonMesh.of(np.concatenate(points), faces)


def with_faces(mesh, faces):
    """The mesh with some more faces."""
    return PolygonMesh.of(mesh.vertices, [*mesh.faces, *faces])


def turned(mesh, numbers):
    """The mesh with some faces turned over."""
    faces = mesh.faces
    return PolygonMesh.of(
        mesh.vertices, [f[::-1] if i in set(numbers) else f for i, f in enumerate(faces)]
    )


def volume(mesh):
    """Of a closed mesh, positive where it faces outward."""
    triangles, _ = mesh.triangles()
    a, b, c = mesh.vertices[triangles].transpose(1, 0, 2)
    return (a * np.cross(b, c)).sum() / 6.0
