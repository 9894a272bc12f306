"""Outlines of SVG as plus curves, in three ways.

* "segments": every piece a curve. Lines have two control lines, quadratics two, cubics three,
  arcs of an ellipse up to 90 degrees three with weights; all exactly.
* "paths": every outline one curve. Without arcs it is a B-spline+ of order 3 with double inner
  knots, exactly; with arcs but no cubics a NURBS+ of order 3, exactly; with both, arcs become
  cubics within 1e-7 of the outline's size.
* "fitted": every outline one B-spline+ of order 4 that keeps its corners, within a tolerance.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal, TypeAlias

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.fitting import fit_bspline_plus
from plusedit.geometry.standard import (
    from_bezier,
    from_bezier_path,
    from_rational_quadratic_path,
)
from plusedit.io.svg_cubics import TOLERANCE, conic_chain
from plusedit.io.svg_pieces import Outline, Piece

How: TypeAlias = Literal["segments", "paths", "fitted"]

NEGLIGIBLE = 1e-12  # of the largest coordinate: a piece shorter than that is a point
CLOSES = 1e-9  # of the size: an end nearer to the start has reached it
SAMPLES = 48  # of each piece, for fitting; between few the curve would be free to stray
CORNER = np.cos(np.radians(3.0))  # tangents that turn by more at a joint make a corner


@dataclass(frozen=True, eq=False)
class Made:
    """A curve made from an outline or a piece of it."""

    curve: PlusCurve
    miss: float = 0.0
    """the largest distance from what it was made from; 0 where it is exact"""


def tidied(outline: Outline) -> tuple[Outline, int]:
    """The outline without pieces that are points, and how many those were."""
    pieces = outline.pieces
    rows = np.concatenate([piece.points for piece in pieces])
    limit = NEGLIGIBLE * float(np.abs(rows).max())
    kept = [piece for piece in pieces if np.ptp(piece.points, axis=0).max() > limit]
    return Outline(outline.start, kept, outline.closed), len(pieces) - len(kept)


def segments(outline: Outline) -> list[Made]:
    """A curve for every piece."""
    return [Made(from_bezier(piece.points, _weights(piece))) for piece in outline.pieces]


def path(outline: Outline) -> Made:
    """One curve for the whole outline."""
    pieces = outline.pieces
    if len(pieces) == 1:
        return segments(outline)[0]
    has_arcs = any(piece.is_arc for piece in pieces)
    if has_arcs and all(piece.degree <= 2 for piece in pieces):
        points = np.stack([_raised(piece.points, 2) for piece in _touching(pieces)])
        heights = np.array([[1.0, piece.weight, 1.0] for piece in pieces])
        return Made(from_rational_quadratic_path(points, heights))
    tolerance = TOLERANCE * size_of(outline)
    rows: list[Floats] = []
    for piece in _touching(pieces):
        weights = _weights(piece)
        chain = [piece.points]
        if weights is not None:
            chain = conic_chain(piece.points, weights, tolerance)
        rows += [_raised(points, 3) for points in chain]
    return Made(from_bezier_path(np.stack(rows)), tolerance if has_arcs else 0.0)


def fitted(outline: Outline, tolerance: float) -> Made:
    """One B-spline+ fitted to the whole outline, within `tolerance` of its size."""
    pieces = _touching(outline.pieces)
    t = np.linspace(0.0, 1.0, SAMPLES + 1)
    points = np.concatenate([pieces[0].points[:1], *(piece.at(t)[1:] for piece in pieces)])
    corners = [number * SAMPLES for number in _corners(pieces)]
    goes_round = outline.closed and closes(outline)
    if goes_round:
        points = points[:-1]
        if not _is_smooth(pieces[-1], pieces[0]):
            corners.append(0)
    size = float(np.ptp(points, axis=0).max())
    fit = fit_bspline_plus(points, tolerance=tolerance * size, closed=goes_round, corners=corners)
    return Made(fit.curve, fit.largest)


def closes(outline: Outline) -> bool:
    """Whether the outline ends where it starts."""
    first, last = outline.pieces[0].points[0], outline.pieces[-1].points[-1]
    return bool(np.abs(last - first).max() <= CLOSES * size_of(outline))


def size_of(outline: Outline) -> float:
    """The larger side of the box about the points of the outline."""
    return float(np.ptp(np.concatenate([p.points for p in outline.pieces]), axis=0).max())


def _weights(piece: Piece) -> Floats | None:
    return np.array([1.0, piece.weight, 1.0]) if piece.is_arc else None


def _touching(pieces: list[Piece]) -> list[Piece]:
    """The pieces, each moved at its start to the end of the one before, should a point be gone."""
    touching = pieces[:1]
    for piece in pieces[1:]:
        points = piece.points.copy()
        points[0] = touching[-1].points[-1]
        touching.append(Piece(points, piece.weight))
    return touching


def _raised(points: Floats, degree: int) -> Floats:
    """The same Bezier curve with degree + 1 points."""
    while len(points) <= degree:
        n = len(points)
        share = np.arange(1, n)[:, None] / n
        inner = share * points[:-1] + (1.0 - share) * points[1:]
        points = np.concatenate([points[:1], inner, points[-1:]])
    return points


def _corners(pieces: list[Piece]) -> list[int]:
    """The numbers of pieces that begin with a corner; the first is not looked at."""
    pairs = pairwise(pieces)
    return [i for i, (before, after) in enumerate(pairs, 1) if not _is_smooth(before, after)]


def _is_smooth(before: Piece, after: Piece) -> bool:
    """Whether two pieces that touch have one tangent there."""
    arriving, leaving = -_leaving(before.points[::-1]), _leaving(after.points)
    lengths = np.hypot(*arriving) * np.hypot(*leaving)
    return bool(arriving @ leaving >= CORNER * lengths)


def _leaving(points: Floats) -> Floats:
    """A vector in the direction in which a Bezier curve leaves its first point."""
    vectors = points[1:] - points[0]
    far = np.abs(vectors).max(axis=1)
    # Control points that rounding alone has moved off the first one say nothing.
    first = int(np.argmax(far > 1e-9 * far.max()))
    vector: Floats = vectors[first]
    return vector
