"""Control lines: the data that shapes a plus curve.

Line i is L_i(u) = P_i + (u - x_i) g_i with g_i = s d_i. Its control point P_i and direction d_i
are kept here; the node x_i belongs to the basis and the magnitude s to the curve.

A direction that nobody has set is *automatic*: it follows the neighbouring points,

    d_i = (P_{i+1} - P_{i-1}) / |P_{i+1} - P_{i-1}|,

one-sided at the ends of an open curve, cyclic on a closed one (eq. 10 of the paper).
"""

from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.net import Flags

LEAST_WEIGHT = 1e-290  # of the largest; less would be lost, and quotients of weights not be finite


def automatic_directions(points: Floats, *, closed: bool) -> Floats:
    """(n, dim) unit directions from neighbour to neighbour; zero where the two coincide."""
    before, after = _neighbors(len(points), closed)
    across = (points.take(after, axis=0) - points.take(before, axis=0)).T
    lengths = np.hypot(across[0], across[1])
    if len(across) == 3:
        lengths = np.hypot(lengths, across[2])
    if np.count_nonzero(lengths) < len(lengths):
        return unit(across.T)
    directions: Floats = (across / lengths).T
    return directions


@lru_cache(maxsize=256)
def _neighbors(count: int, closed: bool) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """(count,) each: the indices before and after; at the ends of an open curve the end itself."""
    here = np.arange(count)
    if closed:
        return (here - 1) % count, (here + 1) % count
    return np.maximum(here - 1, 0), np.minimum(here + 1, count - 1)


@dataclass(frozen=True, eq=False)
class ControlLines:
    """Control points, directions and weights of one curve; never changed in place.

    Compared by identity, so that it can key a cache: an edit makes new control lines.
    `None` in the sequence of directions given to `of` means automatic.
    """

    points: Floats
    """(n, dim), n at least 2, dim 2 or 3"""
    given: Floats
    """(n, dim) the user's directions, of any length; zero rows where automatic"""
    automatic: Flags
    """(n,) true where the direction follows the neighbouring points"""
    weights: Floats | None = None
    """(n,) positive, or None where all are one"""
    _resolved: dict[bool, Floats] = field(default_factory=dict, init=False, repr=False)

    def __post_init__(self) -> None:
        points = _checked_points(self.points)
        automatic = np.array(self.automatic, dtype=np.bool_)
        if automatic.shape != (len(points),):
            raise ValueError(f"automatic: expected shape {(len(points),)}, got {automatic.shape}")
        automatic.flags.writeable = False
        given: ArrayLike = self.given
        if automatic.any():
            given = np.zeros_like(points)
            if not automatic.all():
                np.copyto(given, self.given, where=~automatic[:, None])
        object.__setattr__(self, "points", points)
        object.__setattr__(self, "automatic", automatic)
        object.__setattr__(self, "given", frozen(given, shape=points.shape, name="directions"))
        if self.weights is not None:
            weights = frozen(self.weights, shape=points.shape[:1], name="weights")
            if weights.min() <= 0.0:
                raise ValueError(f"weights: must be positive, got {weights.min():g}")
            object.__setattr__(self, "weights", weights)

    @classmethod
    def of(
        cls,
        points: ArrayLike,
        directions: "ArrayLike | list[ArrayLike | None] | None" = None,
        weights: ArrayLike | None = None,
    ) -> "ControlLines":
        """Control lines at `points`; `directions` may hold None, or be None, for automatic ones."""
        if directions is None:
            at = _checked_points(points)
            free = _all_automatic(*at.shape)
            known = {"points": at, "given": free.given, "automatic": free.automatic}
            made = cls._known(known | {"weights": None, "_resolved": {}})
            return made if weights is None else made.with_weights(_floats(weights))
        at = np.asarray(points, dtype=np.float64)
        rows = list(directions)  # type: ignore[arg-type]
        if len(rows) != len(at):
            raise ValueError(f"directions: expected {len(at)} rows, got {len(rows)}")
        given = np.zeros_like(at)
        for index, row in enumerate(rows):
            if row is not None:
                given[index] = row
        automatic = np.array([row is None for row in rows])
        return cls(at, given, automatic, _floats(weights))

    @classmethod
    def _known(cls, known: dict[str, Any]) -> "ControlLines":
        """Lines of fields that are checked and read-only; made for every frame of a drag."""
        made = object.__new__(cls)
        vars(made).update(known)
        return made

    def __len__(self) -> int:
        return len(self.points)

    @property
    def dimension(self) -> int:
        """2 for a plane curve, 3 for a space curve."""
        return int(self.points.shape[1])

    def directions(self, *, closed: bool) -> Floats:
        """(n, dim) the directions d_i, automatic ones worked out; read-only."""
        if closed not in self._resolved:
            rows = self.given
            if self._automatic_count:
                rows = automatic_directions(self.points, closed=closed)
                if self._automatic_count < len(rows):
                    rows = np.where(self.automatic[:, None], rows, self.given)
                rows.flags.writeable = False
            self._resolved[closed] = rows
        return self._resolved[closed]

    @cached_property
    def _automatic_count(self) -> int:
        return int(self.automatic.sum())

    @cached_property
    def unit_weights(self) -> Floats:
        """(n,) the weights divided by the largest; only their ratios matter. None is zero."""
        if self.weights is None:
            return np.ones(len(self.points))
        scaled: Floats = np.maximum(self.weights / self.weights.max(), LEAST_WEIGHT)
        return scaled

    def with_points(self, points: Floats) -> "ControlLines":
        """The same lines through other points; automatic directions follow them."""
        if len(points) != len(self):
            return replace(self, points=points)
        known = vars(self) | {"points": frozen(points, shape=self.points.shape, name="points")}
        if self._automatic_count:
            known["_resolved"] = {}
        return self._known(known)

    def with_direction(self, index: int, direction: Floats | None) -> "ControlLines":
        """The same lines but for one direction; None makes it automatic again."""
        given, automatic = self.given.copy(), self.automatic.copy()
        automatic[index] = direction is None
        if direction is not None:
            given[index] = direction
        return replace(self, given=given, automatic=automatic)

    def with_directions(self, directions: Floats) -> "ControlLines":
        """The same lines with every direction given."""
        return replace(self, given=directions, automatic=np.zeros(len(self), dtype=bool))

    def with_weights(self, weights: Floats | None) -> "ControlLines":
        """The same lines with other weights."""
        return replace(self, weights=weights)

    # The flat look that edits have at lines and planes alike

    @property
    def control_points(self) -> Floats:
        """(n, dim) the points."""
        return self.points

    @property
    def given_vectors(self) -> Floats:
        """(1, n, dim) the directions set by the user; zero where automatic."""
        return self.given[None]

    @property
    def automatic_vectors(self) -> Flags:
        """(1, n) true where a direction follows the neighbouring points."""
        return self.automatic[None]

    @property
    def weight_row(self) -> Floats | None:
        """(n,) the weights, or None where all are one."""
        return self.weights

    def with_control_points(self, points: Floats) -> "ControlLines":
        """The same lines through other points; automatic directions follow them."""
        return self.with_points(points)

    def with_vectors(self, given: Floats, automatic: Flags) -> "ControlLines":
        """The same points with other directions (1, n, dim), automatic ones marked (1, n)."""
        return replace(self, given=given[0], automatic=automatic[0])

    def with_weight_row(self, weights: Floats | None) -> "ControlLines":
        """The same lines with other weights (n,)."""
        return self.with_weights(weights)

    def taken(self, rows: "list[int] | NDArray[np.intp]") -> "ControlLines":
        """The lines of those indices, in that order."""
        weights = None if self.weights is None else self.weights[rows]
        return ControlLines(self.points[rows], self.given[rows], self.automatic[rows], weights)


def _checked_points(points: ArrayLike) -> Floats:
    at = frozen(points, shape=(None, None), name="points")
    if len(at) < 2:
        raise ValueError(f"points: a curve needs at least 2 control lines, got {len(at)}")
    if at.shape[1] not in (2, 3):
        raise ValueError(f"points: rows need 2 or 3 numbers, got {at.shape[1]}")
    return at


@lru_cache(maxsize=64)
def _all_automatic(count: int, dimension: int) -> ControlLines:
    """Lines that lend their `given` and `automatic` to all others without a direction."""
    nowhere = np.zeros((count, dimension))
    return ControlLines(nowhere, nowhere, np.ones(count, dtype=bool))


def _floats(values: ArrayLike | None) -> Floats | None:
    return None if values is None else np.array(values, dtype=np.float64)
