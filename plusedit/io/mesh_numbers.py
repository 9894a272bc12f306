"""Texts that are numbers throughout, in lines or in one row."""

import re
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number
from plusedit.io.formats import FormatError
from plusedit.io.mesh_words import BLOCK, Bytes, Places, Words, blocks, lines_in

BLANKS = re.compile(rb"[\0-\x20]")


def numbers_of(text: bytes) -> Floats:
    """(k,) all words of a text as numbers. FormatError names the line of one that is none."""
    parts = [np.zeros(0)]
    at, line = 0, 1
    while at < len(text):
        # Any blank will do: a text may have no second line.
        cut = BLANKS.search(text, min(at + BLOCK, len(text) - 1))
        end = cut.end() if cut else len(text)
        words = Words(text[at:end], line)
        parts.append(words.numbers(np.arange(len(words.starts))))
        at, line = end, line + lines_in(words.text)
    return np.concatenate(parts)


@dataclass(frozen=True, eq=False)
class LineNumbers:
    """The numbers of a text, line by line, without empty lines."""

    values: Floats
    """(k,) of all lines"""
    firsts: Places
    """(l + 1,) the first number of every line, and k"""
    lines: Places
    """(l,) which line of the file each is"""

    @cached_property
    def counts(self) -> Places:
        """(l,) how many numbers every line has."""
        return np.diff(self.firsts)

    def row(self, line: int) -> Floats:
        """The numbers of one line."""
        return self.values[self.firsts[line] : self.firsts[line + 1]]

    def rows(self, begin: int, end: int, least: int, what: str) -> Floats:
        """(end - begin, least) the first numbers of some lines.

        FormatError says that `what` stands in a line and has too few.
        """
        if (short := self.counts[begin:end] < least).any():
            line = begin + int(short.argmax())
            count = of_number(int(self.counts[line]), "number")
            raise FormatError(f"{self.where(line)}: {what} has {count}, expected {least}")
        found: Floats = self.values[self.firsts[begin:end, None] + np.arange(least)]
        return found

    def where(self, line: int) -> str:
        """Such as "line 12", for sentences."""
        return f"line {self.lines[line]}"


def line_numbers(text: bytes, first_line: int = 1) -> LineNumbers:
    """The numbers of a text. FormatError names the line of a word that is none."""
    values, counts, lines = [np.zeros(0)], [np.zeros(0, np.int64)], [np.zeros(0, np.int64)]
    for words in blocks(text, first_line):
        filled = np.flatnonzero(words.counts)
        values.append(words.numbers(np.arange(len(words.starts))))
        counts.append(words.counts[filled])
        lines.append(words.first_line + filled)
    firsts = np.concatenate([np.zeros(1, np.int64), np.cumsum(np.concatenate(counts))])
    return LineNumbers(np.concatenate(values), firsts, np.concatenate(lines))


def whole_numbers(characters: Bytes, starts: Places, ends: Places) -> Places:
    """(w,) the whole numbers that stand at those places, digits with a sign or none before them.

    Numbers of more than 18 digits come out as 10**18 with their sign. ValueError with the index
    of the first that is no number.
    """
    signs = characters[starts]
    negative = signs == ord("-")
    starts = starts + (negative | (signs == ord("+")))
    lengths = ends - starts
    values = np.zeros(len(starts), dtype=np.int64)
    wrong = lengths < 1
    for i in range(min(18, int(lengths.max(initial=0)))):
        inside = i < lengths
        digits = characters[np.minimum(starts + i, len(characters) - 1)].astype(np.int64) - ord("0")
        wrong |= inside & ((digits < 0) | (digits > 9))
        values = np.where(inside, 10 * values + digits, values)
    if wrong.any():
        raise ValueError(int(wrong.argmax()))
    values[lengths > 18] = 10**18
    return np.where(negative, -values, values)
