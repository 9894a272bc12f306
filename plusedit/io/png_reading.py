"""PNG pictures as arrays, for what heights are kept in: gray or color, 8 or 16 bits.

Every byte of a picture is written as its difference to a guess from the bytes to the left, above,
and above left. Pixels of one diagonal (row + column the same) need only those of the two before
it, so a diagonal is restored at once. W3C, Portable Network Graphics, third edition, section 9.
"""

import zlib
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.io.formats import FormatError
from plusedit.io.terrain import LARGEST_GRID

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
"""Of the kinds of color: gray, RGB, gray with alpha, RGB with alpha"""
PALETTE = 3
BEST_RATIO = 1032  # no data become smaller by zlib
SUB, UP, AVERAGE, PAETH = 1, 2, 3, 4

Pixels = NDArray[np.uint8] | NDArray[np.uint16]


@dataclass(frozen=True, eq=False)
class Picture:
    """The pixels of a PNG file."""

    pixels: Pixels
    """(rows, columns, channels) from the upper left; the kind of number says how many bits"""
    has_alpha: bool
    """whether the last channel is the opacity"""


@dataclass(frozen=True)
class _Shape:
    width: int
    height: int
    bits: int
    channels: int
    has_alpha: bool

    @property
    def pixel(self) -> int:
        """Bytes of a pixel."""
        return self.channels * self.bits // 8

    @property
    def size(self) -> int:
        """Bytes of all rows, each with its filter in front."""
        return self.height * (1 + self.width * self.pixel)


def read_png(data: bytes) -> Picture:
    """The pixels of a picture. FormatError if it is damaged or of a kind that holds no heights."""
    if not data.startswith(SIGNATURE):
        raise FormatError("is no PNG picture")
    shape: _Shape | None = None
    parts: list[bytes] = []
    for kind, content in _chunks(data):
        if kind == b"IHDR" and shape is None:
            shape = _shape(content)
        elif kind == b"IDAT":
            parts.append(content)
    if shape is None:
        raise FormatError("is cut off, or no PNG picture: it has no header")
    rows = _unpacked(b"".join(parts), shape)
    filters, raw = rows[:, 0], rows[:, 1:].reshape(shape.height, shape.width, shape.pixel)
    if filters.max() > PAETH:
        raise FormatError(f"is damaged: a row has the filter {filters.max()}, and there are 0 to 4")
    plain = _restored(raw, filters)
    if shape.bits == 16:
        return Picture(plain.view(">u2").astype(np.uint16), shape.has_alpha)
    return Picture(plain, shape.has_alpha)


def _chunks(data: bytes) -> Iterator[tuple[bytes, bytes]]:
    """The parts of a file with their kinds."""
    at = len(SIGNATURE)
    while at < len(data):
        size, kind = int.from_bytes(data[at : at + 4], "big"), data[at + 4 : at + 8]
        content = data[at + 8 : at + 8 + size]
        check = data[at + 8 + size : at + 12 + size]
        if len(check) < 4:
            raise FormatError("is cut off: its last part is not whole")
        if zlib.crc32(content, zlib.crc32(kind)) != int.from_bytes(check, "big"):
            raise FormatError("is damaged: a check sum is wrong")
        if kind == b"IEND":
            return
        yield kind, content
        at += 12 + size
    raise FormatError("is cut off: its end is missing")


def _shape(header: bytes) -> _Shape:
    if len(header) != 13:
        raise FormatError("is damaged: its header is not as long as it must be")
    width, height = int.from_bytes(header[:4], "big"), int.from_bytes(header[4:8], "big")
    bits, color, _, _, interlaced = header[8:]
    if color == PALETTE:
        raise FormatError("has colors of a palette, which are no heights; save it in gray")
    if color not in CHANNELS or bits not in (8, 16):
        raise FormatError(f"has {bits} bits a color; heights need 16, or 8")
    if interlaced:
        raise FormatError("is interlaced, which is not read; save it without")
    shape = _Shape(width, height, bits, CHANNELS[color], color >= 4)
    if not width or not height or width * height > LARGEST_GRID:
        raise FormatError(f"has {width} × {height} pixels; that can't be worked with")
    return shape


def _unpacked(packed: bytes, shape: _Shape) -> NDArray[np.uint8]:
    """(height, 1 + bytes of a row) what the packed bytes say."""
    promised = f"promises {shape.width} × {shape.height} pixels"
    if len(packed) * BEST_RATIO < shape.size:
        raise FormatError(f"is cut off: {promised}, but has {len(packed)} packed bytes")
    try:
        raw = zlib.decompressobj().decompress(packed, shape.size)
    except zlib.error:
        raise FormatError("is damaged: its pixels can't be unpacked") from None
    if len(raw) < shape.size:
        raise FormatError(f"is cut off: {promised}, but has {len(raw)} bytes of them")
    return np.frombuffer(raw, dtype=np.uint8).reshape(shape.height, -1)


def _restored(raw: NDArray[np.uint8], filters: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """(rows, columns, bytes) the pixels of differences (rows, columns, bytes)."""
    rows, columns, size = raw.shape
    # A row and a column of zeros in front stand for what lies outside.
    plain = np.zeros((rows + 1, columns + 1, size), dtype=np.uint8)
    plain[1:, 1:] = raw
    flat = plain.reshape(-1, size)
    for diagonal in range(rows + columns - 1):
        first, last = max(0, diagonal - columns + 1), min(rows - 1, diagonal)
        begin = (first + 1) * (columns + 1) + diagonal - first + 1
        here = slice(begin, begin + (last - first) * columns + 1, columns)
        left, above, corner = (
            flat[here.start - back : here.stop - back : columns]
            for back in (1, columns + 1, columns + 2)
        )
        flat[here] += _guess(filters[first : last + 1, None], left, above, corner)
    return np.ascontiguousarray(plain[1:, 1:])


def _guess(
    filters: NDArray[np.uint8],
    left: NDArray[np.uint8],
    above: NDArray[np.uint8],
    corner: NDArray[np.uint8],
) -> NDArray[np.uint8]:
    """(k, bytes) what the filters (k, 1) guess of the pixels of a diagonal."""
    a, b, c = (part.astype(np.int16) for part in (left, above, corner))
    to_a, to_b, to_c = np.abs(b - c), np.abs(a - c), np.abs(a + b - 2 * c)
    nearest = np.where((to_a <= to_b) & (to_a <= to_c), a, np.where(to_b <= to_c, b, c))
    guess = np.where(filters == PAETH, nearest, 0)
    guess = np.where(filters == AVERAGE, (a + b) >> 1, guess)
    guess = np.where(filters == UP, b, guess)
    return np.where(filters == SUB, a, guess).astype(np.uint8)
