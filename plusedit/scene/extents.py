"""How large the shapes of a design are and how much they bend, in numbers that seldom change.

What overlays draw by numbers, such as the teeth of combs, is in proportion to them: alike for all
shapes, so that they can be compared, and the same from frame to frame of a drag.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log, pi
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.extremes import telling

STEP = 2.0**0.5  # from one number to the next


@dataclass(frozen=True)
class Extent:
    """What a shape is like from afar."""

    size: float
    """the longest side of the box around its control points"""
    curvature: float
    """how much its control polygon turns, in radians per length; of half a circle at least"""


USUAL = Extent(1.0, 2.0)
"""Of nothing, or of but one point."""

_KEPT: "WeakKeyDictionary[Geometry, Extent | None]" = WeakKeyDictionary()


@lru_cache(maxsize=4)
def extent_of(design: Design) -> Extent:
    """That of the largest shape that is seen, both numbers rounded upwards."""
    found = [_kept(shape.geometry) for shape in design.shapes.values() if shape.visible]
    largest = max((extent for extent in found if extent), key=lambda each: each.size, default=USUAL)
    return Extent(_rounded(largest.size), _rounded(largest.curvature))


def _kept(geometry: Geometry) -> Extent | None:
    if geometry not in _KEPT:
        with np.errstate(all="ignore"):
            _KEPT[geometry] = _extent(geometry)
    return _KEPT[geometry]


def _extent(geometry: Geometry) -> Extent | None:
    """None where a number would be zero, or is too large."""
    if isinstance(geometry, MeshSurface):
        points = telling(geometry.mesh.vertices)
    else:
        points = geometry.net.control_points
    size = float(np.ptp(points, axis=0).max())
    if not 0.0 < size < np.inf:
        return None
    least = pi / 2.0 / size
    bends = (_turned(polygon) for polygon in _polygons(geometry))
    curvature = max((bend for bend in bends if np.isfinite(bend)), default=least)
    return Extent(size, max(curvature, least))


def _polygons(geometry: Geometry) -> Iterator[Floats]:
    """The control polygon of a curve; of a surface those of its rows and columns."""
    if isinstance(geometry, MeshSurface):
        return
    points = geometry.net.points
    if isinstance(geometry, PlusCurve):
        yield points
        return
    yield from points
    yield from points.swapaxes(0, 1)


def _turned(polygon: Floats) -> float:
    """The mean curvature of a polygon (m, dim): all its angles by its length."""
    ways = np.diff(polygon, axis=0)
    headings = unit(ways)
    sides = np.linalg.norm(headings[1:] - headings[:-1], axis=1)
    length = float(np.linalg.norm(ways, axis=1).sum())
    return float(2.0 * np.arcsin(np.clip(sides / 2.0, 0.0, 1.0)).sum()) / length if length else 0.0


def _rounded(value: float) -> float:
    return float(STEP ** ceil(log(value, STEP) - 1e-9))
