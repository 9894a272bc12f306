"""What curves, surfaces and their handles look like, in the plane and in space."""

from collections.abc import Collection, Iterator, Sequence
from typing import TypeAlias

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import Geometry, PlusGeometry, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.beside import findings, known_findings
from plusedit.scene.camera import Camera
from plusedit.scene.control_lines import control_line_items
from plusedit.scene.control_planes import control_plane_items
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.face_outlines import face_items
from plusedit.scene.handles import faces_handled, handle_shapes
from plusedit.scene.isolines import isoline_items, isolines
from plusedit.scene.items import Caption, Item, Label, Legend, Mesh, Patch, Polyline, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Numbers, Overlay, Seen, in_order
from plusedit.scene.silhouettes import silhouette

WIDTH = 2.0  # of a curve whose style says nothing
EDGE = 1.5  # of the edges of a surface
THINNEST = 1.0  # pixels
HALO = 6.0  # pixels by which the glow of a selected curve is wider than the curve
GLOW = "selected@28"
DIM = "@45"  # locked shapes
FAINT = "@25"  # lines on them


Shown: TypeAlias = tuple[ShapeId, Shape, PlusGeometry]
ShownMesh: TypeAlias = tuple[ShapeId, Shape, MeshSurface]


def shown_shapes(design: Design, only: Collection[ShapeId] | None = None) -> list[Shown]:
    """The shapes that are seen, back to front; with `only`, those of them."""
    return [
        (shape_id, shape, geometry)
        for shape_id, shape in design.shapes.items()
        if shape.visible
        and (geometry := shape.plus) is not None
        and (only is None or shape_id in only)
    ]


def shown_meshes(design: Design, only: Collection[ShapeId] | None = None) -> list[ShownMesh]:
    """The surfaces of meshes that are seen, back to front; with `only`, those of them."""
    return [
        (shape_id, design[shape_id], surface)
        for shape_id, surface in design.meshes()
        if design[shape_id].visible and (only is None or shape_id in only)
    ]


def overlay_items(
    design: Design,
    shown: Sequence[Shown | ShownMesh],
    camera: Camera,
    options: ViewOptions,
    selection: Selection = NOTHING_SELECTED,
    *,
    wait: bool = True,
) -> Iterator[Item]:
    """What the overlays that are switched on draw about those shapes of a design.

    Without `wait` of surfaces of meshes what is known by now.
    """
    lines = selection.by_shape()
    if wait and any(entry.name in options.overlays for entry in in_order()):
        for *_, geometry in shown:
            if isinstance(geometry, MeshSurface):
                drawing_of(geometry)
    for entry in in_order():
        if entry.name in options.overlays:
            numbers = entry.numbers(options.settings)
            for shape_id, shape, geometry in shown:
                found = _findings(entry, geometry, numbers, wait)
                seen = Seen(
                    camera,
                    lines.get(shape_id, ()),
                    numbers,
                    design,
                    found,
                    shape_id in selection.shapes,
                )
                yield from entry.draw(shape, geometry, seen)


def _findings(entry: Overlay, geometry: Geometry, numbers: Numbers, wait: bool) -> object:
    """What the overlay knows of a mesh that takes a while to find."""
    if not entry.finds or not isinstance(geometry, MeshSurface):
        return None
    return (findings if wait else known_findings)(entry, geometry, numbers)


def design_overlay_items(
    design: Design,
    camera: Camera,
    options: ViewOptions,
    selection: Selection,
    *,
    hurried: bool = False,
    wait: bool = True,
) -> Iterator[Item]:
    """What they draw about the design as a whole; `hurried` while an edit is going on.

    Without `wait` what takes its time is as it is known by now.
    """
    for entry in in_order():
        if entry.name in options.overlays:
            numbers = entry.numbers(options.settings)
            seen = Seen(camera, (), numbers, design, is_hurried=hurried, waits=wait)
            yield from entry.draw_design(design, selection.shapes, seen)


def curve_items(
    shape: Shape, curve: PlusCurve, camera: Camera, *, selected: bool, glow: bool = True
) -> Iterator[Item]:
    """The curve in its own color and width, on a glow where it is selected."""
    points = drawn(curve, camera).points
    # Thinner than a pixel, a curve would be fainter than its ghost and its polygon.
    width = WIDTH if shape.style.width is None else max(shape.style.width, THINNEST)
    if selected and glow:
        yield Polyline(points, GLOW, width + HALO)
    color = shape.style.color or "plus"
    yield Polyline(points, color + DIM if shape.locked else color, width)


def surface_line_items(
    shape: Shape,
    surface: PlusSurface,
    camera: Camera,
    grids: Grids,
    *,
    color: str,
    selected: bool,
    inner: bool = True,
    glow: bool = True,
    draft: bool = False,
) -> Iterator[Item]:
    """The edges and the silhouette of a surface in that color, with a glow where it is selected.

    With `inner` the lines on it, too; in a `draft` no silhouette, which takes longer than the rest.
    """
    if inner:
        yield from isoline_items(surface, grids, FAINT if shape.locked else "")
    width = EDGE if shape.style.width is None else max(shape.style.width, THINNEST)
    color = color + DIM if shape.locked else color
    outlines = isolines(surface, grids).edges
    if not draft:
        outlines = (*outlines, *silhouette(surface, camera, grids))
    if selected and glow:
        yield from (Polyline(points, GLOW, width + HALO) for points in outlines)
    yield from (Polyline(points, color, width) for points in outlines)


def handle_items(
    design: Design,
    camera: Camera,
    options: ViewOptions,
    selection: Selection,
    only: Collection[ShapeId] | None,
) -> Iterator[Item]:
    """The control lines and planes that are shown, those of selected shapes in front."""
    lines = selection.by_shape()
    for shape_id, _, surface in shown_meshes(design, only):
        if shape_id in lines:
            yield from face_items(drawing_of(surface, wait=False), lines[shape_id])
    shown = [i for i in handle_shapes(design, selection, options) if only is None or i in only]
    active = selection.active
    # Those of selected shapes come last: they lie in front, as they are what a click takes.
    for shape_id in sorted(shown, key=lambda i: i in selection.shapes):
        geometry = design[shape_id].geometry
        chosen = lines.get(shape_id, ())
        number = active.number if active is not None and active.shape == shape_id else None
        quiet = bool(selection) and shape_id not in selection.shapes
        if isinstance(geometry, PlusCurve):
            yield from control_line_items(
                geometry, camera, selected=chosen, active=number, quiet=quiet
            )
        else:
            faces = faces_handled(design, shape_id, selection)
            yield from control_plane_items(
                geometry, camera, selected=chosen, active=number, quiet=quiet, faces=faces
            )


def is_finite(item: Item) -> bool:
    """Whether all places of an item are numbers."""
    match item:
        case Segments(starts, ends):
            return bool(np.isfinite(starts).all() and np.isfinite(ends).all())
        case Label(at):
            return bool(np.isfinite(at).all())
        case Patch() | Legend() | Caption():
            return True
        case Mesh(points, _, normals):
            # Areas and squares of what is huge are beyond a double before the points are.
            is_whole = normals is None or bool(np.isfinite(normals).all())
            return is_whole and bool(np.isfinite(points).all())
        case _:
            return bool(np.isfinite(item.points).all())
