"""PNG pictures whose gray, or whose color by an agreed formula, is a height."""

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content
from plusedit.io.meshes import register
from plusedit.io.png_reading import SIGNATURE, Pixels, read_png
from plusedit.io.terrain import of_unknown_distances, skip_of, skipped, terrain

HIGHEST_RED = 3  # of Terrain-RGB up to 9600 m, which is above all mountains
TERRARIUM_RED = (81, 163)  # of Terrarium from -12000 to 9000 m
COARSE = "the picture has 8 bits: its heights are steps of a staircase"
SMOOTH = 128.0  # meters that neighbors differ by at most, in the middle of all


class PngHeights:
    """Terrains: gray of 16 or 8 bits, or colors as Terrain-RGB or Terrarium tiles have them."""

    title = "Picture of heights"
    suffixes = (".png",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads, as wide as suits them: pictures say no distances."""
        with within(name):
            if not data.startswith(SIGNATURE):
                check_content(data, "a PNG picture")
            picture = read_png(data)
            every, shape = skip_of(picture.pixels.shape), picture.pixels.shape
            notes = [skipped(shape)] if every > 1 else []
            values, note = _heights(picture.pixels[::every, ::every], picture.has_alpha)
            return terrain(of_unknown_distances(values, (*notes, *note)))


register("png_heights")(PngHeights())


def _heights(raw: Pixels, has_alpha: bool) -> tuple[Floats, list[str]]:
    """(rows, columns) heights, nan where nothing is, and what to say of them."""
    pixels = raw.astype(np.float64)
    colors = pixels[:, :, :-1] if has_alpha else pixels
    if (colors == colors[:, :, :1]).all():
        values = colors[:, :, 0].copy()
        note = [COARSE] if raw.dtype == np.uint8 else []
    elif raw.dtype == np.uint8:
        values, note = _coded(colors)
    else:
        raise _colorful()
    if has_alpha:
        values[pixels[:, :, -1] == 0.0] = np.nan
    return values, note


def _coded(colors: Floats) -> tuple[Floats, list[str]]:
    """Meters, from the two formulas in use for tiles of maps."""
    red, green, blue = np.moveaxis(colors, 2, 0)
    if red.max() <= HIGHEST_RED:
        values = -10000.0 + 0.1 * (65536.0 * red + 256.0 * green + blue)
        return values, ["colors were read as Terrain-RGB: tenths of a meter"]
    values = 256.0 * red + green + blue / 256.0 - 32768.0
    low, high = TERRARIUM_RED
    if low <= red.min() and red.max() <= high and _is_smooth(values):
        return values, ["colors were read as Terrarium: meters"]
    raise _colorful()


def _is_smooth(values: Floats) -> bool:
    """Whether neighbors are of about the same height, as they are not in photographs."""
    steps: NDArray[np.float64] = np.abs(np.diff(values, axis=1))
    return not steps.size or float(np.median(steps)) < SMOOTH


def _colorful() -> FormatError:
    return FormatError("is a picture in color; heights are gray, or coded as Terrain-RGB")
