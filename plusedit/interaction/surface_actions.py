"""Actions on the selected surfaces, most of them for u and for v."""

from collections.abc import Callable, Iterator

import numpy as np

from plusedit.commands.base import Command, Together
from plusedit.commands.directions import ResetDirections, ReverseDirections
from plusedit.commands.surfaces import (
    Balance,
    ChangeFamilyOf,
    ChangeOrderOf,
    ExtractBoundary,
    ExtractCurve,
    InsertRow,
    PassThroughSurface,
    ReverseWay,
    SetClosedOf,
    TangentCorners,
    TangentToCornerPlanes,
    Transpose,
)
from plusedit.document.design import EditError
from plusedit.document.shape import ShapeId
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.surface import WAYS, Way
from plusedit.geometry.surface_sizes import basis_along
from plusedit.interaction.actions import EditAction
from plusedit.interaction.curve_actions import FAMILIES
from plusedit.interaction.modal import chosen
from plusedit.interaction.net_selecting import chosen_planes, place_of
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Surface"

Ids = tuple[ShapeId, ...]

ROWS: dict[Way, str] = {"u": "row", "v": "column"}


def surfaces_of(stage: Stage) -> Ids:
    """The selected surfaces that can be edited. EditError if there is none."""
    found = tuple(i for i in shapes_of(stage) if stage.design[i].surface is not None)
    if not found:
        raise EditError("No surface is selected.")
    return found


def order(stage: Stage, way: Way, by: int) -> Outcome:
    """Raise or lower the order along u or v of every selected surface of B-splines by one."""
    found: list[Command] = []
    limits = set()
    for shape_id in surfaces_of(stage):
        basis = basis_along(stage.design.surface(shape_id), way)
        if not isinstance(basis, BSpline):
            continue
        wanted = basis.order + by
        if wanted < 2 or (not basis.closed and wanted > basis.size):
            limits.add("lowest" if by < 0 else "highest")
            continue
        found.append(ChangeOrderOf((shape_id,), way, wanted))
    if found:
        verb = "Raise" if by > 0 else "Lower"
        return Together(f"{verb} order along {way}", tuple(found))
    if limits:
        raise EditError(f"The order along {way} is the {limits.pop()} that this surface can have.")
    raise EditError("Only B-splines have an order that can be chosen.")


def closing(stage: Stage, way: Way, closed: bool) -> Outcome:
    """Close or open along u or v every selected surface that is not so yet."""
    ids, place = surfaces_of(stage), WAYS.index(way)
    other = tuple(i for i in ids if stage.design.surface(i).closed[place] != closed)
    if not other:
        state = "closed" if closed else "open"
        raise EditError(f"What is selected is {state} along {way} already.")
    return SetClosedOf(other, way, closed)


def insert(stage: Stage, way: Way) -> Outcome:
    """Insert a row, or a column for "v", in the wider gap beside the active plane.

    Without an active plane, in the widest gap of every selected surface.
    """
    ids, active = surfaces_of(stage), stage.selection.active
    edits: list[Command] = []
    for shape_id in ids if active is None or active.shape not in ids else (active.shape,):
        surface = stage.design.surface(shape_id)
        place = None
        if active is not None and active.shape == shape_id:
            place = place_of(surface.planes.shape, active.number, way)
        edits.append(InsertRow(shape_id, way, widest_gap(basis_along(surface, way), place)))
    return edits[0] if len(edits) == 1 else Together(f"Insert {ROWS[way]}s", tuple(edits))


def widest_gap(basis: Basis, place: int | None) -> float:
    """The middle of the widest gap between nodes, of the two beside node `place` if it is given."""
    nodes = basis.nodes
    ends = np.append(nodes, nodes[0] + 1.0) if basis.closed else nodes
    gaps, middles = np.diff(ends), (ends[1:] + ends[:-1]) / 2.0
    if place is not None:
        sides = np.array([place - 1, place])
        sides = sides % len(gaps) if basis.closed else sides[(sides >= 0) & (sides < len(gaps))]
        gaps, middles = gaps[sides], middles[sides]
    return float(middles[gaps.argmax()] % 1.0)


def extract_curve(stage: Stage, way: Way) -> Outcome:
    """The curve of constant u, or v, at the node of the active plane; else of all selected."""
    edits: list[Command] = []
    for shape_id, numbers in chosen_planes(stage).items():
        surface = stage.design.surface(shape_id)
        nodes = basis_along(surface, way).nodes
        places = {place_of(surface.planes.shape, number, way) for number in numbers}
        edits += [ExtractCurve(shape_id, way, float(nodes[place])) for place in sorted(places)]
    if len(edits) == 1:
        return edits[0]
    return Together(f"Extract curves of constant {way}", tuple(edits))


def planes_of(stage: Stage) -> dict[ShapeId, tuple[int, ...]]:
    """The selected control planes, those of whole surfaces too. EditError if there is none."""
    found = {i: rows for i, rows in chosen(stage).items() if stage.design[i].surface is not None}
    if not found:
        raise EditError("No surface is selected.")
    return found


def _with_surfaces(make: Callable[[Ids], Command]) -> Callable[[Stage], Outcome]:
    return lambda stage: make(surfaces_of(stage))


def _whole() -> Iterator[EditAction]:
    yield EditAction("transpose", "Swap u and v", (), MENU, _with_surfaces(Transpose))
    yield EditAction(
        "tangent_corners",
        "Make tangent to the net at the corners",
        (),
        MENU,
        _with_surfaces(TangentCorners),
    )
    yield EditAction(
        "tangent_planes",
        "Make tangent to the corner planes",
        (),
        MENU,
        _with_surfaces(TangentToCornerPlanes),
    )
    yield EditAction(
        "pass_through_surface",
        "Pass through the points",
        (),
        MENU,
        _with_surfaces(PassThroughSurface),
    )
    yield EditAction("balance", "Balance u and v", (), MENU, _with_surfaces(Balance))
    yield EditAction(
        "extract_boundary", "Extract edges as curves", (), MENU, _with_surfaces(ExtractBoundary)
    )


def _along(way: Way) -> Iterator[EditAction]:
    menu = f"{MENU}/Along {way}"
    row = ROWS[way]
    yield _action(
        f"reverse_{way}",
        f"Reverse {way}",
        menu,
        _with_surfaces(lambda ids: ReverseWay(ids, way)),
    )
    yield _action(
        f"close_{way}", f"Close along {way}", menu, lambda stage: closing(stage, way, True)
    )
    yield _action(
        f"open_{way}", f"Open along {way}", menu, lambda stage: closing(stage, way, False)
    )
    yield _action(f"insert_{row}", f"Insert {row}", menu, lambda stage: insert(stage, way))
    yield _action(
        f"extract_{way}",
        f"Extract curve of constant {way} through the plane",
        menu,
        lambda stage: extract_curve(stage, way),
    )
    yield _action(
        f"reverse_directions_{way}",
        f"Reverse direction by {way}",
        menu,
        lambda stage: ReverseDirections(planes_of(stage), way),
    )
    yield _action(
        f"reset_directions_{way}",
        f"Reset direction by {way} to automatic",
        menu,
        lambda stage: ResetDirections(planes_of(stage), way),
    )
    yield _action(
        f"order_up_{way}", f"Raise order along {way}", menu, lambda stage: order(stage, way, 1)
    )
    yield _action(
        f"order_down_{way}", f"Lower order along {way}", menu, lambda stage: order(stage, way, -1)
    )
    for family, title in FAMILIES:
        yield _action(
            f"family_{way}_{family}", f"{title} along {way}", menu, _changes_family(way, family)
        )


def _action(name: str, title: str, menu: str, make: Callable[[Stage], Outcome]) -> EditAction:
    return EditAction(name, title, (), menu, make)


def _changes_family(way: Way, family: str) -> Callable[[Stage], Outcome]:
    return _with_surfaces(lambda ids: ChangeFamilyOf(ids, way, family))


ACTIONS = (*_whole(), *_along("u"), *_along("v"))
