"""Control planes of the faces of a mesh that has parameters.

The plane of a face with vertices V_j at parameters q_j is

    L(x) = P + (x - c)_u A + (x - c)_v B,      P = mean V_j,   c = mean q_j,

(A, B) the least squares fit of V_j - P by q_j - c, of minimum norm where the q_j lie on a line.
The plane of a triangle passes through its vertices. The reach of a plane is the radius r of the
smallest circle around the q_j. Limbs of a closed mesh have parameters as small as 1e-11: all is
calculated from differences to the face's first corner, in units of its size.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.mesh.circles import enclosing_radii
from plusedit.geometry.mesh.polygons import PolygonMesh

COLLINEAR = 1e-10  # determinant over squared trace: below, the q_j lie on a line
LEAST_WEIGHT = 1e-7  # a face without parameter area counts next to nothing, but has a weight


@dataclass(frozen=True, eq=False)
class FacePlanes:
    """One control plane for each face; never changed in place.

    Compared by identity, so that it can key a cache.
    """

    centers: Floats
    """(f, 2) c"""
    points: Floats
    """(f, 3) P"""
    gradients_u: Floats
    """(f, 3) A"""
    gradients_v: Floats
    """(f, 3) B"""
    radii: Floats
    """(f,) r; planes with r = 0 are skipped"""
    weights: Floats
    """(f,) W > 0"""

    def __post_init__(self) -> None:
        count = len(self.radii)
        shapes = {
            "centers": (count, 2),
            "points": (count, 3),
            "gradients_u": (count, 3),
            "gradients_v": (count, 3),
            "radii": (count,),
            "weights": (count,),
        }
        for name, shape in shapes.items():
            array = getattr(self, name)
            if array.flags.writeable or array.dtype != np.float64:
                object.__setattr__(self, name, frozen(array, shape=shape, name=name))
        if count and self.radii.min() < 0.0:
            raise ValueError(f"radii: must not be negative, got {self.radii.min()}")
        if count and self.weights.min() <= 0.0:
            raise ValueError(f"weights: must be positive, got {self.weights.min()}")

    def __len__(self) -> int:
        return len(self.radii)

    @cached_property
    def used(self) -> NDArray[np.intp]:
        """The faces that have a plane: those with r > 0."""
        return np.flatnonzero(self.radii > 0.0)

    @property
    def skipped(self) -> int:
        """How many faces have none, all their corners having the same parameters."""
        return len(self) - len(self.used)

    def values(self, faces: NDArray[np.intp], places: Floats, *, s: float = 1.0) -> Floats:
        """(m, 3) of each of these faces its plane at its own of the places (m, 2)."""
        away = s * (places - self.centers[faces])
        pull = away[:, :1] * self.gradients_u[faces] + away[:, 1:] * self.gradients_v[faces]
        found: Floats = self.points[faces] + pull
        return found


class _Fit(NamedTuple):
    """Sums over the corners of each face."""

    offsets: Floats
    """(c, 2) from the center, in units of the scale"""
    heights: Floats
    """(c, 3) from P"""
    scales: Floats
    """(f,) positive"""


def planes_of(mesh: PolygonMesh, parameters: Floats, area_weights: bool = False) -> FacePlanes:
    """The control planes of all faces, from one (u, v) per corner (c, 2), unwrapped in each face.

    With area weights W = (parameter area) / r^2, which on irregular meshes keeps thin faces from
    counting like large ones; otherwise 1.
    """
    q = frozen(parameters, shape=(len(mesh.corners), 2), name="parameters")
    firsts = q[mesh.starts[:-1]]
    near = q - np.repeat(firsts, mesh.sizes, axis=0)
    inner = mesh.sums(near) / mesh.sizes[:, None]
    corner_points = mesh.vertices[mesh.corners]
    bases = corner_points[mesh.starts[:-1]]
    above = corner_points - np.repeat(bases, mesh.sizes, axis=0)
    means = mesh.sums(above) / mesh.sizes[:, None]
    offsets = near - np.repeat(inner, mesh.sizes, axis=0)
    scales = _scales(mesh, offsets)
    fit = _Fit(
        offsets / np.repeat(scales, mesh.sizes)[:, None],
        above - np.repeat(means, mesh.sizes, axis=0),
        scales,
    )
    by_u, by_v = _gradients(mesh, fit)
    radii = _radii(mesh, q)
    weights = _area_weights(mesh, fit, radii) if area_weights else np.ones(len(radii))
    return FacePlanes(firsts + inner, bases + means, by_u, by_v, radii, weights)


def _scales(mesh: PolygonMesh, offsets: Floats) -> Floats:
    """(f,) the largest offset of each face; one where it is zero."""
    if not mesh.face_count:
        return np.ones(0)
    largest = np.maximum.reduceat(np.abs(offsets).max(axis=1), mesh.starts[:-1])
    return np.where(largest > 0.0, largest, 1.0)


def _gradients(mesh: PolygonMesh, fit: _Fit) -> tuple[Floats, Floats]:
    """A and B (f, 3): by orthogonal columns, which a thin face does not spoil as normal equations
    would be."""
    moments = mesh.sums(fit.offsets[:, :, None] * fit.offsets[:, None, :])
    trace = moments[:, 0, 0] + moments[:, 1, 1]
    # The longer column first; with it the other is made orthogonal.
    swapped = moments[:, 1, 1] > moments[:, 0, 0]
    corner_swapped = np.repeat(swapped, mesh.sizes)
    first = np.where(corner_swapped, fit.offsets[:, 1], fit.offsets[:, 0])
    second = np.where(corner_swapped, fit.offsets[:, 0], fit.offsets[:, 1])
    squared = mesh.sums(first * first)
    safe = np.where(squared > 0.0, squared, 1.0)
    share = mesh.sums(first * second) / safe
    rest = second - np.repeat(share, mesh.sizes) * first
    again = mesh.sums(first * rest) / safe
    share, rest = share + again, rest - np.repeat(again, mesh.sizes) * first
    rest_squared = mesh.sums(rest * rest)
    thin = squared * rest_squared <= COLLINEAR * trace**2
    along = mesh.sums(first[:, None] * fit.heights) / safe[:, None]
    rest_safe = np.where(thin, 1.0, rest_squared)[:, None]
    by_second = mesh.sums(rest[:, None] * fit.heights) / rest_safe
    by_first = along - share[:, None] * by_second
    if thin.any():
        # On a line the heights are a function of the first column alone; its gradient turned into
        # the direction (1, share) of the line has the least norm.
        norm = (1.0 + share**2)[:, None]
        by_first = np.where(thin[:, None], along / norm, by_first)
        by_second = np.where(thin[:, None], share[:, None] * along / norm, by_second)
    by_first, by_second = by_first / fit.scales[:, None], by_second / fit.scales[:, None]
    return (
        np.where(swapped[:, None], by_second, by_first),
        np.where(swapped[:, None], by_first, by_second),
    )


def _radii(mesh: PolygonMesh, parameters: Floats) -> Floats:
    radii = np.zeros(mesh.face_count)
    for size in np.unique(mesh.sizes):
        chosen = np.flatnonzero(mesh.sizes == size)
        corners = mesh.starts[chosen, None] + np.arange(size)
        radii[chosen] = enclosing_radii(parameters[corners])
    return radii


def _area_weights(mesh: PolygonMesh, fit: _Fit, radii: Floats) -> Floats:
    """(f,) areas over r^2."""
    after = fit.offsets[mesh.following]
    doubled = fit.offsets[:, 0] * after[:, 1] - fit.offsets[:, 1] * after[:, 0]
    areas = 0.5 * np.abs(mesh.sums(doubled))
    relative = np.where(radii > 0.0, radii / fit.scales, 1.0)
    weights: Floats = np.maximum(areas / relative**2, LEAST_WEIGHT)
    return weights
