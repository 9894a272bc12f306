"""A plus curve as a file says it: its keys besides those that every shape has."""

import numpy as np

from plusedit.document.shape import Json, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.io.basis_fields import basis_tree, read_basis
from plusedit.io.fields import (
    Object,
    counted,
    nested,
    number,
    numbers,
    of_number,
    required,
    row,
    rows,
)
from plusedit.io.formats import FormatError

CURVE_KEYS = frozenset({"s", "basis", "points", "directions", "weights"})


def read_curve(tree: Object) -> tuple[PlusCurve, dict[str, Object]]:
    """The curve that `tree` says, and the unknown keys of its basis, under "basis"."""
    s = number(required(tree, "s"), "s")
    points = np.array(_at_least_two(rows(required(tree, "points"), "points", (2, 3))))
    basis, unknown = read_basis(required(tree, "basis"), "basis", len(points))
    given, automatic = np.zeros_like(points), np.ones(len(points), dtype=bool)
    if "directions" in tree:
        entries = counted(tree["directions"], "directions", len(points), "points")
        for i, entry in enumerate(entries):
            if entry is not None:
                given[i], automatic[i] = _direction(entry, i, points.shape[1]), False
    weights = None if "weights" not in tree else _weights(tree["weights"], len(points))
    lines = ControlLines(points, given, automatic, weights)
    return PlusCurve(basis, lines, s), {"basis": unknown}


def curve_tree(curve: PlusCurve, extra: Tree) -> Tree:
    """What a file says of `curve`; `extra` holds the unknown keys of the basis."""
    lines = curve.lines
    tree: dict[str, Json] = {
        "s": float(curve.s),
        "basis": basis_tree(curve.basis, nested(extra, "basis")),
    }
    tree["points"] = lines.points.tolist()
    if not lines.automatic.all():
        rows_of_lines = zip(lines.automatic.tolist(), lines.given.tolist(), strict=True)
        tree["directions"] = [None if automatic else row for automatic, row in rows_of_lines]
    if lines.weights is not None:
        tree["weights"] = lines.weights.tolist()
    return tree


def _at_least_two(entries: list[list[float]]) -> list[list[float]]:
    """The rows of points, if they are enough for a curve."""
    if len(entries) < 2:
        raise FormatError("points: has 1 row, a curve needs 2 or more")
    return entries


def _direction(value: Json, place: int, width: int) -> list[float]:
    direction = row(value, f"directions: row {place}")
    if len(direction) != width:
        count = of_number(len(direction), "number")
        raise FormatError(f"directions: row {place} has {count}, rows of points have {width}")
    return direction


def _weights(value: Json, count: int) -> Floats:
    weights = np.array(numbers(counted(value, "weights", count, "points"), "weights"))
    if (weights <= 0.0).any():
        place = int((weights <= 0.0).argmax())
        raise FormatError(f"weights: must be positive, number {place} is {weights[place]:g}")
    return weights
