"""Bases of another size: what becomes of knots, nodes and widths when control lines come or go."""

from dataclasses import replace
from functools import singledispatch

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis, families
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import USUAL_WIDTH, RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines


def basis_of(family: str, size: int, *, order: int = 4, closed: bool = False) -> Basis:
    """The usual basis of a family; an open B-spline has an order of at most its size.

    ValueError where the family is never closed; KeyError if there is no such family.
    """
    if family == "bspline":
        return BSpline(size, order if closed else min(order, size), closed)
    if family == "rag":
        return RationalGaussian(size, USUAL_WIDTH / (size if closed else size - 1), closed)
    if closed:
        raise ValueError("a Bezier curve is never closed; it can only be closed smoothly")
    return families[family].of_size(size)


def family_of(basis: Basis) -> str:
    """The name of the family, as on the shelf."""
    return next(name for name, family in families.items() if isinstance(basis, family))


def without_lines(curve: PlusCurve, rows: "list[int] | tuple[int, ...]") -> PlusCurve:
    """The curve of the other lines. ValueError if fewer than 2 are left."""
    kept = np.setdiff1d(np.arange(len(curve.lines)), rows)
    if len(kept) < 2:
        raise ValueError(f"points: a curve needs at least 2 control lines, {len(kept)} would stay")
    return replace(curve, basis=kept_basis(curve.basis, kept), lines=curve.lines.taken(kept))


def with_end_line(
    curve: PlusCurve,
    point: Floats,
    direction: Floats | None = None,
    *,
    at_end: bool = True,
    order: int | None = None,
) -> PlusCurve:
    """The curve with one more line after the last, or before the first.

    `order` is what a B-spline shall have once it has lines enough; None keeps what it has.
    """
    place = len(curve.lines) if at_end else 0
    old = curve.lines
    given = np.zeros(curve.dimension) if direction is None else direction
    weights = None if old.weights is None else np.insert(old.weights, place, 1.0)
    lines = ControlLines(
        np.insert(old.points, place, point, axis=0),
        np.insert(old.given, place, given, axis=0),
        np.insert(old.automatic, place, direction is None),
        weights,
    )
    return replace(curve, basis=longer_basis(curve.basis, at_end, order), lines=lines)


@singledispatch
def kept_basis(basis: Basis, kept: NDArray[np.intp]) -> Basis:
    """A basis of the same kind for the lines that are kept."""
    return type(basis).of_size(len(kept))


@kept_basis.register
def _(basis: BSpline, kept: NDArray[np.intp]) -> Basis:
    size = len(kept)
    if basis.closed:
        return replace(basis, size=size)
    order = min(basis.order, size)
    if basis.knots is None or order < basis.order:
        return BSpline(size, order)
    # With a line goes the inner knot nearest to its node: the others keep their places.
    inner = list(basis.knots[order:-order])
    for node in np.delete(basis.nodes, kept):
        if inner:
            inner.remove(min(inner, key=lambda knot: abs(knot - node)))
    return BSpline(size, order, knots=(0.0,) * order + tuple(inner) + (1.0,) * order)


@kept_basis.register
def _(basis: RationalGaussian, kept: NDArray[np.intp]) -> Basis:
    sigma = basis.sigma
    if isinstance(sigma, tuple):
        sigma = tuple(sigma[row] for row in kept)
    if basis.given_nodes is not None:
        nodes = tuple(basis.given_nodes[row] for row in kept)
        return RationalGaussian(len(kept), sigma, basis.closed, nodes)
    return resized_rag(basis, len(kept), sigma)


def resized_rag(
    basis: RationalGaussian, size: int, sigma: float | tuple[float, ...]
) -> RationalGaussian:
    """Evenly spread nodes; the widths keep their ratio to the distance of the nodes."""
    ends = 0 if basis.closed else 1
    ratio = (basis.size - ends) / (size - ends)
    wide = tuple(w * ratio for w in sigma) if isinstance(sigma, tuple) else sigma * ratio
    return RationalGaussian(size, wide, basis.closed)


@singledispatch
def longer_basis(basis: Basis, at_end: bool, order: int | None) -> Basis:
    """A basis of the same kind for one more line at an end."""
    return type(basis).of_size(basis.size + 1)


@longer_basis.register
def _(basis: BSpline, at_end: bool, order: int | None) -> Basis:
    size = basis.size + 1
    wanted = basis.order if order is None else order
    if basis.closed:
        return replace(basis, size=size)
    if basis.knots is None or wanted != basis.order:
        return BSpline(size, min(wanted, size))
    # The curve there was takes m of m + 1 parts of the domain, m being its number of pieces.
    pieces = len(basis.breaks) - 1
    k, inner = basis.order, np.array(basis.knots[basis.order : -basis.order])
    if at_end:
        inner = np.append(inner, 1.0) * (pieces / (pieces + 1))
    else:
        inner = (np.insert(inner, 0, 0.0) * pieces + 1.0) / (pieces + 1)
    return BSpline(size, k, knots=(0.0,) * k + tuple(inner.tolist()) + (1.0,) * k)


@longer_basis.register
def _(basis: RationalGaussian, at_end: bool, order: int | None) -> Basis:
    sigma, size = basis.sigma, basis.size + 1
    if isinstance(sigma, tuple):
        sigma = (*sigma, sigma[-1]) if at_end else (sigma[0], *sigma)
    if basis.given_nodes is None or basis.closed:
        return resized_rag(basis, size, sigma)
    # As far from its neighbour as an evenly spread node would be, then brought back into [0, 1].
    nodes, step = np.array(basis.given_nodes), 1.0 / (basis.size - 1)
    nodes = np.append(nodes, nodes[-1] + step) if at_end else np.insert(nodes, 0, nodes[0] - step)
    nodes = np.clip((nodes - min(0.0, nodes[0])) / (1.0 + step), 0.0, 1.0)
    ratio = 1.0 / (1.0 + step)
    wide = tuple(w * ratio for w in sigma) if isinstance(sigma, tuple) else sigma * ratio
    return RationalGaussian(size, wide, given_nodes=tuple(nodes.tolist()))


@singledispatch
def closed_basis(basis: Basis, closed: bool) -> Basis:
    """The same kind of basis open or closed. ValueError where the family has no closed one."""
    if closed:
        raise ValueError("a Bezier curve is never closed; it can only be closed smoothly")
    return basis


@closed_basis.register
def _(basis: BSpline, closed: bool) -> Basis:
    order = basis.order if closed else min(basis.order, basis.size)
    return basis if closed == basis.closed else BSpline(basis.size, order, closed)


@closed_basis.register
def _(basis: RationalGaussian, closed: bool) -> Basis:
    if closed == basis.closed:
        return basis
    n = basis.size
    ratio = (n - 1) / n if closed else n / (n - 1)
    sigma = basis.sigma
    wide = tuple(w * ratio for w in sigma) if isinstance(sigma, tuple) else sigma * ratio
    nodes = basis.given_nodes
    if nodes is not None:
        nodes = tuple(float(np.clip(x * ratio, 0.0, 1.0)) for x in nodes)
        if len(set(nodes)) < n:
            raise ValueError("its nodes don't fit into an open curve; let them be even first")
    return RationalGaussian(n, wide, closed, nodes)


@singledispatch
def ordered_basis(basis: Basis, order: int) -> Basis:
    """The same kind of basis of another order. ValueError where the family has none."""
    raise ValueError("only B-splines have an order that can be chosen")


@ordered_basis.register
def _(basis: BSpline, order: int) -> Basis:
    if order < 2:
        raise ValueError(f"order: expected 2 or more, got {order}")
    wanted = order if basis.closed else min(order, basis.size)
    return basis if wanted == basis.order else BSpline(basis.size, wanted, basis.closed)


def with_family(basis: Basis, family: str) -> Basis:
    """The usual basis of another family, of the same size, closed and of the same order if it can.

    ValueError for a Bezier basis in place of a closed one.
    """
    if family_of(basis) == family:
        return basis
    if family == "bezier" and basis.closed:
        raise ValueError("a Bezier curve is never closed; open the curve first")
    order = basis.size if isinstance(basis, Bernstein) else 4
    return basis_of(family, basis.size, order=min(order, 4), closed=basis.closed)
