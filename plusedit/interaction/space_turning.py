"""Drags that turn directions in space: rigidly about an axis, or one over a ball."""

from dataclasses import dataclass
from math import degrees, radians

import numpy as np

from plusedit.commands.base import Landing, Side, Targets
from plusedit.commands.rotation import Rotate
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import Way
from plusedit.interaction.ball import Ball, azimuth, elevation, from_angles, turn_between
from plusedit.interaction.following import Follower
from plusedit.interaction.readout import number, pie
from plusedit.interaction.revolving import Revolver, rotation
from plusedit.interaction.snapping import AXES, ROUND_ANGLE, to_step
from plusedit.interaction.swing import Slowed
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.scene.camera import Camera
from plusedit.scene.gizmo import RADIUS
from plusedit.scene.handles import handles
from plusedit.scene.plane_handles import handles_of_plane

AXIS_HINT = (
    "Rotate · X, Y, Z about an axis · Ctrl snaps to 15° · Shift is slow · type degrees · "
    "Enter or click accepts · Esc"
)
BALL_HINT = (
    "Drag to point · X, Y, Z about an axis · Ctrl snaps to 15° · Shift is slow · Alt stretches · "
    "type degrees · Esc"
)
LEAST_FACTOR = 0.01  # of a length: what is drawn back to its point is not lost


@dataclass(frozen=True, eq=False)
class Axis:
    """What is turned about."""

    point: Floats
    """(3,)"""
    axis: Floats
    """(3,) unit vector"""
    name: str = ""
    lockable: bool = True
    """whether keys may take an axis of the world in its place"""

    def locked(self, now: Pointer) -> "Axis":
        """The axis of the world that a key has locked, through the same point; else itself."""
        if now.axis is None or not self.lockable:
            return self
        # Two axes are free in the plane across the third: a turn in it is about that one.
        names = now.axis if len(now.axis) == 1 else "".join(a for a in AXES if a not in now.axis)
        return Axis(self.point, np.eye(3)[AXES.index(names)], names)


class Turning:
    """The angle about an axis that pointer, keys and numbers mean."""

    def __init__(self, camera: Camera, own: Axis, start: Pointer) -> None:
        self._camera, self._own, self._start = camera, own, start
        self._revolvers: dict[str, Revolver] = {}
        self._slowed = Slowed()

    def to(self, now: Pointer) -> tuple[Axis, float]:
        """The axis, and the angle in radians counter-clockwise about it."""
        about = self._own.locked(now)
        angle = self._slowed.of(
            self.revolver(about, now.axis or "").to(now.at), slow=Held.SHIFT in now.held
        )
        if now.typed and now.typed[0] is not None:
            angle = radians(now.typed[0])
        elif Held.CTRL in now.held:
            angle = to_step(angle, ROUND_ANGLE)
        return about, angle

    def revolver(self, about: Axis, key: str) -> Revolver:
        """What follows the pointer about that axis."""
        if key not in self._revolvers:
            made = Revolver(self._camera, about.point, about.axis, self._start.at)
            self._revolvers[key] = made
        return self._revolvers[key]

    def feedback(self, about: Axis, angle: float, now: Pointer, hint: str) -> Feedback:
        """The sector that was turned through, and its angle."""
        first = self.revolver(about, now.axis or "").first
        radius = RADIUS * float(self._camera.pixel_at(about.point[None])[0])
        sector = pie(about.point, about.axis, first, angle, radius)
        text = f"{about.name} {number(degrees(angle), 1, signed=True)}°".strip()
        return Feedback(sector, hint, text, "turn")


def axis_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    own: Axis,
    selection: Selection | None = None,
    side: Side = "both",
) -> Drag:
    """Turn directions rigidly about an axis, each about its own control point.

    Both directions of a plane keep their lengths and their angle.
    """
    turning = Turning(stage.camera, own, start)
    now = yield Shown(selection, Feedback(hint=AXIS_HINT, cursor="turn"))
    while True:
        about, angle = turning.to(now)
        edit = Rotate(targets, rotation(about.axis, angle), side)
        now = yield Shown(edit, turning.feedback(about, angle, now, AXIS_HINT))


def ball_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    held: LineId,
    side: int,
    selection: Selection | None = None,
) -> Drag:
    """Let a grip follow the pointer over the ball about its control point.

    The directions on that side of all `targets` turn alike; with Alt they are stretched.
    """
    grip = SpaceGrip(stage.design[held.shape].geometry, held, side, stage.camera)
    ball = Ball(stage.camera, grip.point, grip.tip)
    turning = Turning(stage.camera, Axis(grip.point, ball.toward), start)
    stretch = Follower(stage.camera, grip.tip, unit(grip.tip - grip.point)[None])
    slow_x, slow_y = Slowed(), Slowed()
    now = yield Shown(selection, Feedback(hint=BALL_HINT, cursor="turn"))
    while True:
        slow = Held.SHIFT in now.held
        x, y = now.at - start.at
        moved = np.array([slow_x.of(float(x), slow=slow), slow_y.of(float(y), slow=slow)])
        if Held.ALT in now.held:
            edit, text = grip.stretched(targets, float(stretch.amounts(moved)[0]), now)
        elif now.axis is not None or now.typed:
            about, angle = turning.to(now)
            edit = Rotate(targets, rotation(about.axis, angle), grip.side)
            now = yield Shown(edit, turning.feedback(about, angle, now, BALL_HINT))
            continue
        else:
            edit, text = grip.pointed(targets, ball.to(moved), snap=Held.CTRL in now.held)
        now = yield Shown(edit, Feedback(hint=BALL_HINT, readout=text, cursor="turn"))


class SpaceGrip:
    """A grip in space, and the edits made of where it points."""

    def __init__(self, geometry: Geometry, line: LineId, side: int, camera: Camera) -> None:
        self._line = line
        is_plane = not isinstance(geometry, PlusCurve)
        way = side - 1 if is_plane else 0
        self._way: Way = "v" if way == 1 else "u"
        self.side: Side = self._way if is_plane else "both"
        self._sign = 1.0 if is_plane else float(side)
        self._direction = geometry.vectors[way, line.number]
        self.point = geometry.net.control_points[line.number]
        self.tip = tip_of(geometry, line.number, side, camera)

    @property
    def _arm(self) -> Floats:
        arm: Floats = self.tip - self.point
        return arm

    def pointed(self, targets: Targets, way: Floats | None, *, snap: bool) -> tuple[Rotate, str]:
        """Turned so that the grip points along a unit vector (3,); None: as it did."""
        before = unit(self._arm)
        after = before if way is None else way
        if snap:
            after = from_angles(
                to_step(azimuth(after), ROUND_ANGLE), to_step(elevation(after), ROUND_ANGLE)
            )
        matrix = np.eye(3) if way is None and not snap else turn_between(before, after)
        landings: tuple[Landing, ...] = ()
        if snap:
            exact = self._sign * float(np.linalg.norm(self._direction)) * after
            landings = (Landing(self._line.shape, self._line.number, exact, self._way),)
        edit = Rotate(targets, matrix, self.side, landings=landings)
        pointing = self._sign * after
        text = (
            f"az {number(degrees(azimuth(pointing)), 1)}°  "
            f"el {number(degrees(elevation(pointing)), 1)}°"
        )
        return edit, text

    def stretched(self, targets: Targets, by: float, now: Pointer) -> tuple[Rotate, str]:
        """Longer by as much as the grip went along its arm, in the world."""
        factor = 1.0 + by / float(np.linalg.norm(self._arm))
        if now.typed and now.typed[0] is not None:
            factor = now.typed[0]
        elif Held.CTRL in now.held:
            factor = to_step(factor, 0.1)
        factor = max(factor, LEAST_FACTOR)
        edit = Rotate(targets, np.eye(3), self.side, factor)
        return edit, f"length {number(factor, 2)}×"


def tip_of(geometry: Geometry, number: int, side: int, camera: Camera) -> Floats:
    """(3,) where a grip stands in the world."""
    if isinstance(geometry, PlusCurve):
        arm = handles(geometry, camera).arms[number]
        stand: Floats = geometry.lines.points[number] + side * arm
        return stand
    at, row = handles_of_plane(geometry, number, camera)
    tip: Floats = at.tips_world[side - 1, row]
    return tip
