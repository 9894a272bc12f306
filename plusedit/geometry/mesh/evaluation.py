"""Mesh surfaces to full accuracy, in double precision.

At a place x the Gaussians have the exponents -e_i(x), e_i = |x - c_i|^2 / (2 sigma_i^2). The
least e of all cancels in the quotient and is taken off, so that where no plane is near the nearest
in units of sigma wins and nothing is ever 0 / 0. Planes with an e more than 36 above the least are
left out: a part in 10^15 beside the nearest.

In a domain with periods a Gaussian wider than about the period, summed over its images, is a
constant. It may then be taken for one of 1.5 periods that is higher in proportion, direction by
direction: both differ from constants by less than exp(-2 pi^2 1.5^2) = 5e-20. So the number of
images stays bounded, whatever the smoothness is.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from math import hypot, inf
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.domains import Domain, Images
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.nearby import DEEPEST, nearby
from plusedit.geometry.mesh.ordering import morton_order
from plusedit.geometry.mesh.plane_tree import PlaneTree
from plusedit.geometry.surface_jets import COUNTS

FLAT = 1.5  # periods: a Gaussian so wide, with all its images, is a constant
LEAST, MOST = 1e-60, 1e60  # smoothness: with less there are steps, with more constants
BESIDE = 1e-3  # of the least sigma: so far from a cone point normals are taken
AT = 1e-13  # of parameters: no farther from a cone point is at it
SHARE = 256  # places evaluated by one thread at a time, with S up to 3
LEAST_SHARE = 32  # with S from 8 on

Check: TypeAlias = Callable[[], object]
"""Called now and then, in any thread; what it raises ends the evaluation."""
Evaluator: TypeAlias = Callable[["Prepared", Floats, Floats, Check], None]


@dataclass(frozen=True, eq=False)
class Prepared:
    """The planes of a surface by their order in the tree, as the evaluators want them."""

    tree: PlaneTree
    widths: tuple[float, ...]
    """S and the largest sigma by u and by v"""
    halves: Floats
    """(n, 2) 1 / (2 sigma^2) by u and by v"""
    heights: Floats
    """(n,) weights W, times what widened planes are to be higher"""
    points: Floats
    """(n, 3) P"""
    by_u: Floats
    """(n, 3) s A"""
    by_v: Floats
    """(n, 3) s B"""
    periods: tuple[float, float]
    turns: bool
    images: Images

    @classmethod
    def of(cls, surface: MeshSurface, places: Floats) -> "Prepared":
        """The planes that may count at places (m, 2) in the cell, which are in order."""
        planes, domain = surface.planes, surface.domain
        smoothness = min(max(surface.smoothness, LEAST), MOST)
        caps = np.array([FLAT * p for p in domain.periods])
        images = _images(surface, smoothness, caps)
        tree = nearby(surface.foundation.tree, places, smoothness, caps, images)
        sigmas = smoothness * tree.reaches
        narrowed = np.minimum(sigmas[:, None], caps)
        heights = planes.weights[tree.order] * (sigmas[:, None] / narrowed).prod(axis=1)
        return cls(
            tree=tree,
            widths=(smoothness, *caps.tolist()),
            halves=0.5 / narrowed**2,
            heights=heights / heights.max(),
            points=planes.points[tree.order],
            by_u=surface.s * planes.gradients_u[tree.order],
            by_v=surface.s * planes.gradients_v[tree.order],
            periods=domain.periods,
            turns=domain.turns,
            images=images,
        )

    @cached_property
    def table(self) -> Floats:
        """(14, n) center, halves, height, P, s A and s B: one row for each number."""
        columns = (
            self.tree.centers.T,
            self.halves.T,
            self.heights[None],
            self.points.T,
            self.by_u.T,
            self.by_v.T,
        )
        return np.ascontiguousarray(np.concatenate(columns))


def _images(surface: MeshSurface, smoothness: float, caps: Floats) -> Images:
    """All images of which a plane may count in the cell."""
    domain = surface.domain
    largest = np.minimum(smoothness * surface.foundation.tree.reaches.max(), caps)
    # Of the images of one plane the nearest is half a period away at most.
    reaches = [
        hypot(0.5 * p, np.sqrt(2.0 * DEEPEST) * w) if p < inf else 0.0
        for p, w in zip(domain.periods, largest, strict=True)
    ]
    return domain.images(*reaches)


def unchecked() -> None:
    """What to check where nothing ends an evaluation before its time."""


def evaluated(
    surface: MeshSurface, places: Floats, *, derivatives: bool, check: Check = unchecked
) -> tuple[Floats, Floats, Floats]:
    """(m, 3) each: S, S_u and S_v at places (m, 2); the latter two empty unless asked for.

    ValueError for places that are not finite; what `check` raises.
    """
    if not derivatives:
        nothing = np.zeros((0, 3))
        return jets(surface, places, highest=0, check=check)[0], nothing, nothing
    points, by_u, by_v = jets(surface, places, highest=1, check=check)
    return points, by_u, by_v


def jets(
    surface: MeshSurface, places: Floats, *, highest: int, check: Check = unchecked
) -> tuple[Floats, ...]:
    """(S, S_u, S_v, S_uu, S_uv, S_vv) up to order `highest`, (m, 3) each, at places (m, 2).

    ValueError for places that are not finite; what `check` raises.
    """
    wanted = np.asarray(places, dtype=np.float64)
    if wanted.ndim != 2 or wanted.shape[1] != 2:
        raise ValueError(f"places: expected shape (None, 2), got {wanted.shape}")
    if not np.isfinite(wanted).all():
        raise ValueError("places: has a value that is not finite")
    inside, signs = surface.domain.reduction(wanted)
    order = morton_order(inside)
    ordered = inside[order]
    found = np.empty((len(order), 3 * COUNTS[highest]))
    _evaluator()(Prepared.of(surface, ordered), ordered, found, check)
    back = np.empty_like(found)
    back[order] = found
    # Where an image turns, first derivatives change their signs, and second ones change twice.
    back[:, 3:9] *= signs[:, None]
    parts = range(0, back.shape[1], 3)
    return tuple(np.ascontiguousarray(back[:, part : part + 3]) for part in parts)


def points_and_normals(
    surface: MeshSurface, places: Floats, check: Check = unchecked
) -> tuple[Floats, Floats]:
    """(m, 3) points and unit normals S_u x S_v, to full accuracy; what `check` raises.

    At a cone point of a pillow, where both tangents vanish, the normal is the mean of those around;
    where the surface has none, zero.
    """
    cones, count = cone_points(surface.domain, places), len(places)
    beside = _beside(surface, places[cones])
    points, by_u, by_v = evaluated(
        surface, np.concatenate([places, *beside]), derivatives=True, check=check
    )
    normals = unit(np.cross(unit(by_u[:count]), unit(by_v[:count])))
    if len(cones):
        # S is even about a cone point, so that its tangents at d are Q d with the second
        # derivatives Q. Of S_u x S_v, quadratic in d, the mean over all directions is that of two
        # at right angles.
        around = np.cross(by_u[count:] / BESIDE, by_v[count:] / BESIDE)
        normals[cones] = unit(around.reshape(2, len(cones), 3).sum(axis=0))
    return points[:count], normals


def _beside(surface: MeshSurface, cones: Floats) -> tuple[Floats, ...]:
    """Places (k, 2) beside cone points (k, 2) in two directions at right angles; none of none."""
    if not len(cones):
        return ()
    step = BESIDE * float(surface.sigmas[surface.planes.used].min())
    return cones + np.array([step, 0.0]), cones + np.array([0.0, step])


def cone_points(domain: Domain, places: Floats) -> NDArray[np.intp]:
    """The numbers of the places at which turning images of the domain meet: none but in pillows."""
    if not domain.turns:
        return np.zeros(0, dtype=np.intp)
    half = 0.5 * np.array(domain.periods)
    away = places / half
    away -= np.round(away)
    return np.flatnonzero(np.abs(away).max(axis=1) * half.max() < AT)


def _evaluator() -> Evaluator:
    """By compiled loops, or where numba is missing by trees of scipy."""
    try:
        full_kernels = import_module("plusedit.geometry.mesh.full_kernels")
    except ImportError:
        from plusedit.geometry.mesh.tree_evaluation import evaluate

        return evaluate

    def by_kernels(prepared: Prepared, places: Floats, found: Floats, check: Check) -> None:
        tree = prepared.tree
        in_shares(
            lambda rows: full_kernels.evaluate(
                places[rows],
                tree.boxes,
                tree.largest,
                prepared.table,
                np.array(prepared.widths),
                prepared.images.shifts,
                prepared.images.signs,
                found[rows],
            ),
            len(places),
            share_with(prepared.widths[0]),
            check,
        )

    return by_kernels


def share_with(smoothness: float) -> int:
    """Places that are evaluated in some ten milliseconds, however many planes count at each."""
    return int(max(LEAST_SHARE, min(SHARE, 8.0 * SHARE / smoothness**2)))


def in_shares(
    work: Callable[[slice], object], count: int, share: int, check: Check = unchecked
) -> None:
    """Have the rows 0 to count worked through, on as many threads as there are processors.

    `share` rows at a time; what `check` raises between them.
    """
    shares = [slice(start, start + share) for start in range(0, count, share)]

    def checked(rows: slice) -> None:
        check()
        work(rows)

    if len(shares) < 2:
        for rows in shares:
            checked(rows)
        return
    from concurrent.futures import ThreadPoolExecutor
    from os import cpu_count

    with ThreadPoolExecutor(min(len(shares), cpu_count() or 1)) as pool:
        for done in [pool.submit(checked, rows) for rows in shares]:
            done.result()
