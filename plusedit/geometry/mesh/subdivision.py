"""Faces split into smaller ones of the same shape, without smoothing.

A triangle falls into four by the middles of its sides, a polygon of k > 3 corners into k quads
around its center. Values by corner, such as surface parameters, go along: a middle has the mean of
two corners of its own face, a center that of all.
"""

from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import MOST, Indices, Numbers, PolygonMesh, fixed, rows_of
from plusedit.geometry.mesh.topology import shared_edges


@dataclass(frozen=True, eq=False)
class Round:
    """Every face split once.

    New corners lie at places of the c old corners, then of the middles of the c half-edges, then
    of the f centers.
    """

    before: PolygonMesh
    mesh: PolygonMesh
    parents: Numbers
    """(f',) the face in which each new face lies, ascending"""
    places: Indices
    """(c',) of the new corners"""

    def along(self, values: Floats) -> Floats:
        """(c', k) what values (c, k) by old corner are at the new ones."""
        middles = 0.5 * (values + values[self.before.following])
        centers = self.before.sums(values) / self.before.sizes[:, None]
        moved: Floats = np.concatenate([values, middles, centers])[self.places]
        return moved


@dataclass(frozen=True, eq=False)
class Subdivided:
    """A mesh with every face split some times."""

    mesh: PolygonMesh
    """vertices of the mesh before keep their numbers, new ones follow"""
    parents: Numbers
    """(f',) the face of the mesh before in which each face lies, ascending"""
    rounds: tuple[Round, ...]
    """one after the other"""

    def along(self, values: Floats) -> Floats:
        """(c', k) what values (c, k) by corner of the mesh before are at the corners now."""
        for step in self.rounds:
            values = step.along(values)
        return values


def subdivided(mesh: PolygonMesh, times: int) -> Subdivided:
    """The mesh with every edge halved `times` times.

    ValueError where `times` is negative or there would be more corners than can be numbered.
    """
    if times < 0:
        raise ValueError(f"subdivided: expected 0 or more times, got {times}")
    if times > 16 or len(mesh.corners) * 4**times > MOST:
        raise ValueError(f"subdivided: {mesh.face_count} faces split {times} times are too many")
    parents, rounds = np.arange(mesh.face_count, dtype=np.int32), []
    for _ in range(times):
        rounds.append(_split_once(mesh))
        mesh, parents = rounds[-1].mesh, parents[rounds[-1].parents]
    return Subdivided(mesh, fixed(parents), tuple(rounds))


def _split_once(mesh: PolygonMesh) -> Round:
    count = len(mesh.corners)
    shared = shared_edges(mesh.corners, mesh.following, mesh.vertex_count)
    edges = np.empty(count, dtype=np.intp)
    edges[shared.corners] = np.repeat(np.arange(len(shared.counts)), shared.counts)
    one = shared.corners[shared.firsts]
    ends = mesh.vertices[mesh.corners[one]], mesh.vertices[mesh.corners[mesh.following[one]]]
    around = np.flatnonzero(mesh.sizes > 3)
    center_of = np.cumsum(mesh.sizes > 3) - 1 + mesh.vertex_count + len(one)
    vertices = np.concatenate([mesh.vertices, 0.5 * (ends[0] + ends[1]), mesh.centers[around]])
    numbers = np.concatenate([mesh.corners, mesh.vertex_count + edges, center_of])
    places, starts, parents = _children(mesh)
    split = PolygonMesh(vertices, numbers[places].astype(np.int32), starts)
    return Round(mesh, split, fixed(parents), fixed(places))


def _children(mesh: PolygonMesh) -> tuple[Indices, Numbers, Numbers]:
    """The places of the corners of all new faces, where each begins, and (f',) their parents."""
    count = len(mesh.corners)
    corner, owners = np.arange(count), mesh.owners
    middle, middle_before, center = count + corner, count + mesh.preceding, 2 * count + owners
    quads = mesh.sizes[owners] > 3
    tips = np.stack([corner, middle, middle_before], axis=1)[~quads]
    inner = middle[~quads].reshape(-1, 3)
    rings = np.stack([corner, middle, center, middle_before], axis=1)[quads]
    parents = np.concatenate([owners[~quads], owners[~quads][::3], owners[quads]])
    faces = np.argsort(parents, kind="stable")
    sizes = np.repeat([3, 4], [len(tips) + len(inner), len(rings)])
    order, starts = rows_of(sizes, faces)
    places = np.concatenate([tips.ravel(), inner.ravel(), rings.ravel()])[order]
    return places.astype(np.intp), starts, parents[faces]
