"""The tables of a PLY file, as text or bytes, row after row without any index.

Where rows hold lists, a row begins where the one before ends. If all lists are as long as those
of the first row, which is seen at once, every place is known; if not, the rows are walked through.
"""

import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_cleaning import doubles
from plusedit.io.mesh_words import Places
from plusedit.io.ply_header import Element, Property

MOST_ROWS = 1 << 25  # the place of each is kept
PIECE = 1 << 18  # numbers taken at a time where each has a place of its own
STRUCT = {"i1": "b", "u1": "B", "i2": "h", "u2": "H", "i4": "i", "u4": "I"}


@dataclass(frozen=True, eq=False)
class Body:
    """All that stands behind the header: bytes, or the numbers of a text."""

    values: NDArray[Any]
    """(k,) uint8, or float64 of a text"""
    order: str
    """of bytes, "<" or ">"; "" for a text"""

    @property
    def is_text(self) -> bool:
        return not self.order

    def take(self, places: Places, kind: str) -> Floats:
        """(p,) the numbers of that kind that begin at those places."""
        if self.is_text:
            taken: Floats = self.values[places]
            return taken
        dtype = np.dtype(self.order + kind)
        numbers = np.empty(len(places))
        for at in range(0, len(places), PIECE):
            beside = places[at : at + PIECE, None] + np.arange(dtype.itemsize)
            numbers[at : at + PIECE] = doubles(self.values[beside].view(dtype)).ravel()
        return numbers

    def reader(self, kind: str) -> Callable[[int], int]:
        """Of the count that begins at a place; one call takes a tenth of a microsecond."""
        values = self.values.data
        if self.is_text:
            return lambda at: _whole(values[at])
        if kind == "u1":
            return values.__getitem__
        unpack = struct.Struct(self.order + STRUCT[kind]).unpack_from
        return lambda at: int(unpack(values, at)[0])


@dataclass(frozen=True, eq=False)
class Table:
    """The rows of one element."""

    element: Element
    body: Body
    begins: Places
    """(rows,) where each row begins"""
    counts: NDArray[np.int64]
    """(rows, lists) how long each list of each row is"""
    end: int
    """where the next table begins"""

    def has(self, name: str) -> bool:
        """Whether there is a property of that name."""
        return any(entry.name == name for entry in self.element.properties)

    def column(self, name: str) -> Floats:
        """(rows,) the numbers of a property. FormatError if it is a list."""
        places, entry, lengths = self._places(name)
        if lengths is not None:
            raise FormatError(f"its {self.element.name} has a list {shown(name)} for a number")
        return self.body.take(places, entry.kind)

    def lists(self, name: str) -> tuple[NDArray[np.int64], Floats]:
        """(rows,) lengths and (sum of them,) numbers. FormatError if the property is no list."""
        places, entry, lengths = self._places(name)
        if lengths is None:
            raise FormatError(f"its {self.element.name} has a number {shown(name)} for a list")
        size = entry.size(self.body.is_text)
        firsts = places + entry.least(self.body.is_text) - (np.cumsum(lengths) - lengths) * size
        numbers = np.repeat(firsts, lengths) + np.arange(int(lengths.sum())) * size
        return lengths, self.body.take(numbers, entry.kind)

    def _places(self, name: str) -> tuple[Places, Property, NDArray[np.int64] | None]:
        places, lists = self.begins, 0
        for entry in self.element.properties:
            lengths = self.counts[:, lists] if entry.count_kind else None
            if entry.name == name:
                return places, entry, lengths
            places = places + entry.least(self.body.is_text)
            if lengths is not None:
                places = places + lengths * entry.size(self.body.is_text)
                lists += 1
        raise FormatError(f"its {self.element.name} has no {shown(name)}")


def table_of(element: Element, body: Body, begin: int) -> Table:
    """The rows of `element`, which begin at that place. FormatError if they are not all there."""
    least = sum(entry.least(body.is_text) for entry in element.properties)
    room = len(body.values) - begin
    if not least:  # rows of nothing, however many
        return Table(element, body, np.zeros(0, np.int64), np.zeros((0, 0), np.int64), begin)
    if element.count * least > room:
        raise _cut_off(element, room // least)
    if element.count > MOST_ROWS:
        raise FormatError(f"has more than {MOST_ROWS} rows of {element.name}")
    lists = [entry for entry in element.properties if entry.count_kind]
    counts = np.zeros((element.count, len(lists)), dtype=np.int64)
    if lists and element.count:
        even = _first_counts(element, body, begin)
        rest = sum(n * entry.size(body.is_text) for n, entry in zip(even, lists, strict=True))
        if not _all_have(even, element, body, begin, least + rest):
            return _walked(element, body, begin)
        counts[:], least = even, least + rest
    begins = begin + np.arange(element.count, dtype=np.int64) * least
    return Table(element, body, begins, counts, begin + element.count * least)


def _first_counts(element: Element, body: Body, begin: int) -> list[int]:
    """How long the lists of the first row are."""
    counts = []
    for entry in element.properties:
        if entry.count_kind:
            if begin + entry.least(body.is_text) > len(body.values):
                raise _cut_off(element, 0)
            counts.append(_checked(body.reader(entry.count_kind)(begin), entry))
            begin += counts[-1] * entry.size(body.is_text)
        begin += entry.least(body.is_text)
    return counts


def _all_have(even: list[int], element: Element, body: Body, begin: int, width: int) -> bool:
    """Whether the lists of every row are that long, so that rows of that width follow."""
    if element.count * width > len(body.values) - begin:
        return False
    rows = begin + np.arange(element.count, dtype=np.int64) * width
    wanted = iter(even)
    for entry in element.properties:
        if entry.count_kind:
            count = next(wanted)
            if (body.take(rows, entry.count_kind) != count).any():
                return False
            rows = rows + count * entry.size(body.is_text)
        rows = rows + entry.least(body.is_text)
    return True


def _walked(element: Element, body: Body, begin: int) -> Table:
    """The table whose rows have lists of different lengths."""
    steps, skip = [], 0
    for entry in element.properties:
        if entry.count_kind:
            least, size = entry.least(body.is_text), entry.size(body.is_text)
            steps.append((skip, body.reader(entry.count_kind), least, size))
            skip = 0
        else:
            skip += entry.size(body.is_text)
    begins, counts, at = np.empty(element.count, np.int64), [], begin
    try:
        for row in range(element.count):
            begins[row] = at
            for before, read, least, size in steps:
                count = read(at + before)
                counts.append(count)
                at += before + least + (count if count > 0 else 0) * size
            at += skip
    except (IndexError, OverflowError, struct.error):
        at = len(body.values) + 1
    if at > len(body.values):
        raise _cut_off(element, max(0, len(counts) - 1) // len(steps))
    lengths = np.array(counts, dtype=np.int64).reshape(element.count, len(steps))
    if lengths.min(initial=0) < 0:
        _checked(int(lengths.min()), next(e for e in element.properties if e.count_kind))
    return Table(element, body, begins, lengths, at)


def _checked(count: int, entry: Property) -> int:
    if count < 0:
        raise FormatError(f"has a list {shown(entry.name)} of {count} numbers")
    return count


def _whole(value: float) -> int:
    if not value.is_integer():
        raise FormatError(f"has a list of {value:g} numbers")
    return int(value)


def _cut_off(element: Element, there: int) -> FormatError:
    return FormatError(
        f"is cut off: promises {of_number(element.count, 'row')} of {element.name},"
        f" but ends after at most {there}"
    )
