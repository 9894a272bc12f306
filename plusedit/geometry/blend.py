"""A basis sampled at parameters: the matrices that turn control data into points.

A plus curve is linear in its control points P and directions d,

    C(u) = sum_i W_i (P_i + s (u - x_i) d_i) b_i(u) / sum_i W_i b_i(u)
         = (B (W P) + s D (W d)) / (B W),     B[j, i] = b_i(u_j),   D[j, i] = (u_j - x_i) b_i(u_j),

and B and D depend on the basis and the parameters alone. They are computed once here; moving a
point then costs one small product, and moving s one addition.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis, is_local, is_paired
from plusedit.geometry.matrices import Matrix, dense

DENSE_UP_TO = 80_000  # entries of a matrix; beyond, skipping the zeros of a local basis pays


@dataclass(frozen=True, eq=False)
class Grid:
    """Parameters at which curves are sampled; equal by value, so that it can key a cache."""

    parameters: Floats
    """(m,)"""

    def __post_init__(self) -> None:
        parameters = np.array(self.parameters, dtype=np.float64)
        if parameters.ndim != 1:
            raise ValueError(f"parameters: expected one row of numbers, got {parameters.shape}")
        if not np.isfinite(parameters).all():
            raise ValueError("parameters: has a value that is not finite")
        parameters.flags.writeable = False
        object.__setattr__(self, "parameters", parameters)

    @classmethod
    def uniform(cls, count: int) -> "Grid":
        """`count` evenly spaced parameters from 0 to 1; the same object for the same count."""
        return _uniform(count)

    def __len__(self) -> int:
        return len(self.parameters)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Grid) and self._bytes == other._bytes

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _bytes(self) -> bytes:
        return self.parameters.tobytes()

    @cached_property
    def _hash(self) -> int:
        return hash(self._bytes)


@lru_cache(maxsize=32)
def _uniform(count: int) -> Grid:
    return Grid(np.linspace(0.0, 1.0, count))


@dataclass(frozen=True, eq=False)
class Blend:
    """B and D of a basis at the parameters of a grid, or a derivative of both."""

    values: Matrix
    """B (m, n)"""
    reaches: Matrix
    """D (m, n)"""


def blend_at(basis: Basis, u: Floats, derivative: int = 0) -> Blend:
    """The matrices at parameters u (m,), worked out anew; of a local basis banded."""
    if is_local(basis):
        return Blend(*basis.banded(u, derivative=derivative))
    if is_paired(basis):
        return Blend(*basis.both(u, derivative=derivative))
    return Blend(basis.values(u, derivative=derivative), basis.reaches(u, derivative=derivative))


def blends_at(basis: Basis, u: Floats, highest: int) -> list[Blend]:
    """The matrices and their derivatives up to the highest, worked out anew."""
    if is_local(basis):
        return [Blend(*pair) for pair in basis.banded_jet(u, highest)]
    return [blend_at(basis, u, r) for r in range(highest + 1)]


@lru_cache(maxsize=48)
def blend(basis: Basis, grid: Grid, derivative: int = 0) -> Blend:
    """The matrices at the parameters of `grid`; the same object for equal arguments."""
    made = blend_at(basis, grid.parameters, derivative)
    if basis.size * len(grid) > DENSE_UP_TO:
        return made
    return Blend(dense(made.values), dense(made.reaches))


def parameters_of(u: ArrayLike) -> Floats:
    """`u` as a row of parameters (m,). ValueError if it is not one, or not finite."""
    row = np.atleast_1d(np.asarray(u, dtype=np.float64))
    if row.ndim != 1:
        raise ValueError(f"u: expected one row of parameters, got shape {row.shape}")
    if not np.isfinite(row).all():
        raise ValueError("u: has a value that is not finite")
    return row
