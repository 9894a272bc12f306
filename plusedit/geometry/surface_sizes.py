"""The same control planes blended by other functions: family, order, closedness, one way alone."""

from collections.abc import Callable
from dataclasses import fields, replace

from plusedit.geometry import sizes
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.surface import WAYS, PlusSurface, Way


def basis_along(surface: PlusSurface, way: Way) -> Basis:
    """The basis by u or by v."""
    return surface.bases[WAYS.index(way)]


def with_basis_along(surface: PlusSurface, way: Way, basis: Basis) -> PlusSurface:
    """The surface with another basis of the same size by u or by v.

    The same surface if that is the basis it has. ValueError if the sizes differ.
    """
    if basis == basis_along(surface, way):
        return surface
    if WAYS.index(way) == 0:
        return replace(surface, basis_u=basis)
    return replace(surface, basis_v=basis)


def with_family(surface: PlusSurface, way: Way, family: str) -> PlusSurface:
    """The surface with the usual basis of another family that way, closed or open as it was.

    ValueError for "bezier" in place of a closed basis; KeyError if there is no such family.
    """
    if family == "bezier" and basis_along(surface, way).closed:
        raise ValueError(f"A Bezier basis is never closed; open the surface along {way} first.")
    return _rebased(surface, way, lambda basis: sizes.with_family(basis, family))


def with_order(surface: PlusSurface, way: Way, order: int) -> PlusSurface:
    """The surface with B-splines of another order that way; open ones have at most their number.

    Knots given before become uniform. ValueError for other families, and for orders below 2.
    """
    return _rebased(surface, way, lambda basis: sizes.ordered_basis(basis, order))


def with_closed(surface: PlusSurface, way: Way, closed: bool) -> PlusSurface:
    """The surface closed, or opened, along u or v; knots given before become uniform.

    ValueError where a Bezier basis would have to close.
    """
    if closed and isinstance(basis_along(surface, way), Bernstein):
        raise ValueError(
            f"A Bezier basis is never closed; choose another family along {way} first."
        )
    return _rebased(surface, way, lambda basis: sizes.closed_basis(basis, closed))


def with_field(surface: PlusSurface, way: Way, name: str, value: object) -> PlusSurface:
    """The surface with one parameter of a basis set, such as "sigma" or "knots".

    `value` is what the field of the basis holds; lists will do for tuples, None is the usual
    one. ValueError if a basis of that family has no such field, or can't have that value.
    """
    held = tuple(value) if isinstance(value, list) else value

    def changed(basis: Basis) -> Basis:
        names = {field.name for field in fields(basis)} - {"size"}  # type: ignore[arg-type]
        if name not in names:
            raise ValueError(f"A {sizes.family_of(basis)} basis has no {name}.")
        return replace(basis, **{name: held})  # type: ignore[type-var]

    return _rebased(surface, way, changed)


def _rebased(surface: PlusSurface, way: Way, change: Callable[[Basis], Basis]) -> PlusSurface:
    return with_basis_along(surface, way, change(basis_along(surface, way)))
