"""Items as an SVG picture: what the painter draws, for vector graphics.

Positions are the camera's pixels, sizes and dashes the painter's; text stays text.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import singledispatchmethod
from xml.sax.saxutils import escape, quoteattr

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera
from plusedit.scene.captions import THICK, clear_of_legends, placed_caption
from plusedit.scene.clipping import (
    Box,
    clipped_polygon,
    clipped_polyline,
    clipped_segments,
    reaches_beyond,
)
from plusedit.scene.items import (
    Caption,
    Dash,
    Item,
    Label,
    Legend,
    Markers,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.legends import PlacedLegend, Word, placed
from plusedit.scene.theme import Theme

BEYOND = 2000.0  # pixels around the picture within which lines are drawn as they are
DASHES: Mapping[Dash, str] = {"dash": "6 4", "dot": "2 3"}  # pixels
DIGITS = 3  # of a pixel, behind the point
ANCHORS = {"left": "start", "center": "middle", "right": "end"}
FONT = "Inter, 'Segoe UI', 'Helvetica Neue', 'DejaVu Sans', Arial, sans-serif"
DIAMOND: Floats = np.array([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])
SQUARE: Floats = np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]])


def svg_of(
    items: Iterable[Item], camera: Camera, theme: Theme, *, transparent: bool = False
) -> bytes:
    """The picture of `items` as `camera` sees them, as large as its view; UTF-8.

    The first item is farthest back. Behind all is the theme's canvas, unless `transparent`.
    """
    draw = Drawing(camera, theme)
    width, height = (_number(side) for side in camera.size)
    lines = [f'<rect width="{width}" height="{height}" {draw.fill("canvas")}/>']
    if transparent:
        lines.clear()
    for item in clear_of_legends(items, camera.size):
        lines += draw.elements(item)
    size = f'width="{width}" height="{height}" viewBox="0 0 {width} {height}"'
    return svg_file(size, lines)


def svg_file(size: str, lines: Iterable[str]) -> bytes:
    """The whole file around its elements; `size` are the attributes that tell how large it is."""
    style = 'fill="none" stroke-linejoin="round" stroke-linecap="round"'
    body = "".join(f"{line}\n" for line in lines)
    root = f'<svg xmlns="http://www.w3.org/2000/svg" version="1.1" {size} {style}>'
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{root}\n{body}</svg>\n'.encode()


@dataclass(frozen=True, eq=False)
class Drawing:
    """Turns items into elements."""

    camera: Camera
    theme: Theme

    def fill(self, role: str) -> str:
        """The attributes of an area of that color."""
        return _colored("fill", self.theme.color(role))

    def stroke(self, role: str, width: float, dash: Dash = "solid") -> str:
        """The attributes of a line of that color."""
        attributes = f'{_colored("stroke", self.theme.color(role))} stroke-width="{_number(width)}"'
        if dash == "solid":
            return attributes
        return f'{attributes} stroke-dasharray="{DASHES[dash]}" stroke-linecap="butt"'

    @singledispatchmethod
    def elements(self, item: Item) -> list[str]:
        """The elements that draw an item."""
        raise TypeError(f"an SVG picture draws no {type(item).__name__}")

    @elements.register
    def _(self, item: Polyline) -> list[str]:
        screen, box = self.camera.to_screen(item.points), self._box()
        pieces = clipped_polyline(screen, box) if reaches_beyond(screen, box) else [screen]
        stroke = self.stroke(item.color, item.width, item.dash)
        return [f'<polyline points="{_points(p)}" {stroke}/>' for p in pieces if len(p)]

    @elements.register
    def _(self, item: Polygon) -> list[str]:
        screen, box = self.camera.to_screen(item.points), self._box()
        if reaches_beyond(screen, box):
            screen = clipped_polygon(screen, box)
        paint = self.fill(item.fill)
        if item.outline is not None:
            paint += f" {self.stroke(item.outline, item.width)}"
        return [f'<polygon points="{_points(screen)}" {paint}/>'] if len(screen) else []

    @elements.register
    def _(self, item: Segments) -> list[str]:
        starts, ends = self.camera.to_screen(item.starts), self.camera.to_screen(item.ends)
        box = self._box()
        if len(starts) and (reaches_beyond(starts, box) or reaches_beyond(ends, box)):
            starts, ends = clipped_segments(starts, ends, box)
        if not len(starts):
            return []
        stroke = self.stroke(item.color, item.width, item.dash)
        return [f'<path d="{_strokes(starts, ends)}" {stroke}/>']

    @elements.register
    def _(self, item: Markers) -> list[str]:
        screen, (low, high) = self.camera.to_screen(item.points), self._box()
        screen = screen[((screen >= low) & (screen <= high)).all(axis=1)]
        if not len(screen):
            return []
        radius = (item.size - item.width) / 2.0
        stroke = self.stroke(item.outline, item.width)
        if item.mark == "cross":
            arm = np.full(2, item.size / 2.0)
            across = arm * (1.0, -1.0)
            starts = np.concatenate([screen - arm, screen - across])
            ends = np.concatenate([screen + arm, screen + across])
            return [f'<path d="{_strokes(starts, ends)}" {stroke}/>']
        if item.mark != "ring":
            stroke += f" {self.fill('canvas' if item.fill is None else item.fill)}"
        if item.mark in ("circle", "ring"):
            marks = [f'<circle cx="{x}" cy="{y}" r="{_number(radius)}"/>' for x, y in _rows(screen)]
        else:
            form = radius * (DIAMOND if item.mark == "diamond" else SQUARE)
            marks = [f'<polygon points="{_points(at + form)}"/>' for at in screen]
        return [f"<g {stroke}>", *marks, "</g>"]

    @elements.register
    def _(self, item: Label) -> list[str]:
        x, y = (self.camera.to_screen(item.at[None])[0] + item.offset).tolist()
        if not max(abs(x), abs(y)) < BEYOND * 10:
            return []
        return [self._word(Word(x, y, item.text, item.color, item.size, item.anchor))]

    @elements.register
    def _(self, item: Legend) -> list[str]:
        legend = placed(item, self.camera.size)
        return [] if legend is None else self.legend(legend)

    def legend(self, legend: PlacedLegend) -> list[str]:
        """The elements that draw a legend in its place."""
        ground = f"{self.fill('panel')} {self.stroke('border', 1.0)}"
        ticks = "".join(f"M{_number(a)} {_number(y)}H{_number(b)}" for a, b, y in legend.ticks)
        return [
            f'<rect {_extent(legend.box)} rx="4" {ground}/>',
            *_bar(legend),
            f'<path d="{ticks}" {self.stroke("text", 1.0)}/>',
            *(self._word(word) for word in legend.words),
        ]

    @elements.register
    def _(self, item: Caption) -> list[str]:
        caption = placed_caption(item, self.camera.size)
        if caption is None:
            return []
        ground = f"{self.fill('panel')} {self.stroke('border', 1.0)}"
        return [
            f'<rect {_extent(caption.box)} rx="4" {ground}/>',
            *(
                f'<path d="M{_number(a)} {_number(y)}H{_number(b)}" {self.stroke(color, THICK)}/>'
                for a, b, y, color in caption.samples
            ),
            *(self._word(word) for word in caption.words),
        ]

    def _word(self, word: Word) -> str:
        font = f'font-family={quoteattr(FONT)} font-size="{_number(word.size)}"'
        text = escape("".join(c for c in word.text if c.isprintable()))
        place = f'x="{_number(word.x)}" y="{_number(word.y)}" text-anchor="{ANCHORS[word.anchor]}"'
        return f"<text {place} {font} {self.fill(word.color)}>{text}</text>"

    def _box(self) -> Box:
        return np.full(2, -BEYOND), np.array(self.camera.size) + BEYOND


def _bar(legend: PlacedLegend) -> Iterator[str]:
    """The colors of a legend, and the tips at its ends."""
    last = len(legend.colors) - 1
    stops = "".join(
        f'<stop offset="{_number(number / last)}" stop-color="{color}"/>'
        for number, color in enumerate(legend.colors)
    )
    upwards = 'id="legend" x1="0" y1="1" x2="0" y2="0"'
    yield f"<defs><linearGradient {upwards}>{stops}</linearGradient></defs>"
    yield f'<rect {_extent(legend.bar)} fill="url(#legend)"/>'
    for tip, color in zip(legend.tips, (legend.colors[0], legend.colors[-1]), strict=True):
        if tip:
            yield f'<polygon points="{_points(np.array(tip))}" fill="{color}"/>'


def _extent(box: tuple[float, float, float, float]) -> str:
    names = ("x", "y", "width", "height")
    return " ".join(f'{name}="{_number(n)}"' for name, n in zip(names, box, strict=True))


def _colored(name: str, color: str) -> str:
    """`fill` or `stroke` of "#rrggbb" or "#rrggbbaa", which not every reader of SVG knows."""
    attribute = f'{name}="{color[:7]}"'
    if len(color) == 9:
        attribute += f' {name}-opacity="{_number(int(color[7:], 16) / 255.0)}"'
    return attribute


def _number(value: float) -> str:
    """A number for the eye."""
    text = f"{value:.{DIGITS}f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def _rows(screen: Floats) -> list[tuple[str, str]]:
    return [(_number(x), _number(y)) for x, y in screen.tolist()]


def _points(screen: Floats) -> str:
    return " ".join(f"{x},{y}" for x, y in _rows(screen))


def _strokes(starts: Floats, ends: Floats) -> str:
    """Path data of separate segments."""
    pairs = zip(_rows(starts), _rows(ends), strict=True)
    return "".join(f"M{a} {b}L{c} {d}" for (a, b), (c, d) in pairs)
