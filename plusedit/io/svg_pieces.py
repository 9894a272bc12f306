"""Pieces: what the outlines of SVG are made of, each a Bezier curve of degree 1 to 3.

A line has two points, a quadratic three, a cubic four. An arc of an ellipse of up to 90 degrees
is a rational quadratic: with the tangents at its ends meeting in M,

    w0 = w2 = 1,   w1 = cos(half the angle)    and the points    E(a), M, E(b),

which is the ellipse exactly and stays so under every affine map of the points.
"""

from dataclasses import dataclass, field, replace
from math import asin, atan2, ceil, cos, hypot, pi, radians, sin, tan

import numpy as np

from plusedit.geometry.arrays import Floats

QUARTER = pi / 2.0
TINY = 1e-100  # a radius below this is none: divided by it, coordinates pass a double

Point = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Piece:
    """One Bezier curve of an outline."""

    points: Floats
    """(degree + 1, 2)"""
    weight: float = 1.0
    """of the middle point of an arc; the others have 1"""

    @property
    def degree(self) -> int:
        return len(self.points) - 1

    @property
    def is_arc(self) -> bool:
        """Whether it is rational: an arc of an ellipse."""
        return self.weight != 1.0

    def mapped(self, matrix: Floats) -> "Piece":
        """The piece under an affine map (2, 3)."""
        return replace(self, points=self.points @ matrix[:, :2].T + matrix[:, 2])

    def at(self, t: Floats) -> Floats:
        """(m, 2) points at t in [0, 1]."""
        weights = np.ones(len(self.points))
        weights[1] = self.weight
        rows = np.column_stack([self.points * weights[:, None], weights])
        layers = np.broadcast_to(rows[:, None], (len(rows), len(t), 3))
        while len(layers) > 1:
            layers = layers[:-1] + t[:, None] * (layers[1:] - layers[:-1])
        points: Floats = layers[0, :, :2] / layers[0, :, 2:]
        return points


@dataclass(eq=False)
class Outline:
    """A chain of pieces, each beginning where the one before ends: a subpath."""

    start: tuple[float, float]
    pieces: list[Piece] = field(default_factory=list)
    closed: bool = False

    @property
    def end(self) -> tuple[float, float]:
        """Where the next piece begins."""
        if not self.pieces:
            return self.start
        x, y = self.pieces[-1].points[-1]
        return float(x), float(y)

    def add(self, *points: tuple[float, float], weight: float = 1.0) -> None:
        """Append a piece from the end through `points`."""
        self.pieces.append(Piece(np.array([self.end, *points], dtype=np.float64), weight))

    def close(self) -> None:
        """Return to the start, by a line if it is not reached already."""
        if self.end != self.start:
            self.add(self.start)
        self.closed = True

    def add_arc(
        self, radii: tuple[float, float], turn: float, large: bool, sweep: bool, to: Point
    ) -> None:
        """Append an elliptical arc as the path command A describes it; `turn` in degrees."""
        rx, ry = abs(radii[0]), abs(radii[1])
        if to == self.end:
            return
        if rx < TINY or ry < TINY:
            self.add(to)
            return
        for middle, end, weight in _arc(self.end, (rx, ry), radians(turn), large, sweep, to):
            self.add(middle, end, weight=weight)


@dataclass(frozen=True)
class _Frame:
    """The frame of an ellipse, in which it is the unit circle, about the middle of a chord.

    Measured from there rather than from its center nothing is lost far from the origin.
    """

    origin: Point
    radii: Point
    turn: float

    def inside(self, x: float, y: float) -> Point:
        """A vector of the drawing in the frame."""
        along, across = cos(self.turn) * x + sin(self.turn) * y, cos(self.turn) * y
        return along / self.radii[0], (across - sin(self.turn) * x) / self.radii[1]

    def outside(self, x: float, y: float) -> Point:
        """The point of the drawing that is (x, y) in the frame."""
        x, y = self.radii[0] * x, self.radii[1] * y
        cosine, sine = cos(self.turn), sin(self.turn)
        return self.origin[0] + cosine * x - sine * y, self.origin[1] + sine * x + cosine * y


def _arc(
    start: Point, radii: Point, turn: float, large: bool, sweep: bool, to: Point
) -> list[tuple[Point, Point, float]]:
    """Middle point, end and weight of every piece of an arc between two different points.

    On the unit circle the center lies on the bisector of the chord, whose half is (x, y); radii
    too small to reach are scaled up (SVG 1.1, appendix F.6).
    """
    frame = _Frame(((start[0] + to[0]) / 2.0, (start[1] + to[1]) / 2.0), radii, turn)
    x, y = frame.inside((start[0] - to[0]) / 2.0, (start[1] - to[1]) / 2.0)
    reach = hypot(x, y)
    if reach > 1.0:
        frame = replace(frame, radii=(radii[0] * reach, radii[1] * reach))
        x, y, reach = x / reach, y / reach, 1.0
    half = asin(reach)
    side = 1.0 if sweep else -1.0
    if not large and half <= QUARTER / 2.0:
        # From the chord, not from a center that may be very far away.
        bulge = side * tan(half)
        return [(frame.outside(-y * bulge, x * bulge), to, cos(half))]
    angle = side * (2.0 * (pi - half) if large else 2.0 * half)
    height = cos(half) / reach * (-side if large else side)
    center = (y * height, -x * height)
    begin = atan2(y - center[1], x - center[0])
    count = max(1, ceil(abs(angle) / QUARTER - 1e-9))
    step = angle / count
    weight = cos(step / 2.0)

    def on_circle(along: float, radius: float) -> Point:
        return frame.outside(center[0] + radius * cos(along), center[1] + radius * sin(along))

    middles = [on_circle(begin + (i + 0.5) * step, 1.0 / weight) for i in range(count)]
    ends = [on_circle(begin + i * step, 1.0) for i in range(1, count)]
    return [(m, end, weight) for m, end in zip(middles, [*ends, to], strict=True)]


def ellipse(cx: float, cy: float, rx: float, ry: float) -> Outline:
    """The closed outline of an ellipse: four quarters, beginning at its right end."""
    outline = Outline((cx + rx, cy))
    across = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    points = [(cx + x * rx, cy + y * ry) for x, y in across]
    for corner, end in zip(points[1::2], points[2::2], strict=True):
        outline.add(corner, end, weight=cos(QUARTER / 2.0))
    outline.closed = True
    return outline


def rectangle(x: float, y: float, width: float, height: float, rx: float, ry: float) -> Outline:
    """The closed outline of a rectangle with corners rounded by quarters of an ellipse."""
    right, bottom = x + width, y + height
    if rx <= 0.0 or ry <= 0.0:
        return polyline([(x, y), (right, y), (right, bottom), (x, bottom)], closed=True)
    outline = Outline((x + rx, y))
    sides = [
        ((right - rx, y), (right, y), (right, y + ry)),
        ((right, bottom - ry), (right, bottom), (right - rx, bottom)),
        ((x + rx, bottom), (x, bottom), (x, bottom - ry)),
        ((x, y + ry), (x, y), (x + rx, y)),
    ]
    for side, corner, end in sides:
        if side != outline.end:
            outline.add(side)
        outline.add(corner, end, weight=cos(QUARTER / 2.0))
    outline.closed = True
    return outline


def polyline(points: list[Point], *, closed: bool) -> Outline:
    """Lines through points; back to the first one if `closed`."""
    outline = Outline(points[0])
    for point in points[1:]:
        outline.add(point)
    if closed:
        outline.close()
    return outline
