"""Colors by role, light and dark. Text reaches 4.5 : 1 on its ground, handles 3 : 1."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from types import MappingProxyType

LEAST = 2.0  # contrast to the canvas below which a curve would hardly be found
STEPS = 20  # from a color to that of text, in search of the first that is seen


@dataclass(frozen=True)
class Theme:
    """The colors of one look, "#rrggbb" or "#rrggbbaa" by role."""

    name: str
    colors: Mapping[str, str]
    is_legible: bool = False
    """whether colors of a design's own are brought out where the canvas would swallow them"""

    def legible(self) -> "Theme":
        """The theme of a view to work in: black curves are seen on a dark canvas too.

        Pictures keep the colors as they are.
        """
        return replace(self, is_legible=True)

    def color(self, role: str) -> str:
        """The color of a role; what begins with "#" is a color already. KeyError otherwise.

        "line@40" is the color of "line" at 40 % of its opacity.
        """
        name, _, percent = role.partition("@")
        color = self._own(name) if name.startswith("#") else self.colors[name]
        if not percent:
            return color
        opacity = int(color[7:] or "FF", 16) * int(percent) / 100.0
        return f"{color[:7]}{round(opacity):02X}"

    def _own(self, color: str) -> str:
        if not self.is_legible:
            return color
        return _brought_out(color[:7], self.colors["canvas"], self.colors["text"]) + color[7:]


@lru_cache(maxsize=256)
def _brought_out(color: str, canvas: str, text: str) -> str:
    """The color, or the first between it and that of text that stands out from the canvas."""
    for step in range(STEPS + 1):
        mixed = _mixed(color, text, step / STEPS)
        if contrast(mixed, canvas) >= LEAST:
            return mixed
    return text


def _mixed(color: str, other: str, share: float) -> str:
    if share == 0.0:
        return color
    pairs = zip(_channels(color), _channels(other), strict=True)
    return "#" + "".join(f"{round(a + share * (b - a)):02X}" for a, b in pairs)


def _channels(color: str) -> tuple[int, ...]:
    return tuple(int(color[i : i + 2], 16) for i in (1, 3, 5))


def contrast(color: str, other: str) -> float:
    """From 1, alike, to 21, black on white, as WCAG 2 defines it; "#rrggbb" each."""
    low, high = sorted([_luminance(color), _luminance(other)])
    return (high + 0.05) / (low + 0.05)


def _luminance(color: str) -> float:
    parts = [channel / 255.0 for channel in _channels(color)]
    red, green, blue = (c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def _roles(*values: str) -> Mapping[str, str]:
    return MappingProxyType(dict(zip(ROLES, values, strict=True)))


ROLES = (
    "window",
    "panel",
    "border",
    "text",
    "quiet",
    "accent",
    "canvas",
    "minor",
    "major",
    "plus",
    "classical",
    "line",
    "selected",
    "hover",
    "u",
    "v",
    "parent",
    "union",
    "x",
    "y",
    "z",
    "front",
    "back",
)

# fmt: off
LIGHT = Theme("light", _roles(
    "#F3F4F6", "#FFFFFF", "#D9DDE3", "#1F2430", "#5B6472", "#2563EB",
    "#FCFCFD", "#ECEEF2", "#D7DBE2", "#12824A", "#C8372D", "#334155", "#2563EB", "#F59E0B",
    "#B58900", "#B5379E", "#F4B6C259", "#A9C4F559", "#C8372D", "#12824A", "#3B82C4",
    "#C9C2B8", "#9FB3C8",
))
DARK = Theme("dark", _roles(
    "#1E2127", "#262A31", "#383E48", "#E6E9EF", "#A3ACBA", "#6AA2FF",
    "#16181D", "#22252C", "#30353F", "#F2F4F8", "#FF7B72", "#C3CAD6", "#6AA2FF", "#FFB84D",
    "#F2C94C", "#E07BD0", "#7A3B4B73", "#33507F73", "#FF7B72", "#5BC98C", "#8CC4F0",
    "#B9B2A7", "#7F93A8",
))
# fmt: on

THEMES = {theme.name: theme for theme in (LIGHT, DARK)}
