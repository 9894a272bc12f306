"""Text with x, y and z of a point in every line, the points on a grid in x and y."""

import re

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_numbers import line_numbers
from plusedit.io.mesh_text import plain_text, without_comments
from plusedit.io.meshes import register
from plusedit.io.terrain import Heights, terrain

TITLES = re.compile(rb"\s*\"?[xX]\"?[\s,;]+\"?[yY]\"?[\s,;]+\"?\w+\"?[^\n]*\n")
SPARSEST = 8  # places of the grid for each point
AMISS = 0.1  # of a step, by which coordinates may be rounded


class XyzPoints:
    """Terrains; places of the grid without a point are left open."""

    title = "Text of x, y, z"
    suffixes = (".xyz",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads. FormatError if the points lie on no grid."""
        with within(name):
            text = without_comments(plain_text(data, "a text of points"))
            titles = TITLES.match(text)
            line = 1
            if titles:
                line, text = 1 + text.count(b"\n", 0, titles.end()), text[titles.end() :]
            table = line_numbers(text.replace(b",", b" ").replace(b";", b" "), line)
            if not len(table.counts):
                raise FormatError("has no points")
            return terrain(_heights(table.rows(0, len(table.counts), 3, "a point")))


register("xyz_points")(XyzPoints())


def _heights(points: Floats) -> Heights:
    if not np.isfinite(points[:, :2]).all() or np.abs(points[:, :2]).max() > 1e15:
        raise FormatError("has a point whose x or y is no number that can be worked with")
    axes = [_axis(points[:, axis], len(points)) for axis in range(2)]
    columns, rows = (places for places, _ in axes)
    shape = int(rows.max()) + 1, int(columns.max()) + 1
    if shape[0] * shape[1] > SPARSEST * len(points):
        raise _no_grid(points)
    values = np.full(shape, np.nan)
    filled = np.zeros(shape, dtype=np.bool_)
    values[rows, columns], filled[rows, columns] = points[:, 2], True
    again = len(points) - int(filled.sum())
    if again > len(points) // 100:
        raise _no_grid(points)
    notes = (f"{of_number(again, 'point')} at the place of another left out",) if again else ()
    (west, south), step = points[:, :2].min(axis=0), (axes[0][1], axes[1][1])
    return Heights(values[::-1], step, (float(west), float(south)), notes)


def _axis(at: Floats, count: int) -> tuple[NDArray[np.int64], float]:
    """(n,) which row or column each coordinate is in, and the step between them."""
    distinct = np.unique(at)
    gaps = np.diff(distinct)
    extent = distinct[-1] - distinct[0]
    # Rounding leaves tiny gaps beside the real ones.
    gaps = gaps[gaps > 1e-6 * extent]
    if not gaps.size:
        raise FormatError("has all its points in one line, seen from above")
    step = float(np.median(gaps[gaps <= 1.5 * gaps.min()]))
    intervals = round(extent / step)
    if intervals >= SPARSEST * count:
        raise FormatError("has points that lie on no grid in x and y, as those of a terrain do")
    step = float(extent / intervals)
    places = (at - distinct[0]) / step
    whole = np.rint(places)
    if (np.abs(places - whole) > AMISS).any():
        raise FormatError("has points that lie on no grid in x and y, as those of a terrain do")
    return whole.astype(np.int64), step


def _no_grid(points: Floats) -> FormatError:
    return FormatError(
        f"has {of_number(len(points), 'point')} that lie on no grid in x and y,"
        " as those of a terrain do"
    )
