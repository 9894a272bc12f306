"""Files of text with meshes in them: what they begin with, how their lines end."""

import codecs

import numpy as np

from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown

CONTENTS = {
    b"\x89PNG\r\n\x1a\n": "a PNG picture",
    b"\xff\xd8\xff": "a JPEG picture",
    b"GIF8": "a GIF picture",
    b"%PDF-": "a PDF document",
    b"PK\x03\x04": "a ZIP archive",
    b"\x1f\x8b": "compressed by gzip",
    b"glTF": "a GLB file",
    b"\x93NUMPY": "a NumPy array",
    b"II*\0": "a TIFF picture",
    b"MM\0*": "a TIFF picture",
    b"ply\n": "a PLY file",
    b"ply\r": "a PLY file",
    b"<svg": "an SVG drawing",
    b"<!DOCTYPE": "a web page",
    b"<!doctype": "a web page",
    b"<html": "a web page",
}
HASH, NEW_LINE, BLANK = b"#\n "


def check_content(data: bytes, wanted: str) -> None:
    """FormatError if there is nothing, or something that is known and not `wanted`."""
    if not data or data.isspace():
        raise FormatError("is empty")
    for mark, found in CONTENTS.items():
        if data.startswith(mark):
            raise FormatError(f"is {found}, not {wanted}")


def plain_text(data: bytes, wanted: str) -> bytes:
    """The text of a file that ends every line with "\\n", without a byte order mark.

    UTF-16 becomes UTF-8; other bytes stay as they are. FormatError if it is no text, saying that
    it is not `wanted`, such as "an OBJ file".
    """
    check_content(data, wanted)
    if data.startswith((codecs.BOM_UTF16_LE, codecs.BOM_UTF16_BE)):
        try:
            data = data.decode("utf-16").encode("utf-8", "replace")
        except UnicodeDecodeError:
            raise FormatError("begins as UTF-16 text, but is none") from None
    data = data.removeprefix(codecs.BOM_UTF8)
    if b"\0" in data:
        raise FormatError(f"is a binary file, not {wanted}")
    if b"\r" in data:
        data = data.replace(b"\r\n", b"\n").replace(b"\r", b"\n")
    if not data or data.isspace():
        raise FormatError("is empty")
    return data if data.endswith(b"\n") else data + b"\n"


def without_comments(text: bytes) -> bytes:
    """The text without what follows a # at the beginning of a word, line by line."""
    if b"#" not in text:
        return text
    characters = np.frombuffer(text, dtype=np.uint8)
    hashes = np.flatnonzero(characters == HASH)
    hashes = hashes[(hashes == 0) | (characters[hashes - 1] <= BLANK)]
    line_ends = np.flatnonzero(characters == NEW_LINE)
    lines, first = np.unique(np.searchsorted(line_ends, hashes), return_index=True)
    marks = np.zeros(len(text), dtype=np.int8)
    marks[hashes[first]] = 1
    marks[line_ends[lines]] = -1
    kept = np.cumsum(marks, dtype=np.int8) == 0
    stripped: bytes = characters[kept].tobytes()
    return stripped


def name_of(raw: bytes) -> str:
    """A name in a file, fit to be shown: UTF-8, or else Latin-1."""
    try:
        text = raw.decode("utf-8")
    except UnicodeDecodeError:
        text = raw.decode("latin-1")
    text = " ".join(text.split())
    return text if text.isprintable() else shown(text)[1:-1]
