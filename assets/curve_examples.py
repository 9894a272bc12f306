"""What the designs in the plane among the examples are made with."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from plusedit.document.design import Design
from plusedit.document.shape import Json, Shape, Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import line_ends
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import polygon_length
from plusedit.geometry.transforms import transformed

QUARTERS = (0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0)
HALVES = (0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0)

Layer = tuple[str, PlusCurve, Style]


def bezier(points: ArrayLike, s: float) -> PlusCurve:
    """A Bezier+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(Bernstein(len(lines)), lines), s)


def bspline(points: ArrayLike, s: float, *, closed: bool = False) -> PlusCurve:
    """A cubic B-spline+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(BSpline(len(lines), 4, closed), lines), s)


def gaussian(points: ArrayLike, s: float) -> PlusCurve:
    """A RaG+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(RationalGaussian.of_size(len(lines)), lines), s)


def ellipse(center: tuple[float, float], radii: tuple[float, float]) -> PlusCurve:
    """A whole ellipse, exactly: four rational quarters."""
    around = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    return conic(np.array(around) * radii + center, QUARTERS)


def lower_half(center: tuple[float, float], radii: tuple[float, float]) -> PlusCurve:
    """The lower half of an ellipse, exactly: two rational quarters."""
    below = [(-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    return conic(np.array(below) * radii + center, HALVES)


def conic(points: Floats, knots: tuple[float, ...]) -> PlusCurve:
    """Quadratic NURBS whose weights alternate between those of a corner and of a quarter."""
    weights = np.where(np.arange(len(points)) % 2, np.sqrt(0.5), 1.0)
    lines = ControlLines.of(points, weights=weights)
    return PlusCurve(BSpline(len(points), 3, knots=knots), lines, 0.0)


def scaled(curve: PlusCurve, s: float) -> PlusCurve:
    """The curve with s given in lengths of its control polygon."""
    return replace(curve, s=round(s * polygon_length(curve), 6))


def turned(curve: PlusCurve, degrees: dict[int, float]) -> PlusCurve:
    """The curve with control lines turned counterclockwise, by number."""
    lines, directions = curve.lines, curve.directions
    for number, angle in degrees.items():
        a = np.radians(angle)
        rotation = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
        # Rounded, here and below, so that the files show numbers that people can read.
        lines = lines.with_direction(number, np.round(rotation @ directions[number], 9) + 0.0)
    return replace(curve, lines=lines)


def alternating(curve: PlusCurve, *degrees: float) -> PlusCurve:
    """The curve with its control lines turned by those angles in turn."""
    angles = {i: degrees[i % len(degrees)] for i in range(len(curve.lines))}
    return turned(curve, {i: angle for i, angle in angles.items() if angle})


def moved(curve: PlusCurve, by: ArrayLike) -> PlusCurve:
    """The curve somewhere else."""
    points = np.round(curve.lines.points + np.asarray(by), 9) + 0.0
    return replace(curve, lines=curve.lines.with_points(points))


def mirrored(curve: PlusCurve) -> PlusCurve:
    """The curve with left and right changed."""
    return transformed(curve, np.diag([-1.0, 1.0]), np.zeros(2))


def around(count: int, radii: Sequence[float], start: float = 0.0) -> Floats:
    """Points (count, 2) at even angles, their distances from the center taken in turn."""
    angles = start + 2.0 * np.pi * np.arange(count) / count
    distances = np.resize(radii, count)
    ring: Floats = np.round(distances * [np.cos(angles), np.sin(angles)], 9).T + 0.0
    return ring


def mixed(first: str, last: str, share: float) -> str:
    """A color between two."""
    ends = [[int(color[i : i + 2], 16) for i in (1, 3, 5)] for color in (first, last)]
    parts = (round(a + share * (b - a)) for a, b in zip(*ends, strict=True))
    return "#" + "".join(f"{part:02X}" for part in parts)


def design(layers: Iterable[Layer], about: str, overlays: str = "", handles: str = "") -> Design:
    """A design of named curves, back to front, with the named overlays switched on."""
    view: dict[str, Json] = {"overlays": [*overlays.split()], "grid": False}
    made = Design(view=view | ({"handles": handles} if handles else {}), extra={"about": about})
    for name, curve, style in layers:
        shape_id = made.unused_id(name.strip("()").replace(" ", "-"))
        made = made.with_shape(shape_id, Shape(curve, name, style=style))
    return made


def panels(
    curves: Sequence[PlusCurve],
    columns: int,
    gap: float = 2.0,
    below: float | None = None,
    extent: Callable[[PlusCurve], Floats] = lambda curve: curve.lines.points,
) -> Iterator[Layer]:
    """Curves named (a), (b), ... in rows of so many, in cells that the extents of all fit in.

    Between rows there is `below`, or else as much as between columns. Control points stand in the
    middle of a cell, so that panels can be compared.
    """
    middles = [(c.lines.points.min(axis=0) + c.lines.points.max(axis=0)) / 2.0 for c in curves]
    reach = [extent(c) - middle for c, middle in zip(curves, middles, strict=True)]
    low = np.min([r.min(axis=0) for r in reach], axis=0)
    high = np.max([r.max(axis=0) for r in reach], axis=0)
    width, height = high - low + (gap, gap if below is None else below)
    for number, (curve, middle) in enumerate(zip(curves, middles, strict=True)):
        place = np.array([number % columns * width, -(number // columns) * height])
        yield f"({'abcdef'[number]})", moved(curve, place - middle), Style()


def parent_points(curve: PlusCurve) -> Floats:
    """(2n, 2) the control points of both parents: their hull holds the curve."""
    return np.concatenate(line_ends(curve))
