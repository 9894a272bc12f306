"""Faces in a view of the parameters: what their colors stand for, and the pixels in these colors.

Faces that the map leaves as they are stay pale, so that those it stretches, those that are turned
over, and those that are selected stand out. Faces that are turned over are striped as well.
"""

from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.distortion import Stretch
from plusedit.scene.color_scale import SCALES, ColorScale
from plusedit.scene.items import Legend
from plusedit.scene.parameter_raster import FaceRaster, rims_of
from plusedit.scene.parameter_sheet import ParameterSheet
from plusedit.scene.theme import DARK, Theme

Measure: TypeAlias = Literal["angles", "areas"]
Pixels: TypeAlias = NDArray[np.uint32]
"""Alpha, red, green and blue, eight bits each, from the highest."""

MEASURES: dict[Measure, str] = {"angles": "Stretch of angles", "areas": "Stretch of areas"}
SHADES = 33  # colors that a legend is drawn with
MOST = 4.0  # of lengths to each other: what is stretched more looks alike
DECADES = 2.0  # of areas, both ways
LOUD = "#E6007A"  # faces turned over
STRIPES = 6  # pixels from one to the next
FAR = 0.62  # of the canvas in the color of images of faces
CHOSEN = 0.5  # of the color of the selection in that of selected faces
LINE = 0.4  # of the color of lines in that of faces' outlines
SMALL, LARGE = 3.0, 14.0  # pixels: faces without an outline, and those with a full one

# Near the ground where nothing is stretched; on a bright one the usual scale does that.
_ON_BRIGHT = SCALES["diverging"]
_ON_DARK = ColorScale(("#9CC8F5", "#4A7FB5", "#343A45", "#B5692B", "#FFC07A"), is_diverging=True)


def shares(measure: Measure, stretch: Stretch) -> Floats:
    """(f,) how far along its scale each face lies, from 0 to 1."""
    if measure == "angles":
        found: Floats = np.log(np.minimum(stretch.angles, MOST)) / np.log(MOST)
        return found
    with np.errstate(divide="ignore"):
        decades = np.log10(stretch.areas)
    return np.clip(0.5 + decades / (2.0 * DECADES), 0.0, 1.0)


def scale_of(measure: Measure, theme: Theme) -> ColorScale:
    """The colors for those shares."""
    both = _ON_DARK if theme.name == DARK.name else _ON_BRIGHT
    return both if measure == "areas" else ColorScale(both.colors[2:])


def legend_of(measure: Measure, stretch: Stretch, theme: Theme) -> Legend:
    """What the colors stand for."""
    if measure == "angles":
        marks = [(value, f"{value:g}") for value in (1.0, 1.5, 2.0, 3.0, 4.0)]
        ticks = tuple((float(np.log(v) / np.log(MOST)), text) for v, text in marks)
        is_open = False, bool((stretch.angles > MOST).any())
    else:
        texts = ("1/100", "1/10", "1", "10", "100")
        ticks = tuple((k / 4.0, text) for k, text in enumerate(texts))
        low, high = 10.0**-DECADES, 10.0**DECADES
        is_open = bool((stretch.areas < low).any()), bool((stretch.areas > high).any())
    return Legend(
        title=MEASURES[measure],
        unit="",
        colors=scale_of(measure, theme).hexadecimal(SHADES),
        ticks=ticks,
        is_open=is_open,
    )


@dataclass(frozen=True, eq=False)
class FaceColors:
    """What faces look like before any is selected."""

    faces: Floats
    """(f, 3) red, green and blue, 0 to 1"""
    theme: Theme

    @classmethod
    def of(cls, sheet: ParameterSheet, measure: Measure, theme: Theme) -> "FaceColors":
        """The faces of a sheet colored by that."""
        scale = scale_of(measure, theme)
        return cls(scale.at(shares(measure, sheet.stretch)).astype(np.float64), theme)


def painted(
    raster: FaceRaster, sheet: ParameterSheet, colors: FaceColors, chosen: NDArray[np.intp]
) -> Pixels:
    """(h, w) the faces that a raster shows, those in `chosen` as selected; clear beside them."""
    fills, lines = _palettes(sheet, colors, chosen, raster.camera.scale)
    numbers, rims = raster.numbers, raster.rims
    pixels = fills[numbers]
    pixels[rims] = lines[numbers[rims]]
    if sheet.flips:
        _stripe(pixels, np.append(np.tile(sheet.flipped, 2), False)[numbers])
    if len(chosen):
        is_chosen = np.zeros(2 * sheet.face_count + 1, dtype=np.bool_)
        is_chosen[chosen] = is_chosen[chosen + sheet.face_count] = True
        accent = _rgb(colors.theme.color("selected"))
        pixels[rims_of(is_chosen[numbers])] = _words(accent[None])[0]
    return pixels


def _palettes(
    sheet: ParameterSheet, colors: FaceColors, chosen: NDArray[np.intp], scale: float
) -> tuple[Pixels, Pixels]:
    """(2 f + 1,) of the numbers in a raster the colors of faces, and those of their outlines."""
    canvas, line, accent, loud = (
        _rgb(colors.theme.color(role)) for role in ("canvas", "line", "selected", LOUD)
    )
    near = colors.faces.copy()
    near[sheet.flipped] = loud
    near[chosen] += CHOSEN * (accent - near[chosen])
    faces = np.concatenate([near, near + FAR * (canvas - near)])
    wide = np.tile(sheet.sizes * scale, 2)[:, None]
    strength = LINE * np.clip((wide - SMALL) / (LARGE - SMALL), 0.0, 1.0)
    strength[sheet.face_count :] *= 1.0 - FAR
    lined = faces + strength * (line - faces)
    fills, lines = (np.append(_words(rows), np.uint32(0)) for rows in (faces, lined))
    return fills, lines


def _stripe(pixels: Pixels, where: NDArray[np.bool_]) -> None:
    row, column = np.nonzero(where)
    striped = (row + column) % STRIPES < STRIPES // 3
    pixels[row[striped], column[striped]] = 0xFFFFFFFF


def _rgb(color: str) -> Floats:
    return np.array([int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5)])


def _words(rgb: Floats) -> Pixels:
    """(n,) opaque pixels of colors (n, 3)."""
    red, green, blue = np.rint(255.0 * np.clip(rgb, 0.0, 1.0)).astype(np.uint32).T
    words: Pixels = np.uint32(0xFF000000) | (red << 16) | (green << 8) | blue
    return words
