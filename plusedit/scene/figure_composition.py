"""A design composed into a figure: as a view shows it, or fitted to what there is."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import AXES, PlaneCamera, Projection
from plusedit.scene.captions import in_corners
from plusedit.scene.composition import LEAST_MARGIN
from plusedit.scene.drawn_surface import coarse_points
from plusedit.scene.extremes import telling
from plusedit.scene.figure import HIGHEST, Corner, Figure, FigureForm, bands, cropped, finite
from plusedit.scene.framing import extent_of, framed
from plusedit.scene.items import (
    Caption,
    Item,
    Label,
    Legend,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.label_places import label_box
from plusedit.scene.options import ViewOptions, options_of
from plusedit.scene.scene import Layers, scene_items
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_composition import camera_of_view
from plusedit.scene.space_framing import framed_in_space, in_space
from plusedit.scene.space_scene import SpaceLayers, space_items

MARGIN = LEAST_MARGIN  # pixels around what a figure is fitted to


def plane_figure(
    design: Design,
    form: FigureForm,
    *,
    camera: PlaneCamera | None = None,
    selection: Selection = NOTHING_SELECTED,
    projection: Projection | None = None,
) -> Figure:
    """The design in the plane.

    As `camera` sees it in its view, or else all of it, fitted, as the design's own plane view sees
    it or in that projection. What overlays say of the selection is there, but no selection is.
    """
    options = replace(options_of(design.view), rulers=False)
    if camera is not None:
        seen = _resized(camera, form)
        layers = _plane_layers(design, seen, options, selection)
        return _plane_figure(form, seen, options, layers, (0.0, 0.0, *seen.size))
    kept = design.view.get("camera")
    own = kept.get("projection") if isinstance(kept, dict) else None
    towards: Projection = "top"
    for wanted in (own, projection):
        if wanted in AXES:
            towards = wanted
    first = PlaneCamera(_view(form, (0.0, 0.0)), projection=towards)
    first = framed(design, first, options, margin=MARGIN, words=form.words)
    around = bands(_corners(_plane_layers(design, first, options, selection)), form)
    camera = replace(first, size=_view(form, around))
    camera = framed(design, camera, options, margin=MARGIN, words=form.words)
    layers = _plane_layers(design, camera, options, selection)
    frame = 0.0, 0.0, camera.size[0] + around[0], camera.size[1] + around[1]
    if form.height is None:
        extent = camera.to_screen(camera.placed(extent_of(layers, camera, form.words)))
        frame = cropped(camera.size, around[1], around[0], finite(extent), MARGIN)
    return _plane_figure(form, camera, options, layers, frame)


def space_figure(
    design: Design,
    form: FigureForm,
    *,
    camera: SpaceCamera | None = None,
    selection: Selection = NOTHING_SELECTED,
    view: str | None = None,
) -> Figure:
    """The design in space.

    As `camera` sees it, or else all of it, fitted, as the design's own 3D view looks or from the
    named view; KeyError for an unknown one. What overlays say of the selection is there.
    """
    options = replace(options_of(design.view), ground=design.view.get("ground") is True)
    if camera is not None:
        options = options_of(design.view)
        seen = _resized_in_space(camera, form)
        layers = _space_layers(design, seen, options, selection)
        return _space_figure(form, seen, options, layers, (0.0, 0.0, *seen.size))
    first = camera_of_view(design, _view(form, (0.0, 0.0)), view)
    first = framed_in_space(design, first, options, margin=MARGIN)
    around = bands(_corners(_space_layers(design, first, options, selection)), form)
    camera = replace(first, size=_view(form, around))
    camera = framed_in_space(design, camera, options, margin=MARGIN)
    layers = _space_layers(design, camera, options, selection)
    camera, layers, extent = _with_labels(design, camera, options, selection, layers, form)
    frame = 0.0, 0.0, camera.size[0] + around[0], camera.size[1] + around[1]
    if form.height is None:
        frame = cropped(camera.size, around[1], around[0], extent, MARGIN)
    return _space_figure(form, camera, options, layers, frame)


def _view(form: FigureForm, around: tuple[float, float]) -> tuple[float, float]:
    """Pixels for the shapes of a fitted figure, with so many left on the right and below."""
    right, below = around
    across = form.width / form.pixel
    if form.height is None:
        return across - right, HIGHEST * across
    return across - right, max(form.height / form.pixel - below, 2.0 * MARGIN)


def _resized(camera: PlaneCamera, form: FigureForm) -> PlaneCamera:
    """A camera that sees the same in a view as wide as the figure, or as much as goes in."""
    width, height = _size_like(camera.size, form)
    scale = camera.scale * min(width / camera.size[0], height / camera.size[1])
    return replace(camera, size=(width, height), scale=scale)


def _resized_in_space(camera: SpaceCamera, form: FigureForm) -> SpaceCamera:
    width, height = _size_like(camera.size, form)
    wider = (camera.size[0] / camera.size[1]) / (width / height)
    return replace(camera, size=(width, height), height=camera.height * max(1.0, wider))


def _size_like(view: tuple[float, float], form: FigureForm) -> tuple[float, float]:
    width = form.width / form.pixel
    if form.height is not None:
        return width, form.height / form.pixel
    return width, width * view[1] / view[0]


# In the plane


def _plane_layers(
    design: Design, camera: PlaneCamera, options: ViewOptions, selection: Selection
) -> Layers:
    plain = scene_items(design, camera, options)
    if not selection:
        return plain
    seen = scene_items(design, camera, options, selection, glow=False)
    return replace(seen, shapes=plain.shapes, handles=plain.handles)


def _plane_figure(
    form: FigureForm,
    camera: PlaneCamera,
    options: ViewOptions,
    layers: Layers,
    frame: tuple[float, float, float, float],
) -> Figure:
    flat = tuple(item for item in layers if not isinstance(item, Label | Legend | Caption))
    labels = tuple(item for item in layers if isinstance(item, Label))
    return Figure(form, frame, camera, options, flat, None, labels, _corners(layers))


def _corners(layers: Iterable[Item]) -> tuple[Corner, ...]:
    return in_corners(item for item in layers if isinstance(item, Legend | Caption))


# In space


def _space_layers(
    design: Design, camera: SpaceCamera, options: ViewOptions, selection: Selection
) -> SpaceLayers:
    plain = space_items(design, camera, options)
    if not selection:
        return plain
    seen = space_items(design, camera, options, selection)
    words = tuple(item for item in seen.labels if isinstance(item, Label | Legend))
    return replace(plain, labels=words, captions=seen.captions)


def _space_figure(
    form: FigureForm,
    camera: SpaceCamera,
    options: ViewOptions,
    layers: SpaceLayers,
    frame: tuple[float, float, float, float],
) -> Figure:
    labels = tuple(item for item in layers.labels if isinstance(item, Label))
    return Figure(form, frame, camera, options, (), layers, labels, _corners(layers.words()))


def _with_labels(
    design: Design,
    camera: SpaceCamera,
    options: ViewOptions,
    selection: Selection,
    layers: SpaceLayers,
    form: FigureForm,
) -> tuple[SpaceCamera, SpaceLayers, Floats]:
    """The camera so far away that labels are seen whole, too, and (m, 2) how far all reaches."""
    extent = _extent(layers, camera, form.words)
    width, height = camera.size
    room = np.array([width, height if form.height is not None else np.inf]) - 2.0 * MARGIN
    reach = np.ptp(extent, axis=0) if len(extent) else np.zeros(2)
    factor = float(np.max(reach / room, initial=1.0))
    middle = (extent.min(axis=0) + extent.max(axis=0)) / 2.0 if len(extent) else np.zeros(2)
    aside = np.array([width, height]) / 2.0 - middle if len(extent) else np.zeros(2)
    if factor <= 1.0 and np.abs(aside).max() < 1.0:
        return camera, layers, extent
    camera = camera.panned((float(aside[0]), float(aside[1])))
    camera = replace(camera, height=camera.height * factor)
    layers = _space_layers(design, camera, options, selection)
    return camera, layers, _extent(layers, camera, form.words)


def _extent(layers: SpaceLayers, camera: SpaceCamera, words: float) -> Floats:
    """(m, 2) pixels as far out as what is drawn."""
    rows = [pixels for item in layers for pixels in _reach(item, camera, words)]
    return np.concatenate([telling(finite(row)) for row in rows]) if rows else np.zeros((0, 2))


def _reach(item: Item, camera: SpaceCamera, words: float) -> Iterator[Floats]:
    match item:
        case Polyline(points) | Polygon(points) | Markers(points) | Mesh(points):
            yield camera.to_screen(in_space(points))
        case Segments(starts, ends):
            yield camera.to_screen(in_space(starts))
            yield camera.to_screen(in_space(ends))
        case Patch(surface):
            yield camera.to_screen(coarse_points(surface))
        case Label(at):
            yield camera.to_screen(in_space(at[None])) + words * label_box(item)
        case _:
            pass
