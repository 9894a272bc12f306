"""Colors of items as numbers for shaders."""

from functools import lru_cache

import numpy as np

from plusedit.scene.theme import Theme

Shade = tuple[float, float, float, float]
"""Red, green, blue and opacity, from 0 to 1"""


def shade_of(theme: Theme, color: str) -> Shade:
    """The color of an item in a theme."""
    return _shade(theme.color(color))


def albedo_of(theme: Theme, color: str) -> Shade:
    """How much light what has that color throws back, and its opacity.

    Squares, as shaders take them for the curve between colors and light.
    """
    red, green, blue, opacity = shade_of(theme, color)
    return red * red, green * green, blue * blue, opacity


def word_of(theme: Theme, color: str) -> int:
    """The same as four bytes in one number, red in the lowest."""
    return _word(theme.color(color))


@lru_cache(maxsize=512)
def _shade(color: str) -> Shade:
    red, green, blue = (int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
    return red, green, blue, int(color[7:9] or "FF", 16) / 255.0


@lru_cache(maxsize=512)
def _word(color: str) -> int:
    channels = bytes.fromhex(color[1:7] + (color[7:9] or "FF"))
    return int(np.frombuffer(channels, dtype="<u4")[0])
