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
from math import hypot, inf

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Images
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.ordering import morton_order
from plusedit.geometry.mesh.plane_tree import PlaneTree

DEEPEST = 36.0  # below the largest exponent at a place a plane is left out
FLAT = 1.5  # periods: a Gaussian so wide, with all its images, is a constant
LEAST, MOST = 1e-60, 1e60  # smoothness: with less there are steps, with more constants
SHARE = 4096  # places evaluated by one thread at a time

Evaluator = Callable[["Prepared", Floats, Floats], None]


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
    def of(cls, surface: MeshSurface) -> "Prepared":
        tree, planes = surface.foundation.tree, surface.planes
        domain = surface.domain
        smoothness = min(max(surface.smoothness, LEAST), MOST)
        sigmas = smoothness * tree.reaches
        caps = tuple(FLAT * p for p in domain.periods)
        narrowed = np.minimum(sigmas[:, None], caps)
        heights = planes.weights[tree.order] * (sigmas[:, None] / narrowed).prod(axis=1)
        largest = narrowed.max(axis=0)
        # Of the images of one plane the nearest is half a period away at most.
        reaches = [
            hypot(0.5 * p, np.sqrt(2.0 * DEEPEST) * w) if p < inf else 0.0
            for p, w in zip(domain.periods, largest, strict=True)
        ]
        return cls(
            tree=tree,
            widths=(smoothness, *caps),
            halves=0.5 / narrowed**2,
            heights=heights / heights.max(),
            points=planes.points[tree.order],
            by_u=surface.s * planes.gradients_u[tree.order],
            by_v=surface.s * planes.gradients_v[tree.order],
            periods=domain.periods,
            turns=domain.turns,
            images=domain.images(*reaches),
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


def evaluated(
    surface: MeshSurface, places: Floats, *, derivatives: bool
) -> tuple[Floats, Floats, Floats]:
    """(m, 3) each: S, S_u and S_v at places (m, 2); the latter two empty unless asked for.

    ValueError for places that are not finite.
    """
    wanted = np.asarray(places, dtype=np.float64)
    if wanted.ndim != 2 or wanted.shape[1] != 2:
        raise ValueError(f"places: expected shape (None, 2), got {wanted.shape}")
    if not np.isfinite(wanted).all():
        raise ValueError("places: has a value that is not finite")
    prepared = Prepared.of(surface)
    inside, signs = surface.domain.reduction(wanted)
    order = morton_order(inside)
    found = np.empty((len(order), 9 if derivatives else 3))
    _evaluator()(prepared, inside[order], found)
    back = np.empty_like(found)
    back[order] = found
    points = np.ascontiguousarray(back[:, :3])
    if not derivatives:
        return points, np.zeros((0, 3)), np.zeros((0, 3))
    return points, signs[:, None] * back[:, 3:6], signs[:, None] * back[:, 6:]


def _evaluator() -> Evaluator:
    """By compiled loops, or where numba is missing by trees of scipy."""
    try:
        from plusedit.geometry.mesh import full_kernels
    except ImportError:
        from plusedit.geometry.mesh.tree_evaluation import evaluate

        return evaluate

    def by_kernels(prepared: Prepared, places: Floats, found: Floats) -> None:
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
        )

    return by_kernels


def in_shares(work: Callable[[slice], object], count: int) -> None:
    """Have the rows 0 to count worked through, on as many threads as there are processors."""
    shares = [slice(start, start + SHARE) for start in range(0, count, SHARE)]
    if len(shares) < 2:
        for rows in shares:
            work(rows)
        return
    from concurrent.futures import ThreadPoolExecutor
    from os import cpu_count

    with ThreadPoolExecutor(min(len(shares), cpu_count() or 1)) as pool:
        for done in [pool.submit(work, rows) for rows in shares]:
            done.result()
