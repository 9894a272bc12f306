"""Below a view of parameters: what its colors stand for, and how many triangles are turned over."""

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QFontMetricsF, QLinearGradient, QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from plusedit.scene.items import Legend
from plusedit.scene.parameter_colors import LOUD, STRIPES, Measure, legend_of
from plusedit.scene.parameter_sheet import ParameterSheet
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.painter import color_of, font_of, painting, pen_of

HEIGHT = 52  # pixels
MARGIN = 12.0
WIDEST = 220.0  # the bar
BAR, TICK, TIP = 10.0, 4.0, 8.0  # high, long, wide
SWATCH = 12.0
WORDS, NUMBERS = 12.0, 11.0  # heights of letters


class ParameterLegend(QWidget):
    """A strip of a fixed height."""

    def __init__(self) -> None:
        super().__init__()
        self.legend: Legend | None = None
        self.text = ""
        self._flips = 0
        self._theme: Theme = LIGHT
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName("legend of the parameters")

    def show_sheet(self, sheet: ParameterSheet | None, measure: Measure, theme: Theme) -> None:
        """Speak of those faces; of nothing where there are none."""
        self._theme = theme
        self.legend = None if sheet is None else legend_of(measure, sheet.stretch, theme)
        self._flips = 0 if sheet is None else sheet.flips
        self.text = "" if sheet is None else turned_over(sheet.flips)
        self.setAccessibleDescription(self.text)
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(240, HEIGHT)

    def paintEvent(self, event: QPaintEvent) -> None:
        with painting(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(self.rect(), color_of(self._theme.color("panel")))
            painter.fillRect(QRectF(0, 0, self.width(), 1), color_of(self._theme.color("border")))
            if self.legend is not None:
                self._paint_flips(painter)
                self._paint_bar(painter, self.legend)

    def _paint_flips(self, painter: QPainter) -> None:
        x, middle = MARGIN, self.height() / 2.0
        if self._flips:
            swatch = QRectF(x, middle - SWATCH / 2.0, SWATCH, SWATCH)
            painter.fillRect(swatch, color_of(LOUD))
            painter.setClipRect(swatch)
            painter.setPen(pen_of("#FFFFFF", STRIPES / 3.0, "solid"))
            for step in range(1, 4):
                end = step * STRIPES * 1.5
                painter.drawLine(QPointF(x, swatch.top() + end), QPointF(x + end, swatch.top()))
            painter.setClipping(False)
            x += SWATCH + 6.0
        painter.setFont(font_of(WORDS))
        painter.setPen(color_of(self._theme.color("text" if self._flips else "quiet")))
        room = QRectF(x, 4.0, max(self._left() - x - MARGIN, 0.0), self.height() - 8.0)
        flags = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(room, int(flags | Qt.TextFlag.TextWordWrap), self.text)

    def _left(self) -> float:
        """Where the bar begins."""
        return self.width() - MARGIN - TIP - min(WIDEST, 0.5 * self.width())

    def _paint_bar(self, painter: QPainter, legend: Legend) -> None:
        left = self._left()
        bar = QRectF(left, 20.0, self.width() - MARGIN - TIP - left, BAR)
        gradient = QLinearGradient(bar.topLeft(), bar.topRight())
        for number, color in enumerate(legend.colors):
            gradient.setColorAt(number / (len(legend.colors) - 1), color_of(color))
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(gradient)
        painter.drawRect(bar)
        for is_open, x, out, color in (
            (legend.is_open[0], bar.left(), -TIP, legend.colors[0]),
            (legend.is_open[1], bar.right(), TIP, legend.colors[-1]),
        ):
            if is_open:
                painter.setBrush(color_of(color))
                corners = (x, bar.top()), (x, bar.bottom()), (x + out, bar.center().y())
                painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        self._paint_words(painter, legend, bar)

    def _paint_words(self, painter: QPainter, legend: Legend, bar: QRectF) -> None:
        painter.setPen(color_of(self._theme.color("text")))
        painter.setFont(font_of(WORDS))
        painter.drawText(QPointF(bar.left(), bar.top() - 6.0), legend.title)
        painter.setFont(font_of(NUMBERS))
        metrics = QFontMetricsF(painter.font())
        for share, text in legend.ticks:
            x = bar.left() + share * bar.width()
            painter.drawLine(QPointF(x, bar.bottom()), QPointF(x, bar.bottom() + TICK))
            half = metrics.horizontalAdvance(text) / 2.0
            x = min(x - half, self.width() - 2.0 * half - 2.0)
            painter.drawText(QPointF(x, bar.bottom() + TICK + NUMBERS), text)


def turned_over(count: int) -> str:
    """Such as "3 triangles are turned over"."""
    if count == 1:
        return "1 triangle is turned over"
    return f"{count:,} triangles are turned over" if count else "No triangle is turned over"
