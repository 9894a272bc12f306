"""ESRI ASCII grids: a header of a few words, then heights from north to south."""

import re

import numpy as np

from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_numbers import numbers_of
from plusedit.io.mesh_text import name_of, plain_text
from plusedit.io.meshes import register
from plusedit.io.terrain import Heights, check_shape, terrain

LINE = re.compile(rb"[ \t]*([A-Za-z_]+)[ \t]+(\S+)[ \t]*\n")
MOST_LINES = 20
KEYS = ("ncols", "nrows", "cellsize", "dx", "dy", "nodata_value")
CORNERS = ("xllcorner", "yllcorner", "xllcenter", "yllcenter")
NO_DATA = -9999.0
DEGREES = 0.1  # cells of fewer units may be measured in degrees


class EsriGrid:
    """Terrains; cells without data are left open."""

    title = "ESRI ASCII grid"
    suffixes = (".asc", ".agr")

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads; degrees become meters."""
        with within(name):
            text = plain_text(data, "an ESRI ASCII grid")
            header, end = _header(text)
            heights = _heights(header, text[end:])
            latitude = heights.corner[1] + 0.5 * heights.step[1] * len(heights.values)
            if _is_in_degrees(heights):
                heights = heights.in_meters(latitude)
            return terrain(heights)


register("esri_grid")(EsriGrid())


def _header(text: bytes) -> tuple[dict[str, float], int]:
    """The numbers of the header by lower-case name, and where it ends."""
    header: dict[str, float] = {}
    at = 0
    while len(header) < MOST_LINES and (found := LINE.match(text, at)):
        key = found[1].decode().lower()
        if key == "nan":
            break
        try:
            header[key] = float(found[2])
        except ValueError:
            raise FormatError(f"{key}: {shown(name_of(found[2]))} is no number") from None
        at = found.end()
    if missing := [key for key in ("ncols", "nrows") if key not in header]:
        raise FormatError(f"does not begin as ESRI grids do: {' and '.join(missing)} missing")
    return header, at


def _heights(header: dict[str, float], text: bytes) -> Heights:
    columns, rows = (_count(header, key) for key in ("ncols", "nrows"))
    step = tuple(_positive(header, header.get(key, header.get("cellsize"))) for key in ("dx", "dy"))
    check_shape(rows, columns)
    told = f"promises {rows} × {columns} heights"
    if rows * columns > (len(text) + 1) // 2:
        raise FormatError(f"is cut off: {told}, but ends before")
    values = numbers_of(text)
    notes: tuple[str, ...] = ()
    if len(values) < rows * columns:
        raise FormatError(f"is cut off: {told}, but has {len(values)}")
    if more := len(values) - rows * columns:
        notes = (f"{of_number(more, 'number')} after the last height ignored",)
    grid = values[: rows * columns].reshape(rows, columns)
    empty = header.get("nodata_value", NO_DATA)
    grid = np.where(np.isclose(grid, empty, rtol=1e-6, atol=0.0), np.nan, grid)
    corner = [_corner(header, axis, size) for axis, size in zip("xy", step, strict=True)]
    return Heights(grid, (step[0], step[1]), (corner[0], corner[1]), notes)


def _count(header: dict[str, float], key: str) -> int:
    value = header[key]
    if not (1 <= value <= 1e9 and value.is_integer()):
        raise FormatError(f"{key}: is {value:g}")
    return int(value)


def _positive(header: dict[str, float], value: float | None) -> float:
    if value is None:
        raise FormatError("cellsize: is missing")
    if not 0.0 < value < 1e15:
        raise FormatError(f"cellsize: is {value:g}")
    return value


def _corner(header: dict[str, float], axis: str, size: float) -> float:
    """Of the height farthest to the southwest: the middle of its cell."""
    at = header.get(f"{axis}llcenter", header.get(f"{axis}llcorner", 0.0) + 0.5 * size)
    if f"{axis}llcenter" not in header and f"{axis}llcorner" not in header:
        at = 0.0
    if not abs(at) < 1e15:
        raise FormatError(f"{axis}llcorner: is {at:g}")
    return at


def _is_in_degrees(heights: Heights) -> bool:
    """Whether steps look like degrees: small, on the globe, and absurdly steep if they were not."""
    (across, up), (x, y) = heights.step, heights.corner
    rows, columns = heights.values.shape
    width, height = columns * across, rows * up
    on_globe = x >= -360.0 and x + width <= 361.0 and y >= -91.0 and y + height <= 91.0
    return on_globe and max(across, up) < DEGREES and heights.span > max(width, height)
