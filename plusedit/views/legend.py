"""Legends and captions drawn with a QPainter."""

from collections.abc import Iterable

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QLinearGradient, QPainter, QPolygonF

from plusedit.scene.captions import THICK, PlacedCaption
from plusedit.scene.legends import PlacedLegend, Word
from plusedit.scene.theme import Theme
from plusedit.views.painter import color_of, font_of, pen_of

ROUND = 4.0  # pixels, the radius of the corners
GROUND = "panel@90"


def paint_legend(painter: QPainter, legend: PlacedLegend, theme: Theme) -> None:
    """Draw a legend in its place, on a ground of its own."""
    _paint_ground(painter, legend.box, theme)
    _paint_bar(painter, legend)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen_of(theme.color("text"), 1.0, "solid"))
    painter.drawLines([QLineF(left, y, right, y) for left, right, y in legend.ticks])
    _paint_words(painter, legend.words, theme)


def paint_caption(painter: QPainter, caption: PlacedCaption, theme: Theme) -> None:
    """Draw a caption in its place, on a ground of its own."""
    _paint_ground(painter, caption.box, theme)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    for left, right, y, color in caption.samples:
        painter.setPen(pen_of(theme.color(color), THICK, "solid"))
        painter.drawLine(QLineF(left, y, right, y))
    _paint_words(painter, caption.words, theme)


def _paint_ground(painter: QPainter, box: tuple[float, float, float, float], theme: Theme) -> None:
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(pen_of(theme.color("border"), 1.0, "solid"))
    painter.setBrush(color_of(theme.color(GROUND)))
    painter.drawRoundedRect(QRectF(*box), ROUND, ROUND)


def _paint_words(painter: QPainter, words: Iterable[Word], theme: Theme) -> None:
    for word in words:
        font = font_of(word.size)
        painter.setFont(font)
        painter.setPen(color_of(theme.color(word.color)))
        width = 0.0 if word.anchor == "left" else QFontMetricsF(font).horizontalAdvance(word.text)
        shift = {"left": 0.0, "center": width / 2.0, "right": width}[word.anchor]
        painter.drawText(QPointF(word.x - shift, word.y), word.text)


def _paint_bar(painter: QPainter, legend: PlacedLegend) -> None:
    bar = QRectF(*legend.bar)
    gradient = QLinearGradient(bar.bottomLeft(), bar.topLeft())
    for number, color in enumerate(legend.colors):
        gradient.setColorAt(number / (len(legend.colors) - 1), color_of(color))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(gradient)
    painter.drawRect(bar)
    for corners, color in zip(legend.tips, (legend.colors[0], legend.colors[-1]), strict=True):
        painter.setBrush(color_of(color))
        painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in corners]))
