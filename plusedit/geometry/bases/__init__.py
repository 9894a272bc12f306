"""The shelf of basis families: each module here is one family of blending functions.

A family is a frozen dataclass of numbers and tuples: it hashes by value, so matrices made from
it can be cached, and its fields but `size` are what the design file says of it.
"""

from typing import Protocol, Self, TypeGuard, runtime_checkable

from plusedit.geometry.arrays import Floats
from plusedit.geometry.matrices import Banded
from plusedit.registry import Registry


@runtime_checkable
class Basis(Protocol):
    """n blending functions b_i over [0, 1] that sum to one, with a node x_i each.

    Parameters outside [0, 1] are clamped on an open basis and wrapped on a closed one.
    Derivatives that jump take the value of the span to the right; at u = 1 of the last span.
    """

    def __hash__(self) -> int: ...

    @classmethod
    def of_size(cls, size: int) -> Self:
        """The usual member of the family for that many control lines."""
        ...

    @property
    def size(self) -> int:
        """n, the number of functions and of control lines."""
        ...

    @property
    def closed(self) -> bool:
        """Whether b_i(u + 1) = b_i(u)."""
        ...

    @property
    def nodes(self) -> Floats:
        """(n,) the x_i, in [0, 1]."""
        ...

    def values(self, u: Floats, *, derivative: int = 0) -> Floats:
        """(m, n) b_i at u_j, or its first or second derivative."""
        ...

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        """(m, n) (u_j - x_i) b_i, or its first or second derivative.

        On a closed basis it is the sum over all images k of (u - x_i - k) times the function
        centred at x_i + k, so that a direction means the same on both sides of the seam.
        """
        ...


@runtime_checkable
class LocalBasis(Basis, Protocol):
    """A basis of which only a few functions are not zero at any one parameter."""

    @property
    def order(self) -> int:
        """How many functions are not zero inside a span."""
        ...

    @property
    def breaks(self) -> Floats:
        """Where pieces meet: the distinct knots, 0 and 1 among them."""
        ...

    def banded(self, u: Floats, *, derivative: int = 0) -> tuple[Banded, Banded]:
        """`values` and `reaches` without their zeros."""
        ...

    def banded_jet(self, u: Floats, highest: int) -> list[tuple[Banded, Banded]]:
        """The same and their derivatives up to the highest, for less than one by one."""
        ...


@runtime_checkable
class PairedBasis(Basis, Protocol):
    """A basis that works out values and reaches together for the price of one."""

    def both(self, u: Floats, *, derivative: int = 0) -> tuple[Floats, Floats]:
        """`values` and `reaches`."""
        ...


def is_paired(basis: Basis) -> TypeGuard[PairedBasis]:
    """Whether the basis has `both`."""
    return hasattr(basis, "both")


def is_local(basis: Basis) -> TypeGuard[LocalBasis]:
    """Whether the basis has `order`, `breaks` and `banded`."""
    # A look at one name: isinstance of a protocol looks at all, and this is asked every frame.
    return hasattr(basis, "banded")


families: Registry[type[Basis]] = Registry("plusedit.geometry.bases")
"""The families by the name that the design file uses."""

register = families.register
