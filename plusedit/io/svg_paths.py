"""Path data: the attribute `d` of SVG, as outlines.

As the specification asks, an error ends the path there: what came before it is kept.
"""

import re
from dataclasses import dataclass, field
from math import isfinite

from plusedit.io.formats import FormatError
from plusedit.io.svg_pieces import Outline, Point

NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?")
BLANKS = re.compile(r"[ \t\r\n\f]*")
COMMA = re.compile(r"[ \t\r\n\f]*,?[ \t\r\n\f]*")
FARTHEST = 1e90  # coordinates beyond can't be calculated with
MOST_PIECES = 100_000  # of one path; a drawing may have no more either

ARGUMENTS = {"m": 2, "l": 2, "h": 1, "v": 1, "c": 6, "s": 4, "q": 4, "t": 2, "a": 7, "z": 0}
"""How many numbers each command takes, over and over until the next command"""


@dataclass
class PathData:
    """Outlines of one path."""

    outlines: list[Outline] = field(default_factory=list)
    error: str | None = None
    """where and why reading stopped, None if it did not"""


def parse_path(text: str) -> PathData:
    """The outlines of path data; its `error` says what ended them early.

    FormatError where there are too many of them.
    """
    path = _Path()
    scanner = _Scanner(text)
    try:
        path.run(scanner)
    except _PathError as error:
        path.data.error = f"{error} at character {scanner.position + 1}"
    path.data.outlines = [outline for outline in path.data.outlines if outline.pieces]
    return path.data


def numbers_of(text: str) -> list[float]:
    """The numbers of a list such as the attribute `points`, up to the first that is none.

    FormatError where there are too many of them.
    """
    scanner = _Scanner(text)
    numbers: list[float] = []
    while scanner.at_number():
        if len(numbers) > 2 * MOST_PIECES:
            raise too_many_pieces()
        try:
            numbers.append(scanner.number())
        except _PathError:
            break
    return numbers


def too_many_pieces() -> FormatError:
    """The error that says so."""
    return FormatError(f"draws more than {MOST_PIECES:,} lines and curves")


class _PathError(ValueError):
    """Path data that is none."""


class _Scanner:
    """Reads numbers, flags and commands from left to right."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.position = 0
        self._skip(BLANKS)

    def _skip(self, pattern: re.Pattern[str]) -> None:
        found = pattern.match(self.text, self.position)
        assert found is not None  # these patterns match nothing at all, too
        self.position = found.end()

    def command(self) -> str:
        """The next letter, "" at the end."""
        self._skip(BLANKS)
        letter = self.text[self.position : self.position + 1]
        if letter and letter.lower() not in ARGUMENTS:
            raise _PathError(f"{letter!r} is no command")
        self.position += len(letter)
        self._skip(BLANKS)
        return letter

    def at_number(self) -> bool:
        """Whether a number comes next."""
        return NUMBER.match(self.text, self.position) is not None

    def number(self) -> float:
        """The next number, and the comma behind it."""
        found = NUMBER.match(self.text, self.position)
        if found is None:
            raise _PathError("a number is missing")
        value = float(found.group())
        if not isfinite(value) or abs(value) > FARTHEST:
            raise _PathError(f"{found.group()[:20]} is too large a number")
        self.position = found.end()
        self._skip(COMMA)
        return value

    def flag(self) -> float:
        """The next 0 or 1, which need not be set off from what follows."""
        digit = self.text[self.position : self.position + 1]
        if digit not in ("0", "1"):
            raise _PathError("a flag 0 or 1 is missing")
        self.position += 1
        self._skip(COMMA)
        return float(digit)


class _Path:
    """Draws commands one after the other."""

    def __init__(self) -> None:
        self.data = PathData()
        self._at: Point = (0.0, 0.0)
        self._count = 0
        self._mirrored: tuple[str, Point] = ("", (0.0, 0.0))
        """the kind of the last curve, c or q, and its last control point"""

    def run(self, scanner: _Scanner) -> None:
        """Draw all commands. _PathError at the first that is none."""
        letter = scanner.command()
        if letter and letter not in "mM":
            raise _PathError("a path begins with M")
        while letter:
            kind, relative = letter.lower(), letter.islower()
            if kind == "z":
                self._close()
            else:
                self._draw(kind, relative, self._arguments(kind, scanner))
                while scanner.at_number():
                    kind = "l" if kind == "m" else kind
                    self._draw(kind, relative, self._arguments(kind, scanner))
            letter = scanner.command()

    @staticmethod
    def _arguments(kind: str, scanner: _Scanner) -> list[float]:
        if kind != "a":
            return [scanner.number() for _ in range(ARGUMENTS[kind])]
        radii_and_turn = [scanner.number() for _ in range(3)]
        flags = [scanner.flag() for _ in range(2)]
        return [*radii_and_turn, *flags, scanner.number(), scanner.number()]

    def _close(self) -> None:
        outline = self._outline()
        outline.close()
        self._at = outline.start
        self._mirrored = ("", self._at)

    def _outline(self) -> Outline:
        """The outline under way; after Z another one begins where the last did."""
        if self.data.outlines[-1].closed:
            self.data.outlines.append(Outline(self._at))
        return self.data.outlines[-1]

    def _draw(self, kind: str, relative: bool, numbers: list[float]) -> None:
        self._count += 1
        if self._count > MOST_PIECES:
            raise too_many_pieces()
        x, y = self._at if relative else (0.0, 0.0)
        mirrored = ("", self._at)
        if kind == "m":
            self._at = (x + numbers[0], y + numbers[1])
            self.data.outlines.append(Outline(self._at))
        elif kind == "h":
            self._outline().add((x + numbers[0], self._at[1]))
        elif kind == "v":
            self._outline().add((self._at[0], y + numbers[0]))
        elif kind == "a":
            rx, ry, turn, large, sweep, *end = numbers
            to = (x + end[0], y + end[1])
            self._outline().add_arc((rx, ry), turn, large == 1.0, sweep == 1.0, to)
            self._at = to
        else:
            pairs = zip(numbers[::2], numbers[1::2], strict=True)
            points = [(x + dx, y + dy) for dx, dy in pairs]
            if kind in "st":
                kind = "c" if kind == "s" else "q"
                points.insert(0, self._reflection(kind))
            self._outline().add(*points)
            if kind in "cq":
                mirrored = (kind, points[-2])
        if kind != "m":
            self._at = self._outline_end()
        self._mirrored = mirrored

    def _outline_end(self) -> Point:
        return self.data.outlines[-1].end

    def _reflection(self, kind: str) -> Point:
        """The first control point of S and T: the last one of a curve of that kind mirrored."""
        last, (x, y) = self._mirrored
        if last != kind:
            return self._at
        return 2.0 * self._at[0] - x, 2.0 * self._at[1] - y
