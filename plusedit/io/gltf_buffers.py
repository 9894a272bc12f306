"""Arrays in the buffers of a glTF document, taken only where the bytes are there."""

import base64
import binascii
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import PurePosixPath, PureWindowsPath
from typing import Any
from urllib.parse import unquote

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import Object, object_of, text, whole
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_cleaning import doubles

SideFiles = Callable[[str], bytes]
"""What is in the file of that name beside the document. FormatError in one sentence."""

COMPONENTS = {5120: "<i1", 5121: "<u1", 5122: "<i2", 5123: "<u2", 5125: "<u4", 5126: "<f4"}
WIDTHS = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}


def no_side_files(name: str) -> bytes:
    """The side files of a document that is read from memory: there are none."""
    raise FormatError(f"its data are in another file, {shown(name)}, which was not given")


def entry(tree: Object, key: str, index: object) -> Object:
    """Entry `index` of the list `key` of a document."""
    entries = tree.get(key, [])
    if type(index) is not int or not isinstance(entries, list) or not 0 <= index < len(entries):
        raise FormatError(f"{key}: there is no entry {shown(index)}")
    return object_of(entries[index], f"{key} {index}")


def natural(tree: Object, key: str, where: str, default: int | None = None) -> int:
    """A whole number of 0 or more."""
    if key not in tree:
        if default is None:
            raise FormatError(f"{where}: {key} is missing")
        return default
    value = whole(tree[key], f"{where}: {key}")
    if value < 0:
        raise FormatError(f"{where}: {key} is {value}, below zero")
    return value


@dataclass(eq=False)
class Buffers:
    """The bytes of a document, and the arrays in them."""

    tree: Object
    chunk: bytes | None
    """the binary part of a GLB file"""
    beside: SideFiles

    def __post_init__(self) -> None:
        self._bytes: dict[int, bytes] = {}

    def array(self, index: object, kind: str) -> Floats | NDArray[np.int64]:
        """(count, width) the numbers of an accessor, (count,) of scalars; `kind` as "VEC3"."""
        accessor = entry(self.tree, "accessors", index)
        where = f"accessors {index}"
        if accessor.get("type") != kind:
            raise FormatError(f"{where}: expected {kind}, got {shown(accessor.get('type'))}")
        if "sparse" in accessor or "bufferView" not in accessor:
            raise FormatError(f"{where}: is sparse, which is not read")
        code = accessor.get("componentType")
        if type(code) is not int or code not in COMPONENTS:
            raise FormatError(f"{where}: componentType {shown(code)} is none")
        item = np.dtype((COMPONENTS[code], (WIDTHS[kind],)))
        found = self._view(accessor, item, where)
        if item.base.kind == "f":
            return doubles(found)
        if accessor.get("normalized") is True:
            shares: Floats = np.maximum(found / np.iinfo(item.base).max, -1.0)
            return shares
        return found.astype(np.int64)

    def size(self) -> int:
        """How many bytes have been read."""
        return sum(map(len, self._bytes.values()))

    def _view(self, accessor: Object, item: "np.dtype[Any]", where: str) -> NDArray[Any]:
        """The items of an accessor as they lie in its buffer."""
        view = entry(self.tree, "bufferViews", accessor["bufferView"])
        within = f"bufferViews {accessor['bufferView']}"
        data = self._buffer(view.get("buffer"))
        begin, length = natural(view, "byteOffset", within, 0), natural(view, "byteLength", within)
        if begin + length > len(data):
            raise FormatError(
                f"{within}: ends at byte {begin + length} of a buffer of {len(data)} bytes"
            )
        stride = natural(view, "byteStride", within, 0) or item.itemsize
        count, offset = natural(accessor, "count", where), natural(accessor, "byteOffset", where, 0)
        needed = offset + (count - 1) * stride + item.itemsize if count else 0
        if needed > length or stride < item.itemsize:
            raise FormatError(
                f"{where}: promises {count} entries, more than its {length} bytes hold"
            )
        shape, strides = (count, *item.shape), (stride, item.base.itemsize)
        if not count:
            return np.zeros(shape, dtype=item.base)
        return np.ndarray(shape, item.base, data, begin + offset, strides)

    def _buffer(self, index: object) -> bytes:
        found = entry(self.tree, "buffers", index)
        where = f"buffers {index}"
        assert isinstance(index, int)
        if index not in self._bytes:
            if "uri" in found:
                data = self._content(text(found["uri"], f"{where}: uri"), where)
            elif index == 0 and self.chunk is not None:
                data = self.chunk
            else:
                raise FormatError(f"{where}: has no data")
            promised = natural(found, "byteLength", where)
            if promised > len(data):
                raise FormatError(f"{where}: promises {promised} bytes, but {len(data)} are there")
            self._bytes[index] = data
        return self._bytes[index]

    def _content(self, uri: str, where: str) -> bytes:
        scheme, colon, rest = uri.partition(":")
        if scheme.lower() == "data" and colon:
            head, comma, content = rest.partition(",")
            if not comma or not head.lower().endswith(";base64"):
                raise FormatError(f"{where}: its data are not written in base64")
            try:
                return base64.b64decode(content, validate=True)
            except (binascii.Error, ValueError):
                raise FormatError(f"{where}: its base64 is damaged") from None
        name = unquote(uri)
        if not _is_plain_name(name):
            raise FormatError(
                f"{where}: names a file elsewhere, {shown(uri)}; only files beside it are read"
            )
        return self.beside(name)


def _is_plain_name(name: str) -> bool:
    """Whether it names a file in the same folder, on every system."""
    return (
        0 < len(name) < 256
        and name.isprintable()
        and name not in (".", "..")
        and ":" not in name
        and PurePosixPath(name).name == name == PureWindowsPath(name).name
    )
