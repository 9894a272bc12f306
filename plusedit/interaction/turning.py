"""Drags that turn and stretch directions."""

from dataclasses import dataclass
from math import atan2, degrees, hypot, pi, radians

import numpy as np

from plusedit.commands.base import Landing, Targets
from plusedit.commands.directions import Turn, quarter_exact, turned
from plusedit.document.selection import LineId, Selection
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.places import seen_plane
from plusedit.interaction.readout import angle_text, number
from plusedit.interaction.snapping import ROUND_ANGLE, to_step
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage

SLOW = 0.1  # of the pointer's angle while Shift is held

DEAD = 12.0  # pixels around the center in which the pointer has no angle worth following
OF_START = 0.6  # of the distance at the start: a short handle has a smaller dead center
TOO_NEAR = 4.0  # pixels: from there no angle can be told

HINT = "Drag to rotate · Ctrl snaps to 15° · Shift is slow · Alt stretches · type degrees · Esc"


class Swing:
    """The angle by which a pointer has gone round a center on the screen.

    It counts full turns. A way straight through the center turns by nothing: what is held then
    is the other end of the line. Back at the start it is zero to the last bit, but for full turns.
    """

    def __init__(self, center: Floats, start: Floats) -> None:
        self._center = center
        self._from = self._before = start - center
        distance = hypot(*self._from)
        self._dead = min(DEAD, OF_START * distance)
        self._has_begun = distance >= TOO_NEAR
        self._angle = 0.0

    def to(self, at: Floats) -> float:
        """The angle in radians, counter-clockwise as seen, from the start to `at`."""
        now = at - self._center
        if not self._has_begun:
            self._begin(now)
        if hypot(*now) < self._dead or not self._has_begun:
            return self._angle
        period = pi if self._passes_through(now) else 2.0 * pi
        step = _angle(self._before, now)
        likely = self._angle + step - period * round(step / period)
        plain = _angle(self._from, now)
        self._angle = plain + pi * round((likely - plain) / pi)
        self._before = now
        return self._angle

    def _begin(self, now: Floats) -> None:
        """Begin where the pointer comes far enough from the center, having started on it."""
        if hypot(*now) >= TOO_NEAR:
            self._from = self._before = now
            self._dead, self._has_begun = TOO_NEAR, True

    def _passes_through(self, now: Floats) -> bool:
        way = now - self._before
        square = float(way @ way)
        if square == 0.0:
            return False
        share = min(1.0, max(0.0, float(-self._before @ way) / square))
        return hypot(*(self._before + share * way)) < self._dead


def _angle(first: Floats, second: Floats) -> float:
    """From one vector of pixels to another, counter-clockwise as seen, where y runs downwards."""
    (x1, y1), (x2, y2) = first, second
    return atan2(-(x1 * y2 - y1 * x2), x1 * x2 + y1 * y2)


@dataclass
class Slowed:
    """A number that follows another one at a speed that changes without a jump."""

    speed: float = 1.0
    offset: float = 0.0
    before: float = 0.0

    def of(self, value: float, *, slow: bool) -> float:
        """What stands at `value`; on the way there it was slow or not."""
        speed = SLOW if slow else 1.0
        if speed != self.speed:
            self.offset += (self.speed - speed) * self.before
            self.speed = speed
        self.before = value
        return value * self.speed + self.offset


def turn_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    held: LineId,
    side: int = 1,
    selection: Selection | None = None,
    hint: str = HINT,
) -> Drag:
    """Turn the directions of `targets` by the angle that the pointer goes round the line `held`.

    With Alt the tip on that side follows the pointer: `held` is set to it, the others turn and
    stretch alike.
    """
    curve = stage.design.curve(held.shape)
    grip = Grip(curve, held, side, seen_plane(stage.camera))
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
    """Pull a direction out of the dot of a line that has none."""
    curve = stage.design.curve(held.shape)
    grip = Grip(curve, held, 1, seen_plane(stage.camera))
    now = yield Shown(selection, Feedback(hint=HINT, cursor="turn"))
    targets = {held.shape: (held.number,)}
    while True:
        tip = stage.camera.to_world(now.at, grip.point)
        edit, text = grip.stretched(targets, tip, snap=Held.CTRL in now.held)
        now = yield Shown(edit, Feedback(hint=HINT, readout=text, cursor="turn"))


class Grip:
    """One end of a control line, and the edits that it makes of where it is drawn to."""

    def __init__(self, curve: PlusCurve, line: LineId, side: int, plane: tuple[int, int]) -> None:
        self._line = line
        self._side = side
        self._plane = plane
        self.point = curve.lines.points[line.number]
        self._direction = curve.directions[line.number]
        self._per_unit = curve.spacing * abs(curve.s)
        """the length of a handle whose direction has length 1"""

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
        return Turn(targets, angle, self._plane), angle_text(self.angle + angle, angle)

    def snapped(self, targets: Targets, angle: float) -> tuple[Turn, str]:
        """Turned so that this line points in a multiple of 15 degrees."""
        goal = to_step(self.angle + angle, ROUND_ANGLE)
        by, length = goal - self.angle, hypot(*self._seen)
        exact = self._placed(length * np.array(quarter_exact(goal)))
        landing = Landing(self._line.shape, self._line.number, exact)
        return Turn(targets, by, self._plane, landing=landing), angle_text(goal, by)

    def stretched(self, targets: Targets, tip: Floats, *, snap: bool) -> tuple[Turn | None, str]:
        """Turned and stretched so that the tip on this side of this line stands at `tip`."""
        way = self._side * (tip - self.point)
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
        landing = Landing(self._line.shape, self._line.number, self._placed(flat))
        size = f"{number(factor, 2)}×" if before > 0.0 else number(length, 2)
        text = f"length {size}  angle {number(degrees(goal), 1)}°"
        return Turn(targets, by, self._plane, factor, landing), text

    def _placed(self, flat: Floats) -> Floats:
        """The direction with those two components in the plane of the view."""
        result: Floats = self._direction.copy()
        for axis, value in zip(self._plane, flat, strict=True):
            if axis < len(result):
                result[axis] = value
        return result


def turned_about(center: Floats, angle: float, plane: tuple[int, int]) -> tuple[Floats, Floats]:
    """Matrix (3, 3) and offset (3,) of a turn about a point (3,)."""
    matrix = turned(np.eye(3), angle, plane).T
    offset: Floats = center - matrix @ center
    return matrix, offset
