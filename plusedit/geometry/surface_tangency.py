"""Surfaces that leave their corners along the edges of the control net, or in a given plane.

At a corner of an open Bezier+ or B-spline+ surface only the planes beside it count:

    S_u(0, 0) = A_00 + r (E / h - A_10),   E = P_10 - P_00,  h = x_1 - x_0,  r = W_10 / W_00,

with A = s d^u, and the other corners mirror that: 0 -> l, 1 -> l - 1, E -> P_l - P_{l-1}. For S_v
it is B = s d^v and the plane beside it by v. Turning A_10 is enough, for each corner and each of u
and v another one. The surface leaves along the edge E of the net for

    A_10 = A_00 / r + c E,   S_u = r (1 / h - c) E,

forwards for every c below 1 / h; and in the plane with normal N for N . A_10 = N . (E / h +
A_00 / r), which changes A_10 along N alone.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import groupby

import numpy as np
from numpy.typing import ArrayLike

from plusedit.geometry.arrays import Floats, frozen, unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.geometry.tangency import SLOWEST

Corner = tuple[int, int]
"""u and v there, 0 or 1 each."""

CORNERS: tuple[Corner, ...] = ((0, 0), (1, 0), (0, 1), (1, 1))
STANDS = 1e-9  # of the speed along the edge: less is left only by rounding
ALIKE = 1e-9  # sine of the angle between normals that are one and the same


def tangent_at_corners(
    surface: PlusSurface, corners: Iterable[Corner] = CORNERS, ways: Iterable[Way] = WAYS
) -> PlusSurface:
    """The surface with the planes beside its corners turned so that it leaves along its net.

    At each of `corners`, along each of `ways`, the edge of the surface touches that of the
    control net, and runs forwards at a tenth of the classical speed at least. Each time the
    gradient of one neighboring plane changes, as little as does. With 3 planes along a way the
    middle one has to serve both corners, which it can only where the gradients at the corners lie
    in one plane with the edges, as automatic ones do.

    Raises ValueError, in a sentence for people, where the surface can't be made so.
    """
    _check(surface)
    wanted = tuple(ways)
    for way in wanted:
        _check_rows(way, surface.planes.shape[WAYS.index(way)])
    places = [_place(surface, corner, way) for corner in corners for way in wanted]
    gradients = {key: _along_edges(beside) for key, beside in _by_plane(places)}
    return _with_gradients(surface, gradients)


def tangent_to_plane(
    surface: PlusSurface, corner: Corner, normal: ArrayLike | None = None
) -> PlusSurface:
    """The surface that touches a plane at one corner: `tangent_to_planes` for that one."""
    return tangent_to_planes(surface, {corner: normal})


def tangent_to_planes(
    surface: PlusSurface, normals: Mapping[Corner, ArrayLike | None]
) -> PlusSurface:
    """The surface with the planes beside corners changed so that it touches planes there.

    The plane at a corner goes through it, square to the normal (3,) given for it, of any
    length; None means its own control plane. The gradients beside it change along the
    normal alone. With 3 planes along a way the middle one serves both corners and changes along
    both normals.

    Raises ValueError, in a sentence for people, where the surface can't be made so.
    """
    _check(surface)
    for way, count in zip(WAYS, surface.planes.shape, strict=True):
        _check_rows(way, count)
    square = {corner: _normal(surface, corner, normal) for corner, normal in normals.items()}
    places = [_place(surface, corner, way) for corner in square for way in WAYS]
    gradients = {
        key: _in_planes(beside, [square[place.corner] for place in beside])
        for key, beside in _by_plane(places)
    }
    return _with_gradients(surface, gradients)


Key = tuple[int, int, int]
"""0 for by u or 1 for by v, and i and j of the plane whose gradient that way is meant."""


@dataclass(frozen=True, eq=False)
class _Place:
    """A corner seen along one way; everything runs in the sense of its parameter."""

    corner: Corner
    way: Way
    key: Key
    """of the neighboring plane"""
    gradient: Floats
    """A_00"""
    neighbor: Floats
    """A_10 as it is"""
    edge: Floats
    """E"""
    gap: float
    """h"""
    ratio: float
    """r"""

    @property
    def free(self) -> Floats:
        """A_10 for which the surface stands still: E / h + A_00 / r."""
        return self.edge / self.gap + self.gradient / self.ratio

    @property
    def velocity(self) -> Floats:
        """S_u, or S_v, as it is."""
        return self.ratio * (self.free - self.neighbor)


def _place(surface: PlusSurface, corner: Corner, way: Way) -> _Place:
    planes, by = surface.planes, WAYS.index(way)
    here = [end * (count - 1) for end, count in zip(corner, planes.shape, strict=True)]
    beside = here.copy()
    beside[by] += -1 if corner[by] else 1
    nodes, weights = surface.bases[by].nodes, planes.unit_weights
    points, gradients = planes.points, surface.gradients[by]
    at, next_to = (here[0], here[1]), (beside[0], beside[1])
    sense = -1.0 if corner[by] else 1.0
    return _Place(
        corner,
        way,
        (by, *next_to),
        gradients[at],
        gradients[next_to],
        sense * (points[next_to] - points[at]),
        sense * float(nodes[beside[by]] - nodes[here[by]]),
        float(weights[next_to] / weights[at]),
    )


def _by_plane(places: list[_Place]) -> list[tuple[Key, list[_Place]]]:
    """The places grouped by the plane beside them: one or two to each."""
    ordered = sorted(places, key=lambda place: place.key)
    return [(key, list(beside)) for key, beside in groupby(ordered, lambda place: place.key)]


def _along_edges(places: list[_Place]) -> Floats:
    """The gradient of one plane for which the surface leaves those corners along the edges."""
    for place in places:
        if not place.edge.any():
            raise ValueError(
                f"At a corner the two control points along {place.way} lie in one place; "
                "there the control net has no edge to be tangent to."
            )
    headings = [unit(place.edge) for place in places]
    starts = [place.gradient / place.ratio for place in places]
    gradient = _nearest_on_lines(places, starts, headings)
    heading, low, high = headings[0], -np.inf, np.inf
    for place, start, other in zip(places, starts, headings, strict=True):
        fastest = float(start @ other + (1.0 - SLOWEST) * np.linalg.norm(place.edge) / place.gap)
        low, high = (low, min(high, fastest)) if other @ heading > 0.0 else (-fastest, high)
    if np.linalg.norm(np.cross(headings[0], headings[-1])) < ALIKE:
        along = float(gradient @ heading)
        gradient = gradient + (min(max(along, low), high) - along) * heading
    after = [replace(place, neighbor=gradient) for place in places]
    if any(place.velocity @ place.edge <= 0.0 for place in after):
        raise _shared(places[0].way, "the surface would run backwards at one of them")
    return gradient


def _nearest_on_lines(places: list[_Place], starts: list[Floats], headings: list[Floats]) -> Floats:
    """The point on one line, or on both of two, nearest to the gradient there is."""
    now = places[0].neighbor
    squares = [np.eye(3) - np.outer(heading, heading) for heading in headings]
    missing = [square @ (start - now) for square, start in zip(squares, starts, strict=True)]
    across, wanted = np.concatenate(squares), np.concatenate(missing)
    change = np.linalg.lstsq(across, wanted, rcond=ALIKE)[0]
    size = sum(float(np.linalg.norm(place.free)) for place in places) + np.linalg.norm(now)
    if np.linalg.norm(across @ change - wanted) > ALIKE * size:
        raise _shared(places[0].way, "their gradients do not lie in one plane with the edges")
    found: Floats = now + change
    return found


def _shared(way: Way, why: str) -> ValueError:
    return ValueError(
        f"With 3 control planes along {way} two corners share the middle one, which can't serve "
        f"both: {why}. Insert one more first."
    )


def _in_planes(places: list[_Place], normals: list[Floats]) -> Floats:
    """The gradient of one plane that neighbors those corners, changed along their normals alone."""
    rows = np.stack(normals)
    lacking = [
        float((place.free - place.neighbor) @ n) for place, n in zip(places, normals, strict=True)
    ]
    if len(rows) == 2 and np.linalg.norm(np.cross(*rows)) < ALIKE:
        rows, lacking = rows[:1], _agreed(rows, lacking, places)
    change = rows.T @ np.linalg.solve(rows @ rows.T, np.array(lacking))
    after = [replace(place, neighbor=place.neighbor + change) for place in places]
    for old, new in zip(places, after, strict=True):
        size = np.linalg.norm(old.ratio * old.free) + np.linalg.norm(old.ratio * old.neighbor)
        if np.linalg.norm(new.velocity) <= STANDS * size:
            raise ValueError(
                f"At a corner the surface runs along the normal of the plane by {old.way}, so that "
                "it would stand still in the plane; turn one of them first."
            )
    gradient: Floats = places[0].neighbor + change
    return gradient


def _agreed(rows: Floats, lacking: list[float], places: list[_Place]) -> list[float]:
    """What is asked for along the one normal of two parallel planes, if both ask for the same."""
    same = float(rows[0] @ rows[1]) * lacking[1]
    size = max(np.linalg.norm(place.free) + np.linalg.norm(place.neighbor) for place in places)
    if abs(same - lacking[0]) > STANDS * size:
        raise _shared(places[0].way, "the two parallel planes ask for different things of it")
    return lacking[:1]


def _normal(surface: PlusSurface, corner: Corner, normal: ArrayLike | None) -> Floats:
    """The unit normal wanted at a corner."""
    if normal is not None:
        given = unit(frozen(normal, shape=(3,), name="normal"))
        if not given.any():
            raise ValueError("normal: a plane needs one that is not zero")
        return given
    rows, columns = (end * (n - 1) for end, n in zip(corner, surface.planes.shape, strict=True))
    by_u, by_v = unit(surface.directions[:, rows, columns])
    across = np.cross(by_u, by_v)
    if np.linalg.norm(across) < ALIKE:
        raise ValueError("The control plane at a corner has no normal; turn its directions first.")
    return unit(across)


def _with_gradients(surface: PlusSurface, gradients: dict[Key, Floats]) -> PlusSurface:
    """The surface with some gradients; the magnitude stays, the directions become given."""
    planes = surface.planes
    given, automatic = planes.given.copy(), planes.automatic.copy()
    for key, gradient in gradients.items():
        given[key] = gradient / surface.s
        automatic[key] = False
    return replace(surface, planes=replace(planes, given=given, automatic=automatic))


def corner_objection(surface: PlusSurface) -> str:
    """Why the corners can't be made tangent, with what would help; empty where they can."""
    try:
        _check(surface)
        for way, count in zip(WAYS, surface.planes.shape, strict=True):
            _check_rows(way, count)
    except ValueError as error:
        return str(error)
    return ""


def _check(surface: PlusSurface) -> None:
    for way, basis in zip(WAYS, surface.bases, strict=True):
        if basis.closed:
            raise ValueError(f"A surface that closes along {way} has no corners.")
        if not isinstance(basis, Bernstein | BSpline):
            raise ValueError(
                f"Along {way} the surface is rational Gaussian: it does not end on its outer "
                "control planes and has no corners there."
            )
    if surface.s == 0.0:
        raise ValueError("With s = 0 control planes have no effect; set s first.")


def _check_rows(way: Way, count: int) -> None:
    """Whether corners have neighboring planes that are no corners themselves."""
    if count < 3:
        raise ValueError(
            f"Tangency at the corners needs at least 3 control planes along {way}: each corner "
            f"turns the plane beside it. There are {count}."
        )
