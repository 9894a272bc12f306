"""The blending functions of a shape as plots: b_i and (u - u_i) b_i, of chosen lines in color.

A closed basis is shown somewhat beyond one period, so that functions across the seam are seen
whole; nodes have ticks there, too. With weights the functions are the rational ones.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis, is_local
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blending_functions import (
    BlendingFunctions,
    curve_functions,
    row_functions,
)
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.scene.plots import Axis, Plot, PlotLine, PlotMark, axis_for

SAMPLES = 513
BEYOND = 0.15  # of the period of a closed basis, on either side
COLORS = ("accent", "#D2691E", "#0E9F77", "#B565A7", "#8A8F00", "#C8372D")
"""Of chosen functions, in turn."""
FAINT = "quiet@40"
MOST_FAINT, MOST_NAMED, MOST_KNOTS = 64, 4, 80


@dataclass(frozen=True, eq=False)
class FunctionPlots:
    """Both plots of the functions along one direction."""

    way: Way
    values: Plot
    reaches: Plot
    chosen: tuple[int, ...]


def curve_plots(curve: PlusCurve, lines: Sequence[int]) -> tuple[FunctionPlots, ...]:
    """Those of a curve, the functions of the numbered lines in color."""
    found = curve_functions(curve, parameters(curve.basis))
    is_weighted = curve.lines.weights is not None
    return (_both(curve.basis, found, lines, "u", is_weighted),)


def surface_plots(
    surface: PlusSurface, planes: Sequence[int], place: tuple[float, float]
) -> tuple[FunctionPlots, ...]:
    """Those by u and those by v, of the rows and columns of the numbered planes.

    Weights make them differ from place to place: they are those of the curves through it.
    """
    columns = surface.planes.shape[1]
    rows = sorted({plane // columns for plane in planes}), sorted({p % columns for p in planes})
    is_weighted = surface.planes.weights is not None
    return tuple(
        _both(
            basis,
            row_functions(surface, way, parameters(basis), place[1 - number]),
            rows[number],
            way,
            is_weighted,
        )
        for number, (way, basis) in enumerate(zip(WAYS, surface.bases, strict=True))
    )


def parameters(basis: Basis) -> Floats:
    """(m,) where functions are worked out: evenly, and at their knots."""
    low, high = (-BEYOND, 1.0 + BEYOND) if basis.closed else (0.0, 1.0)
    even = np.linspace(low, high, SAMPLES)
    return np.union1d(even, basis.breaks) if is_local(basis) else even


def _both(
    basis: Basis, found: BlendingFunctions, chosen: Sequence[int], way: Way, is_weighted: bool
) -> FunctionPlots:
    name, number = ("b", "ᵢ") if way == WAYS[0] else ("c", "ⱼ")
    name = f"R{number}" if is_weighted else f"{name}{number}"
    x = Axis(float(found.u[0]), float(found.u[-1]))
    marks = tuple(_marks(basis, chosen, x))
    inside = (0.0, 1.0) if basis.closed else None
    titles = f"{name}({way})", f"({way} − {way}{number}) {name}({way})"
    plots = [
        Plot(
            title,
            x,
            axis_for(rows, from_zero=True),
            tuple(_lines(found.u, rows, found.values, chosen)),
            marks,
            x_name=way,
            inside=inside,
        )
        for title, rows in zip(titles, (found.values, found.reaches), strict=True)
    ]
    return FunctionPlots(way, plots[0], plots[1], tuple(chosen))


def _lines(u: Floats, rows: Floats, values: Floats, chosen: Sequence[int]) -> Iterator[PlotLine]:
    """Every function where it is not zero, or some of very many; the chosen ones in front."""
    count = rows.shape[1]
    picked = set(chosen)
    for number in range(0, count, -(-count // MOST_FAINT)):
        if number not in picked:
            yield _line(u, rows, values, number, FAINT, 1.0)
    for place, number in enumerate(chosen):
        color = COLORS[place % len(COLORS)]
        name = str(number + 1) if place < MOST_NAMED else ""
        yield _line(u, rows, values, number, color, 2.0, name)


def _line(
    u: Floats, rows: Floats, values: Floats, number: int, color: str, width: float, name: str = ""
) -> PlotLine:
    acting = values[:, number] > 0.0
    # With the zeros on either side, from which it rises.
    acting[:-1] |= acting[1:].copy()
    acting[1:] |= acting[:-1].copy()
    y = np.where(acting, rows[:, number], np.nan)
    return PlotLine(u, y, color, width, name=name)


def _marks(basis: Basis, chosen: Sequence[int], x: Axis) -> Iterator[PlotMark]:
    """Knots and nodes, with the images of both that are seen."""
    images = (-1.0, 0.0, 1.0) if basis.closed else (0.0,)
    if is_local(basis) and len(basis.breaks) <= MOST_KNOTS:
        knots = basis.knot_vector if isinstance(basis, BSpline) else basis.breaks
        for knot in sorted({float(k) + image for k in knots for image in images}):
            yield PlotMark(knot, "quiet@45", dash="dot")
    nodes = basis.nodes.tolist()
    if len(nodes) <= MOST_KNOTS:
        for node in nodes:
            for image in images:
                yield PlotMark(node + image, "quiet@70", is_tick=True)
    for place, number in enumerate(chosen):
        for image in images:
            color = COLORS[place % len(COLORS)]
            yield PlotMark(nodes[number] + image, color, is_tick=True)
