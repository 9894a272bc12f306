"""A plus surface as a file says it: its keys besides those that every shape has.

Points, directions and weights are lists of rows that run along v: points[i][j] is P_ij.
"""

import numpy as np

from plusedit.document.shape import Json, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.net import Flags
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.io.basis_fields import basis_tree, read_basis
from plusedit.io.fields import (
    Object,
    counted,
    filled,
    nested,
    number,
    numbers,
    of_number,
    required,
    vector,
)
from plusedit.io.formats import FormatError

DIRECTIONS = ("directions_u", "directions_v")
SURFACE_KEYS = frozenset({"s", "basis_u", "basis_v", "points", *DIRECTIONS, "weights"})


def read_surface(tree: Object) -> tuple[PlusSurface, dict[str, Object]]:
    """The surface that `tree` says, and the unknown keys of its bases, by the keys of those."""
    s = number(required(tree, "s"), "s")
    points = _points(required(tree, "points"))
    basis_u, unknown_u = read_basis(required(tree, "basis_u"), "basis_u", points.shape[0])
    basis_v, unknown_v = read_basis(required(tree, "basis_v"), "basis_v", points.shape[1])
    given, automatic = np.zeros((2, *points.shape)), np.ones((2, *points.shape[:2]), dtype=bool)
    for way, key in enumerate(DIRECTIONS):
        if key in tree:
            _read_directions(tree[key], key, given[way], automatic[way])
    weights = None if "weights" not in tree else _weights(tree["weights"], points)
    planes = ControlPlanes(points, given, automatic, weights)
    return PlusSurface(basis_u, basis_v, planes, s), {"basis_u": unknown_u, "basis_v": unknown_v}


def surface_tree(surface: PlusSurface, extra: Tree) -> Tree:
    """What a file says of `surface`; `extra` holds the unknown keys of the bases."""
    planes = surface.planes
    tree: dict[str, Json] = {"s": float(surface.s)}
    tree["basis_u"] = basis_tree(surface.basis_u, nested(extra, "basis_u"))
    tree["basis_v"] = basis_tree(surface.basis_v, nested(extra, "basis_v"))
    tree["points"] = planes.points.tolist()
    for key, given, automatic in zip(DIRECTIONS, planes.given, planes.automatic, strict=True):
        if not automatic.all():
            tree[key] = _directions_tree(given, automatic)
    if planes.weights is not None:
        tree["weights"] = planes.weights.tolist()
    return tree


def _directions_tree(given: Floats, automatic: Flags) -> Json:
    return [
        [None if is_automatic else vector for vector, is_automatic in zip(*row, strict=True)]
        for row in zip(given.tolist(), automatic.tolist(), strict=True)
    ]


def _points(value: Json) -> Floats:
    """(n_u, n_v, 3)"""
    entries = filled(value, "points")
    grid = [_row_of_points(entry, f"points: row {i}") for i, entry in enumerate(entries)]
    across = len(grid[0])
    for i, row in enumerate(grid):
        if len(row) != across:
            count = of_number(len(row), "point")
            raise FormatError(f"points: row {i} has {count}, row 0 has {across}")
    if len(grid) < 2:
        raise FormatError("points: has 1 row, a surface needs 2 or more")
    if across < 2:
        raise FormatError("points: each row has 1 point, a surface needs 2 or more")
    return np.array(grid)


def _row_of_points(value: Json, key: str) -> list[list[float]]:
    return [vector(entry, f"{key}: point {j}", 3) for j, entry in enumerate(filled(value, key))]


def _read_directions(value: Json, key: str, given: Floats, automatic: Flags) -> None:
    """Put the vectors of `value` into `given` (n_u, n_v, 3) and mark them as not automatic."""
    rows, columns = automatic.shape
    for i, row in enumerate(counted(value, key, rows, "rows of points")):
        for j, entry in enumerate(counted(row, f"{key}: row {i}", columns, "points")):
            if entry is not None:
                given[i, j] = vector(entry, f"{key}: row {i}: entry {j}", 3)
                automatic[i, j] = False


def _weights(value: Json, points: Floats) -> Floats:
    """(n_u, n_v)"""
    rows, columns = points.shape[:2]
    weights = np.empty((rows, columns))
    for i, entry in enumerate(counted(value, "weights", rows, "rows of points")):
        key = f"weights: row {i}"
        weights[i] = numbers(counted(entry, key, columns, "points"), key)
        if (weights[i] <= 0.0).any():
            place = int((weights[i] <= 0.0).argmax())
            raise FormatError(f"{key}: must be positive, number {place} is {weights[i, place]:g}")
    return weights
