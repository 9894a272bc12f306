"""The pillow: a closed part without handles laid on a flat sphere with four cone points.

The chain of paths A - B - C - D cuts the part open to a disk, which is laid out with

    A = (0, 0),   B = (0, 1/2),   C = (W, 1/2),   D = (W, 0)

and the disk to the right of the chain. A triangle to the left of it sees the vertices of the
chain at the images

    -x along A B,     x - (0, 1) along B C,     -x + (2 W, 0) along C D.

All other vertices are means of their neighbors, those of the chain too, of neighbors seen at their
images: the chain leaves no trace, and the result is the same wherever it runs between the cone
points (Aigerman and Lipman, Orbifold Tutte embeddings, 2015). Solved with W = 1. How the chain
winds around the part decides which periods lie along u and v: the shortest ones are taken instead
(`lattices`), and u is stretched so that the energies of u and v agree, which keeps angles as well
as a pillow with these cone points can. Others may be better: `cones` says which.
"""

from itertools import pairwise
from typing import NamedTuple, Self

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import PillowDomain
from plusedit.geometry.mesh.flattening.cones import best_corners, conformal, measured_cost
from plusedit.geometry.mesh.flattening.dissection import elimination_places
from plusedit.geometry.mesh.flattening.equations import Chart, Pins, solution
from plusedit.geometry.mesh.flattening.lattices import reduced_basis
from plusedit.geometry.mesh.flattening.paths import (
    Graph,
    chain_paths,
    distances,
    edge_graph,
    farthest_points,
    half_edges_along,
    left_corners,
    path_of_four,
    shortest_chain,
)
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet
from plusedit.geometry.mesh.flattening.weights import conformal_weights, energies
from plusedit.geometry.mesh.maps import Layout, Progress, share_of

CORNERS = np.array([[0.0, 0.0], [0.0, 0.5], [1.0, 0.5], [1.0, 0.0]])
ORDER = ((0, 0), (0, 1), (1, 1), (1, 0))  # of the corners, in halves of the periods
ACROSS = ((-1.0, (0.0, 0.0)), (1.0, (0.0, -1.0)), (-1.0, (2.0, 0.0)))
WIDEST = 1e4  # of the widths: a part longer than that has no map that can be calculated with
WORTHWHILE = 0.25  # of the costs of cone points: less is not worth another layout


class _Equations(NamedTuple):
    """What the equations of all pillows of a sheet share."""

    sheet: Sheet
    weights: Floats
    """(t, 3, 2)"""
    order: Indices | None
    """(n,) in which the vertices are eliminated; None if it is to be found each time"""

    @classmethod
    def of(cls, sheet: Sheet) -> Self:
        used = np.flatnonzero(sheet.used)
        number = np.cumsum(sheet.used) - 1
        once = sheet.tails < sheet.heads
        edges = (number[ends[once]] for ends in (sheet.tails, sheet.heads))
        places = elimination_places(sheet.points[used], *edges)
        if places is None:
            return cls(sheet, conformal_weights(sheet), None)
        order = np.zeros(len(sheet.points), dtype=np.intp)
        order[used] = places
        return cls(sheet, conformal_weights(sheet), order)


class _Pillow(NamedTuple):
    """A layout by the shortest periods."""

    corners: list[int]
    """the vertices at A, B, C and D"""
    places: Floats
    """(t, 3, 2) of periods one, those in the sheet's filled holes too"""
    energy: Floats
    """(2, 2)"""

    @property
    def width(self) -> float:
        """W"""
        width = float(0.5 * np.sqrt(self.energy[1, 1] / self.energy[0, 0]))
        return float(np.clip(width, 1.0 / WIDEST, WIDEST))

    @property
    def tau(self) -> complex:
        """Where the second period lies if the first is one and angles are kept."""
        (a, b), (_, d) = self.energy
        # The periods' Gram matrix is the inverse, ((d, -b), (-b, a)) but for a factor.
        return complex(-b / d, float(np.sqrt(max(a * d - b * b, 0.0)) / d))

    def parameters(self, sheet: Sheet) -> Floats:
        """(own, 3, 2) of the mesh's triangles on the pillow."""
        parameters: Floats = self.places[: sheet.own] * (2.0 * self.width, 1.0)
        return parameters


def pillow_layout(sheet: Sheet, cone_points: tuple[int, ...], progress: Progress) -> Layout:
    """Parameters on the pillow of a closed sheet without handles.

    Without given cone points it is laid out with four vertices far from each other, and once more
    with better ones if that tells of any (`cones`).
    ValueError where there are too few vertices for four cone points, or no chain joins the given
    ones.
    """
    progress(0.1, "choosing the cone points")
    graph = edge_graph(sheet)
    points, paths = cone_chain(sheet, graph, cone_points)
    progress(0.2, "laying out the pillow")
    equations = _Equations.of(sheet)
    found = _laid_out(equations, points, paths, share_of(progress, 0.2, 0.5))
    if not cone_points:
        progress(0.5, "looking for better cone points")
        found = _improved(equations, graph, found, share_of(progress, 0.6, 0.9))
    progress(0.9, "fitting its width")
    return Layout(
        PillowDomain(found.width), found.parameters(sheet), cone_points=tuple(found.corners)
    )


def _laid_out(
    equations: _Equations, points: list[int], paths: list[list[int]], progress: Progress
) -> _Pillow:
    sheet, weights, order = equations
    chart = _chart(sheet, paths)
    pins = Pins(np.array(points), CORNERS)
    parameters = solution(sheet, weights, pins, chart, order=order, progress=progress)
    # Of period one by u and v, as seen from the chain; then by the shortest periods.
    places = chart.places(sheet, parameters) * (0.5, 1.0)
    energy = energies(sheet, places)
    change = reduced_basis(energy)
    corners = np.round(2.0 * (CORNERS * (0.5, 1.0)) @ change.T).astype(np.intp) % 2
    rows = [int(np.flatnonzero((corners == corner).all(axis=1))[0]) for corner in ORDER]
    return _Pillow([points[row] for row in rows], places @ change.T, change @ energy @ change.T)


def _improved(equations: _Equations, graph: Graph, first: _Pillow, progress: Progress) -> _Pillow:
    """The pillow, or one with better corners if it is found to be better."""
    sheet = equations.sheet
    if not 0.0 < first.tau.imag < WIDEST:
        return first
    known = conformal(sheet, first.places, first.tau, first.corners)
    corners, cost, now = best_corners(known)
    if cost > now - WORTHWHILE:
        return first
    try:
        points, paths = cone_chain(sheet, graph, tuple(corners))
        second = _laid_out(equations, points, paths, progress)
    except ValueError:
        return first
    costs = [measured_cost(sheet, pillow.parameters(sheet)) for pillow in (first, second)]
    return second if costs[1] < costs[0] else first


def cone_chain(
    sheet: Sheet, graph: Graph, cone_points: tuple[int, ...]
) -> tuple[list[int], list[list[int]]]:
    """Four cone points in the order of their chain, and the three paths of it."""
    if cone_points:
        points = list(cone_points)
        if len(set(points)) != 4:
            raise ValueError(f"cone points: a pillow has four different ones, got {points}")
        away = np.array([distances(graph, point)[points] for point in points])
        points = shortest_chain(points, away)
        paths = chain_paths(graph, points)
        if not paths:
            raise ValueError(f"cone points: no paths without crossings join {points}")
        return points, paths
    points, away = farthest_points(sheet, graph, 4)
    if len(set(points)) == 4:
        points = shortest_chain(points, away[:, points])
        if paths := chain_paths(graph, points):
            return points, paths
    path = path_of_four(sheet, graph, points)
    if len(path) < 4:
        raise ValueError("a closed part needs four vertices for the corners of a pillow")
    third = (len(path) - 1) / 3.0
    ends = [0, round(third), round(2.0 * third), len(path) - 1]
    return [path[end] for end in ends], [path[a : b + 1] for a, b in pairwise(ends)]


def _chart(sheet: Sheet, paths: list[list[int]]) -> Chart:
    """The images that the triangles to the left of the chain see."""
    chart = Chart.trivial(sheet)
    whole = [paths[0][0], *(vertex for path in paths for vertex in path[1:])]
    rows = left_corners(sheet, half_edges_along(sheet, whole))
    images = [
        image for path, image in zip(paths, ACROSS, strict=True) for _ in range(len(path) - 1)
    ]
    # At B and C both neighboring images are the same; A and D are their own.
    for row, (sign, shift) in zip(rows, images[:-1], strict=True):
        chart.move(np.array(row), sign, shift)
    return chart
