"""How far shapes are from the classical ones of the same control points, s = 0.

Hairs join points of equal parameters; surfaces and meshes are colored by how far such points are
apart, and the largest distances stand in a corner.
"""

from collections.abc import Iterator
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.departure import (
    Departure,
    departure,
    surface_departure,
    surface_departures,
)
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.coloring import known_values
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Caption, Item, Markers, Polyline, Row, Segments
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import Coloring, Numbers, Seen, Setting, overlay

TITLE = "Plus against classical"
HAIR = "hover@70"
LOUD = "hover"
FEWEST, MOST = 24, 4000  # hairs of a curve
MOST_EACH = 41  # rows of hairs of a surface, each way
OF_SURFACES = 0.25  # of the hairs of a line: rows of hairs of a plane
LISTED = 6  # shapes

against_classical = overlay(
    "against_classical",
    title=TITLE,
    order=56,
    shortcut="Shift+V",
    group="Comparison",
    coloring=Coloring("Plus from classical", "units", least=1e-12),
    settings=(Setting("density", "Hairs per control line", 8.0, 1.0, 100.0),),
)

_KNOWN: "WeakKeyDictionary[PlusGeometry, Departure]" = WeakKeyDictionary()


@against_classical.of_curves
def hairs(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """The classical curve, and hairs from it to the curve; nothing where they are the same."""
    found = departure_of(curve)
    if found.largest == 0.0:
        return
    yield Polyline(drawn(curve.classical, seen.camera).points, "classical", 1.0)
    count = round(seen.settings["density"] * len(curve.lines)) + 1
    grid = Grid.uniform(min(max(count, FEWEST), MOST))
    yield Segments(curve.classical.sample(grid), curve.sample(grid), HAIR)
    place = np.array(found.at)
    yield Segments(curve.classical.at(place), curve.at(place), LOUD, 2.0)
    yield Markers(curve.at(place), "ring", 10.0, None, LOUD)


@against_classical.of_surfaces
def hairs_of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """Hairs from the classical surface to the surface; nothing where they are the same."""
    found = departure_of(surface)
    if found.largest == 0.0:
        return
    rows = OF_SURFACES * seen.settings["density"]
    counts = (min(max(round(rows * n) + 1, n), MOST_EACH) for n in surface.planes.shape)
    by_u, by_v = (Grid.uniform(count) for count in counts)
    starts = surface.classical.sample(by_u, by_v).reshape(-1, 3)
    yield Segments(starts, surface.sample(by_u, by_v).reshape(-1, 3), "classical@60")
    u, v = found.at
    start, end = surface.classical.at(u, v)[0], surface.at(u, v)[0]
    yield Segments(start, end, LOUD, 2.0)
    yield Markers(end, "ring", 10.0, None, LOUD)


@against_classical.coloring_of_surfaces
def of_surface(surface: PlusSurface, u: Floats, v: Floats, numbers: Numbers) -> Floats:
    """(m_u, m_v) distances from the classical surface at the same parameters."""
    return surface_departures(surface, Grid(u), Grid(v))


@against_classical.coloring_of_meshes
def of_mesh(surface: MeshSurface, drawing: MeshDrawing, numbers: Numbers) -> Floats:
    """(n,) distances from the surface that the middles of the faces make alone, s = 0."""
    classical = surface.with_s(0.0).at(drawing.net.places)
    distances: Floats = np.linalg.norm(drawing.points - classical, axis=1)
    return distances


@against_classical.of_designs
def numbers_of(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """The largest and the rms distance, of the selected shapes or else of all."""
    visible = [shape_id for shape_id, shape in design.shapes.items() if shape.visible]
    asked = [shape_id for shape_id in visible if shape_id in chosen] or visible
    spreads = ((shape_id, _spread(design[shape_id], seen)) for shape_id in asked)
    known = {shape_id: spread for shape_id, spread in spreads if spread is not None}
    # Straight lines and the like are the same for every s: they would crowd out the others.
    found = {shape_id: spread for shape_id, spread in known.items() if spread[0]} or known
    if len(found) == 1:
        ((shape_id, (largest, rms)),) = found.items()
        rows = (
            Row(design[shape_id].name),
            Row("largest distance", f"{largest:.4g} units", LOUD),
            Row("rms", f"{rms:.4g} units"),
        )
        yield Caption(TITLE, rows)
    elif found:
        yield Caption(TITLE, tuple(_rows(design, found)))


def departure_of(geometry: PlusGeometry) -> Departure:
    """The distances of a curve or surface in short; kept for as long as it lives."""
    known = _KNOWN.get(geometry)
    if known is None:
        if isinstance(geometry, PlusCurve):
            known = departure(geometry)
        else:
            known = surface_departure(geometry)
        _KNOWN[geometry] = known
    return known


def _spread(shape: Shape, seen: Seen) -> tuple[float, float] | None:
    """The largest and the rms distance; None while those of a mesh are not known."""
    if shape.plus is not None:
        found = departure_of(shape.plus)
        return found.largest, found.rms
    assert shape.mesh is not None
    drawing = drawing_of(shape.mesh, wait=False)
    values = known_values(against_classical, shape.mesh, drawing, seen.settings)
    if values is None:
        return None
    return float(values.max()), float(np.sqrt(np.mean(values**2)))


def _rows(design: Design, found: dict[ShapeId, tuple[float, float]]) -> Iterator[Row]:
    """A row for each shape, those that are farthest away first."""
    yield Row("largest distance, rms", "units")
    farthest = sorted(found, key=lambda shape_id: -found[shape_id][0])
    for shape_id in farthest[:LISTED]:
        largest, rms = found[shape_id]
        yield Row(design[shape_id].name, f"{largest:.4g},  {rms:.4g}")
    if len(farthest) > LISTED:
        yield Row(f"and {len(farthest) - LISTED} more")
