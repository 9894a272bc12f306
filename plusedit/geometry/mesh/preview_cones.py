"""Normals of the fast preview at the cone points of pillows, where both tangents vanish.

S is even about a cone point, so that its tangents at d are Q d with the second derivatives Q. Of
S_u x S_v, quadratic in d, the mean over all directions is that of two at right angles.
"""

from functools import lru_cache

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.domains import PillowDomain
from plusedit.geometry.mesh.forest import forest
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.preview_sums import Target, sums

BESIDE = 0.02  # of sigma: so far from a cone point tangents are taken
MOST = 0.01  # of the shorter side of the domain, however large sigma is


def cone_normals(surface: MeshSurface, cones: Floats) -> Floats:
    """(k, 3) unit normals at cone points (k, 2) of a pillow or images of them, nearly.

    Zero where no plane is near enough to tell.
    """
    domain = surface.domain
    assert isinstance(domain, PillowDomain)
    along, across = (np.round(cones / [domain.width, 0.5]).astype(np.intp) % 2).T
    normals = _normals(surface, domain)
    # The cone points follow each other around the cell.
    found: Floats = normals[np.where(along == 0, across, 3 - across)]
    return found


def _normals(surface: MeshSurface, domain: PillowDomain) -> Floats:
    """(4, 3) at the domain's cone points."""
    reaches = _reaches(surface.foundation, domain)
    steps = np.minimum(BESIDE * surface.smoothness * reaches, MOST * min(domain.cell))
    steps = np.repeat(steps[:, None], 2, axis=0)
    aside = np.repeat(domain.cone_points, 2, axis=0) + steps * np.tile(np.eye(2), (4, 1))
    target = Target.of(domain, aside)
    rows = np.empty((8, 12))
    wood = forest(surface.foundation)
    rows[target.order] = sums(wood, surface.planes, target, surface.smoothness, surface.s)
    total, values = rows[:, :1], rows[:, 1:4]
    with np.errstate(divide="ignore", invalid="ignore"):
        by_u, by_v = (
            (slopes[:, 1:] - slopes[:, :1] * values / total) / total / steps
            for slopes in (rows[:, 4:8], rows[:, 8:])
        )
    means = np.cross(by_u, by_v).reshape(4, 2, 3).sum(axis=1)
    return unit(np.where(np.isfinite(means), means, 0.0))


@lru_cache(maxsize=8)
def _reaches(foundation: Foundation, domain: PillowDomain) -> Floats:
    """(4,) of the planes nearest to the cone points, sigma / S."""
    tree, found = foundation.tree, []
    for cone in domain.cone_points:
        away = domain.nearest(tree.centers, np.broadcast_to(cone, tree.centers.shape)) - cone
        found.append(tree.reaches[np.argmin((away**2).sum(axis=1))])
    return np.array(found)
