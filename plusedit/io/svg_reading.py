"""SVG drawings as designs.

World coordinates are the user units of the outermost <svg>, y turned upwards; its view box and
size are kept with the design. Shapes remember which path they come from, under `extra["svg"]`, so
that writing can put the path together again and fill it.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field

from plusedit.document.design import Design
from plusedit.document.shape import Json, Shape, ShapeId
from plusedit.io.fields import within
from plusedit.io.formats import FormatError, Loaded
from plusedit.io.svg_curves import How, Made, closes, fitted, path, segments, size_of, tidied
from plusedit.io.svg_figures import Figure, Figures, figures_of
from plusedit.io.svg_pieces import Outline
from plusedit.io.svg_tree import parse_tree

LARGEST_FILE = 64 << 20  # bytes
MOST_SHAPES = 50_000
MOST_PROBLEMS = 5  # told one by one; of the rest only how many there are
FIT_TOLERANCE = 1e-3  # of the size of a path

BETWEEN = {"segments": " · segment ", "paths": " · part ", "fitted": " · part "}
"""Between the name of a path and the number of the curve, in the names of shapes"""


def read_svg(
    data: bytes, name: str, how: How = "segments", *, tolerance: float = FIT_TOLERANCE
) -> Loaded:
    """The drawing as a design; see `svg_curves` for the three ways to make curves of it.

    `tolerance`, of the size of each path, is for "fitted" alone. FormatError, beginning with
    `name`, where the file is no SVG drawing or holds nothing that can be read as a curve.
    """
    with within(name):
        if len(data) > LARGEST_FILE:
            raise FormatError(f"is larger than {LARGEST_FILE >> 20} MB")
        found = figures_of(parse_tree(data))
        reading = _Reading(how, tolerance, problems=found.problems)
        for figure in found.figures:
            reading.add(figure)
        if not reading.shapes:
            because = f": {found.problems[0].rstrip('.')}" if found.problems else ""
            raise FormatError(f"holds no path or basic shape that can be read{because}")
    design = Design(reading.shapes, extra={"svg": found.frame.tree()})
    notes = (*reading.notes(), *_left_out(found), *_told(found.problems))
    return Loaded(design, notes)


@dataclass(eq=False)
class _Reading:
    """Makes shapes of figures."""

    how: How
    tolerance: float
    problems: list[str]
    shapes: dict[ShapeId, Shape] = field(default_factory=dict)
    _hidden: int = 0
    _points: int = 0
    _miss: float = 0.0
    _ids: set[str] = field(default_factory=set)
    _numbers: dict[str, int] = field(default_factory=dict)

    def add(self, figure: Figure) -> None:
        """Add the curves of a figure."""
        made = list(self._made(figure))
        if not made:
            return
        if len(self.shapes) + len(made) > MOST_SHAPES:
            raise FormatError(f"holds more than {MOST_SHAPES:,} curves")
        key = self._unused(figure.identity or figure.label.replace(" ", "-"))
        for at, (part, closed, curve) in enumerate(made):
            place: dict[str, Json] = {"path": key, "at": at, "of": len(made), "part": part}
            if closed:
                place["closed"] = True
            single = len(made) == 1
            shape_id = ShapeId(key if single else self._unused(f"{key}-{at + 1}"))
            name = figure.label if single else f"{figure.label}{BETWEEN[self.how]}{at + 1}"
            extra: dict[str, Json] = {"style": figure.paint.details, "svg": place}
            self.shapes[shape_id] = Shape(
                curve.curve, name, figure.visible, style=figure.paint.style, extra=extra
            )
        self._hidden += 0 if figure.visible else len(made)

    def _made(self, figure: Figure) -> Iterator[tuple[int, bool, Made]]:
        """Number of the outline, whether that is closed, and a curve made from it."""
        for number, outline in enumerate(figure.outlines):
            tidy, points = tidied(outline)
            self._points += points
            if not tidy.pieces:
                continue
            closed = tidy.closed and closes(tidy)
            try:
                for made in self._curves(tidy):
                    if made.miss:
                        self._miss = max(self._miss, made.miss / size_of(tidy))
                    yield number, closed, made
            except ValueError as error:
                self.problems.append(f"{figure.label}: {error}; a part of it was left out.")

    def _curves(self, outline: Outline) -> list[Made]:
        if self.how == "segments":
            return segments(outline)
        return [path(outline) if self.how == "paths" else fitted(outline, self.tolerance)]

    def _unused(self, stem: str) -> str:
        """`stem`, or `stem-2`, ...: what no path and no shape of the drawing is called yet."""
        name = stem
        while name in self._ids:
            self._numbers[stem] = self._numbers.get(stem, 1) + 1
            name = f"{stem}-{self._numbers[stem]}"
        self._ids.add(name)
        return name

    def notes(self) -> Iterator[str]:
        """What a person should know about the curves."""
        if self._miss:
            what = "Paths were fitted" if self.how == "fitted" else "Arcs beside cubics were taken"
            yield f"{what} within {self._miss:.1g} of the size of each path."
        if self._points:
            yield f"{_plural(self._points, 'piece', 'of no length')} left out."
        if self._hidden:
            yield f"{_plural(self._hidden, 'curve')} hidden: nothing of it shows in the drawing."


def _left_out(found: Figures) -> Iterator[str]:
    if found.gradients:
        yield f"{_plural(found.gradients, 'gradient or pattern')} replaced by one color."
    for what, count in found.counts.items():
        yield f"{_plural(count, what)} left out."


def _told(problems: list[str]) -> Iterator[str]:
    yield from problems[:MOST_PROBLEMS]
    if len(problems) > MOST_PROBLEMS:
        yield f"{_plural(len(problems) - MOST_PROBLEMS, 'more problem')} of that kind found."


def _plural(count: int, what: str, more: str = "") -> str:
    """Such as "1 text was", "3 texts were", "2 clip paths or masks were", "2 pieces of it were"."""
    if count != 1:
        what = f"{what}s".replace(" or ", "s or ")
    return " ".join(filter(None, [str(count), what, more, "was" if count == 1 else "were"]))
