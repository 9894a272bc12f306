"""Shortest paths along the edges of a sheet, and what lies to their left."""

from collections.abc import Sequence
from itertools import pairwise, permutations
from typing import Any

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Flags, Indices, Sheet

Graph = Any
"""A sparse matrix (n, n) of scipy's"""


def edge_graph(sheet: Sheet, allowed: Flags | None = None) -> Graph:
    """The sparse (n, n) matrix of the edges' lengths, each both ways.

    Only of those half-edges that are marked in `allowed` (3 t,), if that is given.
    """
    from scipy.sparse import coo_array

    tails, heads, lengths = sheet.tails, sheet.heads, sheet.lengths.ravel()
    border = sheet.opposite < 0
    if allowed is not None:
        tails, heads, lengths = tails[allowed], heads[allowed], lengths[allowed]
        border = border[allowed]
    rows = np.concatenate([tails, heads[border]])
    columns = np.concatenate([heads, tails[border]])
    # An edge of length zero would not be one.
    values = np.maximum(np.concatenate([lengths, lengths[border]]), 1e-300)
    count = len(sheet.points)
    order = np.lexsort((columns, rows))
    rows, columns, values = rows[order], columns[order], values[order]
    # Of several edges between two vertices one is enough; their lengths would be added.
    first = np.ones(len(rows), dtype=np.bool_)
    first[1:] = (rows[1:] != rows[:-1]) | (columns[1:] != columns[:-1])
    return coo_array((values[first], (rows[first], columns[first])), (count, count)).tocsr()


def distances(graph: Graph, vertex: int) -> Floats:
    """(n,) from one vertex to all; infinite where no path leads."""
    from scipy.sparse.csgraph import dijkstra

    found: Floats = dijkstra(graph, indices=vertex)
    return found


def farthest_points(sheet: Sheet, graph: Graph, count: int) -> tuple[list[int], Floats]:
    """Vertices of the mesh far from each other, each the farthest from those before.

    Then (count, n) how far all vertices are from each of them.
    """
    candidates = np.zeros(len(sheet.points), dtype=np.bool_)
    candidates[sheet.triangles[: sheet.own].ravel()] = True
    start = int(np.flatnonzero(candidates)[0])
    chosen = [int(_among(distances(graph, start), candidates).argmax())]
    away = [distances(graph, chosen[0])]
    nearest = _among(away[0], candidates)
    while len(chosen) < count:
        chosen.append(int(nearest.argmax()))
        away.append(distances(graph, chosen[-1]))
        nearest = np.minimum(nearest, _among(away[-1], candidates))
    return chosen, np.array(away)


def _among(away: Floats, candidates: Flags) -> Floats:
    return np.where(candidates & np.isfinite(away), away, -1.0)


def shortest_chain(points: Sequence[int], away: Floats) -> list[int]:
    """The points in the order of the shortest chain through them, `away` (k, k) from each other."""
    orders = [row for row in permutations(range(len(points))) if row[0] < row[-1]]
    best = min(orders, key=lambda row: sum(away[a, b] for a, b in pairwise(row)))
    return [points[place] for place in best]


def shortest_path(graph: Graph, start: int, end: int, closed: Flags) -> list[int]:
    """Vertices from start to end that passes none of the closed ones; empty if there is no path."""
    from scipy.sparse.csgraph import dijkstra

    opened = ~closed
    opened[[start, end]] = True
    kept = np.flatnonzero(opened)
    inner = graph[kept][:, kept] if closed.any() else graph
    number = np.cumsum(opened) - 1
    before = dijkstra(inner, indices=number[start], return_predecessors=True)[1]
    path = [int(number[end])]
    while path[-1] != number[start]:
        step = int(before[path[-1]])
        if step < 0:
            return []
        path.append(step)
    found: list[int] = kept[path[::-1]].tolist()
    return found


def chain_paths(graph: Graph, points: Sequence[int]) -> list[list[int]]:
    """Paths from each point to the next without common vertices but the points; empty if there
    are none. That between the nearest two is laid first."""
    count = graph.shape[0]
    legs = list(pairwise(points))
    for order in permutations(range(len(legs))):
        closed = np.zeros(count, dtype=np.bool_)
        closed[list(points)] = True
        found: dict[int, list[int]] = {}
        for leg in order:
            path = shortest_path(graph, *legs[leg], closed)
            if not path:
                break
            found[leg] = path
            closed[path] = True
        if len(found) == len(legs):
            return [found[leg] for leg in range(len(legs))]
    return []


def half_edges_along(sheet: Sheet, path: Sequence[int]) -> list[int]:
    """The half-edges from each vertex of a path to the next, with triangles on their left."""
    on_path = np.zeros(len(sheet.points), dtype=np.bool_)
    on_path[list(path)] = True
    near = np.flatnonzero(on_path[sheet.tails] & on_path[sheet.heads])
    names = zip(sheet.tails[near].tolist(), sheet.heads[near].tolist(), strict=True)
    found = dict(zip(names, near.tolist(), strict=True))
    return [found[step] for step in pairwise(path)]


def left_corners(sheet: Sheet, half_edges: Sequence[int]) -> list[list[int]]:
    """The corners to the left of a path, for each of its vertices but the ends.

    `half_edges` lead along the path, and both sides of them have triangles.
    """
    rows = []
    for before, after in pairwise(half_edges):
        stop, corner = int(sheet.opposite[before]), after
        row = [corner]
        while (turned := int(sheet.opposite[sheet.before(corner)])) != stop:
            row.append(turned)
            corner = turned
        rows.append(row)
    return rows


def corners_left_of_ends(sheet: Sheet, half_edges: Sequence[int]) -> tuple[list[int], list[int]]:
    """The corners to the left of a path that begins and ends at the border, at both ends."""
    first = [half_edges[0]]
    while (turned := int(sheet.opposite[sheet.before(first[-1])])) >= 0:
        first.append(turned)
    last = [sheet.next_of(half_edges[-1])]
    while (turned := int(sheet.opposite[last[-1]])) >= 0:
        last.append(sheet.next_of(turned))
    return first, last


def path_of_four(sheet: Sheet, graph: Graph, points: Sequence[int]) -> list[int]:
    """A path of at least four vertices, for small parts; shorter only where there is none."""
    nothing = np.zeros(len(sheet.points), dtype=np.bool_)
    path = shortest_path(graph, points[0], points[1], nothing)
    neighbors = [graph.indices[a:b].tolist() for a, b in pairwise(graph.indptr.tolist())]
    while len(path) < 4:
        # Longer by a neighbor of an end, or by a detour past a vertex beside an edge of it.
        more = next(
            (
                grown
                for place in range(len(path) + 1)
                for vertex in range(len(neighbors))
                if vertex not in path
                and all(end in neighbors[vertex] for end in path[max(place - 1, 0) : place + 1])
                for grown in [[*path[:place], vertex, *path[place:]]]
            ),
            None,
        )
        if more is None:
            break
        path = more
    return path


def distance_between(graph: Graph, first: Indices, second: Indices) -> float:
    """The length of the shortest path from one of some vertices to one of others."""
    from scipy.sparse.csgraph import dijkstra

    return float(dijkstra(graph, indices=np.unique(first), min_only=True)[second].min())


def path_between(graph: Graph, first: Indices, second: Indices) -> list[int]:
    """That path: only its ends are among them."""
    from scipy.sparse.csgraph import dijkstra

    away, before, _ = dijkstra(
        graph, indices=np.unique(first), min_only=True, return_predecessors=True
    )
    path = [int(second[away[second].argmin()])]
    while (step := int(before[path[-1]])) >= 0:
        path.append(step)
    return path[::-1]
