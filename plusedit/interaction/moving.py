"""Drags that move control points."""

import numpy as np

from plusedit.commands.base import Targets, fitted
from plusedit.commands.lines import Landing, MovePoints
from plusedit.document.selection import LineId, Selection
from plusedit.geometry.arrays import Floats
from plusedit.interaction.places import seen_plane
from plusedit.interaction.readout import shift_text
from plusedit.interaction.snapping import AXES, along_axis, along_longer, to_grid
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage

HINT = "Ctrl snaps to the grid · Shift keeps to an axis · X, Y lock it · type dx Tab dy · Esc"


def move_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    grabbed: LineId | None,
    selection: Selection | None = None,
) -> Drag:
    """Move `targets` with the pointer; snapped, the control point `grabbed` lands on the grid.

    Without a grabbed line the shift itself is snapped. `selection` takes effect at once.
    """
    anchor = np.zeros(3)
    if grabbed is not None:
        anchor = fitted(stage.design.curve(grabbed.shape).lines.points[grabbed.number], 3)
    origin = stage.camera.to_world(start.at, anchor)
    now = yield Shown(selection, Feedback(hint=HINT, cursor="move"))
    while True:
        by = shift(now, stage.camera.to_world(now.at, anchor) - origin, seen_plane(stage.camera))
        landing = None
        if not now.typed and snaps(now, stage):
            by, landing = snapped(by, anchor, grabbed, now, stage)
        text = shift_text(by, stage.camera)
        feedback = Feedback(hint=HINT, readout=text, cursor="move")
        now = yield Shown(MovePoints(targets, by, landing), feedback)


def shift(now: Pointer, by: Floats, plane: tuple[int, int]) -> Floats:
    """The shift (3,) that is meant: as typed, else that of the pointer with its constraints."""
    if now.typed:
        values = [0.0 if value is None else value for value in now.typed]
        if now.axis is not None:
            return along_axis(np.full(3, values[0]), now.axis)
        exact = np.zeros(3)
        exact[list(plane)] = values
        return exact
    if now.axis is not None:
        return along_axis(by, now.axis)
    return along_longer(by) if Held.SHIFT in now.held else by


def snaps(now: Pointer, stage: Stage) -> bool:
    """Whether points go to the grid: with Ctrl, or without where the view snaps by itself."""
    return (Held.CTRL in now.held) != stage.options.snap


def snapped(
    by: Floats, anchor: Floats, grabbed: LineId | None, now: Pointer, stage: Stage
) -> tuple[Floats, Landing | None]:
    """The shift that brings the grabbed point to the grid along the axes that are free."""
    free = np.zeros(3, dtype=bool)
    free[list(seen_plane(stage.camera))] = True
    if now.axis is not None:
        free[[axis != now.axis for axis in AXES]] = False
    elif Held.SHIFT in now.held:
        free[np.arange(3) != np.abs(by).argmax()] = False
    if grabbed is None:
        return np.where(free, to_grid(by, stage.grid_step), 0.0), None
    goal = np.where(free, to_grid(anchor + by, stage.grid_step), anchor)
    return goal - anchor, Landing(grabbed.shape, grabbed.number, goal)
