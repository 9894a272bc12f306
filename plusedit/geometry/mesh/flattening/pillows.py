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
as a pillow with these cone points can.
"""

from itertools import pairwise

import numpy as np

from plusedit.geometry.mesh.domains import PillowDomain
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
from plusedit.geometry.mesh.flattening.sheet import Sheet
from plusedit.geometry.mesh.flattening.weights import conformal_weights, energies
from plusedit.geometry.mesh.maps import Layout, Progress, share_of

CORNERS = np.array([[0.0, 0.0], [0.0, 0.5], [1.0, 0.5], [1.0, 0.0]])
ORDER = ((0, 0), (0, 1), (1, 1), (1, 0))  # of the corners, in halves of the periods
ACROSS = ((-1.0, (0.0, 0.0)), (1.0, (0.0, -1.0)), (-1.0, (2.0, 0.0)))
WIDEST = 1e4  # of the widths: a part longer than that has no map that can be calculated with


def pillow_layout(sheet: Sheet, cone_points: tuple[int, ...], progress: Progress) -> Layout:
    """Parameters on the pillow of a closed sheet without handles.

    ValueError where there are too few vertices for four cone points, or no chain joins the given
    ones.
    """
    progress(0.1, "choosing the cone points")
    points, paths = cone_chain(sheet, edge_graph(sheet), cone_points)
    progress(0.3, "laying out the pillow")
    chart = _chart(sheet, paths)
    pins = Pins(np.array(points), CORNERS)
    told = share_of(progress, 0.3, 0.9)
    parameters = solution(sheet, conformal_weights(sheet), pins, chart, progress=told)
    progress(0.9, "fitting its width")
    # Of period one by u and v, as seen from the chain; then by the shortest periods.
    places = chart.places(sheet, parameters) * (0.5, 1.0)
    energy = energies(sheet, places)
    change = reduced_basis(energy)
    energy, places = change @ energy @ change.T, places @ change.T
    width = float(0.5 * np.sqrt(energy[1, 1] / energy[0, 0]))
    width = float(np.clip(width, 1.0 / WIDEST, WIDEST))
    corners = np.round(2.0 * (CORNERS * (0.5, 1.0)) @ change.T).astype(np.intp) % 2
    order = [int(np.flatnonzero((corners == corner).all(axis=1))[0]) for corner in ORDER]
    return Layout(
        PillowDomain(width),
        (places * (2.0 * width, 1.0))[: sheet.own],
        cone_points=tuple(points[place] for place in order),
    )


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
