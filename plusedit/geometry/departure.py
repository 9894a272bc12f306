"""How far plus curves and surfaces are from the classical ones of the same control points.

Both are compared at equal parameters, where a plus curve is C = base + s plus, the classical one
base: so the distance is |s plus|, and changes with s in proportion.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from plusedit.geometry import curve as curves
from plusedit.geometry import surface as surfaces
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.pieces import pieces
from plusedit.geometry.surface import PlusSurface

FINE = 16  # samples for each control line, to find the largest distance
FEWEST, MOST = 257, 8193  # samples of a curve
FEWEST_EACH, MOST_EACH = 33, 129  # of a surface, each way
FINE_EACH = 4
ROUNDS = 2  # in which the farthest place is looked for, each 16 times as closely
ROUNDING = 1e-13  # of the largest coordinate: so close together, points are taken to be the same


@dataclass(frozen=True)
class Departure:
    """The distances between a shape and its classical one in short."""

    largest: float
    rms: float
    """root of the mean square, even in the parameters"""
    at: tuple[float, ...]
    """the parameters where they are farthest apart, (u,) or (u, v)"""


def departure(curve: PlusCurve) -> Departure:
    """That of a curve from the classical one."""
    even = Grid.uniform(min(max(FINE * len(curve.lines) + 1, FEWEST), MOST))
    rms = _rms(curve_departures(curve, even))
    looked_at = _with_pieces(even, pieces(curve))
    u, distances = looked_at.parameters, curve_departures(curve, looked_at)
    for _ in range(ROUNDS):
        worst = int(distances.argmax())
        u = _between(u[max(worst - 1, 0) : worst + 2], FINE)
        distances = _clean(_apart(curve, u), curve.lines.points)
    worst = int(distances.argmax())
    return Departure(float(distances[worst]), rms, (float(u[worst]),))


def surface_departure(surface: PlusSurface) -> Departure:
    """The same of a surface."""
    counts = (min(max(FINE_EACH * n + 1, FEWEST_EACH), MOST_EACH) for n in surface.planes.shape)
    by_u, by_v = (Grid.uniform(count) for count in counts)
    distances = surface_departures(surface, by_u, by_v)
    row, column = np.unravel_index(distances.argmax(), distances.shape)
    place = float(by_u.parameters[row]), float(by_v.parameters[column])
    return Departure(float(distances.max()), _rms(distances), place)


def curve_departures(curve: PlusCurve, u: Grid) -> Floats:
    """(m,) distances between both curves at the parameters of a grid."""
    _, plus = curves.terms(curve.basis, curve.lines, u)
    return _clean(abs(curve.s) * np.linalg.norm(plus, axis=1), curve.lines.points)


def surface_departures(surface: PlusSurface, u: Grid, v: Grid) -> Floats:
    """(m_u, m_v) distances between both surfaces at every pair of parameters of two grids."""
    _, plus = surfaces.terms(surface.basis_u, surface.basis_v, surface.planes, u, v)
    return _clean(abs(surface.s) * np.linalg.norm(plus, axis=2), surface.planes.points)


def _clean(distances: Floats, points: Floats) -> Floats:
    """The distances without those that are nothing but rounding."""
    least = ROUNDING * float(np.abs(points).max())
    return np.where(distances <= least, 0.0, distances)


@lru_cache(maxsize=16)
def _with_pieces(even: Grid, ends: Grid) -> Grid:
    """Even parameters, and as many between the ends of pieces, however short these are."""
    return Grid(np.union1d(even.parameters, _between(ends.parameters, FINE)))


def _apart(curve: PlusCurve, u: Floats) -> Floats:
    """(m,) the same as `curve_departures`, at parameters that are looked at only once."""
    apart: Floats = np.linalg.norm(curve.at(u) - curve.classical.at(u), axis=1)
    return apart


def _between(ends: Floats, parts: int) -> Floats:
    """Parameters that rise, and others between them that divide each step into parts."""
    return np.unique(np.linspace(ends[:-1], ends[1:], parts + 1, axis=1))


def _rms(distances: Floats) -> float:
    largest = float(distances.max()) or 1.0
    # Squares of what is huge or tiny would not be numbers.
    return largest * float(np.sqrt(np.mean((distances / largest) ** 2)))
