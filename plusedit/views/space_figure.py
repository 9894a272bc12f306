"""Figures of designs in space: surfaces as pixels, lines and marks before them as vectors."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace

from PySide6.QtGui import QImage

from plusedit.scene.figure import Figure
from plusedit.scene.items import Item, Label, Legend, Markers, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.stripes import stripes_of
from plusedit.scene.theme import Theme
from plusedit.views.gl.artist import HIDDEN, Look
from plusedit.views.gl.context import context_for_pictures
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.hidden import depths_of, parted
from plusedit.views.space_picture import shaded_image

FAINT = f"@{round(100 * HIDDEN)}"


@dataclass(frozen=True, eq=False)
class DrawnFigure:
    """What the writers of files lay over each other."""

    shaded: QImage | None
    """surfaces, `resolution` pixels to an inch; None where there are none"""
    flat: tuple[Item, ...]
    """lines and marks over them, the first one farthest back"""


def drawn_figure(figure: Figure, resolution: float, *, in_pixels: bool = False) -> DrawnFigure:
    """The parts of a figure; with `in_pixels`, lines in space are drawn with the surfaces.

    OpenGLError where there is no OpenGL to draw what is in space.
    """
    layers, camera = figure.space, figure.camera
    if layers is None or not isinstance(camera, SpaceCamera):
        return DrawnFigure(None, figure.flat)
    with context_for_pictures() as gl:
        if in_pixels:
            return DrawnFigure(_shaded(gl, figure, layers, camera, resolution), ())
        flat = tuple(_vectors(gl, layers, camera, figure.form.colors))
        surfaces = SpaceLayers(layers.solids, layers.glass)
        is_bare = not (surfaces.solids or surfaces.glass or figure.options.ground)
        shaded = None if is_bare else _shaded(gl, figure, surfaces, camera, resolution)
    return DrawnFigure(shaded, flat)


def _shaded(
    gl: Functions, figure: Figure, layers: SpaceLayers, camera: SpaceCamera, resolution: float
) -> QImage:
    """The pixels of what there is of the view in the figure."""
    options = figure.options
    look = Look(
        ground=options.ground,
        shading=options.shading,
        stripes=stripes_of(options),
        transparent=figure.form.transparent,
    )
    ratio = figure.form.pixel / 25.4 * resolution
    first = round(figure.frame[1] * ratio)
    rows = range(first, first + max(1, round(figure.shaded_size[1] * ratio)))
    return shaded_image(gl, layers, camera, figure.form.colors, look, ratio, rows)


def _vectors(
    gl: Functions, layers: SpaceLayers, camera: SpaceCamera, theme: Theme
) -> Iterator[Item]:
    """What is seen of lines, and handles: those behind surfaces are faint."""
    if not layers.solids:
        yield from (*layers.lines, *layers.handles)
        return
    depths = depths_of(gl, layers.solids, camera)
    yield from parted(layers.lines, depths)[0]
    seen, hidden = parted(layers.handles, depths)
    yield from _fainter(hidden, theme)
    yield from seen


def _fainter(items: Iterable[Item], theme: Theme) -> Iterator[Item]:
    def faint(color: str) -> str:
        return theme.color(color) + FAINT

    for item in items:
        match item:
            case Polyline() | Segments():
                yield replace(item, color=faint(item.color))
            case Markers():
                fill = faint("canvas" if item.fill is None else item.fill)
                yield replace(item, outline=faint(item.outline), fill=fill)
            case Polygon():
                yield replace(item, fill=faint(item.fill))
            case Label() | Legend():
                pass
            case _:
                yield item
