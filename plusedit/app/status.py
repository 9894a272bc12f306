"""The status bar: what can be done here, and the numbers under the pointer."""

from collections.abc import Iterator

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QFontMetrics, QPainter, QPaintEvent, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QStatusBar, QWidget

from plusedit.document.shape import Geometry, ShapeId
from plusedit.interaction.facets import surfaces_under
from plusedit.interaction.picking import curves_under
from plusedit.interaction.readout import number
from plusedit.interaction.tool import Feedback
from plusedit.views.desk import Desk
from plusedit.views.look import tabular
from plusedit.views.panes import Panes
from plusedit.views.probe import reading

PAUSE = 30  # milliseconds between searches for the nearest point
SAID = 6_000  # milliseconds that a sentence stays
USUAL = "F1: keys and mouse   ·   Ctrl+Shift+P: find any command"
NAMES = "xyz"
PLACES = 3  # behind the point
NEAR = 40.0  # pixels to a curve that is told of before others that are chosen, too

Coordinates = tuple[tuple[int, float], ...]
"""What is known of a place: axis and value of each coordinate."""


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

    def __init__(self, desk: Desk, panes: Panes) -> None:
        super().__init__()
        self._desk, self._panes = desk, panes
        self._hint, self._said = "", ""
        self._at: Coordinates | None = None
        self._read = "", ""
        """what a panel says of the place under the pointer"""
        self.text = Elided()
        self.text.setAccessibleName("hint")
        self.place, self.bend = QLabel(), QLabel()
        for label, widest in ((self.place, "x −0000.000  y −0000.000"), (self.bend, "0" * 28)):
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
        desk.pointed.listen(self._pointed)
        desk.hinted.listen(lambda hint: self._told(Feedback(hint=hint)))

    def say(self, sentence: str) -> None:
        """Show a sentence in place of the hint for a moment."""
        self._said = sentence
        self._show_text()
        self._silence.start()

    def point_at(self, at: Coordinates) -> None:
        """The pointer is there, in the view in use."""
        self._at = at
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

    def _pointed(self, place: str, found: str) -> None:
        self._read = place, found
        self._at = None
        self._look_soon()

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
            self.place.setText(self._read[0])
            self.bend.setText(self._read[1])
            return
        self.place.setText(
            "  ".join(f"{NAMES[axis]} {number(value, PLACES)}" for axis, value in self._at)
        )
        view, options = self._panes.active, self._desk.gestures.stage().options
        readings = (reading(g, view.camera, view.pointer.at, options) for g in self._probed())
        self.bend.setText(next(filter(None, readings), ""))

    def _probed(self) -> Iterator[Geometry]:
        """The shapes that numbers are told of: of the first that has a point at the pointer.

        Of several that are chosen that under the pointer; else that with the active line, the first
        chosen, or what lies under the pointer.
        """
        design, selection = self._desk.session.design, self._desk.session.selection
        active = selection.active
        chosen = [i for i in design if i in selection.shapes]
        stage, at = self._desk.gestures.stage(), self._panes.active.pointer.at
        if len(chosen) > 1:
            for hit in curves_under(at, stage, NEAR):
                if hit.shape in chosen:
                    yield design[hit.shape].geometry
        key: ShapeId | None = active.shape if active is not None else next(iter(chosen), None)
        if key is not None and key in design:
            yield design[key].geometry
        for hit in surfaces_under(at, stage)[:1]:
            if hit.shape in design:
                yield design[hit.shape].geometry
