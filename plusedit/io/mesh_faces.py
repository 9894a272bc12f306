"""Quads and triangles of a grid of points, without those that have no area.

The four corners of a cell run a, b, c, d around it: up by u, then up by v, seen from the side to
which the normal points counterclockwise.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

Numbers = NDArray[np.int64]

THIN = 1e-12  # a height of that, by the longest side, is none
CLEARLY = 1.001  # rounding alone shall not change the pattern of diagonals


@dataclass(frozen=True, eq=False)
class Faces:
    """Corners of faces, as numbers of points."""

    points: Floats
    """(n, 3) of a size that areas can be calculated with"""
    quads: Numbers
    """(q, 4)"""
    triangles: Numbers
    """(t, 3)"""
    others: Numbers | None = None
    """(p, k) polygons of k > 4 corners, which a mesh has cut itself where triangles are wanted"""

    @classmethod
    def of_size(cls, points: Floats, corners: Numbers) -> "Faces":
        """Faces (f, k) of k corners each."""
        quads, triangles = np.empty((0, 4), np.int64), np.empty((0, 3), np.int64)
        match corners.shape[1]:
            case 3:
                return cls(points, quads, corners)
            case 4:
                return cls(points, corners, triangles)
            case _:
                return cls(points, quads, triangles, corners)

    def cut(self) -> Numbers:
        """(2 q + t, 3) with every quad cut along the diagonal that gives the fuller triangles."""
        a, b, c, d = self.quads.T
        one = np.stack([[a, b, c], [a, c, d]])
        other = np.stack([[a, b, d], [b, c, d]])
        doubled = [
            np.minimum(*(_doubled_areas(self.points[half.T]) for half in halves))
            for halves in (one, other)
        ]
        halves = np.where(doubled[1] > CLEARLY * doubled[0], other, one)
        return np.concatenate([*halves.transpose(0, 2, 1), self.triangles])


def cells(first: int, last: int, columns: int) -> Numbers:
    """(k, 4) the corners of the cells between rows `first` and `last` of a grid."""
    rows = np.arange(first, last)[:, None] * columns
    a = (rows + np.arange(columns - 1)).ravel()
    return np.stack([a, a + columns, a + columns + 1, a + 1], axis=1)


def faces_of(points: Floats, corners: Numbers) -> Faces:
    """What is left of those cells (k, 4) where corners meet."""
    at = points[corners]
    meets = (at == np.roll(at, -1, axis=1)).all(axis=2)
    crossed = (at[:, 0] == at[:, 2]).all(axis=1) | (at[:, 1] == at[:, 3]).all(axis=1)
    lost = meets.sum(axis=1)
    quads = corners[(lost == 0) & ~crossed]
    three, merged = (lost == 1) & ~crossed, meets.argmax(axis=1)
    triangles = corners[three][np.arange(4) != merged[three][:, None]].reshape(-1, 3)
    wide = np.maximum(*(_width(points[quads[:, half]]) for half in ([0, 1, 2], [0, 2, 3]))) > THIN
    return Faces(points, quads[wide], triangles[_width(points[triangles]) > THIN])


def _doubled_areas(at: Floats) -> Floats:
    """(k,) of triangles (k, 3, 3)."""
    across = np.cross(at[:, 1] - at[:, 0], at[:, 2] - at[:, 0])
    areas: Floats = np.sqrt(np.einsum("kd,kd->k", across, across))
    return areas


def _width(at: Floats) -> Floats:
    """(k,) of triangles (k, 3, 3) the height over the longest side, divided by that side."""
    sides = at - np.roll(at, 1, axis=1)
    squares: Floats = np.einsum("kcd,kcd->kc", sides, sides).max(axis=1)
    areas = _doubled_areas(at)
    return np.divide(areas, squares, out=np.zeros_like(areas), where=squares > 0.0)
