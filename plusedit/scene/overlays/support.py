"""Where the selected control lines and planes act: the supports of their blending functions.

Of a curve a band along it, as wide as the share that the selected lines have in each point. Of
B-splines it ends with the support, marked by squares; the functions of other families are nowhere
zero, and the band ends where the share is small. Of a surface the outline of each plane's support.
"""

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis, is_local
from plusedit.geometry.blend import Grid, blend
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.supports import stretches
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Dash, Item, Markers, Polyline
from plusedit.scene.overlays import Seen, overlay

COLOR = "hover"
THIN, THICK = 3.0, 12.0  # pixels, of the band where the share is small and where it is largest
LEVELS = 9  # widths of it
SMALL = 0.01  # of the largest share, below which a line is taken not to act
SMALL_OF_PLANE = 0.1  # the same of a plane, where the outline of all the surface would say nothing
PER_LINE, FEWEST = 8, 128  # samples
MOST = 24  # selected lines or planes whose own ends are marked
ALONG = 49  # points of a side of an outline

support = overlay(
    "support",
    title="Reach of selected lines",
    order=35,
    shortcut="Shift+L",
    group="Constructions",
)


@support.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """The band, the ends of supports, and the curve at the nodes; nothing if none is selected."""
    if not seen.lines:
        return
    even = np.linspace(0.0, 1.0, max(PER_LINE * len(curve.lines), FEWEST) + 1)
    grid = Grid(np.union1d(drawn(curve, seen.camera).grid.parameters, even))
    points, shares = curve.sample(grid), _shares(curve, grid, seen.lines)
    yield from _band(points, shares)
    lines = seen.lines[:MOST]
    if is_local(curve.basis):
        ends = {end for i in lines for piece in stretches(curve.basis, i) for end in piece}
        yield Markers(curve.at(np.array(sorted(ends))), "square", 6.0, COLOR, "canvas", 1.0)
    nodes = curve.basis.nodes[list(lines)]
    yield Markers(curve.at(nodes), "diamond", 9.0, "canvas", COLOR, 1.5)


@support.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The outline of the region where each selected plane acts, and the surface at its nodes.

    Dashed where the function is nowhere zero: it is a tenth of its largest value there.
    """
    lines = seen.lines[:MOST]
    if not lines:
        return
    columns = surface.planes.shape[1]
    places = [divmod(line, columns) for line in lines]
    dashes: list[Dash] = ["solid" if is_local(basis) else "dash" for basis in surface.bases]
    for row, column in places:
        pieces = _acting(surface.basis_u, row), _acting(surface.basis_v, column)
        for (low_u, high_u), (low_v, high_v) in product(*pieces):
            u, v = np.linspace(low_u, high_u, ALONG), np.linspace(low_v, high_v, ALONG)
            for points in surface.at(u, [low_v, high_v]).swapaxes(0, 1):
                yield Polyline(np.ascontiguousarray(points), COLOR, 2.5, dashes[1])
            for points in surface.at([low_u, high_u], v):
                yield Polyline(np.ascontiguousarray(points), COLOR, 2.5, dashes[0])
    nodes = np.array([[surface.basis_u.nodes[i], surface.basis_v.nodes[j]] for i, j in places])
    yield Markers(surface.derivatives_at(nodes, highest=0)[0], "diamond", 9.0, "canvas", COLOR)


def _shares(curve: PlusCurve, grid: Grid, lines: Sequence[int]) -> Floats:
    """(m,) what part the lines together have in each point."""
    weights = curve.lines.unit_weights
    theirs = np.zeros_like(weights)
    theirs[list(lines)] = weights[list(lines)]
    values = blend(curve.basis, grid).values
    shares: Floats = (values @ theirs) / (values @ weights)
    return shares


def _band(points: Floats, shares: Floats) -> Iterator[Item]:
    """Pieces of the curve, of as many widths as there are levels."""
    between = (shares[:-1] + shares[1:]) / 2.0
    largest = float(between.max())
    if largest <= 0.0:
        return
    levels = np.ceil(LEVELS * between / largest).astype(int)
    levels[between < SMALL * largest] = 0
    starts = np.flatnonzero(np.diff(levels, prepend=-1))
    ends = np.append(starts[1:], len(levels))
    for start, end in zip(starts.tolist(), ends.tolist(), strict=True):
        if levels[start]:
            width = THIN + (THICK - THIN) * levels[start] / LEVELS
            yield Polyline(points[start : end + 1], COLOR, width)


def _acting(basis: Basis, number: int) -> list[tuple[float, float]]:
    """The parts of [0, 1] where a function is not zero, or not small where it is nowhere zero."""
    if is_local(basis):
        return stretches(basis, number)
    u = np.linspace(0.0, 1.0, 513)
    values = basis.values(u)[:, number]
    is_large = values >= SMALL_OF_PLANE * values.max()
    edges = np.flatnonzero(np.diff(np.concatenate([[False], is_large, [False]]).astype(int)))
    return [(float(u[a]), float(u[b - 1])) for a, b in edges.reshape(-1, 2) if b - 1 > a]
