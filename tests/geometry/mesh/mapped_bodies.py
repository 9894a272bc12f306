"""Bodies that are given parameters in tests, and what must hold of parameters."""

import numpy as np
from numpy.testing import assert_allclose

from plusedit.geometry.mesh.polygons import PolygonMesh


def ball(times=3, stretch=(1.0, 1.0, 1.0)):
    """An octahedron whose triangles are quartered so often, blown up to a sphere or ellipsoid."""
    corners = np.concatenate([np.eye(3), -np.eye(3)])
    faces = [(0, 1, 2), (1, 3, 2), (3, 4, 2), (4, 0, 2), (1, 0, 5), (3, 1, 5), (4, 3, 5), (0, 4, 5)]
    fine = PolygonMesh.of(corners, faces).subdivided(times).mesh
    directions = fine.vertices / np.linalg.norm(fine.vertices, axis=1, keepdims=True)
    return fine.with_vertices(directions * stretch)


def blocks(cells):
    """The quads that bound a set of unit cubes, which must not touch at edges or corners only."""
    inside = {tuple(cell) for cell in cells}
    corners, faces = {}, []
    for cell in sorted(inside):
        for axis in range(3):
            for side in (0, 1):
                step = [0, 0, 0]
                step[axis] = 2 * side - 1
                if tuple(np.add(cell, step)) in inside:
                    continue
                first, second = (axis + 1) % 3, (axis + 2) % 3
                around = [(0, 0), (1, 0), (1, 1), (0, 1)][:: 1 if side else -1]
                face = []
                for a, b in around:
                    corner = list(cell)
                    corner[axis] += side
                    corner[first] += a
                    corner[second] += b
                    face.append(corners.setdefault(tuple(corner), len(corners)))
                faces.append(tuple(face))
    return PolygonMesh.of(np.array(list(corners), dtype=np.float64), faces)


def rings(count):
    """Cubes in a plane around so many holes in a row: a body with as many handles."""
    size = 2 * count + 1
    return blocks((x, y, 0) for x in range(size) for y in range(3) if not (y == 1 and x % 2 == 1))


def tube(around, along, radius=1.0, height=3.0):
    """Quads of an upright tube that is open at both ends, facing outward."""
    angle = 2.0 * np.pi * np.arange(around) / around
    points = [
        (radius * np.cos(a), radius * np.sin(a), height * row / along)
        for row in range(along + 1)
        for a in angle
    ]
    lower = np.arange(around * along).reshape(along, around)
    after = np.roll(lower, -1, axis=1)
    quads = np.stack([lower, after, after + around, lower + around], axis=-1)
    return PolygonMesh.of(points, quads.reshape(-1, 4))


def ramp(turns, steps=24):
    """A strip that winds upwards around an axis and looks up everywhere."""
    angle = np.linspace(0.0, 2.0 * np.pi * turns, round(steps * turns) + 1)
    rows = [
        np.stack([r * np.cos(angle), r * np.sin(angle), 0.1 * angle], axis=1) for r in (2.0, 1.0)
    ]
    count = len(angle)
    return PolygonMesh.of(
        np.concatenate(rows), [(i, i + 1, count + i + 1, count + i) for i in range(count - 1)]
    )


def turned_in_space(mesh, seed=0):
    """The mesh after a random rotation and shift."""
    random = np.random.default_rng(seed)
    rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
    rotation *= np.sign(np.linalg.det(rotation))
    return mesh.with_vertices(mesh.vertices @ rotation.T + random.normal(size=3))


def without(mesh, faces):
    """The mesh without some faces."""
    return mesh.taken(np.setdiff1d(np.arange(mesh.face_count), faces)).mesh


def areas_of(mesh, parameters):
    """(t,) signed areas of the triangles in the domain."""
    a, b, c = parameters[mesh.triangulation.corners].transpose(1, 0, 2)
    (x, y), (z, w) = (b - a).T, (c - a).T
    return 0.5 * (x * w - y * z)


def assert_seams_fit(mesh, mapped):
    """Both ends of every inner edge are seen from its two sides at places that one motion of the
    domain's group takes to each other."""
    opposite, q = mesh.topology.opposite, mapped.parameters
    here = np.flatnonzero(opposite >= 0)
    there = opposite[here]
    tails, heads = q[here], q[mesh.following[here]]
    other_heads, other_tails = q[there], q[mesh.following[there]]
    periods = np.array(mapped.domain.periods)
    scale = np.where(np.isfinite(periods), periods, 1.0)
    fits = _by_motion(tails, heads, other_tails, other_heads, scale, 1.0)
    if mapped.domain.turns:
        fits |= _by_motion(tails, heads, other_tails, other_heads, scale, -1.0)
    same = np.where(np.isfinite(periods), True, np.abs(tails - other_tails) < 1e-9).all(axis=1)
    assert (fits & same).all()


def _by_motion(tails, heads, other_tails, other_heads, periods, sign):
    first, second = tails - sign * other_tails, heads - sign * other_heads
    whole = np.abs(first / periods - np.round(first / periods)) < 1e-7
    return (whole & (np.abs(first - second) < 1e-9 * periods)).all(axis=1)


def assert_similar(mesh, parameters):
    """Parameters are the corners' places up to one scale: all distances have one ratio."""
    places = mesh.vertices[mesh.corners]
    for step in (1, 2, 5):
        apart = np.linalg.norm(places - np.roll(places, step, axis=0), axis=1)
        in_plane = np.linalg.norm(parameters - np.roll(parameters, step, axis=0), axis=1)
        scale = in_plane.max() / apart.max()
        assert_allclose(in_plane, scale * apart, atol=1e-9 * in_plane.max())
