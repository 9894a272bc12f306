"""Numbers that tell of a whole curve: its length, its bending energy, its inflections.

A plane polynomial curve of degree d has 2 d - 4 inflections at most: det(C', C'') has that degree,
as the leading terms cancel. A rational one has 3 d - 6. A B-spline has that many between any two
knots; where its curvature jumps, up to order 3, its sense of turning may change at the knots, too.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bending import bending_energy
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.inflections import inflections
from plusedit.geometry.length import arc_length

EVEN = 3  # order of B-splines+ up to which the curvature jumps at knots


@dataclass(frozen=True)
class CurveNumbers:
    """What is known of a curve."""

    length: float
    """in units of the points"""
    energy: float
    """the bending energy, in 1 / unit; infinite where there is a cusp"""
    inflections: int | None
    """None in space"""
    most: int | None
    """inflections that a curve of its kind can have; None where there is no bound"""


_KEPT: "WeakKeyDictionary[PlusCurve, CurveNumbers]" = WeakKeyDictionary()


def curve_numbers(curve: PlusCurve) -> CurveNumbers:
    """The numbers of a curve, found if need be, in whatever thread."""
    found = _KEPT.get(curve)
    if found is None:
        is_plane = curve.dimension == 2
        found = _KEPT[curve] = CurveNumbers(
            arc_length(curve),
            bending_energy(curve),
            len(inflections(curve)) if is_plane else None,
            most_inflections(curve) if is_plane else None,
        )
    return found


def known_numbers(curve: PlusCurve) -> CurveNumbers | None:
    """The numbers if they are known by now."""
    return _KEPT.get(curve)


def together(numbers: Iterable[CurveNumbers]) -> CurveNumbers:
    """The sums for several curves; those in space have no part in the inflections."""
    each = tuple(numbers)
    counts = [one.inflections for one in each if one.inflections is not None]
    bounds = [one.most for one in each if one.inflections is not None]
    return CurveNumbers(
        sum(one.length for one in each),
        sum(one.energy for one in each),
        sum(counts) if counts else None,
        None if None in bounds or not bounds else sum(bound for bound in bounds if bound),
    )


def most_inflections(curve: PlusCurve) -> int | None:
    """How many inflections a plane curve of its degree and knots can have; None for Gaussians."""
    basis, lines = curve.basis, curve.lines
    if isinstance(basis, Bernstein):
        order, spans = basis.size, 1
    elif isinstance(basis, BSpline):
        order, spans = basis.order, len(basis.breaks) - 1
    else:
        return None
    is_plus = bool(np.any(curve.gradients))
    degree = order if is_plus else order - 1
    is_rational = lines.weights is not None
    of_span = max(0, 3 * degree - 6 if is_rational else 2 * degree - 4)
    jumps = spans if curve.closed else spans - 1
    return spans * of_span + (jumps if order <= EVEN + (not is_plus) else 0)
