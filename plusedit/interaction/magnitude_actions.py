"""Actions on the magnitude s of the selected curves and surfaces; without a selection, of all."""

from collections.abc import Callable

from plusedit.commands.curves import SetMagnitude
from plusedit.document.design import EditError
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.natural import best_s_of, natural_length_of
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Edit/Magnitude s"

STEP = 0.01  # of L, by which "-" and "+" change s


def drawn_or_all(stage: Stage) -> tuple[ShapeId, ...]:
    """The selected curves and surfaces; where nothing is selected, all that can be edited."""
    if stage.selection:
        found = tuple(i for i in shapes_of(stage) if stage.design[i].plus is not None)
        if not found:
            raise EditError("No curve or surface is selected.")
        return found
    found = tuple(i for i in stage.design if stage.design[i].editable)
    if not found:
        raise EditError("There is no curve or surface to change.")
    return found


def magnitude(stage: Stage, value: Callable[[PlusGeometry], float]) -> Outcome:
    """Give every curve and surface its own s."""
    design = stage.design
    return SetMagnitude({i: value(design.plus(i)) for i in drawn_or_all(stage)})


def best(geometry: PlusGeometry) -> float:
    """s*. EditError where s changes nothing."""
    s = best_s_of(geometry)
    if s is None:
        noun = "lines" if isinstance(geometry, PlusCurve) else "planes"
        raise EditError(f"s changes nothing here: the control {noun} have no directions.")
    return s


def _s(value: Callable[[PlusGeometry], float]) -> Callable[[Stage], Outcome]:
    return lambda stage: magnitude(stage, value)


def _by(share: float) -> Callable[[Stage], Outcome]:
    return _s(lambda geometry: geometry.s + share * natural_length_of(geometry))


ACTIONS = (
    EditAction("s_up", "s up by 1 % of L", ("+", "="), MENU, _by(STEP)),
    EditAction("s_down", "s down by 1 % of L", ("-",), MENU, _by(-STEP)),
    EditAction("s_zero", "s = 0, classical", (), MENU, _s(lambda geometry: 0.0)),
    EditAction("s_half", "s = L/2, usual", (), MENU, _s(lambda g: natural_length_of(g) / 2.0)),
    EditAction("s_best", "s = s*, closest to the points", (), MENU, _s(best)),
)
