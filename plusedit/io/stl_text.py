"""STL as text: solids of facets, each a loop of vertices."""

from dataclasses import dataclass, field

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import ReadMesh
from plusedit.io.mesh_text import name_of
from plusedit.io.mesh_words import Places, Words, blocks, code

VERTEX, LOOP, SOLID, END = (code(word) for word in (b"vertex", b"endloop", b"solid", b"endsolid"))
MOST_SOLIDS = 20_000


def facets_of(text: bytes) -> ReadMesh:
    """The facets of a text, their points not yet welded. FormatError names the line."""
    reading = _Reading()
    for words in blocks(text):
        reading.add(words)
    return reading.mesh()


@dataclass(eq=False)
class _Reading:
    """Gathers what the blocks hold."""

    points: list[Floats] = field(default_factory=list)
    loop_ends: list[Places] = field(default_factory=list)
    """how many vertices stand before each"""
    labels: list[Places] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    count: int = 0
    is_open: bool = False
    """whether a solid is begun and not ended"""

    def add(self, words: Words) -> None:
        """Take in the next lines."""
        lines = np.flatnonzero(words.counts)
        codes = words.codes(slice(None), fold=True)
        firsts = codes[words.firsts[lines]]
        named = lines[(firsts == SOLID) | (firsts == END)]
        codes[words.of_lines(named)] = 0  # a name can be any word
        vertices, loops = np.flatnonzero(codes == VERTEX), np.flatnonzero(codes == LOOP)
        self._add_solids(words, lines[firsts == SOLID], loops)
        self._add_points(words, vertices)
        self.loop_ends.append(self.count + np.searchsorted(vertices, loops))
        self.count += len(vertices)
        if len(named):
            self.is_open = bool(codes[words.firsts[named[-1]]] == SOLID)

    def mesh(self) -> ReadMesh:
        """All that was gathered."""
        ends = np.concatenate([np.zeros(1, dtype=np.int64), *self.loop_ends])
        if ends[-1] != self.count:
            raise FormatError(
                f"is cut off: after {of_number(len(ends) - 1, 'facet')} a loop is open"
            )
        notes = []
        if self.is_open:
            notes.append("endsolid is missing: the file may be cut off")
        points = np.concatenate([np.zeros((0, 3)), *self.points])
        labels = np.concatenate(self.labels) if len(self.names) <= MOST_SOLIDS else None
        corners = np.arange(self.count)
        return ReadMesh(
            points, corners, np.diff(ends), None, None, labels, self.names, notes, first=1
        )

    def _add_points(self, words: Words, vertices: Places) -> None:
        if len(vertices) and vertices[-1] + 3 >= len(words.starts):
            raise FormatError(f"{words.where(int(vertices[-1]))}: a vertex has no three numbers")
        numbers = (vertices[:, None] + np.arange(1, 4)).ravel()
        self.points.append(words.numbers(numbers).reshape(-1, 3))

    def _add_solids(self, words: Words, solids: Places, loops: Places) -> None:
        label = len(self.names) - 1
        room = max(0, MOST_SOLIDS + 1 - len(self.names))
        for line in solids[:room].tolist():
            begin = words.ends[words.firsts[line]]
            self.names.append(name_of(words.text[begin : words.line_end(line)]) or "solid")
        self.labels.append(label + np.searchsorted(words.firsts[solids[:room]], loops))
