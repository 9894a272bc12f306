"""NumPy's own files without NumPy's own reader, which believes what they say of their size."""

import math
import re
import zlib
from dataclasses import dataclass
from io import BytesIO
from typing import Any
from zipfile import BadZipFile, ZipFile

import numpy as np
from numpy.typing import NDArray

from plusedit.io.formats import FormatError
from plusedit.io.json_text import LARGEST, shown
from plusedit.io.mesh_text import name_of

MAGIC = b"\x93NUMPY"
LONGEST_HEADER = 1 << 16
MOST_ARRAYS = 1000
KIND = re.compile(rb"'descr'\s*:\s*'([<>|=]?[biuf]\d{1,2})'")
FORTRAN = re.compile(rb"'fortran_order'\s*:\s*(True|False)")
SHAPE = re.compile(rb"'shape'\s*:\s*\(([\d,\sL]{0,100})\)")

Array = NDArray[Any]


@dataclass(frozen=True)
class _Header:
    kind: "np.dtype[Any]"
    fortran: bool
    shape: tuple[int, ...]
    end: int


def read_npy(data: bytes) -> Array:
    """The array of numbers in an .npy file. FormatError if it holds something else or less."""
    header = _header(data)
    count = math.prod(header.shape)
    there = (len(data) - header.end) // header.kind.itemsize
    if count > there:
        shape = " × ".join(map(str, header.shape)) or "1"
        raise FormatError(f"is cut off: promises {shape} numbers, but has {there}")
    numbers = np.frombuffer(data, dtype=header.kind, count=count, offset=header.end)
    return numbers.reshape(header.shape, order="F" if header.fortran else "C")


def read_npz(data: bytes) -> dict[str, Array]:
    """The arrays of numbers in an .npz file by name; others are left out."""
    try:
        with ZipFile(BytesIO(data)) as archive:
            members = [info for info in archive.infolist() if info.filename.endswith(".npy")]
            if len(members) > MOST_ARRAYS:
                raise FormatError(f"holds more than {MOST_ARRAYS} arrays")
            if sum(info.file_size for info in members) > LARGEST:
                raise FormatError(f"holds more than {LARGEST >> 20} MB, unpacked")
            raw = {}
            for info in members:
                with archive.open(info) as member:
                    # No more than promised, whatever is packed there.
                    raw[name_of(info.filename[:-4].encode())] = member.read(info.file_size)
    except (BadZipFile, zlib.error, EOFError, OSError):
        raise FormatError("is damaged: its arrays can't be unpacked") from None
    except (NotImplementedError, RuntimeError):
        raise FormatError("is packed or locked in a way that is not read") from None
    arrays = {}
    for name, content in raw.items():
        if content.startswith(MAGIC) and KIND.search(content, 0, LONGEST_HEADER):
            arrays[name] = read_npy(content)
    return arrays


def _header(data: bytes) -> _Header:
    if not data.startswith(MAGIC) or len(data) < 12:
        raise FormatError("is no NumPy array")
    width = 2 if data[6] == 1 else 4
    begin = 8 + width
    end = begin + int.from_bytes(data[8:begin], "little")
    if end > len(data) or end > LONGEST_HEADER:
        raise FormatError("is cut off, or no NumPy array: its header is not whole")
    text = data[begin:end]
    kind, fortran, shape = (found.search(text) for found in (KIND, FORTRAN, SHAPE))
    if not (kind and fortran and shape):
        raise FormatError("is an array of something else than plain numbers")
    try:
        dtype = np.dtype(kind[1].decode())
    except TypeError:
        raise FormatError(f"is an array of unknown numbers {shown(name_of(kind[1]))}") from None
    sizes = [part.strip(b" L\n\t") for part in shape[1].split(b",")]
    numbers = tuple(int(part) for part in sizes if part.isdigit())
    return _Header(dtype, fortran[1] == b"True", numbers, end)
