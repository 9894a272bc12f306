"""D and N of a mesh surface at many places, by grids or plane by plane, whichever is quicker."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from math import hypot, inf, sqrt
from os import cpu_count
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Domain, Images
from plusedit.geometry.mesh.evaluation import FLAT, LEAST, MOST
from plusedit.geometry.mesh.forest import Forest, Grove, values
from plusedit.geometry.mesh.interpolation import weight_polynomials
from plusedit.geometry.mesh.ordering import ordered
from plusedit.geometry.mesh.planes import FacePlanes
from plusedit.geometry.mesh.preview_costs import grids_pay, of_tiles
from plusedit.geometry.mesh.spreading import SPACING, spreading

if TYPE_CHECKING:
    from plusedit.geometry.mesh.tile_kernels import Scene

REACH = 5.5  # sigma: farther planes are left out
ALONE = 1.6  # reaches that the nearest plane may be away from a place, if S is small
SMALL = 0.7  # S below which a grid is too coarse for the few planes at a place
TILES = 1 << 13  # room for these at first
DENSE = 128  # places looking for planes together, if there are as many places as planes

Singles = NDArray[np.float32]
Counts = NDArray[np.int64]
Work = Callable[[Counts, Singles], object]


@dataclass(frozen=True, eq=False)
class Target:
    """Places in the domain's cell, in the order of Morton."""

    order: NDArray[np.intp]
    """(m,) the numbers of the places"""
    codes: NDArray[np.uint64]
    """(m, 2) as `Ordered` has them"""
    low: Floats
    extent: float
    places: Floats
    """(m, 2) in that order"""
    box: Floats
    """(2, 2) the least u and v, and the largest"""

    @classmethod
    def of(cls, domain: Domain, places: Floats) -> "Target":
        """Those of at least one place (m, 2); ValueError where they are not finite."""
        inside = domain.reduced(places)
        if not np.isfinite(inside).all():
            raise ValueError("places: has a value that is not finite")
        found = ordered(inside)
        box = np.stack([inside.min(axis=0), inside.max(axis=0)])
        return cls(found.order, found.codes, found.low, found.extent, inside[found.order], box)


def solitary(smoothness: float) -> float:
    """The exponent of a plane that is alone near a place."""
    return 0.5 * (ALONE / max(smoothness, 0.05)) ** 2


def sums(wood: Forest, planes: FacePlanes, target: Target, smoothness: float, s: float) -> Singles:
    """(m, 12) D, N and their derivatives by u and by v at the places of the target.

    Points are measured from the forest's middle and by its size, u and v by the target's extent.
    """
    from plusedit.geometry.mesh import preview_kernels as kernels
    from plusedit.geometry.mesh import tile_kernels

    places = target.places
    # Places far from each other would see too many planes, and too wide a box has too few digits.
    most = min(max(1, DENSE * len(places) // len(wood.whole.order)), tile_kernels.BLOCK)
    scene = None
    if smoothness >= SMALL:
        scene = scene_of(wood, wood.parted, planes, target, smoothness, s)
    if scene is None or not grids_pay(scene, target.box, len(places), REACH / SPACING):
        scene = scene_of(wood, wood.whole, planes, target, smoothness, s)
        blocks = _listed(partial(tile_kernels.blocks, target.codes, most), 2)
        rows = np.zeros((len(blocks), tile_kernels.COLUMNS), dtype=np.int64)
        rows[:, 1:3] = blocks
        return _in_turns([(partial(kernels.one_by_one, scene, places), rows)], len(places))
    rows = _tiles(scene, target, max(1, most // 4))
    cost, suits = of_tiles(scene, rows, REACH / SPACING)
    dearest = np.argsort(-cost)
    rows, suits = rows[dearest], suits[dearest]
    by_grids = partial(kernels.by_grids, scene, places, weight_polynomials(SPACING))
    one_by_one = partial(kernels.one_by_one, scene, places)
    return _in_turns([(by_grids, rows[suits]), (one_by_one, rows[~suits])], len(places))


def _tiles(scene: "Scene", target: Target, most: int) -> Counts:
    """(k, 5) the tiles, as `tile_kernels` has them."""
    from plusedit.geometry.mesh import tile_kernels as kernels

    work = partial(kernels.tiles, scene, target.codes, target.low, target.extent, most)
    return _listed(work, kernels.COLUMNS)


def _listed(work: Callable[[Counts], int], columns: int) -> Counts:
    """The rows that the work fills in and counts, as many as there are."""
    room = TILES
    while True:
        rows = np.empty((room, columns), dtype=np.int64)
        count = work(rows)
        if count <= room:
            return rows[:count]
        room = count


def _in_turns(works: list[tuple[Work, Counts]], count: int) -> Singles:
    """Have the rows of each work done, on two threads if there are two processors, and add up."""
    workers = min(2, cpu_count() or 1)

    def share(turn: int) -> Singles:
        found = np.zeros((count, 12), dtype=np.float32)
        for work, rows in works:
            if len(mine := np.ascontiguousarray(rows[turn::workers])):
                work(mine, found)
        return found

    if workers == 1:
        return share(0)
    with ThreadPoolExecutor(1) as pool:
        other = pool.submit(share, 1)
        found = share(0)
        found += other.result()
    return found


def scene_of(
    wood: Forest, grove: Grove, planes: FacePlanes, target: Target, smoothness: float, s: float
) -> "Scene":
    """All that the loops need to know of a surface."""
    from plusedit.geometry.mesh.tile_kernels import Scene

    domain = wood.foundation.domain
    bounded = min(max(smoothness, LEAST), MOST)
    caps = np.array([FLAT * p for p in domain.periods])
    depth = 0.5 * REACH**2 + solitary(smoothness)
    halves = _halves(bounded * grove.reaches, caps)
    # What is taken for narrower than it is counts for more.
    heights = 2.0 * (bounded * grove.reaches) ** 2 * np.sqrt(halves[:, 0] * halves[:, 1])
    sigma = np.minimum(bounded * grove.largest.max(), caps)
    images = domain.images(
        *(_image_reach(p, w, depth) for p, w in zip(domain.periods, sigma, strict=True))
    )
    node_halves = _halves(bounded * grove.largest, caps)
    units = SPACING * np.minimum(bounded * grove.least[grove.groups[:, 0]], caps.min())
    roots = grove.counts[:, 0] + 1
    return Scene(
        counts=grove.counts,
        boxes=grove.boxes,
        node_halves=node_halves,
        centers=grove.centers,
        halves=halves,
        heights=heights.astype(np.float32),
        values=values(planes, grove, wood, target.extent),
        groups=grove.groups,
        units=units,
        capped=bounded * grove.largest[roots] > caps.min(),
        spreading=spreading(),
        shifts=images.shifts,
        signs=images.signs,
        images=_near(images, target.box, grove.boxes[roots], node_halves[roots], depth),
        numbers=np.array([s, depth, target.extent]),
    )


def _halves(sigmas: Floats, caps: Floats) -> Floats:
    """(n, 2) 1 / (2 sigma^2) by u and by v, sigma up to the caps; infinite where it is zero."""
    with np.errstate(divide="ignore"):
        inverse = np.sqrt(0.5) / sigmas
    found: Floats = np.maximum(inverse[:, None], np.sqrt(0.5) / caps)
    found *= found
    return found


def _image_reach(period: float, sigma: float, depth: float) -> float:
    return hypot(0.5 * period, sqrt(2.0 * depth) * sigma) if period < inf else 0.0


def _near(
    images: Images, box: Floats, roots: Floats, halves: Floats, depth: float
) -> NDArray[np.bool_]:
    """(trees, images) whether some plane of a tree may reach the box of all places."""
    ends = images.signs[:, None, None] * (box - images.shifts[:, None])
    low, high = ends.min(axis=1), ends.max(axis=1)
    apart = np.maximum(low - roots[:, None, 2:], roots[:, None, :2] - high)
    exponents = (np.maximum(apart, 0.0) ** 2 * halves[:, None]).sum(axis=2)
    found: NDArray[np.bool_] = exponents <= depth
    return found
