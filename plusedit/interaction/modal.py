"""Drags begun by a key: move, turn or scale what is selected, about its centroid."""

from collections.abc import Callable, Mapping
from math import degrees, hypot, radians

import numpy as np

from plusedit.commands.base import Targets, fitted
from plusedit.commands.lines import Transform
from plusedit.document.design import Design, EditError
from plusedit.document.selection import LineId
from plusedit.geometry.arrays import Floats
from plusedit.interaction.moving import move_drag
from plusedit.interaction.places import in_world, seen_plane
from plusedit.interaction.readout import number, thread
from plusedit.interaction.snapping import AXES, ROUND_ANGLE, to_step
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.interaction.turning import TOO_NEAR, Slowed, Swing, turn_drag, turned_about
from plusedit.scene.items import Item

NEAR = 100.0  # pixels that double the size where the pointer began on the center itself

TURN_HINT = "Rotate · Ctrl snaps to 15° · Shift is slow · type degrees · Enter or click accepts"
SINGLE_HINT = (
    "Rotate the direction of this one line · Ctrl snaps to 15° · Shift is slow · "
    "type degrees · Enter or click accepts"
)
SCALE_HINT = "Scale · X, Y along an axis · Ctrl snaps to tenths · Shift is slow · type a factor"


def move_selected(start: Pointer, stage: Stage) -> Drag:
    """Move what is selected; the active line lands on the grid."""
    targets = chosen(stage)
    return move_drag(start, stage, targets, stage.selection.active or single(targets))


def turn_selected(start: Pointer, stage: Stage) -> Drag:
    """Turn what is selected about its centroid; of a single line only the direction turns."""
    targets = chosen(stage)
    line = single(targets)
    if line is not None:
        return turn_drag(start, stage, targets, line, hint=SINGLE_HINT)
    return _turn_all(start, stage, targets)


def _turn_all(start: Pointer, stage: Stage, targets: Targets) -> Drag:
    center = centroid(stage.design, targets)
    at = stage.camera.to_screen(center[None])[0]
    swing, slowed, plane = Swing(at, start.at), Slowed(), seen_plane(stage.camera)
    now = yield Shown(feedback=Feedback(hint=TURN_HINT, cursor="turn"))
    while True:
        angle = slowed.of(swing.to(now.at), slow=Held.SHIFT in now.held)
        if now.typed:
            angle = radians(now.typed[0] or 0.0)
        elif Held.CTRL in now.held:
            angle = to_step(angle, ROUND_ANGLE)
        matrix, offset = turned_about(center, angle, plane)
        text = f"angle {number(degrees(angle), 1)}°"
        feedback = Feedback(_leash(at, now, stage), TURN_HINT, text, "turn")
        now = yield Shown(Transform(targets, matrix, offset, "Rotate"), feedback)


def scale_selected(start: Pointer, stage: Stage) -> Drag:
    """Scale what is selected about its centroid, or along one axis."""
    targets = chosen(stage)
    center = centroid(stage.design, targets)
    at = stage.camera.to_screen(center[None])[0]
    slowed = Slowed()
    now = yield Shown(feedback=Feedback(hint=SCALE_HINT, cursor="move"))
    while True:
        grown = slowed.of(_ratio(at, start.at, now.at) - 1.0, slow=Held.SHIFT in now.held)
        factor = 1.0 + grown
        if now.typed:
            factor = 1.0 if now.typed[0] is None else now.typed[0]
        elif Held.CTRL in now.held:
            factor = to_step(factor, 0.1)
        factors = np.full(3, factor)
        if now.axis is not None:
            factors[[axis != now.axis for axis in AXES]] = 1.0
        matrix = np.diag(factors)
        feedback = Feedback(
            _leash(at, now, stage), SCALE_HINT, f"scale {number(factor, 3)}×", "move"
        )
        now = yield Shown(Transform(targets, matrix, center - matrix @ center, "Scale"), feedback)


def chosen(stage: Stage) -> Targets:
    """What an edit of the selection acts on. EditError if that is nothing."""
    targets = stage.selection.targets(stage.design)
    if targets:
        return targets
    if stage.selection:
        raise EditError("What is selected is locked or hidden.")
    raise EditError("Nothing is selected.")


def single(targets: Targets) -> LineId | None:
    """The line, where the targets are one line alone."""
    lines = [LineId(shape_id, row) for shape_id, rows in targets.items() for row in rows]
    return lines[0] if len(lines) == 1 else None


def centroid(design: Design, targets: Targets) -> Floats:
    """(3,) the mean of the control points."""
    rows = [
        fitted(point, 3)
        for shape_id, numbers in targets.items()
        for point in design.curve(shape_id).lines.points[list(numbers)]
    ]
    mean: Floats = np.mean(rows, axis=0)
    return mean


def _ratio(center: Floats, start: Floats, now: Floats) -> float:
    """How much farther from the center the pointer is than it was."""
    before = hypot(*(start - center))
    if before < TOO_NEAR:
        return 1.0 + float(now[0] - start[0]) / NEAR
    return hypot(*(now - center)) / before


def _leash(at: Floats, now: Pointer, stage: Stage) -> tuple[Item, ...]:
    return (thread(in_world(np.stack([at, now.at]), stage.camera)),)


modal_drags: Mapping[str, Callable[[Pointer, Stage], Drag]] = {
    "move": move_selected,
    "turn": turn_selected,
    "scale": scale_selected,
}
