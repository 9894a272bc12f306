"""Regions that a plus curve cannot leave.

Every line at both ends of the domain, P1_i = L_i(0) and P2_i = L_i(1), gives two classical curves
with C(u) = (1 - u) C_1(u) + u C_2(u): the parents. C lies in the convex hull of all P1 and P2
together. It also lies in the hull of its control points in standard form, and between two knots
in the hull of the lines active there, taken at the knots.
"""

from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.lines import ControlLines

Axes = tuple[int, int]


def parents(curve: PlusCurve) -> tuple[PlusCurve, PlusCurve]:
    """The classical curves of the points L_i(0) and of the points L_i(1).

    ValueError for a closed curve: it is no mean of two closed ones.
    """
    if curve.closed:
        raise ValueError("a closed curve has no parent curves")
    starts, ends = line_ends(curve)
    first, second = (ControlLines.of(at, weights=curve.lines.weights) for at in (starts, ends))
    return replace(curve, lines=first, s=0.0), replace(curve, lines=second, s=0.0)


def line_ends(curve: PlusCurve) -> tuple[Floats, Floats]:
    """(n, dim) each: the points L_i(0) and L_i(1) of an open curve."""
    nodes, gradients = curve.basis.nodes[:, None], curve.gradients
    points = curve.lines.points
    return points - nodes * gradients, points + (1.0 - nodes) * gradients


def parent_hulls(curve: PlusCurve, axes: Axes = (0, 1)) -> tuple[Floats, Floats]:
    """The convex hulls of the control points of both parents; ValueError for a closed curve."""
    first, second = parents(curve)
    return (
        convex_hull(first.lines.points[:, list(axes)]),
        convex_hull(second.lines.points[:, list(axes)]),
    )


def union_hull(curve: PlusCurve, axes: Axes = (0, 1)) -> Floats:
    """The convex hull (h, 2) of all lines at both ends; the curve lies in it.

    Of a closed B-spline+ curve, whose lines come back shifted, it is that of all spans.
    ValueError for a closed curve of another family.
    """
    if curve.closed:
        return convex_hull(span_points(curve).reshape(-1, curve.dimension)[:, list(axes)])
    return convex_hull(np.concatenate(line_ends(curve))[:, list(axes)])


def elevated_hull(curve: PlusCurve, axes: Axes = (0, 1)) -> Floats:
    """The convex hull (h, 2) of the control points in standard form, which is a tighter one.

    ValueError where the family has no standard form.
    """
    return convex_hull(elevated(curve).points[:, list(axes)])


def span_hulls(curve: PlusCurve, axes: Axes = (0, 1)) -> list[Floats]:
    """For the piece between each two neighboring knots, a convex hull (h, 2) that holds it.

    A curve without knots is one piece. ValueError for a closed curve of another family than
    B-splines: all images of its lines have a part everywhere.
    """
    return [convex_hull(points[:, list(axes)]) for points in span_points(curve)]


def span_points(curve: PlusCurve) -> Floats:
    """(p, 2 k, dim) the active lines of every span at both of its ends.

    A curve without knots is one span. ValueError for a closed curve of another family than
    B-splines.
    """
    basis = curve.basis
    if not isinstance(basis, BSpline):
        if curve.closed:
            raise ValueError("only closed B-splines have hulls")
        return np.concatenate(line_ends(curve))[None]
    breaks = basis.breaks
    middles, halves = (breaks[:-1] + breaks[1:]) / 2.0, np.diff(breaks) / 2.0
    rows, distances = basis.active(middles)
    points, gradients = curve.lines.points[rows], curve.gradients[rows]
    pulls = [distances - halves[:, None], distances + halves[:, None]]
    return np.concatenate([points + pull[..., None] * gradients for pull in pulls], axis=1)


def convex_hull(points: Floats) -> Floats:
    """(h, 2) the corners of the smallest convex region that holds the points (m, 2).

    Counter-clockwise from the leftmost, the lowest of those. Points on an edge are left out: of
    points in a row the two ends stay, of equal points one.
    """
    rows = np.unique(points, axis=0).tolist()  # sorted by x, then by y
    if len(rows) <= 2:
        return np.array(rows).reshape(-1, 2)
    lower, upper = _chain(rows), _chain(rows[::-1])
    return np.array(lower[:-1] + upper[:-1])


def _chain(rows: list[list[float]]) -> list[list[float]]:
    """The corners of the hull on the right-hand side of the way from the first row to the last."""
    chain: list[list[float]] = []
    for x, y in rows:
        while len(chain) >= 2:
            (x0, y0), (x1, y1) = chain[-2:]
            if (x1 - x0) * (y - y0) > (y1 - y0) * (x - x0):
                break
            chain.pop()
        chain.append([x, y])
    return chain
