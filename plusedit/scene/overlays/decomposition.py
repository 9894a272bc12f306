"""A shape as the sum of its two parts: the classical shape, and s times the plus term.

The first shows what the control points do, the second what the gradients add to it, at the same
parameters (eq. 9 and 26 of the paper). The second is a shape of its own: that of the same
directions with all control points in one place. It is drawn below the shape, about a cross.
"""

from collections.abc import Iterator
from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve import terms as curve_terms
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface import terms as surface_terms
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_surface import Grids, surface_grids
from plusedit.scene.isolines import isolines
from plusedit.scene.items import Caption, Item, Markers, Patch, Polyline, Row, Segments
from plusedit.scene.overlays import Seen, Setting, overlay
from plusedit.scene.shapes import shown_shapes

PART = "accent"  # the color of what gradients add
FEWEST, MOST = 8, 1200  # hairs of a curve
MOST_OF_SURFACE = 41  # in each direction
ROOM = 0.04  # of the size of a shape, between it and its plus term
NAME = 28.0  # pixels more: where its name stands

decomposition = overlay(
    "decomposition",
    title="Classical and gradient part",
    order=42,
    shortcut="Shift+G",
    group="Constructions",
    settings=(Setting("density", "Hairs per control line", 8.0, 1.0, 64.0),),
)

_TERMS: "WeakKeyDictionary[PlusCurve, tuple[Camera, PlusCurve]]" = WeakKeyDictionary()
_SURFACE_TERMS: "WeakKeyDictionary[PlusSurface, tuple[Camera, PlusSurface]]" = WeakKeyDictionary()
_GLASS: "WeakKeyDictionary[PlusSurface, tuple[Grids, Patch]]" = WeakKeyDictionary()


@decomposition.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """Hairs from the classical curve to the curve, and the same hairs from one place.

    Nothing at s = 0, where there is only one part.
    """
    if curve.s == 0.0:
        return
    count = round(seen.settings["density"] * len(curve.lines))
    grid = Grid.uniform(min(max(count, FEWEST), MOST) + 1)
    base, plus = curve_terms(curve.basis, curve.lines, grid)
    pull = curve.s * plus
    yield Segments(base, base + pull, f"{PART}@60", 1.0)
    yield Polyline(drawn(curve.classical, seen.camera).points, "classical", 1.25)
    kept = _TERMS.get(curve)
    if kept is None or kept[0] != seen.camera:
        place = _beside(curve.lines.points, base, pull, seen.camera)
        kept = _TERMS[curve] = seen.camera, _term_of_curve(curve, place)
    term = kept[1]
    anchor = term.lines.points[:1]
    yield Segments(np.repeat(anchor, len(pull), axis=0), anchor + pull, f"{PART}@30", 1.0)
    yield Polyline(drawn(term, seen.camera).points, PART, 1.5)
    yield Markers(anchor, "cross", 9.0, None, "text", 1.25)


@decomposition.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """Hairs from the classical surface, seen through, to the surface; the plus term as lines."""
    if surface.s == 0.0:
        return
    grid_u, grid_v = (
        Grid.uniform(min(max(2 * basis.size - 1, 5), MOST_OF_SURFACE)) for basis in surface.bases
    )
    base, plus = surface_terms(*surface.bases, surface.planes, grid_u, grid_v)
    base, pull = base.reshape(-1, 3), surface.s * plus.reshape(-1, 3)
    yield Segments(base, base + pull, f"{PART}@70", 1.0)
    grids = surface_grids(surface, seen.camera)
    yield from _classical(surface, grids, seen)
    kept = _SURFACE_TERMS.get(surface)
    if kept is None or kept[0] != seen.camera:
        place = _beside(surface.planes.control_points, base, pull, seen.camera)
        kept = _SURFACE_TERMS[surface] = seen.camera, _term_of_surface(surface, place)
    term = kept[1]
    lines = isolines(term, grids)
    for points in (*lines.along_u, *lines.along_v):
        yield Polyline(points, f"{PART}@50", 1.0)
    for points in lines.edges:
        yield Polyline(points, PART, 1.25)
    yield Markers(term.planes.points[0, :1], "cross", 9.0, None, "text", 1.25)


@decomposition.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """What the colors stand for."""
    if any(geometry.s != 0.0 for _, _, geometry in shown_shapes(design)):
        rows = Row("classical part", color="classical"), Row("s × plus term", color=PART)
        yield Caption("The sum of", rows)


def _classical(surface: PlusSurface, grids: Grids, seen: Seen) -> Iterator[Item]:
    for points in isolines(surface.classical, grids).edges:
        yield Polyline(points, "classical", 1.25)
    if isinstance(seen.camera, PlaneCamera):
        return
    kept = _GLASS.get(surface)
    if kept is None or kept[0] is not grids:
        glass = Patch(surface.classical, *grids, "classical@22", "classical@16")
        kept = _GLASS[surface] = grids, glass
    yield kept[1]


def _beside(points: Floats, base: Floats, pull: Floats, camera: Camera) -> Floats:
    """(dim,) where vectors (m, dim) have to begin so that all end below a shape, in its middle."""
    low, high = points.min(axis=0), points.max(axis=0)
    bottom = np.minimum(low, np.minimum(base, base + pull).min(axis=0))
    place: Floats = (low + high) / 2.0 - (pull.min(axis=0) + pull.max(axis=0)) / 2.0
    gap = ROOM * float((high - low).max()) + NAME * float(camera.pixel_at(points).mean())
    place[-1] = bottom[-1] - gap - max(0.0, float(pull[:, -1].max()))
    return place


def _term_of_curve(curve: PlusCurve, place: Floats) -> PlusCurve:
    """The curve of the same directions with all control points in that place."""
    points = np.tile(place, (len(curve.lines), 1))
    lines = ControlLines.of(points, curve.directions, curve.lines.weights)
    return replace(curve, lines=lines)


def _term_of_surface(surface: PlusSurface, place: Floats) -> PlusSurface:
    """The surface of the same directions with all control points in that place."""
    planes = surface.planes
    along_u, along_v = surface.directions
    points = np.tile(place, (*planes.shape, 1))
    return replace(surface, planes=ControlPlanes.of(points, along_u, along_v, planes.weights))
