"""Actions on the magnitude s of the selected shapes; without a selection, of all.

Of curves and surfaces it is told in units of a length L; of meshes, where 1 gives the planes of
the faces, it is a number by itself.
"""

from collections.abc import Callable

from plusedit.commands.curves import SetMagnitude
from plusedit.commands.multiples import Multiply
from plusedit.document.design import EditError
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.natural import best_s_of, natural_length_of
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage

MENU = "Edit/Magnitude s"

STEP = 0.01  # of L, by which "-" and "+" change s


def chosen_or_all(stage: Stage) -> tuple[ShapeId, ...]:
    """The selected shapes; where nothing is selected, all that can be edited."""
    if stage.selection:
        return shapes_of(stage)
    found = tuple(i for i in stage.design if stage.design[i].editable)
    if not found:
        raise EditError("There is no curve or surface to change.")
    return found


def magnitude(stage: Stage, value: Callable[[Geometry], float]) -> Outcome:
    """Give every shape its own s."""
    return SetMagnitude({i: value(stage.design[i].geometry) for i in chosen_or_all(stage)})


def length_of(geometry: Geometry) -> float:
    """L; 1 of a mesh."""
    return 1.0 if isinstance(geometry, MeshSurface) else natural_length_of(geometry)


def usual(geometry: Geometry) -> float:
    """L / 2; of a mesh 1, the planes of the faces."""
    return 1.0 if isinstance(geometry, MeshSurface) else natural_length_of(geometry) / 2.0


def best(geometry: Geometry) -> float:
    """s*. EditError where s changes nothing, and of a mesh, which has none."""
    if isinstance(geometry, MeshSurface):
        raise EditError("Only curves and surfaces have an s that is closest to their points.")
    s = best_s_of(geometry)
    if s is None:
        noun = "lines" if isinstance(geometry, PlusCurve) else "planes"
        raise EditError(f"s changes nothing here: the control {noun} have no directions.")
    return s


def _s(value: Callable[[Geometry], float]) -> Callable[[Stage], Outcome]:
    return lambda stage: magnitude(stage, value)


def _by(share: float) -> Callable[[Stage], Outcome]:
    return _s(lambda geometry: geometry.s + share * length_of(geometry))


def multiples(stage: Stage) -> Outcome:
    """Copies side by side that differ in s, in a row as the view sees it."""
    across, up, _ = stage.camera.axes_of_view
    return Multiply(chosen_or_all(stage), across=across, down=-up)


ACTIONS = (
    EditAction("s_up", "s up by 1 % of L", ("+", "="), MENU, _by(STEP)),
    EditAction("s_down", "s down by 1 % of L", ("-",), MENU, _by(-STEP)),
    EditAction("s_zero", "s = 0, classical", (), MENU, _s(lambda geometry: 0.0)),
    EditAction("s_half", "s = L/2, usual", (), MENU, _s(usual)),
    EditAction("s_best", "s = s*, closest to the points", (), MENU, _s(best)),
    EditAction("s_multiples", "Copies with s = 0, L/2, L, 3L/2", (), MENU, multiples),
)
