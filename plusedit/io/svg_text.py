"""The text of SVG: numbers, path data, names and elements."""

import re
from collections.abc import Mapping
from math import floor, log10
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from plusedit.geometry.arrays import Floats

LETTERS = {2: "L", 3: "Q", 4: "C"}
"""The command that draws a Bezier curve of so many points"""

ROUNDING = 8 * float(np.finfo(np.float64).eps)  # of the largest number: what arithmetic leaves

# The letters that XML allows in names, but for the colon, and beside them digits and a few marks.
LETTER = (
    "A-Z_a-z\u00c0-\u00d6\u00d8-\u00f6\u00f8-\u02ff\u0370-\u037d\u037f-\u1fff\u200c\u200d"
    "\u2070-\u218f\u2c00-\u2fef\u3001-\ud7ff\uf900-\ufdcf\ufdf0-\ufffd"
)
NOT_IN_NAMES = re.compile(rf"[^{LETTER}\-.0-9\u00b7\u0300-\u036f]")
BEGINS_A_NAME = re.compile(rf"[{LETTER}]")
NOT_IN_XML = re.compile("[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def number(value: float) -> str:
    """A number in as few digits as make the same double."""
    text = repr(float(value))
    text = text.removesuffix(".0")
    return "0" if text == "-0" else text


def path_data(chain: list[Floats], *, closed: bool) -> str:
    """The attribute `d` of Bezier curves (2 to 4, 2) that begin where the one before ends.

    Numbers have 15 digits of the largest one where that is what they are but for rounding, and
    otherwise as many as make the same double. y is turned down.
    """
    largest = max(float(np.abs(piece).max()) for piece in chain)
    digits = 14 - floor(log10(largest)) if largest > 0.0 else 0
    chain = [_plain(piece * (1.0, -1.0), digits, ROUNDING * largest) for piece in chain]
    commands = [f"M{_rows(chain[0][:1])}"]
    pieces = chain
    # Z draws the last line itself.
    if closed and len(chain[-1]) == 2 and (chain[-1][-1] == chain[0][0]).all():
        pieces = chain[:-1]
    commands += [LETTERS[len(piece)] + _rows(piece[1:]) for piece in pieces]
    if closed:
        commands.append("Z")
    return " ".join(commands)


def _plain(points: Floats, digits: int, rounding: float) -> Floats:
    """The points with so many digits behind the point where they are that within rounding."""
    if not abs(digits) <= 300:
        return points
    plain = np.array([[round(x, digits) for x in row] for row in points.tolist()])
    return np.where(np.abs(plain - points) <= rounding, plain, points)


def _rows(points: Floats) -> str:
    return " ".join(f"{number(x)} {number(y)}" for x, y in points.tolist())


def element(tag: str, attributes: Mapping[str, str], inside: str = "", *, text: str = "") -> str:
    """An element with `inside` as it stands, or with `text` escaped."""
    named = "".join(f" {key}={quoteattr(clean(value))}" for key, value in attributes.items())
    inside = inside or escape(clean(text))
    return f"<{tag}{named}>{inside}</{tag}>" if inside else f"<{tag}{named}/>"


def clean(text: str) -> str:
    """The text without characters that XML can't hold."""
    return NOT_IN_XML.sub("", text)


class Names:
    """Ids of one file: names that XML allows, each once."""

    def __init__(self) -> None:
        self._used: set[str] = set()
        self._numbers: dict[str, int] = {}

    def unused(self, wanted: str) -> str:
        """`wanted`, as far as it is a name, with a number behind it if it is taken."""
        stem = NOT_IN_NAMES.sub("_", wanted)
        if not BEGINS_A_NAME.match(stem):
            stem = f"_{stem}"
        name = stem
        while name in self._used:
            self._numbers[stem] = self._numbers.get(stem, 1) + 1
            name = f"{stem}-{self._numbers[stem]}"
        self._used.add(name)
        return name
