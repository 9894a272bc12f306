"""Moving control points that take their neighbors along."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from plusedit.commands.base import Landing, NetCommand, edit_nets, fitted
from plusedit.commands.meshes import transformed_meshes
from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.net import ControlNet

BLOCK = 1 << 17  # pairs of points that are compared at once, 1 MB


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
        def moved(shape_id: ShapeId, geometry: Geometry, rows: list[int]) -> ControlNet:
            net, by = geometry.net, fitted(self.by, geometry.dimension)
            if not by.any():
                return net
            shares = falloff(net, tuple(rows), self.radius)
            points = net.control_points + shares[:, None] * by
            if self.landing is not None and self.landing.shape_id == shape_id:
                points[self.landing.number] = fitted(self.landing.vector, geometry.dimension)
            return net.with_control_points(points)

        design, others = transformed_meshes(design, self.targets, np.eye(3), self.by)
        return edit_nets(design, others, moved)


@lru_cache(maxsize=8)
def falloff(net: ControlNet, rows: tuple[int, ...], radius: float) -> Floats:
    """(n,) the share of the move that each control point takes; kept through a drag.

    ValueError if the radius is negative or no number.
    """
    if not radius >= 0.0:
        raise ValueError(f"a radius can't be {radius:g}")
    meant = list(rows)
    shares = np.zeros(len(net))
    shares[meant] = 1.0
    others = np.flatnonzero(shares == 0.0)
    if radius > 0.0 and len(others):
        points = net.control_points
        t = np.minimum(distances(points[others], points[meant]) / radius, 1.0)
        shares[others] = 1.0 - t * t * (3.0 - 2.0 * t)
    shares.flags.writeable = False
    return shares


def distances(points: Floats, others: Floats) -> Floats:
    """(m,) from each point (m, dim) to the nearest of the others (k, dim)."""
    center = others.mean(axis=0)
    near, asked = others - center, points - center
    # |p - q|^2 less |p|^2, which all q have in common, is one product of matrices. It rounds more
    # than the difference does, which is why it only says which q is nearest.
    left = np.column_stack([asked, np.ones(len(asked))])
    right = np.column_stack([-2.0 * near, (near**2).sum(axis=1)]).T
    step = max(1, BLOCK // len(others))
    blocks = range(0, len(points), step)
    nearest = [(left[start : start + step] @ right).argmin(axis=1) for start in blocks]
    found: Floats = np.linalg.norm(asked - near[np.concatenate(nearest)], axis=1)
    return found
