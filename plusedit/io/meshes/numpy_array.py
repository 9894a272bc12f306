"""NumPy files: an array of heights, in .npz with its distances beside it."""

from collections.abc import Mapping

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import doubles
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content
from plusedit.io.meshes import register
from plusedit.io.npy_reading import MAGIC, Array, read_npy, read_npz
from plusedit.io.terrain import Heights, check_shape, of_unknown_distances, terrain

NAMES = ("elevation", "elevations", "heights", "height", "dem", "z")
ZIP = b"PK"
DEGREES = 0.1  # steps below may be degrees


class NumpyArray:
    """Terrains: rows from north to south; what is not finite is left open."""

    title = "NumPy array"
    suffixes = (".npy", ".npz")

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads."""
        with within(name):
            if data.startswith(ZIP):
                return terrain(_of_arrays(read_npz(data)))
            if not data.startswith(MAGIC):
                check_content(data, "a NumPy array")
            return terrain(of_unknown_distances(_values(read_npy(data))))


register("numpy_array")(NumpyArray())


def _of_arrays(arrays: Mapping[str, Array]) -> Heights:
    grids = {name: array for name, array in arrays.items() if array.ndim == 2 and array.size > 1}
    if not grids:
        raise FormatError("holds no array of rows and columns")
    largest = max(grids, key=lambda name: grids[name].size)
    values = _values(grids[next((name for name in NAMES if name in grids), largest)])
    dx, dy = (_number(arrays, name) for name in ("dx", "dy"))
    if dx is None:
        dx = dy = _number(arrays, "cellsize")
    if not (dx and dy):
        return of_unknown_distances(values)
    heights = Heights(values, (abs(dx), abs(dy)))
    rows, columns = values.shape
    steep = heights.span > max(columns * abs(dx), rows * abs(dy))
    south, north = (_number(arrays, name) for name in ("ymin", "ymax"))
    if max(abs(dx), abs(dy)) < DEGREES and steep and south is not None and abs(south) <= 90.0:
        return heights.in_meters(0.5 * (south + (south if north is None else north)))
    return heights


def _number(arrays: Mapping[str, Array], name: str) -> float | None:
    """The one number of an array of that name, if it is there and finite."""
    array = arrays.get(name)
    if array is None or array.size != 1 or not np.isfinite(array).all():
        return None
    return float(array.reshape(()))


def _values(array: Array) -> Floats:
    if array.ndim == 3 and 1 in array.shape:
        array = array.squeeze()
    if array.ndim != 2:
        shape = " × ".join(map(str, array.shape)) or "one number"
        raise FormatError(f"is an array of {shape}; heights have rows and columns")
    check_shape(*array.shape)
    return doubles(array)
