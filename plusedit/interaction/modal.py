"""Drags begun by a key: move, turn or scale what is selected, about its centroid."""

from collections.abc import Callable, Mapping
from math import degrees, hypot

import numpy as np

from plusedit.commands.base import Targets
from plusedit.commands.lines import Transform
from plusedit.document.design import EditError
from plusedit.document.selection import LineId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.ball import frame_at
from plusedit.interaction.moving import centroid, is_flat, move_drag
from plusedit.interaction.places import in_world
from plusedit.interaction.readout import number, thread
from plusedit.interaction.revolving import rotation
from plusedit.interaction.snapping import AXES, to_step
from plusedit.interaction.space_turning import Axis, Turning, axis_drag
from plusedit.interaction.swing import TOO_NEAR, Slowed
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.interaction.turning import turn_drag
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item

NEAR = 100.0  # pixels that double the size where the pointer began on the center itself

FLAT_HINT = "Rotate · Ctrl snaps to 15° · Shift is slow · type degrees · Enter or click accepts"
TURN_HINT = FLAT_HINT.replace("Rotate", "Rotate · X, Y, Z about an axis")
SINGLE_HINT = (
    "Rotate the direction of this one line · Ctrl snaps to 15° · Shift is slow · "
    "type degrees · Enter or click accepts"
)
SCALE_HINT = (
    "Scale · X, Y, Z along an axis, with Shift across it · Ctrl snaps to tenths · Shift is slow · "
    "type a factor"
)


def move_selected(start: Pointer, stage: Stage) -> Drag:
    """Move what is selected; the active line lands on the grid."""
    targets = chosen(stage)
    return move_drag(start, stage, targets, stage.selection.active or single(targets))


def turn_selected(start: Pointer, stage: Stage) -> Drag:
    """Turn what is selected about its centroid; of a single line or plane only directions turn."""
    targets = chosen(stage)
    line = single(targets)
    if line is None:
        return _turn_all(start, stage, targets)
    geometry = stage.design[line.shape].geometry
    if isinstance(geometry, PlusCurve) and isinstance(stage.camera, PlaneCamera):
        return turn_drag(start, stage, targets, line, hint=SINGLE_HINT)
    own = _view_axis(stage, targets, centroid(stage.design, targets))
    return axis_drag(start, stage, targets, own)


def _view_axis(stage: Stage, targets: Targets, point: Floats) -> Axis:
    """The axis toward the eye; z of what lies in the plane z = 0 in a view of space."""
    if isinstance(stage.camera, PlaneCamera):
        return Axis(point, stage.camera.axes_of_view[2], lockable=not is_flat(stage, targets))
    if is_flat(stage, targets):
        return Axis(point, np.eye(3)[2], "z", lockable=False)
    return Axis(point, frame_at(stage.camera, point)[2])


def _turn_all(start: Pointer, stage: Stage, targets: Targets) -> Drag:
    center = centroid(stage.design, targets)
    at = stage.camera.to_screen(center[None])[0]
    own = _view_axis(stage, targets, center)
    turning, hint = Turning(stage.camera, own, start), TURN_HINT if own.lockable else FLAT_HINT
    now = yield Shown(feedback=Feedback(hint=hint, cursor="turn"))
    while True:
        about, angle = turning.to(now)
        matrix = rotation(about.axis, angle)
        text = f"angle {number(degrees(angle), 1)}°"
        feedback = Feedback(_leash(at, now, stage), hint, text, "turn")
        edit = Transform(targets, matrix, center - matrix @ center, "Rotate")
        now = yield Shown(edit, feedback)


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
            factors[[axis not in now.axis for axis in AXES]] = 1.0
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
    return lines[0] if len(lines) == len(targets) == 1 else None


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
