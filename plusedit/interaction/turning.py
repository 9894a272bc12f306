"""Drags that turn and stretch directions."""

from math import atan2, degrees, hypot, radians

import numpy as np

from plusedit.commands.base import Landing, Side, Targets
from plusedit.commands.directions import SetDirection, Turn, quarter_exact
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import Way
from plusedit.interaction.places import in_space, seen_plane
from plusedit.interaction.readout import angle_text, number
from plusedit.interaction.snapping import ROUND_ANGLE, to_step
from plusedit.interaction.space_turning import Axis, axis_drag, ball_drag
from plusedit.interaction.swing import Slowed, Swing
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.plane_handles import Planar, handles_of_plane, plane_reaches

HINT = "Drag to rotate · Ctrl snaps to 15° · Shift is slow · Alt stretches · type degrees · Esc"


def turn_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    held: LineId,
    side: int = 1,
    selection: Selection | None = None,
    hint: str = HINT,
) -> Drag:
    """Turn the directions of `targets` as the pointer draws a grip of `held`.

    In a view of a plane by the angle that it goes round the control point; with Alt the tip on
    that side follows the pointer: `held` is set to it, the others turn and stretch alike. In space
    the grip follows the pointer over the ball about the control point.
    """
    geometry = stage.design[held.shape].geometry
    if isinstance(stage.camera, PlaneCamera):
        return _flat_drag(start, stage, targets, held, side, selection, hint)
    if geometry.dimension == 2:
        point = in_space(geometry.net.control_points[[held.number]])[0]
        upright = Axis(point, np.eye(3)[2], "z", lockable=False)
        return axis_drag(start, stage, targets, upright, selection)
    return ball_drag(start, stage, targets, held, side, selection)


def _flat_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    held: LineId,
    side: int,
    selection: Selection | None,
    hint: str,
) -> Drag:
    grip = Grip(stage.design[held.shape].geometry, held, side, stage.camera)
    center = stage.camera.to_screen(grip.point[None])[0]
    swing, slowed = Swing(center, start.at), Slowed()
    now = yield Shown(selection, Feedback(hint=hint, cursor="turn"))
    edit: Turn | None
    while True:
        angle = slowed.of(swing.to(now.at), slow=Held.SHIFT in now.held)
        if now.typed:
            edit, text = grip.by(targets, radians(now.typed[0] or 0.0))
        elif Held.ALT in now.held:
            tip = stage.camera.to_world(now.at, grip.point)
            edit, text = grip.stretched(targets, tip, snap=Held.CTRL in now.held)
        elif Held.CTRL in now.held:
            edit, text = grip.snapped(targets, angle)
        else:
            edit, text = grip.by(targets, angle)
        now = yield Shown(edit, Feedback(hint=hint, readout=text, cursor="turn"))


def pull_drag(start: Pointer, stage: Stage, held: LineId, selection: Selection) -> Drag:
    """Pull a direction out of the dot of a line or plane that has none."""
    geometry = stage.design[held.shape].geometry
    side = 2 if geometry.vectors[0, held.number].any() else 1
    if not isinstance(stage.camera, PlaneCamera):
        return _pull_in_space(stage, held, side, selection)
    return _pull_in_plane(stage, held, side, selection)


def _pull_in_plane(stage: Stage, held: LineId, side: int, selection: Selection) -> Drag:
    grip = Grip(stage.design[held.shape].geometry, held, side, stage.camera)
    now = yield Shown(selection, Feedback(hint=HINT, cursor="turn"))
    targets = {held.shape: (held.number,)}
    while True:
        tip = stage.camera.to_world(now.at, grip.point)
        edit, text = grip.stretched(targets, tip, snap=Held.CTRL in now.held)
        now = yield Shown(edit, Feedback(hint=HINT, readout=text, cursor="turn"))


def _pull_in_space(stage: Stage, held: LineId, side: int, selection: Selection) -> Drag:
    geometry = stage.design[held.shape].geometry
    point, reach = geometry.net.control_points[held.number], reach_of(geometry, held.number, side)
    now = yield Shown(selection, Feedback(hint=HINT, cursor="turn"))
    while True:
        way = stage.camera.to_world(now.at, point) - point
        direction = way / reach if reach > 0.0 else unit(way)
        text = f"length {number(float(np.linalg.norm(direction)), 2)}"
        edit = SetDirection(*held, direction, side_of(geometry, side))
        now = yield Shown(edit, Feedback(hint=HINT, readout=text, cursor="turn"))


def side_of(geometry: Geometry, side: int) -> Side:
    """Which directions a grip on that side of a line or plane stands for."""
    if isinstance(geometry, PlusCurve):
        return "both"
    return "v" if side == 2 else "u"


def reach_of(geometry: Geometry, number: int, side: int) -> float:
    """The length of the handle of a direction of length 1, as it is by itself."""
    if isinstance(geometry, PlusCurve):
        return geometry.spacing * abs(geometry.s)
    return float(plane_reaches(geometry, np.array([number]))[side - 1, 0])


class Grip:
    """An end of a control line or an arm of a plane, and the edits made of where it is drawn to."""

    def __init__(self, geometry: Geometry, line: LineId, side: int, camera: Camera) -> None:
        self._line = line
        self._is_plane = not isinstance(geometry, PlusCurve)
        self._side = side_of(geometry, side)
        self._way: Way = "v" if self._side == "v" else "u"
        self._sign = 1 if self._is_plane else side
        self._plane = seen_plane(camera)
        self.point = geometry.net.control_points[line.number]
        self._direction = geometry.vectors[side - 1 if self._is_plane else 0, line.number]
        self._per_unit = reach_of(geometry, line.number, side)
        if not isinstance(geometry, PlusCurve):
            self._per_unit = _drawn_reach(geometry, line.number, side - 1, camera)

    @property
    def _seen(self) -> Floats:
        """(2,) the direction in the plane of the view."""
        return np.array([self._in(self._direction, axis) for axis in self._plane])

    @staticmethod
    def _in(vector: Floats, axis: int) -> float:
        return float(vector[axis]) if axis < len(vector) else 0.0

    @property
    def angle(self) -> float:
        """Of the direction in the plane of the view, in radians."""
        x, y = self._seen
        return atan2(y, x)

    def by(self, targets: Targets, angle: float) -> tuple[Turn, str]:
        """Everything turned by an angle."""
        text = angle_text(self.angle + angle, angle)
        return Turn(targets, angle, self._plane, side=self._side), text

    def snapped(self, targets: Targets, angle: float) -> tuple[Turn, str]:
        """Turned so that this direction points to a multiple of 15 degrees."""
        goal = to_step(self.angle + angle, ROUND_ANGLE)
        by, length = goal - self.angle, hypot(*self._seen)
        exact = self._placed(length * np.array(quarter_exact(goal)))
        text = angle_text(goal, by)
        return Turn(targets, by, self._plane, 1.0, self._landing(exact), self._side), text

    def stretched(self, targets: Targets, tip: Floats, *, snap: bool) -> tuple[Turn | None, str]:
        """Turned and stretched so that the tip on this side stands at `tip`."""
        way = self._sign * (tip - self.point)
        flat = np.array([self._in(way, axis) for axis in self._plane])
        if not flat.any():
            return None, ""
        # Where s is zero the handle says nothing of the length of its direction.
        flat = flat / self._per_unit if self._per_unit > 0.0 else unit(flat)
        goal, length = atan2(flat[1], flat[0]), hypot(*flat)
        if snap:
            goal = to_step(goal, ROUND_ANGLE)
            flat = length * np.array(quarter_exact(goal))
        before = hypot(*self._seen)
        by = goal - self.angle if before > 0.0 else 0.0
        factor = length / before if before > 0.0 else 1.0
        landing = self._landing(self._placed(flat))
        size = f"{number(factor, 2)}×" if before > 0.0 else number(length, 2)
        text = f"length {size}  angle {number(degrees(goal), 1)}°"
        return Turn(targets, by, self._plane, factor, landing, self._side), text

    def _landing(self, direction: Floats) -> Landing:
        return Landing(self._line.shape, self._line.number, direction, self._way)

    def _placed(self, flat: Floats) -> Floats:
        """The direction with those two components in the plane of the view."""
        result: Floats = self._direction.copy()
        for axis, value in zip(self._plane, flat, strict=True):
            if axis < len(result):
                result[axis] = value
        return result


def _drawn_reach(geometry: Planar, number: int, way: int, camera: Camera) -> float:
    """The length of an arm as it is drawn, for a direction of length 1; 0 where there is none."""
    length = float(np.linalg.norm(geometry.vectors[way, number]))
    if length == 0.0:
        return reach_of(geometry, number, way + 1)
    at, row = handles_of_plane(geometry, number, camera)
    return float(np.linalg.norm(at.tips_world[way, row] - at.world[row])) / length
