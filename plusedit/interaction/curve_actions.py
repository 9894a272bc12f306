"""Actions on the selected curves: family, order, ends, closing, running the other way."""

from collections.abc import Callable

from plusedit.commands.base import Command, Together
from plusedit.commands.curves import (
    ChangeFamily,
    ChangeOrder,
    CloseSmoothly,
    MakeTangent,
    PassThrough,
    SetClosed,
)
from plusedit.commands.shapes import ReverseCurves
from plusedit.document.design import EditError
from plusedit.document.shape import ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Curve"

FAMILIES = (("bezier", "Bézier"), ("bspline", "B-spline"), ("rag", "Rational Gaussian"))


def curves_of(stage: Stage) -> tuple[ShapeId, ...]:
    """The selected curves that can be edited. EditError if there is none."""
    shapes = shapes_of(stage)
    found = tuple(i for i in shapes if stage.design[i].curve is not None)
    if found:
        return found
    if any(stage.design[i].surface is not None for i in shapes):
        raise EditError("This works on curves, and only surfaces are selected.")
    raise EditError("No curve is selected.")


def order(stage: Stage, by: int) -> Outcome:
    """Raise or lower the order of every selected B-spline by one."""
    found: list[Command] = []
    limits = set()
    for shape_id in curves_of(stage):
        curve = stage.design.curve(shape_id)
        basis = curve.basis
        if not isinstance(basis, BSpline):
            continue
        wanted = basis.order + by
        if wanted < 2 or (not basis.closed and wanted > basis.size):
            limits.add("lowest" if by < 0 else "highest")
            continue
        found.append(ChangeOrder((shape_id,), wanted))
    if found:
        verb = "Raise order" if by > 0 else "Lower order"
        return Together(verb, tuple(found))
    if limits:
        raise EditError(f"The order is the {limits.pop()} that this curve can have.")
    raise EditError("Only B-splines have an order that can be chosen.")


def closing(stage: Stage, closed: bool) -> Outcome:
    """Close or open every selected curve that is not so yet."""
    ids = curves_of(stage)
    other = tuple(i for i in ids if stage.design.curve(i).closed != closed)
    if not other:
        raise EditError(f"What is selected is {'closed' if closed else 'open'} already.")
    return SetClosed(other, closed)


def _with_curves(make: Callable[[tuple[ShapeId, ...]], Command]) -> Callable[[Stage], Outcome]:
    return lambda stage: make(curves_of(stage))


def _family(family: str) -> Callable[[Stage], Outcome]:
    return lambda stage: ChangeFamily(curves_of(stage), family)


ACTIONS = (
    EditAction("reverse_curve", "Reverse curve", (), MENU, _with_curves(ReverseCurves)),
    EditAction("close_curve", "Close curve", (), MENU, lambda stage: closing(stage, True)),
    EditAction("open_curve", "Open curve", (), MENU, lambda stage: closing(stage, False)),
    EditAction("close_smoothly", "Close smoothly", (), MENU, _with_curves(CloseSmoothly)),
    EditAction(
        "tangent_start",
        "Make tangent at the start",
        (),
        MENU,
        _with_curves(lambda ids: MakeTangent(ids, True, False)),
    ),
    EditAction(
        "tangent_end",
        "Make tangent at the end",
        (),
        MENU,
        _with_curves(lambda ids: MakeTangent(ids, False, True)),
    ),
    EditAction(
        "tangent_ends",
        "Make tangent at both ends",
        (),
        MENU,
        _with_curves(lambda ids: MakeTangent(ids, True, True)),
    ),
    EditAction("pass_through", "Pass through the points", (), MENU, _with_curves(PassThrough)),
    *(
        EditAction(f"family_{name}", title, (), f"{MENU}/Family", _family(name))
        for name, title in FAMILIES
    ),
    EditAction("order_up", "Raise order", (), f"{MENU}/Order", lambda stage: order(stage, 1)),
    EditAction("order_down", "Lower order", (), f"{MENU}/Order", lambda stage: order(stage, -1)),
)
