"""The header of a PLY file: which elements follow, how many, and of what properties."""

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_text import name_of

Order = Literal["ascii", "<", ">"]

LONGEST = 1 << 16  # bytes; some programs put much text into comments
MOST_PROPERTIES = 1000
ORDERS: dict[bytes, Order] = {
    b"ascii": "ascii",
    b"binary_little_endian": "<",
    b"binary_big_endian": ">",
}
TYPES = {
    b"char": "i1",
    b"uchar": "u1",
    b"short": "i2",
    b"ushort": "u2",
    b"int": "i4",
    b"uint": "u4",
    b"float": "f4",
    b"double": "f8",
    b"int8": "i1",
    b"uint8": "u1",
    b"int16": "i2",
    b"uint16": "u2",
    b"int32": "i4",
    b"uint32": "u4",
    b"float32": "f4",
    b"float64": "f8",
}


@dataclass(frozen=True)
class Property:
    """A number of every row of an element, or a list of numbers with their count before them."""

    name: str
    kind: str
    """as numpy calls it, without the order of bytes"""
    count_kind: str = ""
    """of the count; "" where it is no list"""

    def size(self, is_text: bool) -> int:
        """Of one number: words of a text, or bytes."""
        return 1 if is_text else np.dtype(self.kind).itemsize

    def least(self, is_text: bool) -> int:
        """What an entry takes at least: a list may be empty."""
        if not self.count_kind:
            return self.size(is_text)
        return 1 if is_text else np.dtype(self.count_kind).itemsize


@dataclass(eq=False)
class Element:
    """A table of the file."""

    name: str
    count: int
    """of rows; not yet checked against the file"""
    properties: list[Property] = field(default_factory=list)


@dataclass(eq=False)
class Header:
    """What the lines before the tables say."""

    order: Order
    elements: list[Element]
    end: int
    """where the tables begin"""


def header_of(data: bytes) -> Header:
    """The header of a PLY file. FormatError says which line is wrong."""
    if not data.startswith((b"ply\n", b"ply\r")):
        raise FormatError("does not begin as PLY files do, with a line that says ply")
    line_end = b"\r\n" if data[3:5] == b"\r\n" else data[3:4]
    mark = line_end + b"end_header"
    place = data.find(mark, 0, LONGEST)
    if place < 0:
        cut = len(data) < LONGEST
        raise FormatError(f"{'is cut off: ' if cut else ''}its header is not ended by end_header")
    after = data.find(line_end, place + len(mark))
    end = len(data) if after < 0 else after + len(line_end)
    order, elements = _read(data[:place].split(line_end)[1:])
    return Header(order, elements, end)


def _read(lines: list[bytes]) -> tuple[Order, list[Element]]:
    order: Order | None = None
    elements: list[Element] = []
    for line in lines:
        match line.split():
            case [] | [b"comment" | b"obj_info", *_]:
                pass
            case [b"format", kind, _] if kind in ORDERS:
                order = ORDERS[kind]
            case [b"element", name, count] if count.isdigit() and len(count) < 19:
                elements.append(Element(name_of(name), int(count)))
            case [b"property", b"list", count_kind, kind, name] if elements:
                _add(elements[-1], Property(name_of(name), _type(kind), _type(count_kind)))
            case [b"property", kind, name] if elements:
                _add(elements[-1], Property(name_of(name), _type(kind)))
            case _:
                raise FormatError(f"its header has a line {shown(name_of(line))}")
    if order is None:
        raise FormatError("its header does not say the format: ascii or binary")
    return order, elements


def _add(element: Element, new: Property) -> None:
    if len(element.properties) >= MOST_PROPERTIES:
        raise FormatError(f"its header has more than {MOST_PROPERTIES} properties of one element")
    if new.count_kind.startswith("f"):
        raise FormatError(f"its lists {shown(new.name)} are counted with decimals")
    element.properties.append(new)


def _type(kind: bytes) -> str:
    if kind not in TYPES:
        raise FormatError(f"its header has a number of unknown kind {shown(name_of(kind))}")
    return TYPES[kind]
