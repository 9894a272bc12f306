"""Curves turned round and put in order, so that a surface between them does not twist.

People draw curves one after the other and either way round. None of the functions here changes
the shape of a curve, only where it begins and which way it runs.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.coons import MEETING
from plusedit.geometry.transforms import reversed_curve

SAMPLES = 32  # of every curve, compared point by point


def aligned(curves: Sequence[PlusCurve]) -> list[PlusCurve]:
    """The curves, each reversed, and begun elsewhere, so that it runs along the one before.

    The first stays. Closed curves whose nodes are even can begin at any of their lines.
    """
    result = list(curves[:1])
    for curve in curves[1:]:
        result.append(_along(result[-1], curve))
    return result


def _along(before: PlusCurve, curve: PlusCurve) -> PlusCurve:
    u = np.arange(SAMPLES) / SAMPLES if curve.closed else np.linspace(0.0, 1.0, SAMPLES)
    wanted = _placed(before, u)
    candidates = [
        begun
        for turned in (curve, reversed_curve(curve))
        for begun in (_beginnings(turned) if before.closed else [turned])
    ]
    misses = [float(((_placed(found, u) - wanted) ** 2).sum()) for found in candidates]
    best = int(np.argmin(misses))
    # A difference that is only rounding is no reason to change what was drawn.
    return curve if misses[0] <= misses[best] * (1.0 + 1e-9) else candidates[best]


def _placed(curve: PlusCurve, u: Floats) -> Floats:
    """(m, 3) points; of a plane curve in z = 0."""
    at = curve.at(u)
    return at if curve.dimension == 3 else np.column_stack([at, np.zeros(len(at))])


def _beginnings(curve: PlusCurve) -> list[PlusCurve]:
    """The curve begun at every one of its lines, where only the numbers of the lines change."""
    size, basis = curve.basis.size, curve.basis
    even = curve.closed and np.array_equal(basis.nodes, np.arange(size) / size)
    if not even or isinstance(getattr(basis, "sigma", None), tuple):
        return [curve]
    rows = np.arange(size)
    return [replace(curve, lines=curve.lines.taken(np.roll(rows, -start))) for start in rows]


def loop(
    curves: Sequence[PlusCurve],
) -> tuple[PlusCurve, PlusCurve, PlusCurve, PlusCurve]:
    """Four curves that meet at their ends, as the edges u0, u1, v0, v1 of `coons`.

    In whichever order they come, and whichever way round: the first is u0 and stays. Raises
    ValueError if there are not four of them, one is closed, or they don't form a loop.
    """
    if len(curves) != 4:
        raise ValueError(f"A surface between four curves needs four, not {len(curves)}.")
    if any(curve.closed for curve in curves):
        raise ValueError("A closed curve can't be an edge of a surface between four curves.")
    every = np.concatenate([_placed(curve, np.linspace(0.0, 1.0, SAMPLES)) for curve in curves])
    near = MEETING * float(np.ptp(every, axis=0).max())
    chain, left = [curves[0]], list(curves[1:])
    while left:
        end = _placed(chain[-1], np.ones(1))[0]
        found = _next(left, end)
        gap = float(np.linalg.norm(_placed(found[1], np.zeros(1))[0] - end))
        if gap > near:
            raise ValueError(_sentence(gap))
        chain.append(found[1])
        left.pop(found[0])
    gap = float(np.linalg.norm(_placed(chain[-1], np.ones(1)) - _placed(chain[0], np.zeros(1))))
    if gap > near:
        raise ValueError(_sentence(gap))
    return chain[0], reversed_curve(chain[2]), reversed_curve(chain[3]), chain[1]


def _next(curves: list[PlusCurve], end: Floats) -> tuple[int, PlusCurve]:
    """The number of the curve that begins or ends nearest, and the curve begun there."""
    ends = np.array([_placed(curve, np.array([0.0, 1.0])) for curve in curves])
    distances = np.linalg.norm(ends - end, axis=2)
    number, which = divmod(int(distances.argmin()), 2)
    curve = curves[number]
    return number, (reversed_curve(curve) if which else curve)


def _sentence(gap: float) -> str:
    return f"The four curves don't meet at their ends: there is a gap of {gap:.3g}."
