"""Control planes: the data that shapes a plus surface.

Plane (i, j) is L_ij(u, v) = P_ij + s ((u - x_i) d^u_ij + (v - y_j) d^v_ij). Its control point P_ij
and directions d^u_ij and d^v_ij are kept here; the nodes x_i, y_j belong to the bases and the
magnitude s to the surface.

A direction that nobody has set is *automatic*: it follows the neighbouring points, d^u along u at
fixed j and d^v along v at fixed i, as the direction of a control line does along its curve.
"""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.lines import LEAST_WEIGHT
from plusedit.geometry.net import Flags


def automatic_planes(points: Floats, *, closed_u: bool, closed_v: bool) -> Floats:
    """(2, n_u, n_v, 3) unit directions from neighbor to neighbor along u, then along v.

    Zero where both neighbors coincide.
    """
    across = np.empty((2, *points.shape))
    _fill_across(points, closed_u, across[0])
    _fill_across(points.swapaxes(0, 1), closed_v, across[1].swapaxes(0, 1))
    return unit(across)


def _fill_across(points: Floats, closed: bool, across: Floats) -> None:
    """P_{i+1} - P_{i-1} along the first axis, one-sided at the ends of an open direction."""
    np.subtract(points[2:], points[:-2], out=across[1:-1])
    after, before = (points[0], points[-1]) if closed else (points[-1], points[0])
    np.subtract(points[1], before, out=across[0])
    np.subtract(after, points[-2], out=across[-1])


@dataclass(frozen=True, eq=False)
class ControlPlanes:
    """Control points, directions and weights of one surface; never changed in place.

    Compared by identity, so that it can key a cache: an edit makes new control planes.
    """

    points: Floats
    """(n_u, n_v, 3): i along u, j along v, at least 2 each way"""
    given: Floats
    """(2, n_u, n_v, 3) the user's d^u and d^v, of any length; zero where automatic"""
    automatic: Flags
    """(2, n_u, n_v) true where a direction follows the neighbouring points"""
    weights: Floats | None = None
    """(n_u, n_v) positive, or None where all are one"""
    _resolved: dict[tuple[bool, bool], Floats] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        points = frozen(self.points, shape=(None, None, 3), name="points")
        if min(points.shape[:2]) < 2:
            rows, columns = points.shape[:2]
            raise ValueError(f"points: a surface needs at least 2 x 2, got {rows} x {columns}")
        automatic = np.array(self.automatic, dtype=np.bool_)
        if automatic.shape != (2, *points.shape[:2]):
            raise ValueError(
                f"automatic: expected shape {(2, *points.shape[:2])}, got {automatic.shape}"
            )
        automatic.flags.writeable = False
        given: ArrayLike = self.given
        if automatic.any() and np.shape(given) == (2, *points.shape):
            given = np.where(automatic[..., None], 0.0, given)
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "automatic", automatic)
        object.__setattr__(
            self, "given", frozen(given, shape=(2, *points.shape), name="directions")
        )
        if self.weights is not None:
            weights = frozen(self.weights, shape=points.shape[:2], name="weights")
            if weights.min() <= 0.0:
                raise ValueError(f"weights: must be positive, got {weights.min():g}")
            object.__setattr__(self, "weights", weights)

    @classmethod
    def of(
        cls,
        points: ArrayLike,
        directions_u: Any = None,
        directions_v: Any = None,
        weights: ArrayLike | None = None,
    ) -> "ControlPlanes":
        """Control planes at `points` (n_u, n_v, 3).

        Directions are rows of rows of vectors, or None for an automatic one; None for all of
        them. ValueError if counts do not fit together.
        """
        at = frozen(points, shape=(None, None, 3), name="points")
        given, automatic = np.zeros((2, *at.shape)), np.ones((2, *at.shape[:2]), dtype=np.bool_)
        for way, (name, rows) in enumerate((("u", directions_u), ("v", directions_v))):
            if rows is not None:
                _read(rows, given[way], automatic[way], f"directions_{name}")
        kept = None if weights is None else np.array(weights, dtype=np.float64)
        return cls(at, given, automatic, kept)

    @classmethod
    def _known(cls, known: dict[str, Any]) -> "ControlPlanes":
        """Planes of fields that are checked and read-only; made for every frame of a drag."""
        made = object.__new__(cls)
        vars(made).update(known)
        return made

    @property
    def shape(self) -> tuple[int, int]:
        """(n_u, n_v)"""
        rows, columns = self.points.shape[:2]
        return rows, columns

    def __len__(self) -> int:
        return int(self.points.shape[0] * self.points.shape[1])

    @property
    def dimension(self) -> int:
        """3, as the points of every surface have."""
        return 3

    def directions(self, *, closed_u: bool, closed_v: bool) -> Floats:
        """(2, n_u, n_v, 3) d^u and d^v, automatic ones worked out; read-only."""
        key = (closed_u, closed_v)
        if key not in self._resolved:
            rows = self.given
            if self.automatic.any():
                free = automatic_planes(self.points, closed_u=closed_u, closed_v=closed_v)
                rows = np.where(self.automatic[..., None], free, self.given)
                rows.flags.writeable = False
            self._resolved[key] = rows
        return self._resolved[key]

    @cached_property
    def unit_weights(self) -> Floats:
        """(n_u, n_v) the weights divided by the largest; only their ratios matter."""
        if self.weights is None:
            return np.ones(self.shape)
        scaled: Floats = np.maximum(self.weights / self.weights.max(), LEAST_WEIGHT)
        return scaled

    # The flat look that edits have at lines and planes alike

    @property
    def control_points(self) -> Floats:
        """(n, 3) the points in the order of their numbers, i * n_v + j."""
        return self.points.reshape(-1, 3)

    @property
    def given_vectors(self) -> Floats:
        """(2, n, 3) the directions set by the user, by u and by v; zero where automatic."""
        return self.given.reshape(2, -1, 3)

    @property
    def automatic_vectors(self) -> Flags:
        """(2, n) true where a direction follows the neighbouring points."""
        return self.automatic.reshape(2, -1)

    @property
    def weight_row(self) -> Floats | None:
        """(n,) the weights, or None where all are one."""
        return None if self.weights is None else self.weights.ravel()

    def with_control_points(self, points: Floats) -> "ControlPlanes":
        """The same planes through other points (n, 3); automatic directions follow them."""
        return self.with_points(np.reshape(points, self.points.shape))

    def with_vectors(self, given: Floats, automatic: Flags) -> "ControlPlanes":
        """The same points with other directions (2, n, 3), automatic ones marked (2, n)."""
        return replace(
            self,
            given=np.reshape(given, self.given.shape),
            automatic=np.reshape(automatic, self.automatic.shape),
        )

    def with_weight_row(self, weights: Floats | None) -> "ControlPlanes":
        """The same planes with other weights (n,)."""
        return self.with_weights(None if weights is None else np.reshape(weights, self.shape))

    def with_points(self, points: Floats) -> "ControlPlanes":
        """The same planes through as many other points (n_u, n_v, 3)."""
        known = vars(self) | {"points": frozen(points, shape=self.points.shape, name="points")}
        if self.automatic.any():
            known["_resolved"] = {}
        return self._known(known)

    def with_weights(self, weights: Floats | None) -> "ControlPlanes":
        """The same planes with other weights (n_u, n_v)."""
        return replace(self, weights=weights)

    def with_directions(self, directions: Floats) -> "ControlPlanes":
        """The same points with every direction (2, n_u, n_v, 3) given."""
        return replace(self, given=directions, automatic=np.zeros_like(self.automatic))

    def taken(
        self, rows: "list[int] | NDArray[np.intp]", columns: "list[int] | NDArray[np.intp]"
    ) -> "ControlPlanes":
        """The planes of those indices i along u and j along v, in that order."""
        pick = np.ix_(np.asarray(rows), np.asarray(columns))
        weights = None if self.weights is None else self.weights[pick]
        given = np.stack([way[pick] for way in self.given])
        automatic = np.stack([way[pick] for way in self.automatic])
        return ControlPlanes(self.points[pick], given, automatic, weights)


def _read(rows: Any, given: Floats, automatic: Flags, name: str) -> None:
    """Put the vectors of `rows` into `given` (n_u, n_v, 3) and mark them as not automatic."""
    if len(rows) != len(given):
        raise ValueError(f"{name}: expected {len(given)} rows, got {len(rows)}")
    for i, row in enumerate(rows):
        if len(row) != given.shape[1]:
            raise ValueError(f"{name}: row {i}: expected {given.shape[1]} entries, got {len(row)}")
        for j, vector in enumerate(row):
            if vector is not None:
                given[i, j], automatic[i, j] = vector, False
