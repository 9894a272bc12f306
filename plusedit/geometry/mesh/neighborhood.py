"""Where a mesh surface can change at all when a few of its control planes do.

To full accuracy a plane counts at a place only where its exponent e = |x - c|^2 / (2 sigma^2) is
less than 36 above the least of all planes. That least is bounded by the e of a few planes with
their centers near the place, which depend neither on S nor on edits and so are looked for once.
"""

from functools import lru_cache
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.evaluation import FLAT
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.held import Held
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.nearby import DEEPEST
from plusedit.geometry.mesh.planes import FacePlanes

FEW = 16  # centers that are looked at one by one
NEAREST = 4  # planes, of which that with the least e bounds it
ROUNDING = 1e-9

Rows = NDArray[np.intp]


def changed_places(old: MeshSurface, new: MeshSurface, places: Floats) -> Rows | None:
    """The numbers of the places (m, 2), ascending, where points and normals may differ.

    Of surfaces that differ in some control planes or local factors alone; None for others, which
    may differ anywhere. At all other places the surfaces agree to rounding. What is near the places
    is kept for the next call if they are the same read-only array.
    """
    if not _comparable(old, new):
        return None
    faces = changed_faces(old, new)
    if not len(faces) or not len(places):
        return np.zeros(0, dtype=np.intp)
    near = near_planes(old, places)
    limits = DEEPEST + _bounds(old, new, places)
    wide = np.maximum(old.sigmas[faces], new.sigmas[faces])
    found = np.zeros(len(places), dtype=np.bool_)
    octaves = np.floor(np.log2(wide))
    for octave in np.unique(octaves):
        chosen = octaves == octave
        reaches = wide[chosen].max() * np.sqrt(2.0 * limits) * (1.0 + ROUNDING)
        found |= _within(old, faces[chosen], near.places, reaches)
    return np.flatnonzero(found)


def changed_faces(old: MeshSurface, new: MeshSurface) -> Rows:
    """The faces whose control planes differ, ascending, of surfaces of the same mesh."""
    before, after = old.planes, new.planes
    differ = old.foundation.reaches != new.foundation.reaches
    if before is not after:
        for name in ("points", "gradients_u", "gradients_v"):
            unequal = getattr(before, name) != getattr(after, name)
            # Looking at rows of three one by one takes longer than all the rest.
            differ[np.flatnonzero(unequal) // 3] = True
    return np.flatnonzero(differ & (before.radii > 0.0))


def _comparable(old: MeshSurface, new: MeshSurface) -> bool:
    parts = new.foundation_parts._replace(factors=old.factors)
    same_numbers = (old.smoothness, old.s) == (new.smoothness, new.s)
    return same_numbers and old.foundation.serves(parts)


class Near(NamedTuple):
    """Places and planes near them."""

    places: Floats
    """(m, 2) moved into the cell"""
    faces: Rows
    """(m, k) with their centers, or some of their images, near the place"""
    away: Floats
    """(m, k, 2) from these to the place"""


def near_planes(surface: MeshSurface, places: Floats) -> Near:
    """Some planes near each of the places (m, 2), whatever S, s, the edits and factors are."""
    planes, domain = surface.foundation.planes, surface.domain
    if places.flags.writeable:
        return _near_planes(planes, domain, places)
    return _known_near_planes(planes, domain, Held(places))


@lru_cache(maxsize=8)
def _known_near_planes(planes: FacePlanes, domain: Domain, held: Held) -> Near:
    return _near_planes(planes, domain, held.array)


def _near_planes(planes: FacePlanes, domain: Domain, places: Floats) -> Near:
    from scipy.spatial import KDTree

    inside, centers = domain.reduced(places), domain.reduced(planes.centers[planes.used])
    count = min(NEAREST, len(centers))
    _, found = KDTree(centers, balanced_tree=False).query(inside, count)
    nearest = found.reshape(len(inside), count)
    return Near(inside, planes.used[nearest], inside[:, None] - centers[nearest])


def _bounds(old: MeshSurface, new: MeshSurface, places: Floats) -> Floats:
    """(m,) no plane that is nearest in units of sigma, of either surface, has a larger e there."""
    if old.foundation is new.foundation and not places.flags.writeable:
        return _known_bounds(old.foundation, old.smoothness, old.domain, Held(places))
    narrow = np.minimum(old.sigmas, new.sigmas)
    return _least_exponents(near_planes(old, places), narrow, old.domain)


@lru_cache(maxsize=8)
def _known_bounds(foundation: Foundation, smoothness: float, domain: Domain, held: Held) -> Floats:
    near = _known_near_planes(foundation.planes, domain, held)
    return _least_exponents(near, smoothness * foundation.reaches, domain)


def _least_exponents(near: Near, sigmas: Floats, domain: Domain) -> Floats:
    """(m,) no plane that is nearest in units of sigma has a larger e there."""
    widths = np.minimum(sigmas[near.faces][..., None], FLAT * np.array(domain.periods))
    least: Floats = 0.5 * ((near.away / widths) ** 2).sum(axis=2).min(axis=1)
    return least


def _within(
    surface: MeshSurface, faces: Rows, inside: Floats, reaches: Floats
) -> NDArray[np.bool_]:
    """(m,) whether the center of one of these faces, or an image of it, is that near."""
    domain = surface.domain
    # So wide around, nearly every place is near some image.
    found = reaches >= 0.5 * min(domain.periods)
    rest = np.flatnonzero(~found)
    if not len(rest):
        return found
    places, limits = inside[rest], reaches[rest]
    most = float(limits.max())
    centers = domain.shifted(surface.foundation.planes.centers[faces])
    images = domain.images(most if min(domain.periods) < inf else 0.0)
    moved = (images.signs[:, None, None] * centers + images.shifts[:, None]).reshape(-1, 2)
    low, high = places.min(axis=0) - most, places.max(axis=0) + most
    moved = moved[((moved >= low) & (moved <= high)).all(axis=1)]
    found[rest] = _least_distances(places, moved, most) <= limits
    return found


def _least_distances(places: Floats, centers: Floats, most: float) -> Floats:
    """(m,) to the nearest of some centers; infinite where that is farther than the most."""
    if len(centers) > FEW:
        from scipy.spatial import KDTree

        bound = most * (1.0 + ROUNDING)
        return np.asarray(KDTree(centers).query(places, distance_upper_bound=bound)[0])
    squares = np.full(len(places), inf)
    for center in centers:
        u, v = (places - center).T
        np.minimum(squares, u * u + v * v, out=squares)
    away: Floats = np.sqrt(squares)
    return away
