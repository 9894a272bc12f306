"""Moving control points that take their neighbors along."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from plusedit.commands.base import Landing, NetCommand, edit_nets, fitted
from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.net import ControlNet

BLOCK = 1 << 19  # differences that are worked out at once, 12 MB


@dataclass(frozen=True, eq=False)
class SoftMove(NetCommand):
    """Shift control points; those of the same shape within a radius follow, less the farther off.

    At the distance t of the radius from the nearest point that is moved, a point goes the share
    1 - 3 t^2 + 2 t^3 of the way: all of it at 0, none from 1 on, with a smooth passage at both.
    Distances are those before the move.
    """

    by: Floats
    """(dim,) as of `MovePoints`"""
    radius: float
    """in units of the design; 0 moves the points meant alone"""
    landing: Landing | None = None
    """of one of the points meant"""

    @property
    def verb(self) -> str:
        return "Softly move"

    def apply(self, design: Design) -> Design:
        def moved(shape_id: ShapeId, geometry: PlusGeometry, rows: list[int]) -> ControlNet:
            net, by = geometry.net, fitted(self.by, geometry.dimension)
            if not by.any():
                return net
            shares = falloff(net, tuple(rows), self.radius)
            points = net.control_points + shares[:, None] * by
            if self.landing is not None and self.landing.shape_id == shape_id:
                points[self.landing.number] = fitted(self.landing.vector, geometry.dimension)
            return net.with_control_points(points)

        return edit_nets(design, self.targets, moved)


@lru_cache(maxsize=8)
def falloff(net: ControlNet, rows: tuple[int, ...], radius: float) -> Floats:
    """(n,) the share of the move that each control point takes; kept through a drag.

    ValueError if the radius is negative or no number.
    """
    if not radius >= 0.0:
        raise ValueError(f"a radius can't be {radius:g}")
    shares = np.zeros(len(net))
    if radius > 0.0:
        t = np.minimum(distances(net.control_points, list(rows)) / radius, 1.0)
        shares = 1.0 - t * t * (3.0 - 2.0 * t)
    shares[list(rows)] = 1.0
    shares.flags.writeable = False
    return shares


def distances(points: Floats, rows: list[int]) -> Floats:
    """(n,) from each point to the nearest of those of the given numbers."""
    nearest = np.full(len(points), np.inf)
    step = max(1, BLOCK // len(points))
    for start in range(0, len(rows), step):
        some = points[rows[start : start + step]]
        between = np.linalg.norm(points[:, None] - some, axis=2)
        np.minimum(nearest, between.min(axis=1), out=nearest)
    return nearest
