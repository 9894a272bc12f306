"""The figures of an SVG drawing: every path and basic shape, where and how it is drawn.

Groups, nested drawings and `use` are followed with their transforms; what only serves others
(`defs`, symbols, clip paths, patterns, ...) is not drawn. What is there but not seen, such as
`display="none"`, is read as hidden.
"""

from collections import Counter
from dataclasses import dataclass, field, replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.formats import FormatError
from plusedit.io.svg_frames import UPWARDS, Frame
from plusedit.io.svg_lengths import IDENTITY, ViewBox, joined, length, scale_of, shift, transform
from plusedit.io.svg_paint import Paint, paint_of
from plusedit.io.svg_paths import FARTHEST, MOST_PIECES, too_many_pieces
from plusedit.io.svg_pieces import Outline
from plusedit.io.svg_shapes import SHAPES, outlines_of
from plusedit.io.svg_styles import INITIAL, Properties, StyleSheet, reference, share
from plusedit.io.svg_tree import Element

MOST_VISITS = 100_000  # elements, those that `use` repeats counted every time
WIDEST = 1e6  # pixels of a stroke
DEEPEST_USE = 20  # uses inside one another

GROUPS = frozenset(["g", "a", "switch"])
LEFT_OUT = {"text": "text", "image": "picture", "foreignObject": "foreign object"}
FRAMED = frozenset(["svg", "symbol"])


@dataclass(frozen=True, eq=False)
class Figure:
    """One path or basic shape, in the world."""

    identity: str
    """its id in the file, "" if it has none"""
    label: str
    """what a person called it, else its id, else such as "path 3" """
    outlines: list[Outline]
    paint: Paint
    visible: bool


@dataclass(frozen=True)
class Place:
    """What an element has from those around it."""

    matrix: Floats
    properties: Properties
    viewport: tuple[float, float]
    hidden: bool = False
    opacity: float = 1.0
    uses: tuple[str, ...] = ()
    """ids of what is being repeated, against circles"""


@dataclass(eq=False)
class Figures:
    """All figures of a drawing in the order of drawing, and what could not be read."""

    frame: Frame
    figures: list[Figure] = field(default_factory=list)
    counts: "Counter[str]" = field(default_factory=Counter)
    """how many of a kind were left out"""
    gradients: int = 0
    """paints that became one color"""
    problems: list[str] = field(default_factory=list)
    """sentences about single elements"""


@np.errstate(over="ignore", invalid="ignore")  # too large: such figures are left out
def figures_of(root: Element) -> Figures:
    """Every path and basic shape below an outermost <svg>. FormatError past the limits."""
    frame = Frame.of(root)
    walk = _Walk(root, frame)
    properties = walk.sheet.of(root, INITIAL)
    place = Place(IDENTITY, properties, frame.viewport)
    walk.children(root, walk.within(root, place, properties))
    if root.get("transform"):
        walk.found.problems.append("The transform of the drawing as a whole was left out.")
    return walk.found


class _Walk:
    """Goes through a drawing once."""

    def __init__(self, root: Element, frame: Frame) -> None:
        self.sheet = StyleSheet(root)
        self.found = Figures(frame)
        self._by_id: dict[str, Element] = {}
        self._visits = 0
        self._pieces = 0
        self._numbers: Counter[str] = Counter()
        self._index(root)

    def _index(self, element: Element) -> None:
        if identity := element.get("id"):
            self._by_id.setdefault(identity, element)
        for child in element.children:
            self._index(child)

    def children(self, element: Element, place: Place) -> None:
        """Draw what is inside an element."""
        for child in element.children:
            self._draw(child, place)

    def within(self, element: Element, place: Place, properties: Properties) -> Place:
        """The place of what is drawn by an element itself."""
        if (
            properties.get("clip-path", "none") != "none"
            or properties.get("mask", "none") != "none"
        ):
            self.found.counts["clip path or mask"] += 1
        return replace(
            place,
            properties=properties,
            hidden=place.hidden or properties.get("display") == "none",
            opacity=place.opacity * share(properties.get("opacity", "1")),
        )

    def _draw(self, element: Element, place: Place) -> None:
        self._visits += 1
        if self._visits > MOST_VISITS:
            raise FormatError(f"draws more than {MOST_VISITS:,} elements")
        tag = element.tag
        if tag in LEFT_OUT:
            self.found.counts[LEFT_OUT[tag]] += 1
        elif tag in SHAPES or tag in GROUPS or tag in ("svg", "use"):
            here = self.within(element, place, self.sheet.of(element, place.properties))
            here = replace(here, matrix=joined(here.matrix, self._transform(element)))
            if tag in SHAPES:
                self._figure(element, here)
            elif tag == "use":
                self._use(element, here)
            elif tag == "svg":
                self.children(element, self._viewport(element, element, here))
            else:
                self.children(element, here)

    def _transform(self, element: Element) -> Floats:
        try:
            return transform(element.get("transform"))
        except ValueError as error:
            self.found.problems.append(f"{_name(element)}: {error}, so it was left out.")
            return IDENTITY

    def _viewport(self, sized: Element, framed: Element, place: Place) -> Place:
        """The place inside a nested drawing or symbol, of the size that `sized` gives."""
        width, height = place.viewport
        x, y = (length(sized.get(k), w) for k, w in zip("xy", place.viewport, strict=True))
        sizes = [sized.get("width") or framed.get("width", "100%") or "100%", ""]
        sizes[1] = sized.get("height") or framed.get("height", "100%") or "100%"
        width, height = length(sizes[0], width, width), length(sizes[1], height, height)
        matrix = joined(place.matrix, shift(x, y))
        box = ViewBox.of(framed.get("viewBox"))
        if box is None:
            return replace(place, matrix=matrix, viewport=(width, height))
        inner = box.fitted(width, height, framed.get("preserveAspectRatio"))
        return replace(place, matrix=joined(matrix, inner), viewport=(box.width, box.height))

    def _use(self, element: Element, place: Place) -> None:
        """Draw what a <use> repeats, shifted to its place."""
        address = element.get("href") or element.get("xlink:href")
        target = self._by_id.get(address[1:]) if address.startswith("#") else None
        if target is None or address in place.uses or len(place.uses) >= DEEPEST_USE:
            self.found.counts["use of something that is not there"] += 1
            return
        place = replace(place, uses=(*place.uses, address))
        if target.tag in FRAMED:
            properties = self.sheet.of(target, place.properties)
            place = self.within(target, place, properties)
            self.children(target, self._viewport(element, target, place))
            return
        width, height = place.viewport
        by = shift(length(element.get("x"), width), length(element.get("y"), height))
        self._draw(target, replace(place, matrix=joined(place.matrix, by)))

    def _figure(self, element: Element, place: Place) -> None:
        self._numbers[element.tag] += 1
        label = _label(element) or f"{element.tag} {self._numbers[element.tag]}"
        outlines, error = outlines_of(element, place.viewport)
        self._pieces += sum(len(outline.pieces) for outline in outlines)
        if self._pieces > MOST_PIECES:
            raise too_many_pieces()
        matrix = joined(UPWARDS, place.matrix)
        for outline in outlines:
            outline.pieces = [piece.mapped(matrix) for piece in outline.pieces]
        if not all(_is_near(outline) for outline in outlines):
            outlines, error = [], "its coordinates are too large to calculate with"
        if error:
            kept = "what comes before is kept" if outlines else "nothing of it could be read"
            self.found.problems.append(f"{label}: {error}; {kept}.")
        width = self._stroke_width(place)
        paint = paint_of(place.properties, width, place.opacity, self._by_id, self.sheet)
        painted = (place.properties.get(name, "") for name in ("fill", "stroke"))
        self.found.gradients += sum(bool(reference(text)) for text in painted)
        seen = place.properties.get("visibility") == "visible" and paint.is_seen
        visible = seen and not place.hidden
        self.found.figures.append(Figure(element.get("id"), label, outlines, paint, visible))

    def _stroke_width(self, place: Place) -> float:
        """The width of the stroke in pixels, where the drawing is shown at its own size."""
        across, up = place.viewport
        diagonal = ((across**2 + up**2) / 2.0) ** 0.5
        width = length(place.properties.get("stroke-width", "1"), diagonal, 1.0)
        if place.properties.get("vector-effect") == "non-scaling-stroke":
            return width
        width *= scale_of(place.matrix) * self.found.frame.pixels
        return width if width <= WIDEST else WIDEST


def _is_near(outline: Outline) -> bool:
    """Whether an outline has numbers that can be calculated with."""
    # A transform with a number too large makes nan, which is not near either.
    return all(bool((abs(piece.points) <= FARTHEST).all()) for piece in outline.pieces)


def _label(element: Element) -> str:
    return element.get("inkscape:label") or element.title or element.get("id")


def _name(element: Element) -> str:
    return _label(element) or f"a {element.tag}"
