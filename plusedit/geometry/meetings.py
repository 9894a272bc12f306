"""Where ends of several curves meet, and how smoothly."""

from collections.abc import Iterator, Sequence
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.continuity import SAME, Joint, meeting
from plusedit.geometry.curve import PlusCurve

_ENDS: "WeakKeyDictionary[PlusCurve, Floats]" = WeakKeyDictionary()
_MEETINGS: "WeakKeyDictionary[PlusCurve, WeakKeyDictionary[PlusCurve, tuple[Joint, ...]]]"
_MEETINGS = WeakKeyDictionary()


def meetings(curves: Sequence[PlusCurve]) -> tuple[Joint, ...]:
    """The joints of all open curves whose ends lie on ends of others.

    Plane curves meet plane curves only. What was found of two curves is kept as long as both live:
    while one of thousands moves, the others cost next to nothing.
    """
    found: list[Joint] = []
    for dimension in (2, 3):
        same = [curve for curve in curves if curve.dimension == dimension and not curve.closed]
        for one, other in _pairs(same):
            found += _met(one, other)
    return tuple(found)


def _met(one: PlusCurve, other: PlusCurve) -> tuple[Joint, ...]:
    kept = _MEETINGS.setdefault(one, WeakKeyDictionary())
    joints = kept.get(other)
    if joints is None:
        joints = kept[other] = meeting(one, other)
    return joints


def _pairs(curves: Sequence[PlusCurve]) -> Iterator[tuple[PlusCurve, PlusCurve]]:
    """Curves of which an end lies about where one of the other does, in their order."""
    if len(curves) < 2:
        return
    ends = np.concatenate([_ends_of(curve) for curve in curves])
    near = SAME * float(np.ptp(ends, axis=0).max() or 1.0)
    order = np.argsort(ends[:, 0], kind="stable")
    ends, owners = ends[order], order // 2
    pairs: set[tuple[int, int]] = set()
    for step in range(1, len(ends)):
        ways = ends[step:] - ends[:-step]
        is_level = ways[:, 0] <= near
        if not is_level.any():
            break
        rows = np.flatnonzero(is_level & (np.abs(ways) <= near).all(axis=1))
        pairs |= set(zip(owners[rows].tolist(), owners[rows + step].tolist(), strict=True))
    for one, other in sorted({(min(pair), max(pair)) for pair in pairs}):
        if one != other:
            yield curves[one], curves[other]


def _ends_of(curve: PlusCurve) -> Floats:
    """(2, dim)"""
    ends = _ENDS.get(curve)
    if ends is None:
        ends = _ENDS[curve] = curve.at([0.0, 1.0])
    return ends
