"""Sliders with marks: of s / L from 0 to 2, of s of meshes, and of their smoothness."""

from dataclasses import dataclass
from math import exp, log

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPen,
    QWheelEvent,
)
from PySide6.QtWidgets import QSizePolicy, QWidget

from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.own_keys import OwnKeys

STEP = 0.01  # of L, for a key or a notch of the wheel
PAUSE = 400  # milliseconds after the last notch or key before the edit is one step
HEIGHT = 42  # logical pixels
KNOB = 7.0  # radius in logical pixels
KEYS = {
    Qt.Key.Key_Left: -1,
    Qt.Key.Key_Down: -1,
    Qt.Key.Key_Minus: -1,
    Qt.Key.Key_Right: 1,
    Qt.Key.Key_Up: 1,
    Qt.Key.Key_Plus: 1,
    Qt.Key.Key_Equal: 1,
    Qt.Key.Key_PageDown: -10,
    Qt.Key.Key_PageUp: 10,
}


@dataclass(frozen=True)
class Scale:
    """What a slider runs over."""

    name: str
    tip: str
    high: float
    low: float = 0.0
    usual: float = 0.5
    """where keys begin from where there is no value"""
    marks: tuple[tuple[float, str], ...] = ()
    special: tuple[tuple[float, str], ...] = ()
    """marks that stand out, and that the knob sticks to"""
    step: float = STEP
    """for a key or a notch of the wheel; of the logarithm where the scale is logarithmic"""
    is_logarithmic: bool = False

    def share(self, value: float) -> float:
        """How far from left to right a value lies, from 0 to 1."""
        if self.is_logarithmic:
            return log(min(self.high, max(self.low, value)) / self.low) / log(self.high / self.low)
        return (min(self.high, max(self.low, value)) - self.low) / (self.high - self.low)

    def value(self, share: float) -> float:
        """The value that lies so far from left to right."""
        share = min(1.0, max(0.0, share))
        if self.is_logarithmic:
            return self.low * exp(share * log(self.high / self.low))
        return self.low + (self.high - self.low) * share

    def stepped(self, value: float, steps: int) -> float:
        """The value some steps on; without end where the scale is linear."""
        if not self.is_logarithmic:
            return round(value + self.step * steps, 10)
        return min(self.high, max(self.low, value * exp(self.step * steps)))


OF_LENGTH = Scale(
    "s / L",
    "How strongly the control lines pull: s in units of L, the length of the control "
    "polygon.\nDouble-click: back to L / 2. Keys − and + or the wheel: 1 % of L.",
    2.0,
    marks=((0.5, "½ L"), (1.0, "L"), (1.5, "1½ L"), (2.0, "2 L")),
    special=((0.0, "classical"),),
)
OF_MESHES = Scale(
    "s",
    "How much of the planes of the faces is used: 0 their points alone, 1 the planes as they "
    "are.\nDouble-click: back to 1. Keys − and + or the wheel: 0.01.",
    1.5,
    usual=1.0,
    marks=((0.5, "½"), (1.5, "1½")),
    special=((0.0, "points alone"), (1.0, "the faces' planes")),
)
OF_SMOOTHNESS = Scale(
    "S",
    "Smoothness: how much detail is left, in radii of the faces.\n"
    "Double-click: back to 0.7. Keys − and + or the wheel: 2 %.",
    16.0,
    low=0.25,
    usual=0.7,
    marks=((0.25, "¼"), (0.5, "½"), (1.0, "1"), (2.0, "2"), (4.0, "4"), (8.0, "8"), (16.0, "16")),
    special=((0.7, "0.7"),),
    step=0.02,
    is_logarithmic=True,
)


class MagnitudeSlider(QWidget):
    """Emits `moved` while it is dragged and `settled` once when it is let go."""

    moved = Signal(float)
    settled = Signal()
    dropped = Signal()
    """the drag was broken off: everything as before"""
    reset_asked = Signal()

    def __init__(self, scale: Scale = OF_LENGTH) -> None:
        super().__init__()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._own_keys = OwnKeys(self, KEYS)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.set_scale(scale)
        self._theme = LIGHT
        self.ratio: float | None = 0.5
        """None where the shapes differ, or there are none"""
        self.best: float | None = None
        """s* / L, where the curve comes closest to its control points"""
        self._is_held = False
        self._pause = QTimer(self)
        self._pause.setSingleShot(True)
        self._pause.setInterval(PAUSE)
        self._pause.timeout.connect(self.settled)

    @property
    def theme(self) -> Theme:
        """The colors that it is drawn in."""
        return self._theme

    @theme.setter
    def theme(self, theme: Theme) -> None:
        if theme != self._theme:
            self._theme = theme
            self.update()

    @property
    def is_busy(self) -> bool:
        """Whether a drag, or a run of keys or notches, is under way."""
        return self._is_held or self._pause.isActive()

    def sizeHint(self) -> QSize:
        return QSize(360, HEIGHT)

    def minimumSizeHint(self) -> QSize:
        return QSize(160, HEIGHT)

    def set_scale(self, scale: Scale) -> None:
        """Run over that from now on."""
        self.scale = scale
        self.setAccessibleName(scale.name)
        self.setToolTip(scale.tip)
        self.update()

    def show_ratio(self, ratio: float | None, best: float | None) -> None:
        """Stand at `ratio` with a mark at `best`."""
        if (ratio, best) != (self.ratio, self.best):
            self.ratio, self.best = ratio, best
            self.update()

    def drop(self) -> None:
        """Break off what is under way."""
        if self.is_busy:
            self._is_held = False
            self._pause.stop()
            self.dropped.emit()

    def finish(self) -> None:
        """Settle now what waits for a pause."""
        if self._pause.isActive():
            self._pause.stop()
            self.settled.emit()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.RightButton:
            self.drop()
        elif event.button() == Qt.MouseButton.LeftButton and self.isEnabled():
            self.finish()
            self._is_held = True
            knob = None if self.ratio is None else self._x(self.ratio)
            x = event.position().x()
            # Taken by the knob it moves with the pointer; taken beside it, it jumps there first.
            self._grip = x - knob if knob is not None and abs(x - knob) <= KNOB + 3 else 0.0
            if not self._grip and knob != x:
                self._drag(x, snapped=True)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._is_held:
            is_free = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self._drag(event.position().x() - self._grip, snapped=not is_free)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._is_held and event.button() == Qt.MouseButton.LeftButton:
            self._is_held = False
            self.settled.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.drop()
        self.reset_asked.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        if turned := event.angleDelta().y():
            self._step(1 if turned > 0 else -1)
        event.accept()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = Qt.Key(event.key())
        if key == Qt.Key.Key_Escape:
            self.drop()
        elif key == Qt.Key.Key_Home:
            self.moved.emit(self.scale.low)
            self._pause.start()
        elif steps := KEYS.get(key):
            self._step(steps)
        else:
            super().keyPressEvent(event)

    def _step(self, steps: int) -> None:
        if self.isEnabled() and not self._is_held:
            start = self.ratio if self.ratio is not None else self.scale.usual
            self.moved.emit(self.scale.stepped(start, steps))
            self._pause.start()

    def _drag(self, x: float, *, snapped: bool) -> None:
        left, width = self._track()
        ratio = self.scale.value((x - left) / width)
        marks = [mark for mark, _ in self._special()]
        near = [mark for mark in marks if abs(self._x(mark) - x) <= 4.0]
        self.moved.emit(near[0] if snapped and near else round(ratio, 4))

    def _track(self) -> tuple[float, float]:
        margin = KNOB + 2.0
        return margin, max(1.0, self.width() - 2.0 * margin)

    def _x(self, ratio: float) -> float:
        left, width = self._track()
        return left + width * self.scale.share(ratio)

    def _special(self) -> list[tuple[float, str]]:
        best = [] if self.best is None else [(self.best, "s*")]
        return [*self.scale.special, *best]

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setOpacity(1.0 if self.isEnabled() else 0.4)
        y = 15.0
        self._draw_track(painter, y)
        self._draw_marks(painter, y)
        if self.ratio is not None:
            self._draw_knob(painter, QPointF(self._x(self.ratio), y))

    def _draw_track(self, painter: QPainter, y: float) -> None:
        left, width = self._track()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(self.theme.color("border")))
        painter.drawRoundedRect(QRectF(left, y - 2, width, 4), 2, 2)
        if self.ratio is not None:
            painter.setBrush(QColor(self.theme.color("accent")))
            painter.drawRoundedRect(QRectF(left, y - 2, self._x(self.ratio) - left, 4), 2, 2)

    def _draw_marks(self, painter: QPainter, y: float) -> None:
        font = QFont(self.font())
        font.setPointSizeF(max(7.0, font.pointSizeF() * 0.82))
        painter.setFont(font)
        quiet = QColor(self.theme.color("quiet"))
        taken: list[QRectF] = []
        special = self._special()
        for ratio, text in [*special, *self.scale.marks]:
            if not self.scale.low <= ratio <= self.scale.high:
                continue
            x, is_special = self._x(ratio), (ratio, text) in special
            painter.setPen(QPen(QColor(self.theme.color("accent")) if is_special else quiet, 1.5))
            if is_special:
                painter.drawLine(QPointF(x, y + 5), QPointF(x, y + 10))
            else:
                painter.drawPoint(QPointF(x, y + 8))
            width = painter.fontMetrics().horizontalAdvance(text)
            start = min(max(0.0, x - width / 2.0), self.width() - width)
            place = QRectF(start, y + 11, width + 1, 14)
            if not any(place.adjusted(-4, 0, 4, 0).intersects(other) for other in taken):
                painter.setPen(quiet)
                painter.drawText(place, int(Qt.AlignmentFlag.AlignCenter), text)
                taken.append(place)

    def _draw_knob(self, painter: QPainter, at: QPointF) -> None:
        accent = QColor(self.theme.color("accent"))
        painter.setPen(QPen(accent, 2.0))
        painter.setBrush(QColor(self.theme.color("panel")))
        painter.drawEllipse(at, KNOB - 1, KNOB - 1)
        if self.hasFocus():
            halo = QColor(accent)
            halo.setAlpha(60)
            painter.setPen(QPen(halo, 4.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawEllipse(at, KNOB + 2, KNOB + 2)
