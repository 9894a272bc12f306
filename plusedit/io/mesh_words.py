"""Texts as words, found with arrays instead of line by line.

A text is taken in blocks of whole lines: what is needed beside the text itself stays small
however large the file is.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_text import name_of

Bytes = NDArray[np.uint8]
Places = NDArray[np.int64]

BLOCK = 1 << 22  # characters
LONGEST_LINE = 1 << 25
CODED = 8  # characters of a keyword that tell it from others
NEW_LINE, BLANK = b"\n "
SMALL = np.uint8(ord("a") - ord("A"))

NO_NUMBER = re.compile(r"[+-]?(1\.#(ind|qnan|snan)\d*|nan\([\w-]*\))", re.ASCII | re.IGNORECASE)
NO_FINITE = re.compile(r"([+-]?)1\.#inf\d*", re.ASCII | re.IGNORECASE)


def code(keyword: bytes) -> int:
    """What `Words.codes` gives for that keyword."""
    return int.from_bytes(keyword[:CODED], "little")


def lines_in(text: bytes) -> int:
    """How many lines of a file end in a text; "\\v" stands where two were put together."""
    return text.count(b"\n") + text.count(b"\v")


def blocks(text: bytes, line: int = 1) -> "Iterator[Words]":
    """The words of a text that begins with that line of a file and ends with a line's end.

    FormatError if a line is absurdly long.
    """
    at = 0
    while at < len(text):
        end = text.find(b"\n", min(at + BLOCK, len(text) - 1)) + 1 or len(text)
        words = Words(text[at:end], line)
        if words.longest_line > LONGEST_LINE:
            raise FormatError(f"has a line of more than {LONGEST_LINE >> 20} million characters")
        yield words
        at, line = end, line + lines_in(words.text)


@dataclass(frozen=True, eq=False)
class Words:
    """Where the words of a text stand, separated by whatever is no printing character."""

    text: bytes
    """whole lines, each with "\\n" at its end"""
    first_line: int = 1
    """the number of its first line in the file; a "\\v" counts as the end of a line too"""

    @cached_property
    def characters(self) -> Bytes:
        """(t,) of the text."""
        return np.frombuffer(self.text, dtype=np.uint8)

    @cached_property
    def _places(self) -> tuple[Places, Places]:
        """(w,) where words begin and end."""
        printing = np.zeros(len(self.text) + 1, dtype=np.bool_)
        np.greater(self.characters, BLANK, out=printing[1:])
        changes = np.flatnonzero(printing[1:] != printing[:-1])
        # The text ends with a blank: changes come in pairs.
        return changes[::2], changes[1::2]

    @property
    def starts(self) -> Places:
        """(w,) the first character of every word."""
        return self._places[0]

    @property
    def ends(self) -> Places:
        """(w,) the blank after every word."""
        return self._places[1]

    @cached_property
    def _line_ends(self) -> Places:
        return np.flatnonzero(self.characters == NEW_LINE)

    @property
    def longest_line(self) -> int:
        """How many characters it has."""
        return int(np.diff(self._line_ends, prepend=-1).max(initial=0))

    @cached_property
    def firsts(self) -> Places:
        """(l + 1,) the first word of every line, and w."""
        after = np.searchsorted(self.starts, self._line_ends)
        return np.concatenate([np.zeros(1, dtype=np.int64), after])

    @cached_property
    def counts(self) -> Places:
        """(l,) how many words every line has."""
        return np.diff(self.firsts)

    def line_end(self, line: int) -> int:
        """Where the end of a line stands in the text."""
        return int(self._line_ends[line])

    def codes(self, words: Any, *, fold: bool = False) -> NDArray[np.uint64]:
        """Of some words their first eight characters as a number, to compare with `code`.

        With `fold`, capital letters count as small ones.
        """
        starts = self.starts[words]
        lengths = self.ends[words] - starts
        codes = np.zeros(len(starts), dtype=np.uint64)
        for i in range(min(CODED, int(lengths.max(initial=0)))):
            letters = self.characters[np.minimum(starts + i, len(self.text) - 1)]
            if fold:
                letters = letters | SMALL
            codes |= np.where(i < lengths, letters, 0).astype(np.uint64) << np.uint64(8 * i)
        return codes

    def joined(self, words: Places) -> bytes:
        """Some words, ascending, with one blank after each."""
        marks = np.zeros(len(self.text) + 1, dtype=np.int8)
        marks[self.starts[words]] = 1
        marks[self.ends[words] + 1] -= 1
        taken: NDArray[np.bool_] = np.cumsum(marks[:-1], dtype=np.int8).view(np.bool_)
        return self.characters[taken].tobytes()

    def of_lines(self, lines: Places) -> Places:
        """The words of some lines without the first of each, ascending."""
        counts = self.counts[lines] - 1
        begins = self.firsts[lines] + 1
        shifts = np.cumsum(counts) - counts
        places: Places = np.arange(int(counts.sum())) + np.repeat(begins - shifts, counts)
        return places

    def numbers(self, words: Places) -> Floats:
        """What some words, ascending, say as numbers, "nan" and "inf" among them.

        FormatError names the line of a word that is none.
        """
        joined = self.joined(words)
        if b"_" not in joined:  # float() would skip it
            try:
                return np.fromiter(map(float, joined.split()), dtype=np.float64, count=len(words))
            except ValueError:
                pass
        return np.array([self._number(word) for word in words.tolist()])

    def word(self, number: int) -> bytes:
        """The word of that number."""
        return self.text[self.starts[number] : self.ends[number]]

    def where(self, word: int) -> str:
        """Such as "line 12", for sentences."""
        return f"line {self.first_line + lines_in(self.text[: self.starts[word]])}"

    def _number(self, word: int) -> float:
        raw = self.word(word)
        try:
            if b"_" not in raw:
                return float(raw)
        except ValueError:
            pass
        text = name_of(raw)
        if NO_NUMBER.fullmatch(text):
            return float("nan")
        if infinite := NO_FINITE.fullmatch(text):
            return float(f"{infinite[1]}inf")
        hint = ""
        if re.fullmatch(r"[+-]?\d*,\d+", text, re.ASCII):
            hint = "; decimals are written with a point"
        raise FormatError(f"{self.where(word)}: {shown(text)} is no number{hint}")
