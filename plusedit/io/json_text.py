"""JSON as bytes: read without trusting it, written so that people can read it.

Python's own parser does the work. What it can't know is looked at before (how much there is) and
after (keys that stand twice); NaN and numbers beyond a double come out as such, so that whoever
knows what they were meant for can say where they stand.
"""

import codecs
import gc
import json
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from plusedit.document.shape import Json
from plusedit.io.formats import FormatError

LARGEST = 256 * 2**20  # bytes
MOST_BRACKETS = 4_000_000  # a list takes some 100 bytes of memory however short it is in the file
MOST_COMMAS = 20_000_000
LONGEST_WHOLE = 308  # digits of a whole number; longer ones are beyond a double, or take minutes
WIDTH = 100  # characters of a line, unless a single value is longer
LEAST = 3  # characters of an entry with its comma and space

ENCODINGS = {
    codecs.BOM_UTF8: "begins with a byte order mark; save it as UTF-8 without one",
    codecs.BOM_UTF16_LE: "is UTF-16 text; save it as UTF-8",
    codecs.BOM_UTF16_BE: "is UTF-16 text; save it as UTF-8",
}


@dataclass(frozen=True)
class Lines:
    """A long list, each entry of which is JSON already; it is written an entry a line."""

    entries: Sequence[str]


class _StandsTwiceError(Exception):
    """An object of the text has the same key twice."""


def parse(data: bytes) -> Json:
    """What a JSON text says. FormatError in one sentence, without the name of the file.

    NaN, Infinity and numbers too large for a double come back as floats that are not finite.
    """
    text = _decoded(data)
    try:
        with _nothing_collected():
            tree: Json = json.loads(text, parse_int=_whole, object_pairs_hook=_object)
    except json.JSONDecodeError as error:
        raise FormatError(_why(error)) from None
    except _StandsTwiceError as twice:
        raise FormatError(str(twice)) from None
    except RecursionError:
        raise FormatError("is nested too deeply") from None
    except MemoryError:
        raise FormatError("needs more memory than there is") from None
    return tree


def encode(value: object) -> str:
    """`value` as JSON on one line. ValueError if a number is not finite, TypeError if no JSON."""
    return _encoder.encode(value)


def layout(value: object, indent: str = "", *, opened: int = 0) -> str:
    """`value` as JSON, what is short on one line, but for the outermost `opened` levels."""
    if isinstance(value, Lines):
        return _block("[", value.entries, "]", indent)
    if not isinstance(value, list | tuple | Mapping) or not value:
        return encode(value)
    if not opened and LEAST * len(value) <= WIDTH:
        line = encode(value)
        if len(indent) + len(line) <= WIDTH:
            return line
    inner, deeper = indent + "  ", max(0, opened - 1)
    if isinstance(value, Mapping):
        parts = [f"{encode(k)}: {layout(v, inner, opened=deeper)}" for k, v in value.items()]
        return _block("{", parts, "}", indent)
    if any(isinstance(entry, list | tuple | Mapping) for entry in value):
        parts = [_row(entry) or layout(entry, inner, opened=deeper) for entry in value]
    else:
        parts = _filled([encode(entry) for entry in value], WIDTH - len(inner))
    return _block("[", parts, "]", indent)


def document(tree: Mapping[str, object], opened: Mapping[str, int]) -> bytes:
    """`tree` as the text of a file, a key a line; under some keys that many levels are broken.

    FormatError if it would be more than is read again.
    """
    parts = [f"{encode(k)}: {layout(v, '  ', opened=opened.get(k, 0))}" for k, v in tree.items()]
    data = to_bytes(_block("{", parts, "}", "") + "\n")
    _check_amount(data)
    return data


def to_bytes(text: str) -> bytes:
    """UTF-8; half a surrogate pair, which UTF-8 has not, as the escape that JSON has for it."""
    return text.encode("utf-8", "backslashreplace")


def _decoded(data: bytes) -> str:
    for mark, sentence in ENCODINGS.items():
        if data.startswith(mark):
            raise FormatError(sentence)
    if not data.strip():
        raise FormatError("is empty")
    _check_amount(data)
    try:
        return data.decode("utf-8")
    except UnicodeDecodeError as error:
        raise FormatError(f"is not UTF-8 text: byte {error.start} is wrong") from None


def _check_amount(data: bytes) -> None:
    if len(data) > LARGEST:
        raise FormatError(f"has {len(data)} bytes; more than {LARGEST} are not read")
    brackets = data.count(b"[")
    if brackets <= MOST_BRACKETS:
        brackets += data.count(b"{")
    if brackets > MOST_BRACKETS or data.count(b",") > MOST_COMMAS:
        raise FormatError("holds more values than can be read")


@contextmanager
def _nothing_collected() -> Iterator[None]:
    """What is parsed is no garbage; looking for some among all of it takes as long as parsing."""
    was_on = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if was_on:
            gc.enable()


def _why(error: json.JSONDecodeError) -> str:
    where = f"line {error.lineno}, column {error.colno}"
    unended = error.msg.startswith("Unterminated")
    if unended or error.pos >= len(error.doc.rstrip()):
        return f"is cut off: something begun is not ended at {where}"
    return f"is not JSON: {error.msg[:1].lower()}{error.msg[1:]} at {where}"


def _whole(digits: str) -> int | float:
    # A negative zero has no whole number.
    return int(digits) if len(digits) <= LONGEST_WHOLE and digits != "-0" else float(digits)


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    tree = dict(pairs)
    if len(tree) == len(pairs):
        return tree
    times = Counter(key for key, _ in pairs)
    key = next(key for key, count in times.items() if count > 1)
    owner = f"shape {shown(tree['id'])}: " if {"id", "kind"} <= tree.keys() else ""
    raise _StandsTwiceError(f"{owner}{shown(key)} stands twice in one object")


def shown(value: object, longest: int = 60) -> str:
    """A value as a sentence can quote it: in JSON's own writing, shortened, on one line."""
    if isinstance(value, list):
        return f"a list of {len(value)}"
    if isinstance(value, dict):
        return "an object"
    text = json.dumps(value, ensure_ascii=False)
    if not text.isprintable():
        text = json.dumps(value)
    return text if len(text) <= longest else text[: longest - 1] + "…"


def _plain(value: object) -> object:
    """What the encoder asks for when it meets something else than JSON."""
    if isinstance(value, Mapping):
        return dict(value)
    raise TypeError(f"{type(value).__name__} can't be written as JSON")


def _row(value: object) -> str | None:
    """A row of decimals or null, or None where `value` is more: the encoder takes far longer."""
    if value is None:
        return "null"
    if type(value) is not list or len(value) > 4:
        return None
    try:
        words = ", ".join(map(float.__repr__, value))
    except TypeError:
        return None
    # Numbers that are not finite are left to the encoder, which refuses them.
    return None if "n" in words else f"[{words}]"


def _block(opening: str, parts: Sequence[str], closing: str, indent: str) -> str:
    separator = f",\n{indent}  "
    return f"{opening}\n{indent}  {separator.join(parts)}\n{indent}{closing}"


def _filled(words: list[str], width: int) -> list[str]:
    """Lines of words with commas between, each as long as fits."""
    lines: list[list[str]] = [[]]
    length = 0
    for word in words:
        if lines[-1] and length + len(word) + 2 > width:
            lines.append([])
            length = 0
        lines[-1].append(word)
        length += len(word) + 2
    return [", ".join(line) for line in lines]


_encoder = json.JSONEncoder(ensure_ascii=False, allow_nan=False, default=_plain)
