"""Colors of items as numbers for shaders."""

from plusedit.scene.theme import Theme

Shade = tuple[float, float, float, float]
"""Red, green, blue and opacity, from 0 to 1"""


class Palette:
    """The colors of a theme, each worked out once. Compared by identity, so that it keys caches."""

    def __init__(self, theme: Theme) -> None:
        self.theme = theme
        self._shades: dict[str, Shade] = {}
        self._words: dict[str, int] = {}

    def shade(self, color: str) -> Shade:
        """The color of an item."""
        shade = self._shades.get(color)
        if shade is None:
            code = self.theme.color(color)
            red, green, blue = (int(code[i : i + 2], 16) / 255.0 for i in (1, 3, 5))
            shade = self._shades[color] = red, green, blue, int(code[7:9] or "FF", 16) / 255.0
        return shade

    def lets_through(self, color: str) -> bool:
        """Whether what lies behind is seen."""
        return self.shade(color)[3] < 1.0

    def albedo(self, color: str) -> Shade:
        """How much light what has that color throws back, and its opacity.

        Squares, as shaders take them for the curve between colors and light.
        """
        red, green, blue, opacity = self.shade(color)
        return red * red, green * green, blue * blue, opacity

    def word(self, color: str) -> int:
        """The color as four bytes in one number, red in the lowest."""
        word = self._words.get(color)
        if word is None:
            channels = bytes(round(255.0 * channel) for channel in self.shade(color))
            word = self._words[color] = int.from_bytes(channels, "little")
        return word
