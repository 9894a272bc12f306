"""The statements of an OBJ file, a block of lines at a time.

Numbers of vertices begin with 1; a negative one counts backwards from the vertices that stand
before the face.
"""

from collections import Counter
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_cleaning import ReadMesh, vertices, were
from plusedit.io.mesh_numbers import whole_numbers
from plusedit.io.mesh_text import name_of
from plusedit.io.mesh_words import Bytes, Places, Words, code

Codes = NDArray[np.uint64]

V, VT, F, FO = code(b"v"), code(b"vt"), code(b"f"), code(b"fo")
GROUPS = (code(b"g"), code(b"o"))
SHORT_KINDS = {code(b"l"): "line", code(b"p"): "point"}
FREE_FORM = tuple(code(word) for word in (b"curv", b"curv2", b"surf"))
SILENT = (
    *(b"vn", b"vp", b"s", b"mg", b"usemtl", b"mtllib", b"usemap", b"maplib", b"lod", b"bevel"),
    *(b"c_interp", b"d_interp", b"shadow_obj", b"trace_obj", b"cstype", b"deg", b"bmat", b"step"),
    *(b"parm", b"trim", b"hole", b"scrv", b"sp", b"end", b"con", b"ctech", b"stech", b"call"),
)
"""Statements that say nothing of faces"""
KNOWN = np.array([V, VT, F, FO, *GROUPS, *SHORT_KINDS, *FREE_FORM, *map(code, SILENT)], np.uint64)
MOST_GROUPS = 20_000
SLASH = ord("/")


class Corners(NamedTuple):
    """The corners of the faces of a block."""

    vertex: Places
    """as written: from 1, or negative"""
    uv: Places
    """likewise; 0 where there is none"""


@dataclass(eq=False)
class ObjReading:
    """Gathers what the blocks hold."""

    _points: list[Floats] = field(default_factory=list)
    _uv: list[Floats] = field(default_factory=list)
    _corners: list[Places] = field(default_factory=list)
    _uv_corners: list[Places] = field(default_factory=list)
    _sizes: list[Places] = field(default_factory=list)
    _labels: list[Places] = field(default_factory=list)
    _names: list[str] = field(default_factory=list)
    _kinds: Counter[str] = field(default_factory=Counter)
    _point_count: int = 0
    _uv_count: int = 0
    _face_count: int = 0
    _uv_is_sound: bool = True

    def add(self, words: Words) -> None:
        """Take in the next lines. FormatError names the first that is wrong."""
        lines = np.flatnonzero(words.counts)
        kinds = words.codes(words.firsts[lines])
        points, uv = lines[kinds == V], lines[kinds == VT]
        is_face = (kinds == F) | (kinds == FO)
        faces = lines[is_face]
        self._add_groups(words, lines, kinds, faces)
        self._add_faces(words, faces, points, uv)
        self._add_points(words, points)
        self._add_uv(words, uv)
        self._count_others(kinds)

    def mesh(self) -> ReadMesh:
        """All that was gathered."""
        points = np.concatenate([np.zeros((0, 3)), *self._points])
        corners = np.concatenate([np.zeros(0, dtype=np.int64), *self._corners]) - 1
        sizes = np.concatenate([np.zeros(0, dtype=np.int64), *self._sizes])
        notes: list[str] = []
        uv = self._uv_of_corners(notes)
        labels = (
            None if len(self._names) > MOST_GROUPS else np.concatenate([*self._labels, sizes[:0]])
        )
        if labels is None:
            notes.append(f"more than {MOST_GROUPS} groups of faces were ignored")
        notes += (
            f"{_of(count, kind)} {were(count)} left out"
            for kind in ("unknown statement", "free-form curve or surface", "line", "point")
            if (count := self._kinds[kind])
        )
        kinds = " and ".join(k + "s" for k in ("line", "point") if self._kinds[k])
        return ReadMesh(
            points, corners, sizes, uv, None, labels, self._names, notes, first=1, kinds=kinds
        )

    def _add_points(self, words: Words, lines: Places) -> None:
        if not len(lines):
            return
        if (short := words.counts[lines] < 4).any():
            line = lines[short.argmax()]
            count = of_number(int(words.counts[line]) - 1, "number")
            raise FormatError(f"{words.where(words.firsts[line])}: a vertex has {count}, not three")
        first = words.firsts[lines]
        self._points.append(words.numbers(_beside(first, 3)).reshape(-1, 3))
        self._point_count += len(lines)

    def _add_uv(self, words: Words, lines: Places) -> None:
        if not len(lines):
            return
        self._uv_count += len(lines)
        if (words.counts[lines] < 3).any():
            self._uv_is_sound = False
        if self._uv_is_sound:
            try:
                found = words.numbers(_beside(words.firsts[lines], 2))
            except FormatError:
                self._uv_is_sound = False
            else:
                self._uv.append(found.reshape(-1, 2))

    def _add_faces(self, words: Words, lines: Places, points: Places, uv: Places) -> None:
        if not len(lines):
            return
        sizes = words.counts[lines] - 1
        chosen = words.of_lines(lines)
        corners = _corners(words, chosen)
        owner = np.repeat(np.arange(len(lines)), sizes)
        before = self._point_count + np.searchsorted(points, lines)[owner]
        vertex = np.where(corners.vertex < 0, corners.vertex + before + 1, corners.vertex)
        wrong = (vertex < 1) | (vertex >= 10**18)
        if wrong.any():
            corner = int(wrong.argmax())
            number = name_of(words.word(int(chosen[corner]))).partition("/")[0]
            face = self._face_count + int(owner[corner]) + 1
            what = f"{words.where(int(chosen[corner]))}: face {face} names vertex {number}"
            if not corners.vertex[corner]:
                raise FormatError(f"{what}, but they are numbered from 1")
            raise FormatError(f"{what}, but there are {vertices(int(before[corner]))} before it")
        before = self._uv_count + np.searchsorted(uv, lines)[owner]
        self._corners.append(vertex)
        # What counts back beyond the first is wrong, not missing.
        counted = np.where(corners.uv < -before, -1, corners.uv + before + 1)
        self._uv_corners.append(np.where(corners.uv < 0, counted, corners.uv))
        self._sizes.append(sizes)
        self._face_count += len(lines)

    def _add_groups(self, words: Words, lines: Places, kinds: Codes, faces: Places) -> None:
        label = len(self._names) - 1
        if not len(faces) and len(self._names) > MOST_GROUPS:
            return
        groups = lines[np.isin(kinds, np.array(GROUPS, dtype=np.uint64))]
        room = max(0, MOST_GROUPS + 1 - len(self._names))
        for line in groups[:room].tolist():
            begin = words.ends[words.firsts[line]]
            self._names.append(name_of(words.text[begin : words.line_end(line)]) or "default")
        self._labels.append(label + np.searchsorted(groups[:room], faces))

    def _uv_of_corners(self, notes: list[str]) -> Floats | None:
        if not self._uv_count or not self._uv_corners:
            return None
        named = np.concatenate(self._uv_corners)
        if not named.any():
            return None
        missing = int((named == 0).sum())
        wrong = int(((named < 0) | (named > self._uv_count)).sum())
        why = []
        if missing:
            why.append(f"{of_number(missing, 'corner')} {'has' if missing == 1 else 'have'} none")
        if wrong:
            does = "names" if wrong == 1 else "name"
            why.append(f"{of_number(wrong, 'corner')} {does} some that are not there")
        if not self._uv_is_sound:
            why.append("some are no pairs of numbers")
        if why:
            notes.append(f"all texture coordinates were ignored: {', '.join(why)}")
            return None
        uv: Floats = np.concatenate(self._uv)[named - 1]
        return uv

    def _count_others(self, kinds: Codes) -> None:
        self._kinds["unknown statement"] += int((~np.isin(kinds, KNOWN)).sum())
        for kind, name in SHORT_KINDS.items():
            self._kinds[name] += int((kinds == kind).sum())
        free = np.isin(kinds, np.array(FREE_FORM, dtype=np.uint64))
        self._kinds["free-form curve or surface"] += int(free.sum())


def _beside(first: Places, count: int) -> Places:
    """The next `count` words after each of `first`, in one row."""
    return (first[:, None] + np.arange(1, count + 1)).ravel()


def _corners(words: Words, chosen: Places) -> Corners:
    """What some words say as corners: vertex, vertex/uv, vertex//normal or vertex/uv/normal."""
    text = np.frombuffer(words.joined(chosen), dtype=np.uint8)
    lengths = words.ends[chosen] - words.starts[chosen]
    begins = np.cumsum(lengths + 1) - lengths - 1
    slash = text == SLASH
    if not slash.any():
        return Corners(_whole(words, chosen, text, begins, begins + lengths), np.zeros_like(chosen))
    part = (text > ord(" ")) & ~slash
    changes = np.flatnonzero(np.diff(part, prepend=False, append=False))
    starts, ends = changes[::2], changes[1::2]
    owner = np.searchsorted(begins, starts, side="right") - 1
    slashes = np.cumsum(slash, dtype=np.int32)
    place = slashes[starts] - slashes[begins[owner]] + slash[begins[owner]]
    first = place == 0
    if (lacks := np.bincount(owner[first], minlength=len(chosen)) == 0).any():
        raise _no_corner(words, int(chosen[lacks.argmax()]))
    vertex = _whole(words, chosen, text, starts[first], ends[first])
    uv = np.zeros_like(vertex)
    second = place == 1
    uv[owner[second]] = _whole(words, chosen[owner[second]], text, starts[second], ends[second])
    return Corners(vertex, uv)


def _whole(words: Words, chosen: Places, text: Bytes, starts: Places, ends: Places) -> Places:
    try:
        return whole_numbers(text, starts, ends)
    except ValueError as error:
        raise _no_corner(words, int(chosen[error.args[0]])) from None


def _no_corner(words: Words, word: int) -> FormatError:
    written = shown(name_of(words.word(word)))
    return FormatError(f"{words.where(word)}: {written} is no corner of a face")


def _of(count: int, noun: str) -> str:
    """Such as "2 free-form curves or surfaces"."""
    several = noun.replace(" or ", "s or ")
    return f"1 {noun}" if count == 1 else f"{count} {several}s"
