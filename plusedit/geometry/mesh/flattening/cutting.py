"""Sheets with handles cut open to a disk.

From one vertex shortest paths lead to all others. Of the edges beside them, all are crossed that
join faces to a tree whose edges close the longest loops with the paths; 2 g edges are left. The
cut consists of these and the paths to them: the shortest one through that vertex (Erickson and
Whittlesey, Greedy optimal homotopy and homology generators, 2005). Polygons are not cut.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.paths import edge_graph
from plusedit.geometry.mesh.flattening.sheet import Flags, Indices, Sheet
from plusedit.geometry.mesh.topology import first_of_each, umbrellas


def cut_open(sheet: Sheet, owners: Indices) -> Sheet:
    """A closed sheet with handles as a disk; vertices of the cut are there once for each side.

    `owners` (t,) are the faces in which the triangles lie.
    """
    cut = _cut(sheet, owners)
    opposite = np.where(cut, -1, sheet.opposite)
    after = np.arange(len(opposite)).reshape(-1, 3)
    following = np.roll(after, -1, axis=1).ravel()
    umbrella_of = umbrellas(following.astype(np.int32), opposite.astype(np.int32))
    points = sheet.points[sheet.tails[first_of_each(umbrella_of)]]
    return Sheet(points, umbrella_of.reshape(-1, 3).astype(np.intp), opposite, sheet.own)


def border_ring(sheet: Sheet) -> Indices:
    """(k,) the half-edges of the border of a disk, in order."""
    border = np.flatnonzero(sheet.opposite < 0)
    leaving = dict(zip(sheet.tails[border].tolist(), border.tolist(), strict=True))
    ring = [int(border[0])]
    while (step := leaving[int(sheet.heads[ring[-1]])]) != ring[0]:
        ring.append(step)
    return np.array(ring)


def _cut(sheet: Sheet, owners: Indices) -> Flags:
    """(3 t,) true for half-edges on both sides of the cut."""
    from scipy.sparse.csgraph import dijkstra

    inner = owners[np.arange(len(sheet.opposite)) // 3] == owners[sheet.opposite // 3]
    graph = edge_graph(sheet, ~inner)
    away, before = dijkstra(graph, indices=int(sheet.tails[0]), return_predecessors=True)
    tree = _half_edges_to(sheet, before, ~inner)
    in_tree = np.zeros(len(sheet.opposite), dtype=np.bool_)
    in_tree[tree[tree >= 0]] = True
    in_tree[sheet.opposite[tree[tree >= 0]]] = True
    beside = np.flatnonzero(~inner & ~in_tree & (np.arange(len(inner)) < sheet.opposite))
    loops = away[sheet.tails[beside]] + away[sheet.heads[beside]]
    loops += sheet.lengths.reshape(-1)[beside]
    cut = np.zeros(len(inner), dtype=np.bool_)
    for half_edge in beside[_not_joining(sheet, owners, beside, loops)].tolist():
        cut[[half_edge, sheet.opposite[half_edge]]] = True
        for vertex in (int(sheet.tails[half_edge]), int(sheet.heads[half_edge])):
            while (step := int(tree[vertex])) >= 0:
                cut[[step, sheet.opposite[step]]] = True
                vertex = int(before[vertex])
    return cut


def _half_edges_to(sheet: Sheet, before: Indices, allowed: Flags) -> Indices:
    """(n,) a half-edge from the vertex before to each vertex; -1 where there is none before."""
    found = np.full(len(sheet.points), -1)
    fits = np.flatnonzero(allowed & (before[sheet.heads] == sheet.tails))
    found[sheet.heads[fits]] = fits
    return found


def _not_joining(sheet: Sheet, owners: Indices, beside: Indices, loops: Floats) -> Flags:
    """True for those of some edges that a tree of faces, of the longest loops, does not cross."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import minimum_spanning_tree

    ends = np.stack([owners[beside // 3], owners[sheet.opposite[beside] // 3]], axis=1)
    ends.sort(axis=1)
    ranks = np.empty(len(beside))
    ranks[np.argsort(-loops, kind="stable")] = np.arange(1.0, len(beside) + 1.0)
    # Of several edges between two faces only the one of the longest loop can be crossed.
    order = np.lexsort((ranks, ends[:, 1], ends[:, 0]))
    new = np.ones(len(order), dtype=np.bool_)
    new[1:] = (ends[order[1:]] != ends[order[:-1]]).any(axis=1)
    first = order[new]
    first = first[ends[first, 0] != ends[first, 1]]
    count = int(owners.max()) + 1
    graph = coo_array((ranks[first], (ends[first, 0], ends[first, 1])), (count, count))
    joined = minimum_spanning_tree(graph.tocsr()).data.astype(np.intp) - 1
    rest = np.ones(len(beside), dtype=np.bool_)
    rest[np.argsort(ranks)[joined]] = False
    return rest
