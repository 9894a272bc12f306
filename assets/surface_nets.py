"""Surfaces of bodies as meshes of quads, by surface nets.

A grid is laid over the body. Every cell that the surface passes through gets a vertex for each
sheet of it, every edge of the grid that it crosses a quad of the cells around. Vertices are then
evened out along the surface.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

import numpy as np
from bodies import AXES, Body
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh

ROUNDS = 4  # in which vertices are evened out

Numbers = NDArray[np.intp]


@dataclass(frozen=True)
class Box:
    """Where a surface is looked for."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]

    def nodes(self, step: float) -> Floats:
        """(nx, ny, nz, 3) places of a grid."""
        sides = [np.arange(a, b + step, step) for a, b in zip(self.low, self.high, strict=True)]
        return np.stack(np.meshgrid(*sides, indexing="ij"), axis=-1)


def surface(body: Body, box: Box, step: float) -> PolygonMesh:
    """The surface of a body as quads about `step` wide, which face outwards."""
    nodes = box.nodes(step)
    values = body(nodes.reshape(-1, 3)).reshape(nodes.shape[:3])
    crossed = [np.argwhere(np.diff(values < 0.0, axis=axis)) for axis in range(3)]
    vertex_of = _Sheets(values < 0.0)
    faces = np.concatenate([_quads(values, crossed[axis], axis, vertex_of) for axis in range(3)])
    places = [_crossings(nodes, values, crossed[axis], axis) for axis in range(3)]
    used, corners = np.unique(faces, return_inverse=True)
    corners = corners.reshape(-1, 4)
    around = np.repeat(np.concatenate(places), 4, axis=0)
    vertices = _means(corners.ravel(), around, len(used))
    return PolygonMesh.of_rows(np.round(_evened(body, vertices, corners, step), 5) + 0.0, corners)


class _Sheets:
    """The vertices of all cells, one for each sheet of the surface in them."""

    def __init__(self, inside: NDArray[np.bool_]) -> None:
        cells = tuple(side - 1 for side in inside.shape)
        self._cases = np.zeros(cells, dtype=np.intp)
        for corner in product((0, 1), repeat=3):
            part = tuple(slice(k, k + n) for k, n in zip(corner, cells, strict=True))
            self._cases += inside[part] << _bit(corner)

    def number(self, cells: Numbers, edge: int) -> Numbers:
        """The vertex of the sheet that crosses that edge of the cells (n, 3)."""
        flat = np.ravel_multi_index(tuple(cells.T), self._cases.shape)
        return 12 * flat + SHEETS[self._cases.ravel()[flat], edge]


def _bit(corner: tuple[int, ...]) -> int:
    return 4 * corner[0] + 2 * corner[1] + corner[2]


def _edge(axis: int, i: int, j: int) -> int:
    """The number of an edge of a cell by its axis and its place along the two others."""
    return 4 * axis + 2 * i + j


def _edges_of_faces() -> Iterator[list[tuple[int, int, int]]]:
    """Of each face of a cell its edges, each with the corners at its ends."""
    edges = []
    for axis, i, j in product(range(3), (0, 1), (0, 1)):
        low = [i, j]
        low.insert(axis, 0)
        high = [*low]
        high[axis] = 1
        edges.append((_edge(axis, i, j), tuple(low), tuple(high)))
    for across, side in product(range(3), (0, 1)):
        yield [
            (edge, _bit(low), _bit(high))
            for edge, low, high in edges
            if low[across] == high[across] == side
        ]


def _sheets() -> Numbers:
    """(256, 12) by which corners are inside: for each edge the first one of the same sheet.

    Sheets run on across faces; where four edges of a face are crossed they go around what is
    inside.
    """
    found = np.tile(np.arange(12), (256, 1))
    faces = list(_edges_of_faces())
    for case in range(256):
        for face in faces:
            crossed = [e for e in face if (case >> e[1] & 1) != (case >> e[2] & 1)]
            inner = {e[0]: e[1] if case >> e[1] & 1 else e[2] for e in crossed}
            for one, other in product(inner, inner):
                if len(inner) == 2 or inner[one] == inner[other]:
                    first, last = sorted((found[case, one], found[case, other]))
                    found[case][found[case] == last] = first
    return found


SHEETS = _sheets()


def _quads(values: Floats, crossed: Numbers, axis: int, sheets: _Sheets) -> Numbers:
    """(k, 4) vertices around each crossed edge, counterclockwise as seen from outside."""
    one, two = (other for other in range(3) if other != axis)
    steps = np.eye(3, dtype=np.intp)
    around = [(1, 1), (0, 1), (0, 0), (1, 0)]
    if axis == 1:  # its two others come in the wrong order
        around.reverse()
    cells = [(crossed - i * steps[one] - j * steps[two], _edge(axis, i, j)) for i, j in around]
    rows = np.stack([sheets.number(cell, edge) for cell, edge in cells], axis=1)
    outwards = values[tuple(crossed.T)] < 0.0
    return np.where(outwards[:, None], rows, rows[:, ::-1])


def _crossings(nodes: Floats, values: Floats, crossed: Numbers, axis: int) -> Floats:
    """(k, 3) where the surface crosses edges."""
    ends = crossed, crossed + np.eye(3, dtype=np.intp)[axis]
    (a, b), (p, q) = ([of[tuple(end.T)] for end in ends] for of in (values, nodes))
    share = (a / (a - b))[:, None]
    places: Floats = p + share * (q - p)
    return places


def _means(numbers: Numbers, values: Floats, count: int) -> Floats:
    """(count, 3) the mean of the values of each number."""
    sums = [np.bincount(numbers, values[:, k], count) for k in range(3)]
    means: Floats = np.stack(sums, axis=1) / np.bincount(numbers, minlength=count)[:, None]
    return means


def _evened(body: Body, vertices: Floats, faces: Numbers, step: float) -> Floats:
    """Vertices in the middle of those around them, but on the surface."""
    starts, ends = faces.ravel(), np.roll(faces, -1, axis=1).ravel()
    for _ in range(ROUNDS):
        vertices = _onto(body, _means(starts, vertices[ends], len(vertices)), step)
    return vertices


def _onto(body: Body, vertices: Floats, step: float) -> Floats:
    """Vertices moved onto the surface, each by less than a step."""
    nudge = 0.05 * step
    slopes = [body(vertices + nudge * a) - body(vertices - nudge * a) for a in AXES]
    slope = np.stack(slopes, axis=1) / (2.0 * nudge)
    squares = np.maximum((slope**2).sum(axis=1), 0.1)
    moves = -(body(vertices) / squares)[:, None] * slope
    moved: Floats = vertices + np.clip(moves, -0.5 * step, 0.5 * step)
    return moved
