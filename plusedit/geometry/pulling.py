"""A point of a curve or surface pulled to another place by the least change.

With the shares R and E of `influence`, the point moves by sum R_i dP_i + sum E_ki dg_ki. Of all
changes that move it by `by`, the one with the least sum of squares is

    dP_i = R_i / T by,    h_k dg_ki = (E_ki / h_k) / T by,    T = sum R_i^2 + sum (E_ki / h_k)^2,

where a gradient counts as what it moves its own line by over the spacing h of the nodes. Only
points, or only gradients, may change as well: T has the other sum no more.
"""

from collections.abc import Callable
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.influence import Influence, Linear, Place, influence
from plusedit.geometry.mesh.mesh_surface import MeshSurface

Change = Literal["points", "gradients", "both"]
"""What may change."""

STEPS = 24  # of following automatic directions, which turn with the points
NEAR = 1e-14  # of the size of the shape: a miss that is rounding
FAINT = 1e-6  # of the largest share: a line with less stays as it is
LEAST = 1e-12  # share of the gradients: below, they have no hold on the point


def pulled(
    geometry: Linear,
    place: Place,
    to: ArrayLike,
    change: Change = "points",
    keep: Callable[[Linear], Linear] | None = None,
) -> Linear:
    """The shape whose point at `place` is `to` (dim,), with the least change of its data.

    Parameters
    ----------
    place
        (u,) on a curve, (u, v) on a surface.
    change
        "points": the control points move, automatic directions follow them. "gradients": the
        directions alone change, and stay so. "both": both do.
    keep
        What is done to the shape after the pull, such as bringing it back to its constraints. The
        point comes to `to` all the same, or as near as what is kept lets it.

    Raises ValueError, in a sentence for people, where nothing that may change moves that point,
    as at the end of an open curve, which is held by its control point alone.
    """
    if change not in get_args(Change):
        raise ValueError(f"change: expected one of {get_args(Change)}, got {change!r}")
    target = frozen(to, shape=(geometry.dimension,), name="to")
    shares = influence(geometry, place)
    if keep is None:
        return _once(geometry, place, target, change, shares)
    start = _at(geometry, place)

    def kept(by: Floats) -> Linear:
        return keep(_once(geometry, place, start + by, change, shares))

    return _met(kept, place, target, target - start)[0]


def _once(
    geometry: Linear, place: Place, target: Floats, change: Change, shares: Influence
) -> Linear:
    """The shape pulled, with nothing to keep."""
    if change == "points":
        return _by_points(geometry, place, target, shares)
    if geometry.s == 0.0:
        if change == "both":
            return _by_points(geometry, place, target, shares)
        raise ValueError("With s = 0 gradients move nothing; set s first, or pull points.")
    return _by_gradients(geometry, place, target, shares, with_points=change == "both")


def _met(
    make: Callable[[Floats], Linear], place: Place, target: Floats, by: Floats
) -> tuple[Linear, bool]:
    """The shape made by the vector (dim,) that brings its point to the target, and whether it does.

    Broyden's method, which begins as if the point moved by what it is pulled by. Where no vector
    is found, the shape whose point comes nearest.
    """
    change, inverse = by, np.eye(len(by))
    best = moved = make(change)
    least = np.inf
    miss = target - _at(moved, place)
    for _ in range(STEPS):
        size = float(np.abs(miss).max())
        if size < least:
            best, least = moved, size
        near = NEAR * (float(np.abs(moved.net.control_points).max()) + np.abs(target).max())
        if size <= near:
            return moved, True
        step = inverse @ miss
        moved = make(change + step)
        left = target - _at(moved, place)
        seen = inverse @ (miss - left)
        along = float(step @ seen)
        if not np.isfinite(left).all() or along == 0.0:
            break
        inverse = inverse + np.outer(step - seen, step @ inverse) / along
        change, miss = change + step, left
    return best, False


def _by_points(geometry: Linear, place: Place, target: Floats, shares: Influence) -> Linear:
    net, start = geometry.net, geometry.net.control_points
    row = _cut(shares.values)
    row = row / (row @ shares.values)
    by = target - _at(geometry, place)
    if not by.any():
        return geometry
    # Automatic directions turn with the points, so the shape is not linear in these any more.
    moved, is_there = _met(
        lambda change: geometry.with_net(net.with_control_points(start + np.outer(row, change))),
        place,
        target,
        by,
    )
    if is_there:
        return moved
    kept = net.with_vectors(geometry.vectors, np.zeros_like(net.automatic_vectors))
    return geometry.with_net(kept.with_control_points(start + np.outer(row, by)))


def _by_gradients(
    geometry: Linear, place: Place, target: Floats, shares: Influence, *, with_points: bool
) -> Linear:
    net, spacings = geometry.net, _spacings(geometry)
    reaches = _cut(shares.reaches / spacings)
    if np.abs(reaches).max() <= LEAST and not with_points:
        raise ValueError(
            "There only control points have a hold on the shape, as at an open end: pull points."
        )
    values = _cut(shares.values) if with_points else np.zeros_like(shares.values)
    by = target - _at(geometry, place)
    if not by.any():
        return geometry
    total = float(values @ shares.values + (reaches * shares.reaches / spacings).sum())
    turned = np.multiply.outer(reaches / (spacings * total * geometry.s), by)
    # A direction that has no share may go on following its neighbors, wherever these go.
    bound = NEAR * np.abs(shares.reaches).max() if with_points else 0.0
    stays = (np.abs(shares.reaches) <= bound) | ((reaches == 0.0) & (not with_points))
    automatic = net.automatic_vectors & stays
    given = np.where(automatic[..., None], 0.0, geometry.vectors + turned)
    changed = net.with_vectors(given, automatic)
    if with_points:
        points = net.control_points + np.outer(values / total, by)
        changed = changed.with_control_points(points)
    return geometry.with_net(changed)


def _cut(shares: Floats) -> Floats:
    """The shares without those too small to matter: their lines are left alone."""
    cut: Floats = np.where(np.abs(shares) > FAINT * np.abs(shares).max(), shares, 0.0)
    return cut


def _spacings(geometry: Linear) -> Floats:
    """(k, 1) of the nodes by each direction; (1, f) of a mesh the radii of its faces."""
    if isinstance(geometry, PlusCurve):
        return np.array([[geometry.spacing]])
    if isinstance(geometry, MeshSurface):
        radii = geometry.foundation.planes.radii
        return np.where(radii > 0.0, radii, 1.0)[None]
    return np.array(geometry.spacings)[:, None]


def _at(geometry: Linear, place: Place) -> Floats:
    """(dim,) the point of the shape."""
    if isinstance(geometry, PlusCurve):
        at = geometry.at([place[0]])
    elif isinstance(geometry, MeshSurface):
        at = geometry.at([place])
    else:
        at = geometry.derivatives_at([place], highest=0)[0]
    point: Floats = at[0]
    return point
