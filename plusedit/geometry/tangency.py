"""Curves that leave and reach their ends along the control lines there, and close smoothly.

An open Bezier+ or B-spline+ curve begins at P_0 with the velocity

    C'(0) = g_0 + r (e - g_1),   e = (P_1 - P_0) / (x_1 - x_0),   r = W_1 / W_0,

and its end mirrors that: 0 -> l, 1 -> l - 1, e -> (P_l - P_{l-1}) / (x_l - x_{l-1}). With the
heading d = g_0 / |g_0| the velocity runs along the control line at the speed m, C'(0) = m d, where

    g_1 = (e - (e . d) d) + a d,   m = |g_0| + r (e . d - a),

for any a: turning the neighboring line is enough, and a chooses the speed.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve

How = Literal["least", "exact", "unit"]

SLOWEST = 0.1  # of the classical curve's speed at the end: slower, it looks like a cusp
OPPOSITE = 1e-9  # sum of two unit vectors: such lines have no middle but for rounding


def tangent_at_ends(
    curve: PlusCurve,
    *,
    start: bool = True,
    end: bool = True,
    how: How = "least",
    speed: float | None = None,
) -> PlusCurve:
    """The curve with its second and last but one lines changed so that the ends are tangent.

    Parameters
    ----------
    start, end
        Which ends: there the curve will run along the control line, forwards. For both it
        takes 4 control lines, for one 3.
    how
        "least": the least change; only what is across the end line. "exact": so that the curve
        has the given speed there. "unit": so that the changed direction has length one, as far
        as s is large enough for that.
    speed
        Length per unit of parameter. For "exact" the speed, for "least" a lower bound of it; a
        tenth of the classical curve's by default.

    Raises ValueError, in a sentence for people, where the curve can't be made so.
    """
    _check_open(curve)
    needed = 4 if start and end else 3
    if len(curve.lines) < needed:
        ends = "both ends" if needed == 4 else "an end"
        raise ValueError(
            f"Tangency at {ends} needs at least {needed} control lines: "
            f"each end turns the line beside it. This curve has {len(curve.lines)}."
        )
    if speed is not None and not speed > 0.0:
        raise ValueError(f"speed: must be positive, got {speed}")
    gradients = {}
    for wanted, place in ((start, _start(curve)), (end, _end(curve))):
        if wanted:
            gradients[place.beside] = _turned(place, how, speed, curve.s)
    return _with_gradients(curve, gradients)


def closed_smoothly(curve: PlusCurve) -> PlusCurve:
    """The curve with its last point on its first one, and one velocity for both.

    The two end lines become one and the same, halfway between them; of all speeds the one that
    changes the lines beside them least is taken. For Bezier+ and open B-spline+ curves of at
    least 4 lines; others have a closed basis. Raises ValueError where the curve can't be closed.
    """
    _check_open(curve)
    if len(curve.lines) < 4:
        raise ValueError(
            f"Closing smoothly needs at least 4 control lines; this curve has {len(curve.lines)}."
        )
    points = curve.lines.points.copy()
    points[-1] = points[0]
    joined = replace(curve, lines=curve.lines.with_points(points))
    common = _common_gradient(joined)
    last = len(points) - 1
    joined = _with_gradients(joined, {0: common, last: common})
    places = _start(joined), _end(joined)
    speed = _least_common_speed(places)
    return _with_gradients(
        joined, {place.beside: place.gradient_for(place.along_for(speed)) for place in places}
    )


@dataclass(frozen=True, eq=False)
class _End:
    """One end of a curve and the line beside it; everything runs in the sense of the curve."""

    beside: int
    """index of the neighboring line"""
    gradient: Floats
    """g_0, of the end line"""
    chord: Floats
    """e"""
    ratio: float
    """r"""
    neighbor: Floats
    """g_1 as it is"""

    @property
    def heading(self) -> Floats:
        """d"""
        return unit(self.gradient)

    @property
    def across(self) -> Floats:
        """e - (e . d) d"""
        return self.chord - (self.chord @ self.heading) * self.heading

    @property
    def slowest(self) -> float:
        """The speed below which the end would look like a cusp."""
        length = float(np.linalg.norm(self.chord)) or float(np.linalg.norm(self.gradient))
        return SLOWEST * length

    def speed_for(self, along: float) -> float:
        """m for a."""
        leg = float(self.chord @ self.heading)
        return float(np.linalg.norm(self.gradient)) + self.ratio * (leg - along)

    def along_for(self, speed: float) -> float:
        """a for m."""
        leg = float(self.chord @ self.heading)
        return leg + (float(np.linalg.norm(self.gradient)) - speed) / self.ratio

    def gradient_for(self, along: float) -> Floats:
        """g_1 for a."""
        return self.across + along * self.heading


def _start(curve: PlusCurve) -> _End:
    return _end_of(curve, 0, 1)


def _end(curve: PlusCurve) -> _End:
    last = len(curve.lines) - 1
    return _end_of(curve, last, last - 1)


def _end_of(curve: PlusCurve, index: int, beside: int) -> _End:
    points, nodes, weights = curve.lines.points, curve.basis.nodes, curve.lines.unit_weights
    if not curve.directions[index].any():
        which = "first" if index == 0 else "last"
        raise ValueError(f"The {which} control line has no direction; give it one first.")
    chord = (points[beside] - points[index]) / (nodes[beside] - nodes[index])
    ratio = float(weights[beside] / weights[index])
    return _End(beside, curve.gradients[index], chord, ratio, curve.gradients[beside])


def _turned(place: _End, how: How, speed: float | None, s: float) -> Floats:
    """The gradient of the neighboring line."""
    if how == "unit":
        return place.gradient_for(_along_of_unit(place, s))
    least = place.slowest if speed is None else speed
    if how == "exact":
        return place.gradient_for(place.along_for(least))
    along = float(place.neighbor @ place.heading)
    return place.gradient_for(min(along, place.along_for(least)))


def _along_of_unit(place: _End, s: float) -> float:
    """a such that g_1 / s has length one: of the two, the slower that still runs forwards."""
    across = float(np.linalg.norm(place.across))
    if abs(s) < across:
        raise ValueError(
            f"With directions of length one this end is tangent only for s of at least "
            f"{across:.6g}; s is {abs(s):.6g}."
        )
    c = float(np.sqrt((abs(s) - across) * (abs(s) + across)))
    for along in (c, -c):
        if place.speed_for(along) > 0.0:
            return along
    raise ValueError("With directions of length one the curve would run backwards at this end.")


def _common_gradient(curve: PlusCurve) -> Floats:
    """Halfway between the gradients of both end lines."""
    points, (first, last) = curve.lines.points, curve.gradients[[0, -1]]
    lengths = np.linalg.norm([first, last], axis=1)
    if not lengths.any():
        raise ValueError("The end control lines have no direction; give them one first.")
    heading = unit(first) + unit(last)
    if np.linalg.norm(heading) < OPPOSITE:
        heading = points[1] - points[-2]
    if not heading.any():
        heading = first
    common: Floats = unit(heading) * lengths[lengths > 0.0].mean()
    return common


def _least_common_speed(places: tuple[_End, _End]) -> float:
    """The m for which both lines change least along the heading, but not below the slowest."""
    free = np.array([place.along_for(0.0) - place.neighbor @ place.heading for place in places])
    rate = np.array([1.0 / place.ratio for place in places])
    least = float(np.mean([place.slowest for place in places]))
    return max(float(free @ rate / (rate @ rate)), least)


def _with_gradients(curve: PlusCurve, gradients: dict[int, Floats]) -> PlusCurve:
    """The curve with some gradients; the magnitude stays, the directions become given."""
    lines = curve.lines
    for index, gradient in gradients.items():
        lines = lines.with_direction(index, gradient / curve.s)
    return replace(curve, lines=lines)


def end_objection(curve: PlusCurve, *, at_start: bool) -> str:
    """Why one end can't be made tangent by itself, with what would help; empty where it can."""
    try:
        _check_open(curve)
        _start(curve) if at_start else _end(curve)
    except ValueError as error:
        return str(error)
    if len(curve.lines) < 3:
        return (
            "Tangency at an end needs at least 3 control lines: the one beside it turns. "
            f"This curve has {len(curve.lines)}."
        )
    return ""


def _check_open(curve: PlusCurve) -> None:
    if curve.closed:
        raise ValueError("A closed curve has no ends.")
    if not isinstance(curve.basis, Bernstein | BSpline):
        raise ValueError(
            "A rational Gaussian curve does not end on its first and last control line; "
            "to close it, use its closed basis."
        )
    if curve.s == 0.0:
        raise ValueError("With s = 0 control lines have no effect; set s first.")
