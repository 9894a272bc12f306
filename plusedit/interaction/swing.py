"""Angles that follow the pointer."""

from dataclasses import dataclass
from math import atan2, copysign, hypot, pi

from plusedit.geometry.arrays import Floats

SLOW = 0.1  # of the pointer's angle while Shift is held

DEAD = 12.0  # pixels around the center in which the pointer has no angle worth following
OF_START = 0.6  # of the distance at the start: a short handle has a smaller dead center
CATCHES_UP = 15.0  # pixels, the least way on which an angle that could not be told is made up for
TOO_NEAR = 4.0  # pixels: from there no angle can be told


class Swing:
    """The angle by which a pointer has gone round a center on the screen.

    It counts full turns. A way straight through the center turns by nothing: what is held then
    is the other end of the line. On a way that goes by so close that no angle can be told, it is
    made up for afterwards, little by little. Back at the start it is zero to the last bit, but for
    half and full turns.
    """

    def __init__(self, center: Floats, start: Floats, dead: float = DEAD) -> None:
        self._center = center
        self._from = self._before = self._last = start - center
        distance = hypot(*self._from)
        self._dead = min(dead, OF_START * distance)
        self._pace = pi / 2.0 / max(distance - self._dead, CATCHES_UP)
        """radians made up for with each pixel: all of it on the way back to the start"""
        self._has_begun = distance >= TOO_NEAR
        self._angle = self._lag = 0.0

    def to(self, at: Floats) -> float:
        """The angle in radians, counter-clockwise as seen, from the start to `at`."""
        now = at - self._center
        if not self._has_begun:
            self._begin(now)
        if hypot(*now) >= self._dead and self._has_begun:
            self._follow(now)
        self._last = now
        return self._angle + self._lag

    def _follow(self, now: Floats) -> None:
        said, passes = self._angle + self._lag, self._passes_through(now)
        period = pi if passes else 2.0 * pi
        step = _angle(self._before, now)
        likely = self._angle + step - period * round(step / period)
        plain = _angle(self._from, now)
        self._angle = plain + pi * round((likely - plain) / pi)
        if passes:
            self._lag = said - self._angle
        made_up = self._pace * hypot(*(now - self._last))
        self._lag = copysign(max(abs(self._lag) - made_up, 0.0), self._lag)
        self._before = now

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
