"""Curvature combs: teeth across a curve, as long as it is curved, and the line along their tips.

A tooth stands on the outer side of the curve, at p - f k N with the curvature vector k N. Teeth are
even by length along the curve, however fast it runs through its parameters. The factor f is the
same for all of a design, so that combs of different curves can be compared. Where the curvature
jumps, at a knot, there are two teeth and the line is broken; it is broken, too, where teeth would
be longer than the design and are cut.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curvature_profile import CurvatureRun, curvature_run
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import Camera
from plusedit.scene.extents import USUAL, Extent
from plusedit.scene.items import Item, Polyline, Segments
from plusedit.scene.outward import outward_label

TEETH = 160  # of a curve, about
SAMPLES, EACH = 800, 8  # places of the line along the tips: of a curve, and of each control line
SHARE = 0.08  # of the size of shapes: a tooth where a curve bends as its polygon does in the mean
LONGEST = 0.5  # sizes: longer teeth are cut
EVEN = 1e-6  # of the size: tips that near are one
TOLD = 24.0  # pixels, from which on the line says how much it stands for where it is farthest out
COLOR, FAINT = "v", "v@50"
APART = 8.0  # pixels from the line to these words


@dataclass(frozen=True)
class Measure:
    """How combs are drawn."""

    factor: float
    """the length of a tooth for a curvature of one"""
    longest: float
    """in the world"""
    teeth: int

    @classmethod
    def of(cls, scale: float, density: float, extent: Extent = USUAL) -> "Measure":
        """Teeth so many times as long and as close as usual, for shapes of that extent."""
        factor = scale * SHARE * extent.size / extent.curvature
        return cls(factor, LONGEST * extent.size, max(1, round(TEETH * density)))


@dataclass(frozen=True, eq=False)
class Comb:
    """The comb of one curve."""

    items: tuple[Item, ...]
    foot: Floats
    """(1, dim) where the curvature is largest"""
    tip: Floats
    """(1, dim)"""
    largest: float
    """the curvature there, by its size"""
    is_cut: bool
    """whether a tooth would be longer than any is drawn"""


@dataclass(eq=False)
class _Kept:
    run: CurvatureRun
    combs: dict[Measure, Comb] = field(default_factory=dict)


_KEPT: "WeakKeyDictionary[PlusCurve, _Kept]" = WeakKeyDictionary()


def comb_of(curve: PlusCurve, measure: Measure) -> Comb:
    """The comb of a curve; the same one, with the same items, for the same measure."""
    kept = _KEPT.get(curve)
    if kept is None:
        count = max(SAMPLES, EACH * len(curve.lines))
        kept = _KEPT[curve] = _Kept(curvature_run(curve, count))
    comb = kept.combs.get(measure)
    if comb is None:
        comb = _comb(kept.run, measure)
        kept.combs = {measure: comb}
    return comb


def comb_items(curve: PlusCurve, measure: Measure, camera: Camera) -> Iterator[Item]:
    """The comb, and where its line is farthest out the curvature that this stands for."""
    comb = comb_of(curve, measure)
    yield from comb.items
    foot, tip = (camera.to_screen(end)[0] for end in (comb.foot, comb.tip))
    length = float(np.hypot(*(tip - foot)))
    if TOLD <= length < np.inf and not comb.is_cut:
        way = (comb.tip - comb.foot)[0]
        yield outward_label(comb.tip[0], way, f"κ {comb.largest:.3g}", COLOR, camera, apart=APART)


def _comb(run: CurvatureRun, measure: Measure) -> Comb:
    vectors = np.nan_to_num(run.vectors, posinf=0.0, neginf=0.0)
    size = np.linalg.norm(vectors, axis=1)
    length = measure.factor * size
    is_long = length > measure.longest
    shrunk = np.divide(measure.longest, length, out=np.ones(len(size)), where=is_long)
    tips = run.points - (measure.factor * shrunk)[:, None] * vectors
    is_whole = np.isfinite(run.vectors).all(axis=1) & ~is_long
    jumps = _jumps(run, tips, measure.longest)
    joined = is_whole[:-1] & is_whole[1:] & ~jumps
    lines = np.split(tips, 1 + np.flatnonzero(~joined))
    places = _places(run, jumps, measure.teeth)
    feet, ends = _between(run.points, places), _between(tips, places)
    best = int(size.argmax())
    return Comb(
        (
            Segments(feet, ends, FAINT, 1.0),
            *(Polyline(line, COLOR, 1.0) for line in lines if len(line) > 1),
        ),
        run.points[best : best + 1],
        tips[best : best + 1],
        float(size[best]),
        bool(is_long[best]),
    )


def _jumps(run: CurvatureRun, tips: Floats, size: float) -> NDArray[np.bool_]:
    """(m - 1,) whether a piece ends after a sample, and the next begins with another tooth."""
    jumps = np.zeros(len(tips) - 1, dtype=np.bool_)
    last = run.starts[1:-1] - 1
    apart = np.linalg.norm(tips[last + 1] - tips[last], axis=1)
    jumps[last] = apart > EVEN * size
    return jumps


def _places(run: CurvatureRun, jumps: NDArray[np.bool_], count: int) -> Floats:
    """(k,) where teeth stand, counted in samples: at jumps, and evenly by length between them."""
    along = np.concatenate([[0.0], np.linalg.norm(np.diff(run.points, axis=0), axis=1).cumsum()])
    if not 0.0 < along[-1] < np.inf:
        return np.zeros(1)
    ends = [0, *(1 + np.flatnonzero(jumps)).tolist(), len(along)]
    rows = []
    for start, stop in pairwise(ends):
        low, high = along[start], along[stop - 1]
        number = 1 + max(1, round(count * float((high - low) / along[-1])))
        wanted = np.linspace(low, high, number)
        rows.append(np.interp(wanted, along[start:stop], np.arange(start, stop, dtype=np.float64)))
    return np.concatenate(rows)


def _between(rows: Floats, places: Floats) -> Floats:
    """(k, dim) rows (m, dim) at places that may lie between two of them."""
    before = np.minimum(places.astype(np.intp), len(rows) - 1)
    after = np.minimum(before + 1, len(rows) - 1)
    share = (places - before)[:, None]
    found: Floats = rows[before] + share * (rows[after] - rows[before])
    return found
