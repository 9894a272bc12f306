"""Paths and basic shapes of SVG as outlines."""

from collections.abc import Callable

from plusedit.io.svg_lengths import length
from plusedit.io.svg_paths import numbers_of, parse_path
from plusedit.io.svg_pieces import Outline, ellipse, polyline, rectangle
from plusedit.io.svg_tree import Element

Viewport = tuple[float, float]
Read = tuple[list[Outline], str | None]


def outlines_of(element: Element, viewport: Viewport) -> Read:
    """The outlines of a path or basic shape, and what was wrong with it, if anything was."""
    outlines, error = SHAPES[element.tag](element, viewport)
    return [outline for outline in outlines if outline.pieces], error


def _path(element: Element, viewport: Viewport) -> Read:
    data = parse_path(element.get("d"))
    return data.outlines, data.error


def _rect(element: Element, viewport: Viewport) -> Read:
    across, up = viewport
    width, height = length(element.get("width"), across), length(element.get("height"), up)
    if width <= 0.0 or height <= 0.0:
        return [], None  # as the specification asks: not drawn
    rx, ry = element.get("rx", "auto"), element.get("ry", "auto")
    rx, ry = (ry if rx == "auto" else rx), (rx if ry == "auto" else ry)
    corner = (
        min(length(rx, across), width / 2.0),
        min(length(ry, up), height / 2.0),
    )
    place = (length(element.get("x"), across), length(element.get("y"), up))
    return [rectangle(*place, width, height, *corner)], None


def _circle(element: Element, viewport: Viewport) -> Read:
    across, up = viewport
    diagonal = ((across**2 + up**2) / 2.0) ** 0.5
    radius = length(element.get("r"), diagonal)
    return _round(element, viewport, radius, radius)


def _ellipse(element: Element, viewport: Viewport) -> Read:
    rx, ry = element.get("rx", "auto"), element.get("ry", "auto")
    rx, ry = (ry if rx == "auto" else rx), (rx if ry == "auto" else ry)
    return _round(element, viewport, length(rx, viewport[0]), length(ry, viewport[1]))


def _round(element: Element, viewport: Viewport, rx: float, ry: float) -> Read:
    if rx <= 0.0 or ry <= 0.0:
        return [], None
    across, up = viewport
    center = length(element.get("cx"), across), length(element.get("cy"), up)
    return [ellipse(*center, rx, ry)], None


def _line(element: Element, viewport: Viewport) -> Read:
    across, up = viewport
    start = length(element.get("x1"), across), length(element.get("y1"), up)
    end = length(element.get("x2"), across), length(element.get("y2"), up)
    return [polyline([start, end], closed=False)], None


def _points(element: Element, *, closed: bool) -> Read:
    numbers = numbers_of(element.get("points"))
    points = list(zip(numbers[::2], numbers[1::2], strict=False))
    if len(points) < 2:
        return [], None
    error = "a number of its points is missing" if len(numbers) % 2 else None
    return [polyline(points, closed=closed)], error


SHAPES: dict[str, Callable[[Element, Viewport], Read]] = {
    "path": _path,
    "rect": _rect,
    "circle": _circle,
    "ellipse": _ellipse,
    "line": _line,
    "polyline": lambda element, viewport: _points(element, closed=False),
    "polygon": lambda element, viewport: _points(element, closed=True),
}
"""Every element that draws an outline by itself"""
