"""A design as items to draw in space, in layers: solids, what is seen through, lines, handles.

This is the one place that says how a design looks in 3D; windows and pictures draw what comes from
here. Items are the same objects as before while what they show stays as it is.
"""

from collections.abc import Collection, Iterable, Iterator
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias
from weakref import WeakValueDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import PlusGeometry, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.arrows import direction_arrow
from plusedit.scene.captions import stacked
from plusedit.scene.color_scale import Colors
from plusedit.scene.coloring import (
    NO_TINTS,
    Tints,
    coloring_overlay,
    tinted,
)
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import Grids, surface_grids
from plusedit.scene.face_outlines import face_fill
from plusedit.scene.gizmo import gizmo_items, gizmo_of
from plusedit.scene.items import Caption, Item, Label, Legend, Mesh, Patch, Polygon
from plusedit.scene.label_places import uncrowded
from plusedit.scene.map_values import values_of
from plusedit.scene.mesh_shapes import darker, mesh_items_in_space
from plusedit.scene.options import ViewOptions
from plusedit.scene.shapes import (
    DIM,
    curve_items,
    design_overlay_items,
    handle_items,
    is_finite,
    overlay_items,
    shown_meshes,
    shown_shapes,
    surface_line_items,
)
from plusedit.scene.space_camera import SpaceCamera

WIRE = "line@30"

Solid: TypeAlias = Patch | Mesh
Area: TypeAlias = Patch | Mesh | Polygon


@dataclass(frozen=True, eq=False)
class SpaceLayers:
    """What to draw in space."""

    solids: tuple[Solid, ...] = ()
    """opaque; they hide each other and all that follows but labels by depth"""
    glass: tuple[Area, ...] = ()
    """what is seen through, in any order: hulls, ghosts, locked surfaces"""
    lines: tuple[Item, ...] = ()
    """curves, lines on surfaces and marks"""
    handles: tuple[Item, ...] = ()
    """control lines and planes, the first one farthest back: in front of all else, the hidden ones
    fainter"""
    labels: tuple[Item, ...] = ()
    """in front of everything, the first one farthest back: words, and what moves the selection"""
    captions: tuple[Caption, ...] = ()
    """all in the same place: they are yet to be stacked"""

    def __iter__(self) -> Iterator[Item]:
        return chain(self.solids, self.glass, self.lines, self.handles, self.words())

    def words(self, more: Iterable[Caption] = ()) -> Iterator[Item]:
        """The labels, and all captions stacked, with more of them."""
        return chain(self.labels, stacked([*self.captions, *more]))


def space_items(
    design: Design,
    camera: SpaceCamera,
    options: ViewOptions,
    selection: Selection = NOTHING_SELECTED,
    *,
    draft: bool = False,
    wait: bool = True,
    hurried: bool = False,
    only: Collection[ShapeId] | None = None,
) -> SpaceLayers:
    """How `design` looks in space; with `only`, how those shapes of it do.

    With `draft` surfaces are coarser; without `wait` those of meshes are as they are known by now.
    While an edit is going on (`hurried`) overlays leave for later what takes its time.
    What is too large to be calculated with is left out.
    """
    shown = shown_shapes(design, only)
    solids: list[Solid] = []
    glass: list[Area] = []
    lines: list[Item] = []
    labels: list[Item] = []
    captions: list[Caption] = []
    with np.errstate(all="ignore"):
        chosen = selection.shapes
        tints = _tints(design, camera, options, chosen, draft=draft, wait=wait, only=only)
        overlays = chain(
            design_overlay_items(design, camera, options, selection, hurried=hurried, wait=wait)
            if only is None
            else (),
            overlay_items(design, shown, camera, options, selection),
            overlay_items(
                design, shown_meshes(design, only), camera, options, selection, wait=wait
            ),
        )
        shapes = (
            item
            for shape_id, shape, geometry in shown
            for item in _shape(
                shape,
                geometry,
                camera,
                options,
                shape_id in selection.shapes,
                draft,
                tints.by_shape.get(shape_id),
            )
        )
        meshes = (
            item
            for shape_id, shape, surface in shown_meshes(design, only)
            for item in mesh_items_in_space(
                shape,
                surface,
                camera,
                options,
                selected=shape_id in selection.shapes,
                draft=draft,
                wait=wait,
                colors=tints.by_shape.get(shape_id),
            )
        )
        faces = _faces(design, selection, only)
        for item in filter(is_finite, chain(overlays, shapes, meshes, faces)):
            match item:
                case Patch() | Mesh() if is_opaque(item):
                    solids.append(item)
                case Patch() | Mesh() | Polygon():
                    glass.append(item)
                case Caption():
                    captions.append(item)
                case Label() | Legend():
                    labels.append(item)
                case _:
                    lines.append(item)
        handles = filter(is_finite, _handles(design, camera, options, selection, only))
        labels = [*uncrowded(labels, camera)]
        labels += filter(is_finite, _gizmo(design, camera, options, selection))
        if tints.legend is not None:
            labels.append(tints.legend)
        return SpaceLayers(
            tuple(solids),
            tuple(glass),
            tuple(lines),
            tuple(handles),
            tuple(labels),
            tuple(captions),
        )


def _faces(
    design: Design, selection: Selection, only: Collection[ShapeId] | None
) -> Iterator[Mesh]:
    """The selected faces of meshes."""
    lines = selection.by_shape()
    for shape_id, _, surface in shown_meshes(design, only):
        if shape_id in lines:
            yield face_fill(drawing_of(surface, wait=False), lines[shape_id])


def _tints(
    design: Design,
    camera: SpaceCamera,
    options: ViewOptions,
    chosen: frozenset[ShapeId],
    *,
    draft: bool,
    wait: bool,
    only: Collection[ShapeId] | None,
) -> Tints:
    """What the overlay that is switched on colors, as far as it is known or waited for."""
    entry = coloring_overlay(options.overlays)
    if entry is None:
        return NO_TINTS
    known = values_of(
        entry, design, camera, options, draft=draft, wait=wait, only=only, chosen=chosen
    )
    return tinted(entry, known, entry.numbers(options.settings))


def is_opaque(item: Solid) -> bool:
    """Whether nothing is seen through it, as far as its own colors tell."""
    return not any("@" in color or len(color) == 9 for color in (item.front, item.back))


def _shape(
    shape: Shape,
    geometry: PlusGeometry,
    camera: SpaceCamera,
    options: ViewOptions,
    selected: bool,
    draft: bool,
    colors: Colors | None,
) -> Iterator[Item]:
    if isinstance(geometry, PlusCurve):
        yield from curve_items(shape, geometry, camera, selected=selected)
        return
    grids = surface_grids(geometry, camera, draft=draft)
    yield _patch(shape, geometry, grids, options, colors)
    color = "selected" if selected else "line"
    yield from surface_line_items(
        shape,
        geometry,
        camera,
        grids,
        color=color,
        selected=selected,
        inner=options.isolines,
        draft=draft,
    )


_PATCHES: "WeakValueDictionary[tuple[object, ...], Patch]" = WeakValueDictionary()
"""Those that someone still draws."""


def _patch(
    shape: Shape,
    surface: PlusSurface,
    grids: Grids,
    options: ViewOptions,
    colors: Colors | None,
) -> Patch:
    """The surface shaded, the same item as before while it is to look the same."""
    own, dim = shape.style.color, DIM if shape.locked else ""
    front, back = (own, darker(own)) if own else ("front", "back")
    wire = WIRE if options.wire else None
    key = (surface, *grids, front + dim, back + dim, wire, id(colors))
    kept = _PATCHES.get(key)
    if kept is None:
        # It holds its colors: as long as it is kept, no others get their number.
        kept = _PATCHES[key] = Patch(surface, *grids, front + dim, back + dim, wire, colors)
    return kept


def _handles(
    design: Design,
    camera: SpaceCamera,
    options: ViewOptions,
    selection: Selection,
    only: Collection[ShapeId] | None,
) -> Iterator[Item]:
    for shape_id, _, geometry in shown_shapes(design, only):
        if shape_id in selection.shapes and isinstance(geometry, PlusCurve):
            yield from direction_arrow(geometry, camera)
    yield from handle_items(design, camera, options, selection, only)


def _gizmo(
    design: Design, camera: SpaceCamera, options: ViewOptions, selection: Selection
) -> Iterator[Item]:
    gizmo = None if options.handles == "none" else gizmo_of(design, selection, camera)
    if gizmo is not None:
        yield from gizmo_items(gizmo, camera)
