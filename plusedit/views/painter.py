"""Items drawn with a QPainter: what windows and pictures have in common.

The painter's own transformation is only that of the device's pixels; the camera has turned
everything into logical pixels before.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache, singledispatchmethod

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPainter, QPen

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera
from plusedit.scene.clipping import (
    Box,
    clipped_polygon,
    clipped_polyline,
    clipped_segments,
    reaches_beyond,
)
from plusedit.scene.items import Item, Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.theme import Theme
from plusedit.views.arrays import polygon_of

BEYOND = 2000.0  # pixels around the view within which lines are drawn as they are
DASHES = {"dash": [6.0, 4.0], "dot": [2.0, 3.0]}  # pixels


@dataclass(frozen=True, eq=False)
class ItemPainter:
    """Draws items as one camera sees them, in the colors of one theme."""

    painter: QPainter
    camera: Camera
    theme: Theme

    def paint(self, items: Iterable[Item]) -> None:
        """Draw the items, the first one farthest back."""
        self.painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        for item in items:
            self._draw(item)

    @singledispatchmethod
    def _draw(self, item: Item) -> None:
        raise TypeError(f"the painter draws no {type(item).__name__}")

    @_draw.register
    def _(self, item: Polyline) -> None:
        screen = self.camera.to_screen(item.points)
        box = self._box()
        pieces = clipped_polyline(screen, box) if reaches_beyond(screen, box) else [screen]
        self.painter.setPen(pen_of(self.theme.color(item.color), item.width, item.dash))
        for piece in pieces:
            self.painter.drawPolyline(polygon_of(piece))

    @_draw.register
    def _(self, item: Polygon) -> None:
        screen = self.camera.to_screen(item.points)
        box = self._box()
        if reaches_beyond(screen, box):
            screen = clipped_polygon(screen, box)
        outline = item.outline
        self.painter.setPen(
            Qt.PenStyle.NoPen
            if outline is None
            else pen_of(self.theme.color(outline), item.width, "solid")
        )
        self.painter.setBrush(color_of(self.theme.color(item.fill)))
        self.painter.drawPolygon(polygon_of(screen))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)

    @_draw.register
    def _(self, item: Segments) -> None:
        starts, ends = self.camera.to_screen(item.starts), self.camera.to_screen(item.ends)
        box = self._box()
        if len(starts) and (reaches_beyond(starts, box) or reaches_beyond(ends, box)):
            starts, ends = clipped_segments(starts, ends, box)
        self.painter.setPen(pen_of(self.theme.color(item.color), item.width, item.dash))
        self._segments(starts, ends)

    @_draw.register
    def _(self, item: Markers) -> None:
        screen = self.camera.to_screen(item.points)
        low, high = self._box()
        screen = screen[((screen >= low) & (screen <= high)).all(axis=1)]
        if not len(screen):
            return
        outline = self.theme.color(item.outline)
        fill = self.theme.color("canvas" if item.fill is None else item.fill)
        match item.mark:
            case "circle" | "square":
                cap = _ROUND if item.mark == "circle" else _SQUARE
                self._points(screen, item.size, outline, cap)
                if fill != outline:
                    self._points(screen, item.size - 2.0 * item.width, fill, cap)
            case "ring":
                self._paths(screen, item, outline, None)
            case "diamond":
                self._paths(screen, item, outline, fill)
            case "cross":
                arm = np.array([item.size / 2.0, item.size / 2.0])
                flipped = arm * (1.0, -1.0)
                self.painter.setPen(pen_of(outline, item.width, "solid"))
                self._segments(screen - arm, screen + arm)
                self._segments(screen - flipped, screen + flipped)

    @_draw.register
    def _(self, item: Label) -> None:
        x, y = self.camera.to_screen(item.at[None])[0] + item.offset
        if not (abs(x) < BEYOND * 10 and abs(y) < BEYOND * 10):
            return
        font = font_of(item.size)
        width = QFontMetricsF(font).horizontalAdvance(item.text)
        shift = {"left": 0.0, "center": width / 2.0, "right": width}[item.anchor]
        self.painter.setFont(font)
        self.painter.setPen(color_of(self.theme.color(item.color)))
        self.painter.drawText(QPointF(x - shift, y), item.text)

    def _box(self) -> Box:
        return np.full(2, -BEYOND), np.array(self.camera.size) + BEYOND

    def _segments(self, starts: Floats, ends: Floats) -> None:
        if len(starts):
            pairs = polygon_of(np.stack([starts, ends], axis=1).reshape(-1, 2))
            self.painter.drawLines(pairs.data(), len(starts))

    def _points(self, screen: Floats, size: float, color: str, cap: Qt.PenCapStyle) -> None:
        pen = QPen(color_of(color), size)
        pen.setCapStyle(cap)
        self.painter.setPen(pen)
        self.painter.drawPoints(polygon_of(screen))

    def _paths(self, screen: Floats, item: Markers, outline: str, fill: str | None) -> None:
        radius = (item.size - item.width) / 2.0
        self.painter.setPen(pen_of(outline, item.width, "solid"))
        if fill is not None:
            self.painter.setBrush(color_of(fill))
        for at in screen:
            if item.mark == "ring":
                self.painter.drawEllipse(QPointF(*at), radius, radius)
            else:
                self.painter.drawPolygon(polygon_of(at + radius * _DIAMOND))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)


_ROUND, _SQUARE = Qt.PenCapStyle.RoundCap, Qt.PenCapStyle.SquareCap
_DIAMOND = np.array([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])


@lru_cache(maxsize=256)
def color_of(color: str) -> QColor:
    """The color "#rrggbb" or "#rrggbbaa"; Qt itself would read the latter as "#aarrggbb"."""
    made = QColor(color[:7])
    if len(color) == 9:
        made.setAlpha(int(color[7:], 16))
    return made


@lru_cache(maxsize=256)
def pen_of(color: str, width: float, dash: str) -> QPen:
    """A pen of that many logical pixels with round joins; dashes are in pixels, too."""
    pen = QPen(color_of(color), width)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    pen.setCapStyle(_ROUND if dash == "solid" else Qt.PenCapStyle.FlatCap)
    if dash != "solid":
        pen.setDashPattern([length / max(width, 1.0) for length in DASHES[dash]])
    return pen


@lru_cache(maxsize=16)
def font_of(size: float) -> QFont:
    """The program's font, that many pixels high."""
    font = QFont()
    font.setPixelSize(round(size))
    return font
