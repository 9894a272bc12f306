"""Curves fitted to given functions of the parameter, several of them in one B-spline basis.

In contrast to `fitting`, the parameters stay: what lies at u on a given curve lies at u on the
fitted one, so that curves which belong together still do. The lines start as

    P_i = f(x_i),   g_i = f'(x_i) / 2,

exact for a quadratic f, and are then moved by least squares as little as brings the curve onto f.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blend import blend_at
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.making.refining import as_bspline
from plusedit.geometry.matrices import dense

ORDER = 4  # of what is fitted
SAMPLES = 8  # in every span, or about every line
RELUCTANCE = 1e-5  # what leaving the start counts beside leaving the given function
LARGEST_SIZE = 160  # lines; a curve that needs more stays less exact
GROWTH = 1.5  # of the number of lines of closed curves, from one attempt to the next

Path = Callable[[Floats], tuple[Floats, Floats]]
"""Points (m, dim) and velocities (m, dim) at parameters (m,)."""


def fitted_curve(basis: Basis, path: Path, s: float, u: Floats) -> PlusCurve:
    """The curve in that basis that comes closest to `path` at the parameters u (m,).

    With s = 0 by its points alone. It has the directions g / s, all of them given.
    """
    points, velocities = path(basis.nodes)
    gradients = velocities / 2.0 if s else np.zeros_like(points)
    matrices = blend_at(basis, u)
    values, reaches = dense(matrices.values), dense(matrices.reaches)
    missing = path(u)[0] - values @ points - reaches @ gradients
    pull = basis.size  # a gradient counts as what it moves the curve by
    columns = np.concatenate([values, pull * reaches], axis=1) if s else values
    free = _free(basis, columns.shape[1])
    normal = columns[:, free].T @ columns[:, free]
    normal += np.eye(len(normal)) * (RELUCTANCE**2 * len(u) / basis.size)
    change = np.zeros((columns.shape[1], points.shape[1]))
    for _ in range(2):  # the second round makes up for the reluctance
        rest = missing - columns @ change
        change[free] += np.linalg.solve(normal, columns[:, free].T @ rest)
    points = points + change[: basis.size]
    if s:
        gradients = (gradients + pull * change[basis.size :]) / s
    return PlusCurve(basis, ControlLines.of(points, list(gradients)), s)


def _free(basis: Basis, count: int) -> NDArray[np.bool_]:
    """(count,) true but for the end points, which an open B-spline+ curve meets anyway."""
    free = np.ones(count, dtype=np.bool_)
    if not basis.closed and isinstance(basis, BSpline | Bernstein):
        free[[0, basis.size - 1]] = False
    return free


def fitted_together(
    curves: Sequence[PlusCurve], tolerance: float
) -> tuple[tuple[PlusCurve, ...], float]:
    """Curves in one B-spline basis without weights, within the tolerance, and the largest miss.

    Closed if all of them are. The miss is measured between points of the same parameter; it may
    be larger than the tolerance where a curve would need more than 160 lines.
    """
    if all(curve.closed for curve in curves):
        return _fitted_closed(curves, tolerance)
    breaks, times = _merged_breaks(curves)
    while True:
        inner = np.repeat(breaks[1:-1], times[1:-1])
        knots = (0.0,) * ORDER + tuple(inner.tolist()) + (1.0,) * ORDER
        basis = BSpline(len(knots) - ORDER, ORDER, knots=knots)
        u = np.concatenate(
            [np.linspace(a, b, SAMPLES, endpoint=False) for a, b in pairwise(breaks)]
        )
        u = np.append(u, 1.0)
        made, misses = _attempt(curves, basis, u)
        span = np.clip(np.searchsorted(breaks, u, side="right") - 1, 0, len(breaks) - 2)
        bad = np.unique(span[misses > tolerance])
        if not len(bad) or basis.size + len(bad) > LARGEST_SIZE:
            return made, float(misses.max())
        breaks = np.insert(breaks, bad + 1, (breaks[bad] + breaks[bad + 1]) / 2.0)
        times = np.insert(times, bad + 1, 1)


def _fitted_closed(
    curves: Sequence[PlusCurve], tolerance: float
) -> tuple[tuple[PlusCurve, ...], float]:
    size = max(ORDER, *(curve.basis.size for curve in curves))
    while True:
        basis = BSpline(size, ORDER, closed=True)
        u = np.arange(SAMPLES * size) / (SAMPLES * size)
        made, misses = _attempt(curves, basis, u)
        larger = int(np.ceil(GROWTH * size))
        if misses.max() <= tolerance or larger > LARGEST_SIZE:
            return made, float(misses.max())
        size = larger


def _attempt(
    curves: Sequence[PlusCurve], basis: BSpline, u: Floats
) -> tuple[tuple[PlusCurve, ...], Floats]:
    """The curves fitted in that basis, and the largest of their misses at each of u."""
    made = tuple(fitted_curve(basis, _path(curve), curve.s, u) for curve in curves)
    misses = [
        np.linalg.norm(new.at(u) - old.at(u), axis=1) for new, old in zip(made, curves, strict=True)
    ]
    return made, np.max(misses, axis=0)


def _path(curve: PlusCurve) -> Path:
    def path(u: Floats) -> tuple[Floats, Floats]:
        at, velocity = curve.derivatives(u, highest=1)
        return at, velocity

    return path


def _merged_breaks(curves: Sequence[PlusCurve]) -> tuple[Floats, NDArray[np.intp]]:
    """Where any of the curves is less smooth, with the multiplicity of a knot of order 4 for it."""
    found: dict[float, int] = {0.0: 1, 1.0: 1}
    for curve in map(as_bspline, curves):
        basis = curve.basis
        if not isinstance(basis, BSpline) or basis.closed:
            continue
        knots, counts = np.unique(basis.knot_vector, return_counts=True)
        for knot, count in zip(knots.tolist(), counts.tolist(), strict=True):
            # A knot of multiplicity m leaves order - 1 - m derivatives of the blending functions.
            wanted = int(np.clip(count + ORDER - basis.order, 1, ORDER - 1))
            found[knot] = max(found.get(knot, 1), wanted)
    breaks = np.array(sorted(found))
    return breaks, np.array([found[knot] for knot in breaks.tolist()])
