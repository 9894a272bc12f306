"""Several curves made alike: in space, in one basis and with one magnitude s.

Surfaces through curves blend control lines of the same number, so the curves need the same basis.
Bezier+ and B-spline+ curves get there without any change: their orders are raised and their knots
merged; closed B-spline+ curves of one order become finer; beside open ones they are cut open.
Rational Gaussians, and closed curves that differ in more, are fitted.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import lcm

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.refining import as_bspline, finer, opened, raised, with_knots
from plusedit.geometry.making.refitting import fitted_together

TOLERANCE = 1e-4  # of the extent of all curves: how far fitted ones may leave theirs
MOST = 96  # lines that an exact form may have before a fitted one serves better
SAME_KNOT = 1e-9  # knots of two curves that are closer are one


@dataclass(frozen=True, eq=False)
class Compatible:
    """Curves with the same basis and s, all of them in space."""

    curves: tuple[PlusCurve, ...]
    largest_miss: float
    """between points of the same parameter on a curve given and the one made; 0 where exact"""


def compatible(curves: Sequence[PlusCurve], *, tolerance: float | None = None) -> Compatible:
    """The curves in one basis and with one s, each the same curve as before if that can be.

    Where it can't be, all are fitted, without weights, within the tolerance: a distance, by
    default 1e-4 of the extent of all curves together.
    """
    alike = of_one_magnitude([in_space(curve) for curve in curves])
    made = _exactly(alike)
    if made is not None:
        return Compatible(tuple(made), 0.0)
    if tolerance is None:
        points = np.concatenate([curve.at(np.linspace(0.0, 1.0, 65)) for curve in alike])
        tolerance = TOLERANCE * float(np.ptp(points, axis=0).max()) or 1.0
    return Compatible(*fitted_together(alike, tolerance))


def unweighted(curves: Sequence[PlusCurve], *, tolerance: float | None = None) -> Compatible:
    """As `compatible`, but curves with weights are fitted by ones without."""
    alike = compatible(curves, tolerance=tolerance)
    if all(curve.lines.weights is None for curve in alike.curves):
        return alike
    if tolerance is None:
        points = np.concatenate([curve.lines.points for curve in alike.curves])
        tolerance = TOLERANCE * float(np.ptp(points, axis=0).max()) or 1.0
    return Compatible(*fitted_together(alike.curves, tolerance))


def in_space(curve: PlusCurve) -> PlusCurve:
    """A plane curve as a space curve in z = 0; a space curve as it is."""
    if curve.dimension == 3:
        return curve
    old, zeros = curve.lines, np.zeros((len(curve.lines), 1))
    lines = ControlLines(
        np.hstack([old.points, zeros]), np.hstack([old.given, zeros]), old.automatic, old.weights
    )
    return replace(curve, lines=lines)


def of_one_magnitude(curves: Sequence[PlusCurve]) -> list[PlusCurve]:
    """The same curves with one s, that of the largest size among theirs.

    Directions of a curve that had another s become given ones of other lengths.
    """
    s = max((curve.s for curve in curves), key=abs)
    return [_with_magnitude(curve, s) for curve in curves]


def _with_magnitude(curve: PlusCurve, s: float) -> PlusCurve:
    if curve.s == s:
        return curve
    return replace(curve, lines=curve.lines.with_directions(curve.gradients / s), s=s)


def _exactly(curves: list[PlusCurve]) -> list[PlusCurve] | None:
    """The curves in one basis, unchanged; None where no basis of a fair size holds all of them."""
    if len({curve.basis for curve in curves}) == 1:
        return curves
    if any(isinstance(curve.basis, RationalGaussian) for curve in curves):
        return None
    if all(curve.closed for curve in curves):
        return _closed(curves)
    curves = [opened(curve) for curve in curves]
    if all(isinstance(curve.basis, Bernstein) for curve in curves):
        return _raised(curves, max(curve.basis.size for curve in curves))
    curves = [as_bspline(curve) for curve in curves]
    order = max(_order(curve) for curve in curves)
    # Raising by one adds a knot to each that there is.
    pieces = max(len(_bspline(curve).breaks) - 1 for curve in curves)
    if pieces * (order - 1) > MOST:
        return None
    return _on_one_knots([_to_order(curve, order) for curve in curves])


def _closed(curves: list[PlusCurve]) -> list[PlusCurve] | None:
    order, size = _order(curves[0]), lcm(*(curve.basis.size for curve in curves))
    factors = [size // curve.basis.size for curve in curves]
    same = all(_order(curve) == order for curve in curves)
    odd = order % 2 == 1 and any(factor % 2 == 0 for factor in factors)
    if not same or odd or size > MOST:
        return None
    return [finer(curve, factor) for curve, factor in zip(curves, factors, strict=True)]


def _raised(curves: list[PlusCurve], size: int) -> list[PlusCurve] | None:
    if size > MOST:
        return None
    result = []
    for curve in curves:
        while curve.basis.size < size:
            curve = raised(curve)
        result.append(curve)
    return result


def _to_order(curve: PlusCurve, order: int) -> PlusCurve:
    while _order(curve) < order:
        curve = raised(curve)
    return curve


def _on_one_knots(curves: list[PlusCurve]) -> list[PlusCurve] | None:
    """Open B-spline+ curves of one order on all knots that any of them has."""
    order = _order(curves[0])
    every = np.unique(np.concatenate([_bspline(curve).knot_vector for curve in curves]))
    distinct = every[np.append(True, np.diff(every) > SAME_KNOT)]
    distinct[-1] = 1.0
    counts = np.zeros(len(distinct), dtype=np.intp)
    snapped = []
    for curve in curves:
        place = np.abs(_bspline(curve).knot_vector[:, None] - distinct).argmin(axis=1)
        counts = np.maximum(counts, np.bincount(place, minlength=len(distinct)))
        snapped.append(_snapped(curve, distinct[place]))
    knots = np.repeat(distinct, counts)
    if len(knots) - order > MOST:
        return None
    return [with_knots(curve, knots) for curve in snapped]


def _snapped(curve: PlusCurve, knots: Floats) -> PlusCurve:
    """The curve with knots that differ from its own by rounding."""
    basis = _bspline(curve)
    if np.array_equal(basis.knot_vector, knots):
        return curve
    return replace(curve, basis=BSpline(basis.size, basis.order, knots=tuple(knots.tolist())))


def _bspline(curve: PlusCurve) -> BSpline:
    if not isinstance(curve.basis, BSpline):
        raise TypeError(f"expected a B-spline curve, got {type(curve.basis).__name__}")
    return curve.basis


def _order(curve: PlusCurve) -> int:
    return _bspline(curve).order
