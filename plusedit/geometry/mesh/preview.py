"""Mesh surfaces while a slider moves: nearly right, in a time that hardly depends on S.

With D = sum W G and N = sum W L G the surface is N / D, and where many planes count, both vary
only at the scale of sigma. So they are summed up at the nodes of grids and interpolated:

* The planes are sorted into groups of sigmas that differ by a factor of 1.55 at most (`forest`).
  Each group has a grid of its own, of a spacing of 0.36 of its least sigma. Places gather from the
  grids of all groups whose planes reach them, so that a fine grid is only where planes are small.
* A grid is made tile by tile, about a hundred nodes wide, and only where there are places. A plane
  is spread on fourteen nodes each way, whatever S is, and what is left of its Gaussian is one blur
  of the whole grid (`spreading`).
* The larger S, the fewer nodes and tiles. Only the planes themselves do not become fewer.
* Tiles with few places or planes, and for small S all, are summed up without a grid
  (`preview_costs`).

Planes beyond 5.5 sigma are left out; the error stays below 1e-5 of the mesh's diagonal. Where D is
too small to tell, the surface is evaluated to full accuracy.
"""

from functools import lru_cache
from importlib import import_module
from math import exp
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.evaluation import cone_points, points_and_normals
from plusedit.geometry.mesh.forest import forest
from plusedit.geometry.mesh.held import Held
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.preview_cones import cone_normals
from plusedit.geometry.mesh.preview_sums import Target, solitary, sums

THIN = 0.1  # of D where planes lie evenly: below, the surface is evaluated to full accuracy

Singles = NDArray[np.float32]


class Preview(NamedTuple):
    """The surface at places, nearly."""

    points: Singles
    """(m, 3)"""
    normals: Singles
    """(m, 3) unit vectors along S_u x S_v; zero where there is no normal"""


def preview(surface: MeshSurface, places: Floats) -> Preview:
    """Points and normals at places (m, 2), the points within 1e-5 of the mesh's diagonal, or within
    2e-5 where S differs much from face to face.

    What does not depend on S, s and the edits is kept for the next call; of places also, if they
    are the same read-only array. Without numba all is to full accuracy and slow.
    """
    points = np.empty((len(places), 3), dtype=np.float32)
    normals = np.zeros_like(points)
    weak = _quickly(surface, places, points, normals)
    if weak.any():
        points[weak], normals[weak] = points_and_normals(surface, places[weak])
    return Preview(points, normals)


def _quickly(
    surface: MeshSurface, places: Floats, points: Singles, normals: Singles
) -> NDArray[np.bool_]:
    """Fill points and normals; (m,) where that could not be done."""
    weak = np.zeros(len(places), dtype=np.bool_)
    try:
        finish = import_module("plusedit.geometry.mesh.preview_kernels").finish
    except ImportError:
        return ~weak
    if not len(places):
        return weak
    wood, smoothness = forest(surface.foundation), surface.smoothness
    target = target_of(surface.domain, places)
    found = sums(wood, surface.planes, target, smoothness, surface.s)
    least = THIN * max(1.0, smoothness**2) * exp(-solitary(smoothness))
    finish(found, target.order, least, wood.middle, wood.size, points, normals, weak)
    cones = cone_points(surface.domain, places)
    if len(cones):
        normals[cones] = cone_normals(surface, places[cones])
        weak[cones] |= ~normals[cones].any(axis=1)
    return weak


def target_of(domain: Domain, places: Floats) -> Target:
    """The places in order; kept, if nobody can write to them."""
    if places.flags.writeable:
        return Target.of(domain, places)
    return _known_target(domain, Held(places))


@lru_cache(maxsize=8)
def _known_target(domain: Domain, held: Held) -> Target:
    return Target.of(domain, held.array)
