"""Actions that let the selected shapes keep something while anything else is edited."""

from collections.abc import Callable

from plusedit.commands.base import Command, Together
from plusedit.commands.constraints import Constrain, Release
from plusedit.document.design import EditError
from plusedit.document.shape import ShapeId
from plusedit.geometry.constraints import Wish, constraints
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface_tangency import CORNERS
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Constraints"
TITLES = {
    "tangent_start": "Keep tangent at the start",
    "tangent_end": "Keep tangent at the end",
    "smooth_closing": "Keep closed smoothly",
    "corner_tangency": "Keep tangent at corners",
    "passing": "Keep passing through points",
}
SHORTCUTS = {"passing": ("Ctrl+Alt+P",), "tangent_start": ("Ctrl+Alt+T",)}


def taking(stage: Stage, kind: str) -> tuple[ShapeId, ...]:
    """The selected shapes that can have a constraint. EditError if there is none."""
    found = []
    for shape_id in shapes_of(stage):
        geometry = stage.design[shape_id].plus
        if geometry is not None and constraints[kind].takes(geometry):
            found.append(shape_id)
    if not found:
        raise EditError(f"Nothing that is selected can have this: {constraints[kind].title}.")
    return tuple(found)


def wish_of(stage: Stage, shape_id: ShapeId, kind: str) -> Wish:
    """The constraint as it is meant for what is selected of a shape.

    Points are the selected ones, corners those among the selected planes; all of them where the
    shape is selected as a whole.
    """
    net = stage.design.plus(shape_id).net
    chosen = stage.selection.by_shape().get(shape_id, ())
    match constraints[kind].counts:
        case "elements":
            return Wish(kind, chosen or tuple(range(len(net))))
        case "corners" if isinstance(net, ControlPlanes):
            rows, columns = net.shape
            at = [u * (rows - 1) * columns + v * (columns - 1) for u, v in CORNERS]
            found = tuple(number for number, plane in enumerate(at) if plane in chosen)
            return Wish(kind, found or tuple(range(len(CORNERS))))
    return Wish(kind)


def switched(stage: Stage, kind: str) -> Outcome:
    """Release the constraint where all selected shapes keep it just like that, else set it."""
    ids = taking(stage, kind)
    wishes = {shape_id: wish_of(stage, shape_id, kind) for shape_id in ids}
    if all(wish in stage.design[i].constraints for i, wish in wishes.items()):
        return Release(ids, kind)
    return Constrain(wishes)


def released(stage: Stage) -> Outcome:
    """Release all constraints of the selected shapes."""
    ids = shapes_of(stage)
    kinds = {wish.kind for i in ids for wish in stage.design[i].constraints}
    if not kinds:
        raise EditError("What is selected keeps no constraints.")
    steps: tuple[Command, ...] = tuple(Release(ids, kind) for kind in sorted(kinds))
    return Together("Release all constraints", steps)


def _switch(kind: str) -> Callable[[Stage], Outcome]:
    return lambda stage: switched(stage, kind)


ACTIONS = (
    *(
        EditAction(f"keep_{kind}", title, SHORTCUTS.get(kind, ()), MENU, _switch(kind))
        for kind, title in TITLES.items()
    ),
    EditAction("release_constraints", "Release all", (), MENU, released),
)
