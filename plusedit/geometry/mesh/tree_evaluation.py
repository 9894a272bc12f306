"""Mesh surfaces to full accuracy without compiled loops, by k-d trees of scipy.

Slow, for where numba is missing, and the same as `full_kernels` to rounding. Planes are sorted into
octaves of sigma. In every octave the plane nearest to a place bounds its least e; then the planes
within the radius at which even the widest of the octave is more than 36 above that are gathered.
"""

from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats

DEEPEST = 36.0
TOGETHER = 256  # places


if TYPE_CHECKING:
    from scipy.spatial import KDTree

    from plusedit.geometry.mesh.evaluation import Check, Prepared


class _Octave(NamedTuple):
    """Planes whose sigmas differ by less than a factor of two."""

    numbers: NDArray[np.intp]
    search: "KDTree"
    widest: float
    """the largest sigma"""


def evaluate(prepared: "Prepared", places: Floats, found: Floats, check: "Check") -> None:
    """found (m, 3, 9 or 18) = S and, if there is room, its derivatives at places (m, 2)."""
    octaves = _octaves(prepared)
    for start in range(0, len(places), TOGETHER):
        check()
        rows = slice(start, start + TOGETHER)
        _evaluate_some(prepared, octaves, places[rows], found[rows])


def _octaves(prepared: "Prepared") -> list[_Octave]:
    from scipy.spatial import KDTree

    sigmas = np.sqrt(0.5 / prepared.halves.min(axis=1))
    numbers = np.floor(np.log2(sigmas))
    octaves = []
    for number in np.unique(numbers):
        chosen = np.flatnonzero(numbers == number)
        search = KDTree(prepared.tree.centers[chosen])
        octaves.append(_Octave(chosen, search, float(sigmas[chosen].max())))
    return octaves


def _evaluate_some(
    prepared: "Prepared", octaves: list[_Octave], places: Floats, found: Floats
) -> None:
    shifts, signs = prepared.images
    near = [sign * (places - shift) for shift, sign in zip(shifts, signs, strict=True)]
    limits = np.full(len(places), np.inf)
    for octave in octaves:
        for seen in near:
            _, nearest = octave.search.query(seen)
            chosen = octave.numbers[nearest]
            np.minimum(limits, _exponents(prepared, chosen, seen), out=limits)
    pieces = []
    for octave in octaves:
        radii = octave.widest * np.sqrt(2.0 * (limits + DEEPEST)) * (1.0 + 1e-9)
        for seen, sign in zip(near, signs, strict=True):
            lists = octave.search.query_ball_point(seen, radii)
            counts = np.array([len(each) for each in lists])
            rows = np.repeat(np.arange(len(seen)), counts)
            local = np.concatenate([np.asarray(each, dtype=np.intp) for each in lists])
            planes = octave.numbers[local]
            pieces.append((rows, planes, seen[rows], np.full(len(rows), sign)))
    rows, planes, seen_rows, row_signs = (
        np.concatenate(each) for each in zip(*pieces, strict=True)
    )
    _sum(prepared, rows, planes, seen_rows, row_signs, found)


def _exponents(prepared: "Prepared", planes: NDArray[np.intp], places: Floats) -> Floats:
    """(k,) e of each plane at its own place."""
    away = places - prepared.tree.centers[planes]
    found: Floats = (away**2 * prepared.halves[planes]).sum(axis=1)
    return found


def _sum(
    prepared: "Prepared",
    rows: NDArray[np.intp],
    planes: NDArray[np.intp],
    places: Floats,
    signs: Floats,
    found: Floats,
) -> None:
    """Plane `planes[k]` counts for row `rows[k]`, which it sees at `places[k]`."""
    count = len(found)
    away = places - prepared.tree.centers[planes]
    exponents = (away**2 * prepared.halves[planes]).sum(axis=1)
    least = np.full(count, np.inf)
    np.minimum.at(least, rows, exponents)
    shares = prepared.heights[planes] * np.exp(least[rows] - exponents)
    origin = prepared.points[planes[0]]
    by_u, by_v = prepared.by_u[planes], prepared.by_v[planes]
    values = prepared.points[planes] - origin + away[:, :1] * by_u + away[:, 1:] * by_v

    def summed(terms: Floats) -> Floats:
        return np.stack([np.bincount(rows, column, count) for column in terms.T], axis=1)

    total = summed(shares[:, None])
    middle = summed(shares[:, None] * values) / total
    found[:, :3] = origin + middle
    if found.shape[1] == 3:
        return
    from_middle, slopes = values - middle[rows], (by_u, by_v)
    steep = [-2.0 * away[:, axis] * prepared.halves[planes, axis] for axis in (0, 1)]
    for axis in (0, 1):
        terms = (shares * signs)[:, None] * (slopes[axis] + steep[axis][:, None] * from_middle)
        found[:, 3 + 3 * axis : 6 + 3 * axis] = summed(terms) / total
    if found.shape[1] == 9:
        return
    # Of what is measured from S itself the sum is zero: S_uu = (N_uu - 2 w_u S_u) / w.
    thinned = [summed((shares * signs * each)[:, None]) / total for each in steep]
    for place, (a, b) in enumerate(((0, 0), (0, 1), (1, 1))):
        bend = steep[a] * steep[b] - (2.0 * prepared.halves[planes, a] if a == b else 0.0)
        terms = bend[:, None] * from_middle
        terms += steep[a][:, None] * slopes[b] + steep[b][:, None] * slopes[a]
        below = sum(
            thinned[one] * found[:, 3 + 3 * other : 6 + 3 * other]
            for one, other in ((a, b), (b, a))
        )
        start = 9 + 3 * place
        found[:, start : start + 3] = summed(shares[:, None] * terms) / total - below
