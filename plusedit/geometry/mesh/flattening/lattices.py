"""Domains that repeat: which periods are the best, and how one-forms lead around a torus.

Parameters s whose periods are the whole numbers have the energies E_kl = integral grad s_k . grad
s_l. Seen in coordinates in which E is the identity the map keeps angles as well as it can, and the
periods have there the lengths and angles of the Gram matrix 1 / E. Any basis of the lattice of
periods may be taken for the domain's; its domains are rectangles, and the reduced basis is the one
closest to a right angle.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet

STEPS = 200  # of reduction; each but the last makes a period shorter


def reduced_basis(energy: Floats) -> Floats:
    """(2, 2) whole numbers N of determinant one: parameters N s have the shortest periods.

    The two periods then make an angle between 60 and 120 degrees.
    """
    gram = np.linalg.inv(energy)
    basis = np.eye(2)
    for _ in range(STEPS):
        lengths = basis @ gram @ basis.T
        times = np.round(lengths[0, 1] / lengths[0, 0])
        basis[1] -= times * basis[0]
        lengths = basis @ gram @ basis.T
        if lengths[1, 1] >= lengths[0, 0] * (1.0 - 1e-12):
            break
        basis = np.array([basis[1], -basis[0]])
    # Rows are periods: s = basis^T s'.
    found: Floats = np.round(np.linalg.inv(basis.T))
    return found


def leading_around(sheet: Sheet) -> Floats:
    """(3 t, 2 g) for each of the 2 g ways around a closed sheet a closed one-form of whole numbers.

    It says how often a half-edge crosses, from left to right, a ring of triangles: sums around
    triangles are zero, and a ring of edges that goes around the other way has the sum 1.
    """
    tree = _tree_of_triangles(sheet)
    crossed = np.zeros(len(sheet.opposite), dtype=np.bool_)
    crossed[tree[tree >= 0]] = True
    crossed[sheet.opposite[tree[tree >= 0]]] = True
    rest = _left_over(sheet, crossed)
    forms = np.zeros((len(sheet.opposite), len(rest)))
    for column, half_edge in enumerate(rest):
        across = int(sheet.opposite[half_edge])
        forms[half_edge, column] += 1.0
        forms[across, column] -= 1.0
        for start, sign in ((across, 1.0), (half_edge, -1.0)):
            triangle = start // 3
            while (out := int(tree[triangle])) >= 0:
                forms[out, column] += sign
                forms[sheet.opposite[out], column] -= sign
                triangle = int(sheet.opposite[out]) // 3
    return forms


def _tree_of_triangles(sheet: Sheet) -> Indices:
    """(t,) the half-edge across which each triangle is left for the first one; -1 for that."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import breadth_first_order

    count = len(sheet.triangles)
    half_edges = np.arange(3 * count)
    owners, across = half_edges // 3, sheet.opposite // 3
    graph = coo_array((np.ones(3 * count, dtype=np.int8), (owners, across)), (count, count))
    before = breadth_first_order(graph.tocsr(), 0, directed=False)[1]
    fits = np.flatnonzero(across == before[owners])
    tree = np.full(count, -1)
    tree[owners[fits[::-1]]] = fits[::-1]
    return tree


def _left_over(sheet: Sheet, crossed: "np.typing.NDArray[np.bool_]") -> list[int]:
    """Half-edges that neither the tree of triangles crosses nor a tree of the others contains."""
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import minimum_spanning_tree

    count = len(sheet.points)
    free = np.flatnonzero(~crossed & (np.arange(len(crossed)) < sheet.opposite))
    ends = np.sort(np.stack([sheet.tails[free], sheet.heads[free]], axis=1), axis=1)
    # Of several edges between two vertices the tree can have one.
    pairs, first = np.unique(ends, axis=0, return_index=True)
    simple = pairs[:, 0] != pairs[:, 1]
    pairs, first = pairs[simple], first[simple]
    values = np.arange(1.0, len(pairs) + 1.0)
    graph = coo_array((values, (pairs[:, 0], pairs[:, 1])), (count, count)).tocsr()
    kept = minimum_spanning_tree(graph).data.astype(np.intp) - 1
    rest = np.ones(len(free), dtype=np.bool_)
    rest[first[kept]] = False
    left: list[int] = free[rest].tolist()
    return left
