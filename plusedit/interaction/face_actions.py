"""Actions on the selected faces of meshes: the smoothness there, and taking edits back."""

from plusedit.commands.base import Targets
from plusedit.commands.faces import ResetPlanes, SetFactor
from plusedit.document.design import EditError
from plusedit.document.selection import LineId, Selection
from plusedit.interaction.actions import EditAction
from plusedit.interaction.modal import chosen
from plusedit.interaction.tool import Outcome, Stage

MENU = "Mesh"


def meshes_meant(stage: Stage) -> Targets:
    """The selected meshes with their selected faces. EditError if there is none."""
    found = {i: rows for i, rows in chosen(stage).items() if stage.design[i].mesh is not None}
    if not found:
        raise EditError("No mesh is selected.")
    return found


def faces_of(stage: Stage) -> Targets:
    """The selected faces. EditError if there is none."""
    found = {i: rows for i, rows in meshes_meant(stage).items() if rows}
    if not found:
        raise EditError("Select faces of a mesh first: click on the surface once it is selected.")
    return found


def select_edited(stage: Stage) -> Outcome:
    """The faces of the selected meshes whose planes are edited."""
    lines = [
        LineId(shape_id, face)
        for shape_id in meshes_meant(stage)
        for face in stage.design.mesh(shape_id).edited
    ]
    if not lines:
        raise EditError("No control plane of the selected mesh is edited.")
    return Selection.of_lines(lines)


ACTIONS = (
    EditAction(
        "sharper",
        "Sharper here",
        ("Alt+[",),
        MENU,
        lambda stage: SetFactor(faces_of(stage), 0.5, relative=True),
    ),
    EditAction(
        "smoother",
        "Smoother here",
        ("Alt+]",),
        MENU,
        lambda stage: SetFactor(faces_of(stage), 2.0, relative=True),
    ),
    EditAction(
        "reset_factor",
        "Reset local smoothness",
        (),
        MENU,
        lambda stage: SetFactor(meshes_meant(stage), 1.0),
    ),
    EditAction(
        "reset_planes", "Reset planes", (), MENU, lambda stage: ResetPlanes(meshes_meant(stage))
    ),
    EditAction("select_edited", "Select edited planes", (), MENU, select_edited),
)
