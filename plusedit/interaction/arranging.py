"""Actions on shapes as wholes: what lies in front, what is hidden or locked."""

from plusedit.commands.shapes import Reorder, SetLocked, SetVisible
from plusedit.document.design import EditError
from plusedit.document.shape import ShapeId
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Arrange"


def to_end(stage: Stage, *, front: bool) -> Outcome:
    """Bring the selected shapes in front of all others, or behind them."""
    chosen = shapes_of(stage)
    others = tuple(i for i in stage.design if i not in chosen)
    return Reorder(others + chosen if front else chosen + others)


def by_one(stage: Stage, *, forward: bool) -> Outcome:
    """Swap each selected shape with the one in front of it, or behind it."""
    chosen = shapes_of(stage)
    order: list[ShapeId] = list(stage.design)
    if forward:
        order.reverse()
    for place in range(1, len(order)):
        if order[place] in chosen and order[place - 1] not in chosen:
            order[place - 1 : place + 1] = [order[place], order[place - 1]]
    if forward:
        order.reverse()
    return Reorder(tuple(order))


def hide(stage: Stage) -> Outcome:
    """Hide the selected shapes."""
    return SetVisible(shapes_of(stage), False)


def lock(stage: Stage) -> Outcome:
    """Lock the selected shapes."""
    return SetLocked(shapes_of(stage), True)


def show_all(stage: Stage) -> Outcome:
    """Show every hidden shape."""
    hidden = tuple(i for i, shape in stage.design.shapes.items() if not shape.visible)
    if not hidden:
        raise EditError("Nothing is hidden.")
    return SetVisible(hidden, True)


def unlock_all(stage: Stage) -> Outcome:
    """Unlock every locked shape."""
    locked = tuple(i for i, shape in stage.design.shapes.items() if shape.locked)
    if not locked:
        raise EditError("Nothing is locked.")
    return SetLocked(locked, False)


ACTIONS = (
    EditAction(
        "to_front",
        "Bring to front",
        ("Alt+Home",),
        MENU,
        lambda stage: to_end(stage, front=True),
    ),
    EditAction(
        "forward",
        "Bring forward",
        ("Alt+PgUp",),
        MENU,
        lambda stage: by_one(stage, forward=True),
    ),
    EditAction(
        "backward",
        "Send backward",
        ("Alt+PgDown",),
        MENU,
        lambda stage: by_one(stage, forward=False),
    ),
    EditAction(
        "to_back", "Send to back", ("Alt+End",), MENU, lambda stage: to_end(stage, front=False)
    ),
    EditAction("hide", "Hide", ("Ctrl+H",), MENU, hide),
    EditAction("show_all", "Show all", ("Ctrl+Shift+H",), MENU, show_all),
    EditAction("lock", "Lock", ("Ctrl+L",), MENU, lock),
    EditAction("unlock_all", "Unlock all", ("Ctrl+Shift+L",), MENU, unlock_all),
)
