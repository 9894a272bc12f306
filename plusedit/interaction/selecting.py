"""Actions that select, delete and duplicate."""

import numpy as np

from plusedit.commands.base import Command, Together
from plusedit.commands.shapes import DeleteLines, DeleteShapes, Duplicate
from plusedit.document.design import EditError
from plusedit.document.joints import whole_path
from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.interaction.actions import EditAction
from plusedit.interaction.tool import Outcome, Stage
from plusedit.interaction.world_axes import world_axes


def shapes_of(stage: Stage) -> tuple[ShapeId, ...]:
    """The selected shapes that can be edited, back to front. EditError if there is none."""
    found = [i for i in stage.design if i in stage.selection.shapes and _is_free(i, stage)]
    if found:
        return tuple(found)
    if stage.selection:
        raise EditError("What is selected is locked or hidden.")
    raise EditError("Nothing is selected.")


def _is_free(shape_id: ShapeId, stage: Stage) -> bool:
    shape = stage.design[shape_id]
    return shape.visible and not shape.locked


def all_lines(stage: Stage) -> list[LineId]:
    """Every control line and plane that can be edited, in order, back to front; no faces."""
    return [
        LineId(shape_id, number)
        for shape_id, geometry in stage.design.drawn()
        if stage.design[shape_id].editable
        for number in range(len(geometry.net))
    ]


def delete(stage: Stage) -> Outcome:
    """Delete the selected lines and rows of planes, and shapes selected without any of them.

    EditError where faces of a mesh are selected: what they are is not for the editor to change.
    """
    lines = stage.selection.by_shape()
    free = shapes_of(stage)
    targets = {shape_id: rows for shape_id, rows in lines.items() if shape_id in free}
    if any(stage.design[shape_id].mesh is not None for shape_id in targets):
        raise EditError(
            "Faces of a mesh can't be deleted. Reset planes takes back what was changed of them."
        )
    whole = tuple(shape_id for shape_id in free if shape_id not in lines)
    commands: list[Command] = []
    if targets:
        commands.append(DeleteLines(targets))
    if whole:
        commands.append(DeleteShapes(whole))
    return commands[0] if len(commands) == 1 else Together("Delete selection", tuple(commands))


def duplicate(stage: Stage) -> Outcome:
    """Copies one grid step to the right and below, along the axes nearest to that."""
    offset = np.zeros(3)
    (across, right), (up, upwards), _ = world_axes(stage.camera)
    offset[across], offset[up] = right * stage.grid_step, -upwards * stage.grid_step
    return Duplicate(shapes_of(stage), offset)


def select_all(stage: Stage) -> Outcome:
    """All control lines and planes that can be edited, and shapes of other kinds as wholes."""
    others = [i for i in stage.design if stage.design[i].plus is None and _is_free(i, stage)]
    return Selection(frozenset(all_lines(stage)), frozenset(others))


def select_none(stage: Stage) -> Outcome:
    """Nothing."""
    return NOTHING_SELECTED


def select_paths(stage: Stage) -> Outcome:
    """All segments of the paths of which some are selected."""
    chosen = shapes_of(stage)
    return Selection.of_shapes(
        i for shape_id in chosen for i in whole_path(stage.design, shape_id) if _is_free(i, stage)
    )


def invert(stage: Stage) -> Outcome:
    """The lines that are not selected; a shape selected as a whole counts with all its lines.

    Of a mesh with selected faces the others, and all of one that is not selected, as a whole.
    """
    targets = stage.selection.targets(stage.design)
    lines = {line for line in all_lines(stage) if line.number not in targets.get(line.shape, ())}
    whole = set()
    for shape_id, surface in stage.design.meshes():
        if _is_free(shape_id, stage) and shape_id not in targets:
            whole.add(shape_id)
        elif rows := targets.get(shape_id):
            others = np.setdiff1d(np.arange(surface.mesh.face_count), rows).tolist()
            lines |= {LineId(shape_id, number) for number in others}
    chosen = Selection.of_lines(lines)
    return Selection(chosen.lines, frozenset(whole), chosen.active)


def neighbor(stage: Stage, by: int) -> Outcome:
    """The line after or before the one selected last, from shape to shape and round again.

    On a mesh that is selected the face after or before.
    """
    meshes = [i for i, _ in stage.design.meshes() if i in stage.selection.shapes]
    if len(meshes) == len(stage.selection.shapes) == 1:
        return _next_face(stage, meshes[0], by)
    lines = all_lines(stage)
    if not lines:
        raise EditError("There are no control lines to select.")
    current = stage.selection.active
    if current not in lines:
        chosen = [line for line in lines if line in stage.selection.lines]
        chosen = chosen or [line for line in lines if line.shape in stage.selection.shapes]
        if not chosen:
            return Selection.of_lines([lines[0 if by > 0 else -1]])
        current = chosen[-1 if by > 0 else 0]
        if current not in stage.selection.lines:
            # A shape selected as a whole: begin at its first line, or its last.
            return Selection.of_lines([chosen[0 if by > 0 else -1]])
    return Selection.of_lines([lines[(lines.index(current) + by) % len(lines)]])


def _next_face(stage: Stage, shape_id: ShapeId, by: int) -> Selection:
    leading, count = stage.selection.leading, stage.design[shape_id].element_count
    if leading is None:
        return Selection.of_lines([LineId(shape_id, 0 if by > 0 else count - 1)])
    return Selection.of_lines([LineId(shape_id, (leading.number + by) % count)])


ACTIONS = (
    EditAction("delete", "Delete", ("Delete", "Backspace"), "Edit", delete),
    EditAction("duplicate", "Duplicate", ("Ctrl+D",), "Edit", duplicate),
    EditAction("select_all", "Select all", ("Ctrl+A",), "Select", select_all),
    EditAction("select_paths", "Select whole path", ("L",), "Select", select_paths),
    EditAction("select_none", "Select nothing", ("Ctrl+Shift+A",), "Select", select_none),
    EditAction("invert", "Invert selection", ("Ctrl+I",), "Select", invert),
    EditAction(
        "next_line", "Next control line", ("Tab",), "Select", lambda stage: neighbor(stage, 1)
    ),
    EditAction(
        "previous_line",
        "Previous control line",
        ("Shift+Tab", "Backtab"),
        "Select",
        lambda stage: neighbor(stage, -1),
    ),
)
