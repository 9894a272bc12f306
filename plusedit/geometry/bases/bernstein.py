"""The Bernstein polynomials B_{i,k}(u) = (k over i) u^i (1 - u)^(k - i): Bezier curves."""

from dataclasses import dataclass
from functools import lru_cache
from math import comb, lgamma

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import register
from plusedit.geometry.domain import clamped

EXACT = 1000  # degrees up to here have binomials that fit a double


@register("bezier")
@dataclass(frozen=True)
class Bernstein:
    """The n polynomials of degree k = n - 1; node i / k, where B_i is largest."""

    size: int

    closed = False

    def __post_init__(self) -> None:
        if self.size < 2:
            raise ValueError(f"points: a Bezier curve needs at least 2 of them, got {self.size}")

    @classmethod
    def of_size(cls, size: int) -> "Bernstein":
        """The Bernstein polynomials of degree size - 1."""
        return cls(size)

    @property
    def nodes(self) -> Floats:
        return np.linspace(0.0, 1.0, self.size)

    def values(self, u: Floats, *, derivative: int = 0) -> Floats:
        return self._functions(clamped(u), derivative)

    def reaches(self, u: Floats, *, derivative: int = 0) -> Floats:
        return self.both(u, derivative=derivative)[1]

    def both(self, u: Floats, *, derivative: int = 0) -> tuple[Floats, Floats]:
        u = clamped(u)
        b = self._functions(u, derivative)
        reach = (u - self.nodes[:, None]).T * b
        if derivative:
            reach += derivative * self._functions(u, derivative - 1)
        return b, reach

    def _functions(self, u: Floats, derivative: int) -> Floats:
        degree = self.size - 1
        if derivative > degree:
            return np.zeros((len(u), self.size))
        b = bernstein(u, degree - derivative)
        for k in range(degree - derivative + 1, degree + 1):
            # B'_{i,k} = k (B_{i-1,k-1} - B_{i,k-1}), the missing ones at both ends being zero.
            b = k * -np.diff(b, axis=1, prepend=0.0, append=0.0)
        return b


def bernstein(u: Floats, degree: int) -> Floats:
    """(m, degree + 1) Bernstein polynomials at u in [0, 1]."""
    if degree > EXACT:
        return _by_logarithms(u, degree)
    # Powers by repeated products, one row of all u after the other.
    rising = np.ones((degree + 1, len(u)))
    falling = np.ones_like(rising)
    rising[1:], falling[:-1] = u, 1.0 - u
    np.multiply.accumulate(rising, axis=0, out=rising)
    np.multiply.accumulate(falling[::-1], axis=0, out=falling[::-1])
    rising *= _binomials(degree)[:, None]
    rising *= falling
    return rising.T


@lru_cache(maxsize=128)
def _binomials(degree: int) -> Floats:
    return np.array([float(comb(degree, i)) for i in range(degree + 1)])


def _by_logarithms(u: Floats, degree: int) -> Floats:
    i = np.arange(degree + 1)
    logs = np.array([lgamma(degree + 1) - lgamma(j + 1) - lgamma(degree - j + 1) for j in i])
    with np.errstate(divide="ignore", invalid="ignore"):
        # 0 log 0 is 0 here: at the ends only the first or last polynomial is left.
        left = np.where(i == 0, 0.0, i * np.log(u)[:, None])
        right = np.where(i == degree, 0.0, (degree - i) * np.log1p(-u)[:, None])
    b: Floats = np.exp(logs + left + right)
    return b
