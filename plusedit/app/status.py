"""The status bar: what can be done here, and the numbers under the pointer."""

from math import isfinite

import numpy as np
from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QFontMetrics, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QStatusBar, QWidget

from plusedit.document.shape import ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.tool import Feedback
from plusedit.scene.camera import AXES, Projection
from plusedit.views.desk import Desk
from plusedit.views.look import tabular

PAUSE = 30  # milliseconds between searches for the nearest point
SAID = 6_000  # milliseconds that a sentence stays
USUAL = "F1: keys and mouse   ·   Ctrl+Shift+P: find any command"
NAMES = "xyz"


class Elided(QLabel):
    """A line of text that ends in "…" where there is no room for all of it."""

    def __init__(self) -> None:
        super().__init__()
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
        self.setMinimumWidth(120)

    def setText(self, text: str) -> None:
        super().setText(text)
        self._set_tip()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._set_tip()

    def _set_tip(self) -> None:
        is_cut = QFontMetrics(self.font()).horizontalAdvance(self.text()) > self.width()
        self.setToolTip(self.text() if is_cut else "")

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        mode = Qt.TextElideMode.ElideRight
        text = QFontMetrics(self.font()).elidedText(self.text(), mode, self.width())
        painter.setPen(self.palette().color(self.foregroundRole()))
        align = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        painter.drawText(self.rect(), int(align), text)


class Status(QStatusBar):
    """Left the hint of the tool, or what was just said; right coordinates, u and curvature."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._hint, self._said = "", ""
        self._at: tuple[float, float] | None = None
        self._projection: Projection = "top"
        self.text = Elided()
        self.text.setAccessibleName("hint")
        self.place, self.bend = QLabel(), QLabel()
        for label, widest in ((self.place, "x -0000.000  y -0000.000"), (self.bend, "0" * 24)):
            label.setFont(tabular(label.font()))
            label.setMinimumWidth(label.fontMetrics().horizontalAdvance(widest))
            label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._lay_out()
        self._show_text()
        self._silence = self._timer(SAID, self._be_silent)
        self._look = self._timer(PAUSE, self._measure)
        desk.said.listen(self.say)
        desk.gestures.feedback.listen(self._told)
        desk.session.changed.listen(lambda *_: self._look_soon())

    def say(self, sentence: str) -> None:
        """Show a sentence in place of the hint for a moment."""
        self._said = sentence
        self._show_text()
        self._silence.start()

    def point_at(self, x: float, y: float, projection: Projection) -> None:
        """The pointer is there, in the plane of that projection."""
        self._at, self._projection = (x, y), projection
        self._look_soon()

    def point_nowhere(self) -> None:
        """The pointer has left the view."""
        self._at = None
        self._look_soon()

    def event(self, event: QEvent) -> bool:
        # Tips of menu entries are shown in tooltips; here they would push the hint away.
        if event.type() == QEvent.Type.StatusTip:
            return True
        return super().event(event)

    def _lay_out(self) -> None:
        inside = QWidget()
        row = QHBoxLayout(inside)
        row.setContentsMargins(12, 2, 8, 2)
        row.setSpacing(16)
        row.addWidget(self.text, 1)
        row.addWidget(self.bend)
        row.addWidget(self.place)
        self.addWidget(inside, 1)
        self.setSizeGripEnabled(False)

    def _timer(self, pause: int, act: object) -> QTimer:
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(pause)
        timer.timeout.connect(act)
        return timer

    def _told(self, feedback: Feedback) -> None:
        self._hint = feedback.hint
        if feedback.error:
            self.say(feedback.error)
        self._show_text()

    def _be_silent(self) -> None:
        self._said = ""
        self._show_text()

    def _show_text(self) -> None:
        self.text.setText(self._said or self._hint or USUAL)

    def _look_soon(self) -> None:
        if not self._look.isActive():
            self._look.start()

    def _measure(self) -> None:
        if self._at is None:
            self.place.setText("")
            self.bend.setText("")
            return
        across, up = (NAMES[axis] for axis in AXES[self._projection])
        x, y = self._at
        self.place.setText(f"{across} {x:.3f}  {up} {y:.3f}")
        found = self._nearest_curve()
        self.bend.setText("" if found is None else bend_text(found, self._at, self._projection))

    def _nearest_curve(self) -> PlusCurve | None:
        curves = self._desk.selected_curves()
        active = self._desk.session.selection.active
        key: ShapeId | None = active.shape if active is not None else next(iter(curves), None)
        return None if key is None else curves.get(key)


def bend_text(curve: PlusCurve, at: tuple[float, float], projection: Projection) -> str:
    """Parameter and curvature of the point of `curve` nearest to a point of the view."""
    from plusedit.geometry.frames import curvature, space_curvature
    from plusedit.geometry.nearest import nearest_parameter

    axes = AXES[projection]
    if max(axes) >= curve.dimension:
        return ""
    u = nearest_parameter(curve, np.array(at), axes=axes)
    _, velocity, acceleration = curve.derivatives([u])
    bend = (curvature if curve.dimension == 2 else space_curvature)(velocity, acceleration)[0]
    bend += 0.0  # a straight line has no "-0"
    return f"u {u:.4f}   κ {bend:.4g}" if isfinite(bend) else f"u {u:.4f}   κ –"
