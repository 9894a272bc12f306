"""How a figure is painted: what becomes the style of a shape, and what only SVG needs.

Shapes know the color and width of a stroke. The rest (fill, opacities, caps, ...) is kept under
`extra["style"]` as SVG names it, so that a drawing comes out as it went in.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from plusedit.document.shape import Json, Style
from plusedit.io.svg_lengths import length
from plusedit.io.svg_paths import numbers_of
from plusedit.io.svg_styles import CURRENT, Properties, StyleSheet, color_of, reference, share
from plusedit.io.svg_tree import Element

KEPT = {
    "fill-rule": frozenset(["evenodd"]),
    "stroke-linecap": frozenset(["round", "square"]),
    "stroke-linejoin": frozenset(["round", "bevel"]),
}
"""Properties kept as they stand, and their values but for the usual one"""


@dataclass(frozen=True, eq=False)
class Paint:
    """Style of a shape and what else its element is to be written with."""

    style: Style
    """without a color where nothing is stroked, or where the drawing leaves it to be chosen"""
    details: dict[str, Json]
    """properties of SVG: fill, stroke (only "none"), opacities, ..."""

    @property
    def is_seen(self) -> bool:
        """Whether anything of it shows."""
        if self.details.get("opacity") == 0.0:
            return False
        stroked = "stroke" not in self.details and self.details.get("stroke-opacity") != 0.0
        filled = self.details["fill"] != "none" and self.details.get("fill-opacity") != 0.0
        return stroked or filled


def paint_of(
    properties: Properties,
    width: float,
    opacity: float,
    by_id: Mapping[str, Element],
    sheet: StyleSheet,
) -> Paint:
    """The paint of a figure with those properties; `width` of its stroke in pixels."""
    details: dict[str, Json] = {}
    fill, fill_opacity = _color(properties, "fill", by_id, sheet)
    stroke, stroke_opacity = _color(properties, "stroke", by_id, sheet)
    if width <= 0.0:
        stroke = None
    details["fill"] = fill or "none"
    if stroke is None:
        details["stroke"] = "none"
    shares = {"fill-opacity": fill_opacity, "stroke-opacity": stroke_opacity, "opacity": opacity}
    details |= {name: value for name, value in shares.items() if value != 1.0}
    for name, values in KEPT.items():
        if properties.get(name) in values:
            details[name] = properties[name]
    if stroke is not None:
        details |= _dashes(properties, width)
    if stroke is None:
        return Paint(Style(), details)
    return Paint(Style(None if stroke == CURRENT else stroke, width), details)


def _color(
    properties: Properties, name: str, by_id: Mapping[str, Element], sheet: StyleSheet
) -> tuple[str | None, float]:
    """Color and opacity of fill or stroke; a gradient counts as its first color."""
    text = properties.get(name, "none")
    if identity := reference(text):
        target = by_id.get(identity)
        fallback = text.partition(")")[2].strip() or "none"
        text = _first_stop(target, by_id, sheet) or fallback
    color, opacity = color_of(text, properties.get("color", CURRENT))
    return color, opacity * share(properties.get(f"{name}-opacity", "1"))


def _first_stop(
    gradient: Element | None, by_id: Mapping[str, Element], sheet: StyleSheet, depth: int = 5
) -> str:
    """The first color of a gradient, or of the one that it refers to; "" if there is none."""
    if gradient is None or depth == 0:
        return ""
    for child in gradient.children:
        if child.tag == "stop":
            return sheet.own(child).get("stop-color", "black")
    address = gradient.get("href") or gradient.get("xlink:href")
    return _first_stop(by_id.get(address[1:]), by_id, sheet, depth - 1)


def _dashes(properties: Properties, width: float) -> dict[str, Json]:
    """Dashes in units of the stroke width, so that they grow with it."""
    own = length(properties.get("stroke-width", "1"), 0.0, 1.0)
    numbers = numbers_of(properties.get("stroke-dasharray", ""))
    if not numbers or own <= 0.0 or min(numbers) < 0.0 or max(numbers) == 0.0 or width <= 0.0:
        return {}
    dashes: list[Json] = [number / own for number in numbers[:64]]
    return {"dashes": dashes}
