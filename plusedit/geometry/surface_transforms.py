"""Surfaces moved, turned, scaled and mirrored as wholes, run backwards, and with u and v swapped.

For x -> T x + t: P -> T P + t, d^u -> T d^u and d^v -> T d^v, not made unit again, with s as it
was. Then the surface of the images is the image of the surface.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import frozen
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.geometry.transforms import reversed_basis, reversed_rows, similarity


def transformed_surface(
    surface: PlusSurface, matrix: ArrayLike, offset: ArrayLike | float = 0.0
) -> PlusSurface:
    """The image of the surface under x -> matrix x + offset, exactly; the matrix is (3, 3).

    A map that scales all lengths alike scales s in place of the directions, so that automatic
    ones may stay automatic; any other makes every direction a given one.
    """
    old = surface.planes
    T = frozen(matrix, shape=(3, 3), name="matrix")
    points = old.points @ T.T + np.asarray(offset, dtype=np.float64)
    scale = similarity(T)
    if scale is None:
        given, automatic = surface.directions @ T.T, np.zeros_like(old.automatic)
        return replace(surface, planes=ControlPlanes(points, given, automatic, old.weights))
    planes = ControlPlanes(points, old.given @ T.T / scale, old.automatic, old.weights)
    return replace(surface, planes=planes, s=surface.s * scale)


def transposed(surface: PlusSurface) -> PlusSurface:
    """The surface S(v, u): rows become columns, d^u becomes d^v. Twice, it is the same again."""
    old = surface.planes
    planes = ControlPlanes(
        np.swapaxes(old.points, 0, 1),
        np.swapaxes(old.given, 1, 2)[::-1],
        np.swapaxes(old.automatic, 1, 2)[::-1],
        None if old.weights is None else old.weights.T,
    )
    return PlusSurface(surface.basis_v, surface.basis_u, planes, surface.s)


def transposed_numbers(surface: PlusSurface) -> NDArray[np.intp]:
    """(n,) the old number of each plane of the transposed surface."""
    return _numbers(surface).T.ravel()


def reversed_surface(surface: PlusSurface, way: Way) -> PlusSurface:
    """The surface S(1 - u, v), or S(u, 1 - v): the directions along that way are negated."""
    planes = surface.planes.taken(*_rows_and_columns(surface, way))
    given = planes.given.copy()
    given[WAYS.index(way)] *= -1.0
    turned = replace(planes, given=given)
    if way == "u":
        return replace(surface, basis_u=reversed_basis(surface.basis_u), planes=turned)
    return replace(surface, basis_v=reversed_basis(surface.basis_v), planes=turned)


def reversed_numbers(surface: PlusSurface, way: Way) -> NDArray[np.intp]:
    """(n,) the old number of each plane of the reversed surface.

    Planes at the seam of a closed direction stay the first; otherwise the last come first.
    """
    return _numbers(surface)[np.ix_(*_rows_and_columns(surface, way))].ravel()


def _numbers(surface: PlusSurface) -> NDArray[np.intp]:
    """(n_u, n_v) the number of every plane."""
    return np.arange(len(surface.planes)).reshape(surface.planes.shape)


def _rows_and_columns(surface: PlusSurface, way: Way) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The old row i of each new one, and the old column j: one of both runs backwards."""
    rows, columns = (
        reversed_rows(basis) if along == way else np.arange(basis.size)
        for basis, along in zip(surface.bases, WAYS, strict=True)
    )
    return rows, columns
