"""Heights over a grid become a mesh of quads, open where a height is not known."""

from dataclasses import dataclass, field
from math import ceil, cos, radians, sqrt

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import LARGEST
from plusedit.io.mesh_file import MeshFile, Numbers

LARGEST_GRID = 1 << 26  # heights that are looked at
MOST = 1_000_000  # heights of a mesh; of more, rows and columns are skipped evenly
METERS = 111_195.0  # of one degree on a sphere of 6371 km
WIDE = 4.0  # a terrain of unknown distances is so many times as wide as high


@dataclass(frozen=True, eq=False)
class Heights:
    """Heights over a grid, as a file has them."""

    values: Floats
    """(rows, columns) from north to south and from west to east; not finite where unknown"""
    step: tuple[float, float]
    """from column to column in x, from row to row in y; both positive"""
    corner: tuple[float, float] = (0.0, 0.0)
    """x and y of the height that is farthest to the southwest"""
    notes: tuple[str, ...] = field(default=())

    def in_meters(self, latitude: float, why: str = "") -> "Heights":
        """The same where steps are degrees, seen from that latitude."""
        across, up = self.step
        step = across * METERS * max(cos(radians(latitude)), 0.01), up * METERS
        note = f"degrees were turned into meters as at latitude {latitude:.4g}{why}"
        return Heights(self.values, step, notes=(*self.notes, note))

    @property
    def span(self) -> float:
        """The difference between the highest and the lowest height."""
        known = np.isfinite(self.values)
        if not known.any():
            return 0.0
        highest = self.values.max(where=known, initial=-np.inf)
        return float(highest - self.values.min(where=known, initial=np.inf))


def of_unknown_distances(values: Floats, notes: tuple[str, ...] = ()) -> Heights:
    """Heights (rows, columns) whose steps are chosen so that the terrain is seen as one."""
    span = Heights(values, (1.0, 1.0)).span
    step = WIDE * span / max(*values.shape, 1) or 1.0
    told = f"the file says no distances: heights were set {step:.4g} apart"
    shape = f", {WIDE:g} times as wide as high" if span else ""
    return Heights(values, (step, step), notes=(*notes, told + shape))


def check_shape(rows: int, columns: int) -> None:
    """FormatError if a grid has too few places for a terrain, or more than can be worked with."""
    if rows < 2 or columns < 2:
        raise FormatError(f"has {rows} × {columns} heights; a terrain needs two rows and columns")
    if rows * columns > LARGEST_GRID:
        raise FormatError(
            f"has {rows} × {columns} heights; up to {LARGEST_GRID >> 20} million are read"
        )


def skip_of(shape: tuple[int, ...]) -> int:
    """Every how many-th row and column of a grid is taken."""
    return ceil(sqrt(shape[0] * shape[1] / MOST))


def skipped(shape: tuple[int, ...]) -> str:
    """The note that says how many rows and columns of a large grid are left out."""
    every = skip_of(shape)
    ordinal = {2: "2nd", 3: "3rd"}.get(every, f"{every}th")
    return f"of {shape[0]} × {shape[1]} heights every {ordinal} row and column was taken"


def terrain(heights: Heights) -> MeshFile:
    """The mesh of a grid, z up, faces counterclockwise from above. FormatError if it has no face.

    x and y begin with 0 at the southwest: coordinates of a whole country would leave single
    precision, in which meshes are drawn, no digits for the grid.
    """
    values, (across, up) = heights.values, heights.step
    check_shape(*values.shape)
    notes = list(heights.notes)
    if any(heights.corner):
        west, south = heights.corner
        notes.append(f"x and y are counted from the corner at {west:.10g}, {south:.10g}")
    if (every := skip_of(values.shape)) > 1:
        notes.append(skipped(values.shape))
        # The last row is to the south, where y begins.
        values, across, up = values[::-every][::-1, ::every], across * every, up * every
    _check(values, across, up)
    known: NDArray[np.bool_] = np.isfinite(values)
    if unknown := int((~known).sum()):
        have = "has" if unknown == 1 else "have"
        notes.append(f"{unknown} of {values.size} places {have} no height and are left open")
    mesh = _mesh(values, known, across, up)
    return MeshFile(mesh, is_height_field=True, notes=tuple(notes))


def _mesh(values: Floats, known: NDArray[np.bool_], across: float, up: float) -> PolygonMesh:
    quads = _quads(known)
    if not len(quads):
        raise FormatError("has no four neighboring heights that are known")
    used = np.zeros(values.size, dtype=np.bool_)
    used[quads] = True
    rows, columns = np.divmod(np.flatnonzero(used), values.shape[1])
    places = columns * across, (values.shape[0] - 1 - rows) * up
    points = np.stack([*places, values.ravel()[used]], axis=1)
    renumbered = np.cumsum(used, dtype=np.int32) - 1
    return PolygonMesh.of_rows(points, renumbered[quads])


def _check(values: Floats, across: float, up: float) -> None:
    largest = np.abs(values, where=np.isfinite(values), out=np.zeros_like(values)).max()
    if largest > LARGEST:
        raise FormatError(
            f"has a height of size {largest:.3g}; more than {LARGEST:g} can't be worked with"
        )
    rows, columns = values.shape
    if not (min(across, up) > 0.0 and max(columns * across, rows * up) <= LARGEST):
        raise FormatError(f"has steps of {across:g} and {up:g}")


def _quads(known: NDArray[np.bool_]) -> Numbers:
    """(q, 4) places of the corners of cells whose four heights are known."""
    cells = known[1:, :-1] & known[1:, 1:] & known[:-1, 1:] & known[:-1, :-1]
    rows, columns = np.nonzero(cells)
    northwest = (rows * known.shape[1] + columns).astype(np.int32)
    southwest = northwest + np.int32(known.shape[1])
    return np.stack([southwest, southwest + 1, northwest + 1, northwest], axis=1)
