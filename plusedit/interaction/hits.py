"""What can lie under the pointer."""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from plusedit.document.selection import LineId
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats

TIE = 0.25  # pixels: what is nearer by less counts as equally near

Kind = Literal["dot", "grip", "curve", "surface", "mesh", "face", "edge", "arrow", "ring"]
"""A "face" is the surface of a mesh where that is selected; where it is not, it is a "mesh"."""


@dataclass(frozen=True)
class Hit:
    """Something under the pointer."""

    kind: Kind
    shape: ShapeId
    number: int = -1
    """of the control line or plane; of an edge of a net that of the plane where it begins; of the
    surface of a mesh the face; else -1"""
    side: int = 0
    """of a grip: 1 where the direction of a line points, -1 opposite; 1 by u and 2 by v on a plane
    """
    u: float = 0.0
    """of a curve or surface: the parameter nearest to the pointer"""
    v: float = 0.0
    axis: int = 0
    """of an arrow or a ring: u, v, normal or x, y, z; of an edge 0 where u runs along it, 1 for v
    """
    distance: float = 0.0
    """in pixels"""
    depth: float = 0.0
    """in the view, as the camera tells it"""

    @property
    def line(self) -> LineId | None:
        """The control line or plane whose dot, grip or face was hit; None of anything else."""
        is_one = self.kind in ("dot", "grip", "face")
        return LineId(self.shape, self.number) if is_one else None


def nearest_on_segments(at: Floats, starts: Floats, ends: Floats) -> tuple[Floats, Floats]:
    """Where on each segment (0 to 1) it is nearest to a point (2,), and the distance there."""
    along = ends - starts
    square = (along**2).sum(axis=1)
    share = np.divide(
        ((at - starts) * along).sum(axis=1), square, out=np.zeros(len(starts)), where=square > 0.0
    ).clip(0.0, 1.0)
    distances: Floats = np.hypot(*(starts + share[:, None] * along - at).T)
    return share, distances
