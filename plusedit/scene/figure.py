"""Figures for print: a design composed at a width in millimeters, with words of a size in points.

Lines, marks and handles are laid out in logical pixels, as everywhere; how large a pixel is follows
from how thick a curve is to be in print. Words have a size of their own.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import isfinite
from typing import TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.captions import placed_caption
from plusedit.scene.items import Caption, Item, Label, Legend
from plusedit.scene.legends import MARGIN as ASIDE
from plusedit.scene.legends import WORDS, placed
from plusedit.scene.options import ViewOptions
from plusedit.scene.shapes import WIDTH
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.theme import THEMES, Theme

POINT = 25.4 / 72.0  # millimeters
PAPER = "#FFFFFF"
HIGHEST = 1.6  # widths: how high a figure becomes that is fitted to what it shows
MOST_ASIDE = 0.4  # of the width that a legend may have beside the shapes
MOST_BELOW = 0.5  # of a height that is given, for a legend below the shapes
HUGE = 1e5  # pixels: room for every legend
RANGES = {"width": (10.0, 2000.0), "height": (5.0, 2000.0), "text": (2.0, 72.0), "line": (0.1, 20)}
UNITS = {"width": "mm", "height": "mm", "text": "pt", "line": "pt"}

Corner: TypeAlias = Legend | Caption


@dataclass(frozen=True)
class FigureForm:
    """How large a figure is, and what is in it. ValueError, in a sentence, where that can't be."""

    width: float = 85.0
    """millimeters; what a column of a journal has"""
    height: float | None = None
    """millimeters; None: as high as what is shown needs"""
    text: float = 8.0
    """points, the size of usual words"""
    line: float = 1.0
    """points, the width of a curve that has none of its own"""
    theme: str = "light"
    transparent: bool = False

    def __post_init__(self) -> None:
        for name, (least, most) in RANGES.items():
            value = getattr(self, name)
            if value is not None and not (isfinite(value) and least <= value <= most):
                unit = UNITS[name]
                raise ValueError(
                    f"The {name} of a figure is {least:g} to {most:g} {unit}, not {value:g}."
                )

    @property
    def pixel(self) -> float:
        """Millimeters to a logical pixel."""
        return self.line / WIDTH * POINT

    @property
    def words(self) -> float:
        """How many times as large as in a window words are, beside lines."""
        return self.text * POINT / (WORDS * self.pixel)

    @property
    def colors(self) -> Theme:
        """The theme, on white paper where it is the light one."""
        theme = THEMES[self.theme]
        if theme.name != "light":
            return theme
        return replace(theme, colors={**theme.colors, "canvas": PAPER})


@dataclass(frozen=True, eq=False)
class Figure:
    """What a figure shows."""

    form: FigureForm
    frame: tuple[float, float, float, float]
    """left, top, width and height of the figure, in pixels of the camera's view"""
    camera: PlaneCamera | SpaceCamera
    options: ViewOptions
    flat: tuple[Item, ...]
    """what is drawn in the plane, the first item farthest back; empty where `space` is not"""
    space: SpaceLayers | None
    labels: tuple[Label, ...]
    """in front of all else, `form.words` times as large as they say"""
    corners: tuple[Corner, ...]
    """in corners of the figure, as much larger"""

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in millimeters."""
        return self.form.width, self.frame[3] * self.form.pixel

    def pixels(self, resolution: float) -> tuple[int, int]:
        """Width and height in pixels, so many of them to an inch."""
        width, height = (max(1, round(side / 25.4 * resolution)) for side in self.size)
        return width, height

    @property
    def shaded_size(self) -> tuple[float, float]:
        """Width and height of what there is of the camera's view in the figure, in its pixels."""
        _, top, _, height = self.frame
        return self.camera.size[0], min(top + height, self.camera.size[1]) - top

    @property
    def label_camera(self) -> PlaneCamera | SpaceCamera:
        """The camera whose pixels are those of words."""
        words, camera = self.form.words, self.camera
        size = camera.size[0] / words, camera.size[1] / words
        if isinstance(camera, PlaneCamera):
            return replace(camera, size=size, scale=camera.scale / words)
        return replace(camera, size=size)

    @property
    def corner_camera(self) -> PlaneCamera:
        """A camera whose view is the figure, in pixels of words."""
        return PlaneCamera(self.corner_size)

    @property
    def corner_size(self) -> tuple[float, float]:
        """Width and height of the figure in pixels of words."""
        return self.frame[2] / self.form.words, self.frame[3] / self.form.words


def bands(corners: Sequence[Corner], form: FigureForm) -> tuple[float, float]:
    """What legends need beside the shapes, and captions below them: pixels to the right, below.

    A legend that would take too much of the width stands below them, too; or before them, where the
    height is given and would be gone.
    """
    across = form.width / form.pixel
    right = below = 0.0
    for item in corners:
        if isinstance(item, Legend):
            legend = placed(item, (across / form.words, HUGE), 0.0)
            if legend is not None:
                right = (legend.box[2] + ASIDE) * form.words
                if right > MOST_ASIDE * across:
                    right, below = 0.0, _below(legend.box[3], form, below)
        elif (caption := placed_caption(item, (HUGE, HUGE))) is not None:
            below = max(below, (caption.box[3] + item.at[1] + ASIDE) * form.words)
    return right, below


def _below(legend: float, form: FigureForm, captions: float) -> float:
    """What a legend so high leaves of a figure for itself and captions."""
    needed = (legend + ASIDE) * form.words
    if form.height is not None and needed > MOST_BELOW * form.height / form.pixel:
        return captions
    return max(captions, needed)


def cropped(
    view: tuple[float, float], below: float, right: float, extent: Floats, margin: float
) -> tuple[float, float, float, float]:
    """The frame as high as the extent (m, 2) of what is seen in a view, and what stands beside."""
    across = view[0] + right
    if not len(extent):
        return 0.0, 0.0, across, view[1] + below
    low, high = extent[:, 1].min(), extent[:, 1].max()
    top = max(0.0, float(low) - margin)
    bottom = min(view[1], float(high) + margin)
    return 0.0, top, across, max(bottom - top, 2.0 * margin) + below


def finite(points: Floats) -> Floats:
    """The points (m, 2) that are somewhere."""
    found: Floats = points[np.isfinite(points).all(axis=1)]
    return found
