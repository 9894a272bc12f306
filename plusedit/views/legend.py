"""A legend drawn with a QPainter."""

from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QLinearGradient, QPainter, QPolygonF

from plusedit.scene.legends import PlacedLegend
from plusedit.scene.theme import Theme
from plusedit.views.painter import color_of, font_of, pen_of

ROUND = 4.0  # pixels, the radius of the corners
GROUND = "panel@90"


def paint_legend(painter: QPainter, legend: PlacedLegend, theme: Theme) -> None:
    """Draw a legend in its place, on a ground of its own."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(pen_of(theme.color("border"), 1.0, "solid"))
    painter.setBrush(color_of(theme.color(GROUND)))
    painter.drawRoundedRect(QRectF(*legend.box), ROUND, ROUND)
    _paint_bar(painter, legend)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(pen_of(theme.color("text"), 1.0, "solid"))
    painter.drawLines([QLineF(left, y, right, y) for left, right, y in legend.ticks])
    for word in legend.words:
        painter.setFont(font_of(word.size))
        painter.setPen(color_of(theme.color(word.color)))
        painter.drawText(QPointF(word.x, word.y), word.text)


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
