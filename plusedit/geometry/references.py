"""Points of known shapes, and of those of a design, for families of shapes to come near to."""

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.comparison import even_points
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.fitting import parameters_by_length
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_comparison import SampledSurface

OF_CURVES = 201  # points
OF_SURFACES = 41  # each way
FINE = 4001  # points from which even ones are taken
FILLED = 0.97  # of its box, from which on the domain of a mesh is taken for a rectangle
INNER = 0.68  # of the box around a disk, each way: just inside

Reference: TypeAlias = Floats | SampledSurface
"""Points (m, dim) of a curve, or a grid of points of a surface."""


def spiral() -> Floats:
    """(m, 2) two turns, the radius growing with the angle."""
    t = np.linspace(0.0, 1.0, FINE)
    return _even((0.15 + 0.85 * t)[:, None] * _directions(4.0 * np.pi * t))


def wave() -> Floats:
    """(m, 2) a sine wave of four arcs."""
    t = np.linspace(0.0, 1.0, FINE)
    return _even(np.stack([6.0 * t, np.sin(4.0 * np.pi * t)], axis=1))


def airfoil() -> Floats:
    """(m, 2) NACA 2412 from the trailing edge above to that below, with a closed edge."""
    x = (1.0 - np.cos(np.linspace(0.0, np.pi, FINE))) / 2.0
    thickness = 0.6 * (
        0.2969 * np.sqrt(x) - 0.126 * x - 0.3516 * x**2 + 0.2843 * x**3 - 0.1036 * x**4
    )
    camber = np.where(x < 0.4, 0.02 / 0.16 * (0.8 * x - x**2), 0.02 / 0.36 * (0.2 + 0.8 * x - x**2))
    upper = np.stack([x, camber + thickness], axis=1)
    lower = np.stack([x, camber - thickness], axis=1)
    return _even(np.concatenate([upper[::-1], lower[1:]]))


def lissajous() -> Floats:
    """(m, 2) the closed Lissajous curve of 3 : 2."""
    t = 2.0 * np.pi * np.linspace(0.0, 1.0, FINE)
    return _even(np.stack([np.sin(3.0 * t), np.sin(2.0 * t)], axis=1))


def franke() -> SampledSurface:
    """Franke's function, two hills, a shoulder and a hollow, the usual test of height fields."""
    x, y = _square()
    heights = (
        0.75 * np.exp(-((9.0 * x - 2.0) ** 2 + (9.0 * y - 2.0) ** 2) / 4.0)
        + 0.75 * np.exp(-((9.0 * x + 1.0) ** 2) / 49.0 - (9.0 * y + 1.0) / 10.0)
        + 0.5 * np.exp(-((9.0 * x - 7.0) ** 2 + (9.0 * y - 3.0) ** 2) / 4.0)
        - 0.2 * np.exp(-((9.0 * x - 4.0) ** 2) - (9.0 * y - 7.0) ** 2)
    )
    return SampledSurface.even(np.stack([x, y, heights], axis=2))


def ripples() -> SampledSurface:
    """Rings of waves about a point beside the middle."""
    x, y = _square()
    distance = np.hypot(x - 0.4, y - 0.3)
    return SampledSurface.even(np.stack([x, y, 0.15 * np.cos(14.0 * distance)], axis=2))


REFERENCES: Mapping[str, Callable[[], Reference]] = MappingProxyType(
    {
        "Spiral": spiral,
        "Wave": wave,
        "Airfoil": airfoil,
        "Lissajous curve": lissajous,
        "Franke's hills": franke,
        "Ripples": ripples,
    }
)
"""What is offered where nothing is selected, by what it is called."""


def sampled(geometry: PlusCurve | PlusSurface | MeshSurface) -> Reference:
    """Points of a shape: of a curve even in its length, of surfaces even in the parameters."""
    if isinstance(geometry, PlusCurve):
        return even_points(geometry, OF_CURVES)
    if isinstance(geometry, MeshSurface):
        return sampled_mesh(geometry)
    even = np.linspace(0.0, 1.0, OF_SURFACES)
    return SampledSurface(geometry.at(even, even), even, even)


def sampled_mesh(surface: MeshSurface, count: int = OF_SURFACES) -> SampledSurface:
    """A patch of the surface of a mesh on an even grid.

    All of a domain that fills a rectangle, as of terrains; of another the middle of it.
    """
    low, high = surface.parameters.min(axis=0), surface.parameters.max(axis=0)
    first, second, third = surface.parameters[surface.mesh.triangulation.corners.T]
    one, other = second - first, third - first
    area = float(np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]).sum()) / 2.0
    if area < FILLED * float(np.prod(high - low)):
        middle, half = (low + high) / 2.0, INNER * (high - low) / 2.0
        low, high = middle - half, middle + half
    u, v = (np.linspace(low[way], high[way], count) for way in (0, 1))
    places = np.stack(np.meshgrid(u, v, indexing="ij"), axis=2).reshape(-1, 2)
    return SampledSurface.even(surface.at(places).reshape(count, count, 3))


def _even(points: Floats) -> Floats:
    """Points of a chain, even in its length."""
    length = parameters_by_length(points)
    at = np.linspace(0.0, 1.0, OF_CURVES)
    return np.stack([np.interp(at, length, row) for row in points.T], axis=1)


def _directions(angles: Floats) -> Floats:
    return np.stack([np.cos(angles), np.sin(angles)], axis=1)


def _square() -> tuple[Floats, Floats]:
    even = np.linspace(0.0, 1.0, OF_SURFACES)
    x, y = np.meshgrid(even, even, indexing="ij")
    return x, y
