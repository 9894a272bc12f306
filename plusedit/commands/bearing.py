"""Pointing directions of space by azimuth and elevation."""

from dataclasses import dataclass
from math import atan2, hypot, pi

import numpy as np

from plusedit.commands.base import NetCommand, Side
from plusedit.commands.directions import quarter_exact, redirected
from plusedit.document.design import Design, EditError
from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats


@dataclass(frozen=True, eq=False)
class SetBearing(NetCommand):
    """Give directions an azimuth, an elevation or both; lengths stay, none becomes length 1."""

    azimuth: float | None = None
    """in radians from the x axis towards the y axis; None: what it is"""
    elevation: float | None = None
    """in radians above the plane of x and y, from -pi / 2 to pi / 2; None: what it is"""
    side: Side = "both"

    @property
    def verb(self) -> str:
        return f"Set {'azimuth' if self.elevation is None else 'elevation'} of"

    def apply(self, design: Design) -> Design:
        if self.elevation is not None and not abs(self.elevation) <= pi / 2.0:
            raise EditError("an elevation lies between -90 and 90 degrees")

        def pointed(_: Geometry, vectors: Floats) -> Floats:
            if vectors.shape[-1] != 3:
                raise ValueError("a plane curve has angles, no azimuth and elevation")
            flat = vectors.reshape(-1, 3)
            return np.array([self._pointed(vector) for vector in flat]).reshape(vectors.shape)

        return redirected(design, self.targets, pointed, side=self.side)

    def _pointed(self, vector: Floats) -> Floats:
        x, y, z = vector
        length = hypot(x, y, z) or 1.0
        azimuth = atan2(y, x) if self.azimuth is None else self.azimuth
        elevation = atan2(z, hypot(x, y)) if self.elevation is None else self.elevation
        c, s = quarter_exact(azimuth)
        rise = quarter_exact(elevation)
        return length * np.array([c * rise[0], s * rise[0], rise[1]])
