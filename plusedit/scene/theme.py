"""Colors by role, light and dark. Text reaches 4.5 : 1 on its ground, handles 3 : 1."""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType


@dataclass(frozen=True)
class Theme:
    """The colors of one look, "#rrggbb" or "#rrggbbaa" by role."""

    name: str
    colors: Mapping[str, str]

    def color(self, role: str) -> str:
        """The color of a role; what begins with "#" is a color already. KeyError otherwise.

        "line@40" is the color of "line" at 40 % of its opacity.
        """
        name, _, percent = role.partition("@")
        color = name if name.startswith("#") else self.colors[name]
        if not percent:
            return color
        opacity = int(color[7:] or "FF", 16) * int(percent) / 100.0
        return f"{color[:7]}{round(opacity):02X}"


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
)

# fmt: off
LIGHT = Theme("light", _roles(
    "#F3F4F6", "#FFFFFF", "#D9DDE3", "#1F2430", "#5B6472", "#2563EB",
    "#FCFCFD", "#ECEEF2", "#D7DBE2", "#12824A", "#C8372D", "#334155", "#2563EB", "#F59E0B",
    "#B58900", "#B5379E", "#F4B6C259", "#A9C4F559", "#C8372D", "#12824A", "#3B82C4",
))
DARK = Theme("dark", _roles(
    "#1E2127", "#262A31", "#383E48", "#E6E9EF", "#A3ACBA", "#6AA2FF",
    "#16181D", "#22252C", "#30353F", "#F2F4F8", "#FF7B72", "#C3CAD6", "#6AA2FF", "#FFB84D",
    "#F2C94C", "#E07BD0", "#7A3B4B73", "#33507F73", "#FF7B72", "#5BC98C", "#8CC4F0",
))
# fmt: on

THEMES = {theme.name: theme for theme in (LIGHT, DARK)}
