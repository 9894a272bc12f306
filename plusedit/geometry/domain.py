"""Parameters brought into the domain [0, 1], and the product rule for reaches."""

from typing import Protocol

import numpy as np

from plusedit.geometry.arrays import Floats


class OpenFunctions(Protocol):
    """The part of an open basis that its reaches are made from."""

    @property
    def nodes(self) -> Floats: ...

    def values(self, u: Floats, *, derivative: int = 0) -> Floats: ...


def clamped(u: Floats) -> Floats:
    """Parameters outside [0, 1] moved to the nearer end."""
    return np.clip(u, 0.0, 1.0)


def wrapped(u: Floats) -> Floats:
    """Parameters brought into [0, 1) by a whole number of periods."""
    inside = u - np.floor(u)
    # A tiny negative parameter rounds up to the period itself.
    return np.where(inside >= 1.0, 0.0, inside)


def open_reaches(basis: OpenFunctions, u: Floats, derivative: int) -> Floats:
    """(m, n) derivative of (u - x_i) b_i(u): (u - x_i) b_i^(r) + r b_i^(r-1)."""
    distance = clamped(u)[:, None] - basis.nodes
    reach = distance * basis.values(u, derivative=derivative)
    if derivative:
        reach += derivative * basis.values(u, derivative=derivative - 1)
    return reach
