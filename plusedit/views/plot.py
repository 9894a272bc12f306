"""A plot of functions with a cursor, in the look of the program."""

import numpy as np
from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QFontMetricsF,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPixmap,
    QResizeEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from plusedit.scene.plots import UPWARDS, Plot, PlotLine, PlotMark
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.arrays import polygon_of
from plusedit.views.look import tabular
from plusedit.views.painter import color_of, font_of, painting, pen_of

LEFT, RIGHT, TOP, BOTTOM = 46.0, 12.0, 26.0, 22.0  # pixels around what is plotted
NUMBERS, WORDS = 11.0, 12.0  # heights of letters
MARK_BELOW = 30.0  # pixels from the top to the base line: below a legend inside
SAMPLE = 14.0  # of a line in the legend
HANDLE = 5.0  # radius of the grip of a cursor that can be dragged
NEAR = 7.0  # pixels within which a mark holds the cursor


class PlotView(QWidget):
    """Shows one plot. The cursor follows the pointer, or is dragged."""

    pointed = Signal(object)
    """the x under the pointer; None once it has left"""
    moved = Signal(float)
    """the cursor is dragged there"""
    settled = Signal()
    dropped = Signal()
    """the drag was broken off: everything as before"""

    def __init__(self, name: str, *, draggable: bool = False) -> None:
        super().__init__()
        self.setAccessibleName(name)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setMouseTracking(True)
        self.setMinimumSize(56, 90)
        self._draggable = draggable
        if draggable:
            self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
            self.setCursor(Qt.CursorShape.SizeHorCursor)
        self._plot: Plot | None = None
        self._theme: Theme = LIGHT
        self._cursor: float | None = None
        self._is_held = False
        self._still: QPixmap | None = None
        """all but the cursor"""

    @property
    def plot(self) -> Plot | None:
        """What is shown."""
        return self._plot

    @property
    def cursor_x(self) -> float | None:
        """Where the cursor stands."""
        return self._cursor

    @property
    def is_held(self) -> bool:
        """Whether the cursor is being dragged."""
        return self._is_held

    def show_plot(self, plot: Plot | None, theme: Theme) -> None:
        """Show that, in those colors."""
        if plot is not self._plot or theme is not self._theme:
            self._plot, self._theme, self._still = plot, theme, None
            self.setToolTip("" if plot is None else plot.words)
            self.update()

    def show_cursor(self, x: float | None) -> None:
        """Let the cursor stand there, or nowhere."""
        if x != self._cursor:
            self._cursor = x
            self.update()

    def drop(self) -> bool:
        """Break off the drag; whether there was one."""
        was_held, self._is_held = self._is_held, False
        if was_held:
            self.dropped.emit()
        return was_held

    def x_of(self, pixel: float) -> float:
        """The x that is shown that many pixels from the left edge, within the axis."""
        area = self._area()
        share = min(max((pixel - area.left()) / max(area.width(), 1.0), 0.0), 1.0)
        return 0.0 if self._plot is None else self._plot.x.value(share)

    def pixel_of(self, x: float) -> float:
        """How far from the left edge an x is shown."""
        area = self._area()
        share = 0.0 if self._plot is None else self._plot.x.share(x)
        return area.left() + share * area.width()

    # What Qt tells

    def sizeHint(self) -> QSize:
        return QSize(220, 170)

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._still = None
        super().resizeEvent(event)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.RightButton:
            self.drop()
        elif event.button() == Qt.MouseButton.LeftButton and self._plot is not None:
            self._is_held = self._draggable
            self._go(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        self._go(event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._is_held and event.button() == Qt.MouseButton.LeftButton:
            self._is_held = False
            self.settled.emit()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self.pointed.emit(None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() != Qt.Key.Key_Escape or not self.drop():
            super().keyPressEvent(event)

    def _go(self, event: QMouseEvent) -> None:
        if self._plot is None:
            return
        pixel = event.position().x()
        x = self.x_of(pixel)
        if self._is_held:
            is_free = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            holding = [m.x for m in self._plot.marks if m.text and not is_free]
            near = [mark for mark in holding if abs(self.pixel_of(mark) - pixel) <= NEAR]
            self.moved.emit(near[0] if near else x)
        else:
            self.pointed.emit(x)

    # How it looks

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._still is None:
            self._still = self._drawn()
        with painting(self) as painter:
            painter.drawPixmap(0, 0, self._still)
            if self._plot is not None and self._cursor is not None:
                self._paint_cursor(painter, self._plot, self._cursor)

    def _area(self) -> QRectF:
        width, height = float(self.width()), float(self.height())
        return QRectF(LEFT, TOP, max(width - LEFT - RIGHT, 1.0), max(height - TOP - BOTTOM, 1.0))

    def _drawn(self) -> QPixmap:
        ratio = self.devicePixelRatioF()
        pixmap = QPixmap(self.size() * ratio)
        pixmap.setDevicePixelRatio(ratio)
        pixmap.fill(self._color("panel"))
        if self._plot is not None:
            with painting(pixmap) as painter:
                painter.setRenderHint(QPainter.RenderHint.Antialiasing)
                self._paint_ground(painter, self._plot)
                painter.setClipRect(self._area().adjusted(-1.0, -1.0, 1.0, 1.0))
                for line in self._plot.lines:
                    self._paint_line(painter, self._plot, line)
                painter.setClipping(False)
                self._paint_legend(painter, self._plot)
        return pixmap

    def _paint_ground(self, painter: QPainter, plot: Plot) -> None:
        area = self._area()
        painter.fillRect(area, self._color("canvas"))
        if plot.inside is not None:
            left, right = (self.pixel_of(x) for x in plot.inside)
            for low, high in ((area.left(), left), (right, area.right())):
                outside = QRectF(low, area.top(), max(high - low, 0.0), area.height())
                painter.fillRect(outside, self._color("border@45"))
        painter.setFont(tabular(font_of(NUMBERS)))
        self._paint_heights(painter, plot, area)
        self._paint_widths(painter, plot, area)
        for mark in plot.marks:
            self._paint_mark(painter, mark, area)

    def _paint_heights(self, painter: QPainter, plot: Plot, area: QRectF) -> None:
        flags = int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for value, text in plot.y.ticks(area.height(), UPWARDS):
            y = round(area.bottom() - plot.y.share(value) * area.height()) + 0.5
            is_zero = value == 0.0 and not plot.y.is_logarithmic
            painter.setPen(
                pen_of(self._theme.color("quiet@60" if is_zero else "major"), 1.0, "solid")
            )
            painter.drawLine(QLineF(area.left(), y, area.right(), y))
            painter.setPen(self._color("quiet"))
            painter.drawText(QRectF(0.0, y - 8.0, LEFT - 6.0, 16.0), flags, text)

    def _paint_widths(self, painter: QPainter, plot: Plot, area: QRectF) -> None:
        flags = int(Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        painter.setPen(self._color("quiet"))
        for value, text in plot.x.ticks(area.width()):
            x = self.pixel_of(value)
            painter.drawLine(QLineF(x, area.bottom(), x, area.bottom() + 3.0))
            box = QRectF(x - 30.0, area.bottom() + 4.0, 60.0, 16.0)
            painter.drawText(box, flags, text)
        corner = QRectF(0.0, area.bottom() + 4.0, LEFT - 10.0, 16.0)
        painter.drawText(corner, int(Qt.AlignmentFlag.AlignRight), plot.x_name)

    def _paint_mark(self, painter: QPainter, mark: PlotMark, area: QRectF) -> None:
        x = self.pixel_of(mark.x)
        if not area.left() - 0.5 <= x <= area.right() + 0.5:
            return
        painter.setPen(pen_of(self._theme.color(mark.color), 1.0, mark.dash))
        if mark.is_tick:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(self._color(mark.color))
            foot = area.bottom()
            tip = [QPointF(x, foot - 6.0), QPointF(x + 3.5, foot), QPointF(x - 3.5, foot)]
            painter.drawPolygon(tip)
            painter.setBrush(Qt.BrushStyle.NoBrush)
        else:
            painter.drawLine(QLineF(x, area.top(), x, area.bottom()))
        if mark.text:
            metrics = QFontMetricsF(painter.font())
            width = metrics.horizontalAdvance(mark.text)
            left = x + 3.0 if x + 3.0 + width < area.right() else x - 3.0 - width
            painter.setPen(self._color(mark.color))
            painter.drawText(QPointF(left, area.top() + MARK_BELOW), mark.text)

    def _paint_line(self, painter: QPainter, plot: Plot, line: PlotLine) -> None:
        area = self._area()
        x = area.left() + plot.x.shares(line.x) * area.width()
        y = area.bottom() - plot.y.shares(line.y) * area.height()
        # What is far beyond the plot can't be drawn, and need not be.
        y = np.clip(y, area.top() - 2.0 * area.height(), area.bottom() + 2.0 * area.height())
        points = np.column_stack([x, y])
        known = np.isfinite(points).all(axis=1)
        painter.setPen(pen_of(self._theme.color(line.color), line.width, line.dash))
        ends = np.flatnonzero(np.diff(np.concatenate([[False], known, [False]]).astype(int)))
        for start, end in ends.reshape(-1, 2).tolist():
            painter.drawPolyline(polygon_of(points[start:end]))

    def _paint_legend(self, painter: QPainter, plot: Plot) -> None:
        """The title with the unit on the left; names of lines on the right, or else inside."""
        area, base = self._area(), 17.0
        painter.setFont(font_of(WORDS))
        metrics = QFontMetricsF(painter.font())
        painter.setPen(self._color("text"))
        room = max(area.right() - 8.0, 1.0)
        title = metrics.elidedText(plot.title, Qt.TextElideMode.ElideRight, room)
        painter.drawText(QPointF(8.0, base), title)
        x = 8.0 + metrics.horizontalAdvance(plot.title) + 6.0
        painter.setPen(self._color("quiet"))
        if x + metrics.horizontalAdvance(plot.unit) <= area.right():
            painter.drawText(QPointF(x, base), plot.unit)
        x += metrics.horizontalAdvance(plot.unit) + 8.0
        painter.setFont(font_of(NUMBERS))
        metrics = QFontMetricsF(painter.font())
        named = [line for line in plot.lines if line.name]
        widths = [SAMPLE + 5.0 + metrics.horizontalAdvance(line.name) + 10.0 for line in named]
        left = area.right() + 10.0 - sum(widths)
        if left < area.left():
            return
        if left < x:
            base = area.top() + 15.0
        for line, width in zip(named, widths, strict=True):
            painter.setPen(pen_of(self._theme.color(line.color), line.width, line.dash))
            painter.drawLine(QLineF(left, base - 4.0, left + SAMPLE, base - 4.0))
            painter.setPen(self._color("quiet"))
            painter.drawText(QPointF(left + SAMPLE + 5.0, base), line.name)
            left += width

    def _paint_cursor(self, painter: QPainter, plot: Plot, at: float) -> None:
        area, x = self._area(), self.pixel_of(at)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        color = self._theme.color("hover")
        painter.setPen(pen_of(color, 1.25, "solid"))
        painter.drawLine(QLineF(x, area.top(), x, area.bottom()))
        painter.setBrush(color_of(color))
        painter.setPen(pen_of(self._theme.color("panel"), 1.0, "solid"))
        for line in plot.lines:
            if line.width > 1.0:
                y = plot.y.share(float(np.interp(at, line.x, line.y)))
                if 0.0 <= y <= 1.0:
                    painter.drawEllipse(QPointF(x, area.bottom() - y * area.height()), 3.0, 3.0)
        if self._draggable:
            painter.drawEllipse(QPointF(x, area.bottom()), HANDLE, HANDLE)

    def _color(self, role: str) -> QColor:
        return color_of(self._theme.color(role))
