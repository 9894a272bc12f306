"""Rows of coordinates: points in their order, through which a curve is fitted.

Two or three numbers a line, split by blanks, commas or semicolons; an empty line, or one without
numbers, begins another curve. A first line of titles is passed over.
"""

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import LARGEST, Floats
from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError, Loaded, register
from plusedit.io.json_text import shown
from plusedit.io.mesh_text import plain_text

TOLERANCE = 2e-3  # of the size of the points: as near as a curve is fitted at first
MOST = 100_000  # points, and
MOST_CURVES = 1000  # curves: more are a file of another kind
FITTED = 2000  # points of one curve that it is fitted to: of more, as many are taken
SAMPLES = 129  # points written of a curve
REPEATED = 1e-12  # of the size: points so near to the one before are the same


class PointRows:
    """Lists of points; curves fitted to them in, points of curves out."""

    title = "Points in rows"
    suffixes = (".csv", ".txt", ".dat", ".pts")
    keeps_all = False

    def read(self, data: bytes, name: str) -> Loaded:
        """A curve for every list. FormatError names the line of what is no number."""
        from plusedit.commands.fitting import FitSource, fitted_shape

        with within(name):
            lists = _lists(plain_text(data, "a text of points").decode("utf-8", "replace"))
            notes: list[str] = []
            shapes = {}
            for number, points in enumerate(lists, 1):
                kept = _thinned(points, notes)
                size = float(np.ptp(kept, axis=0).max())
                is_closed = len(kept) > 3 and bool((kept[0] == kept[-1]).all())
                source = FitSource(kept, TOLERANCE * size, is_closed)
                title = "Fitted curve" if len(lists) == 1 else f"Fitted curve {number}"
                shapes[ShapeId(f"curve-{number}")] = fitted_shape(source, title)
        return Loaded(Design(shapes), tuple(dict.fromkeys(notes)))

    def write(self, design: Design) -> bytes:
        """Even samples of its curves, an empty line between two. FormatError if it has none."""
        even = np.linspace(0.0, 1.0, SAMPLES)
        parts = [
            "".join(",".join(map(repr, row)) + "\n" for row in curve.at(even).tolist())
            for shape_id, curve in design.curves()
            if design[shape_id].visible
        ]
        if not parts:
            raise FormatError("the design has no curves, and rows of points hold nothing else")
        return "\n".join(parts).encode()


register("point_rows")(PointRows())


def _lists(text: str) -> list[Floats]:
    """The lists of points (m, 2 or 3)."""
    found: list[list[list[float]]] = [[]]
    count = 0
    for number, line in enumerate(text.split("\n"), 1):
        words = line.partition("#")[0].replace(",", " ").replace(";", " ").split()
        row = _row(words, number, is_first=count == 0 and len(found) == 1)
        if row is None:
            if found[-1]:
                found.append([])
            continue
        if found[-1] and len(row) != len(found[-1][0]):
            before = of_number(len(found[-1][0]), "number")
            raise FormatError(f"line {number}: has {len(row)} numbers, the line before {before}")
        found[-1].append(row)
        count += 1
        if count > MOST or len(found) > MOST_CURVES:
            raise FormatError(f"has more than {MOST:,} points or {MOST_CURVES:,} curves")
    lists = [points for rows in found if len(rows) > 1 and len(points := _distinct(rows)) > 1]
    if not lists:
        raise FormatError("has no two different points one after the other")
    return lists


def _row(words: list[str], number: int, *, is_first: bool) -> list[float] | None:
    """The numbers of a line; None where it has none at all."""
    try:
        row = [float(word) for word in words]
    except ValueError:
        if is_first:
            return None
        wrong = next(word for word in words if not _is_number(word))
        raise FormatError(f"line {number}: expected numbers, got {shown(wrong)}") from None
    if not row:
        return None
    if len(row) not in (2, 3):
        raise FormatError(f"line {number}: has {of_number(len(row), 'number')}, expected 2 or 3")
    if not all(abs(value) <= LARGEST for value in row):
        raise FormatError(f"line {number}: has a number that is not finite, or too large")
    return row


def _is_number(word: str) -> bool:
    try:
        float(word)
    except ValueError:
        return False
    return True


def _distinct(rows: list[list[float]]) -> Floats:
    """The points without those that repeat the one before."""
    points = np.array(rows)
    steps = np.abs(np.diff(points, axis=0)).max(axis=1)
    kept = np.append(True, steps > REPEATED * max(float(np.ptp(points, axis=0).max()), 1e-300))
    distinct: Floats = points[kept]
    return distinct


def _thinned(points: Floats, notes: list[str]) -> Floats:
    if len(points) <= FITTED:
        return points
    notes.append(f"Of lists with more than {FITTED:,} points every few were taken.")
    thinned: Floats = points[np.linspace(0, len(points) - 1, FITTED).round().astype(int)]
    return thinned
