"""Surfaces of meshes whose parameters fill a rectangle: they can be sampled on an even grid.

So do those of terrains, of sheets laid out as a rectangle, of cylinders and of tori. Those of
pillows do as well, but crowd what sticks out into a few cells of any grid; they are left out.
"""

from dataclasses import dataclass
from math import inf, isfinite, sqrt

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface

FILLED = 0.98  # of a rectangle, by the faces: what they leave free is the surface's own making
FEWEST = 2  # cells along a side


@dataclass(frozen=True)
class Rectangle:
    """The parameters of a surface, from corner to corner."""

    low: tuple[float, float]
    """u and v"""
    high: tuple[float, float]
    closed: tuple[bool, bool]
    """whether the surface comes back to where it began"""
    is_mirrored: bool
    """whether faces run clockwise in the parameters, so that S_u x S_v points to their back"""

    @property
    def sizes(self) -> tuple[float, float]:
        """Along u and v; positive."""
        return self.high[0] - self.low[0], self.high[1] - self.low[1]

    def cells(self, count: int) -> tuple[int, int]:
        """How many cells along u and v make about `count` squares."""
        wide, high = self.sizes
        along = max(FEWEST, round(sqrt(count * wide / high)))
        return along, max(FEWEST, round(count / along))

    def lines(self, cells: tuple[int, int]) -> tuple[Floats, Floats]:
        """(m,) u and (n,) v of the lines between so many cells."""
        u, v = (
            np.linspace(low, high, count + 1)
            for low, high, count in zip(self.low, self.high, cells, strict=True)
        )
        return u, v


def rectangle(surface: MeshSurface) -> Rectangle | None:
    """The rectangle that the parameters of the faces fill; None where there is none."""
    mesh, domain, parameters = surface.mesh, surface.domain, surface.parameters
    if domain.turns or not mesh.face_count:
        return None
    periods = domain.periods
    low, high = parameters.min(axis=0), parameters.max(axis=0)
    for axis, period in enumerate(periods):
        if period < inf:
            low[axis], high[axis] = 0.0, period
    whole, area = float(np.prod(high - low)), _area(surface)
    if not (isfinite(whole) and whole > 0.0 and FILLED <= abs(area) / whole <= 1.0 / FILLED):
        return None
    return Rectangle(
        (float(low[0]), float(low[1])),
        (float(high[0]), float(high[1])),
        (periods[0] < inf, periods[1] < inf),
        area < 0.0,
    )


def _area(surface: MeshSurface) -> float:
    """Of the faces in the parameters; negative where they run clockwise."""
    mesh, parameters = surface.mesh, surface.parameters
    # From the first corner of each face, so that nothing large is taken from something large.
    at = parameters - np.repeat(parameters[mesh.starts[:-1]], mesh.sizes, axis=0)
    following = at[mesh.following]
    return 0.5 * float((at[:, 0] * following[:, 1] - at[:, 1] * following[:, 0]).sum())
