"""Widgets that follow the session: many changes in a row make one refresh."""

from abc import abstractmethod
from collections.abc import Iterable
from typing import TypeVar

from PySide6.QtCore import QTimer
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QWidget

from plusedit.views.desk import Desk

PAUSE = 10  # milliseconds: what changes together is shown together
PAUSE_OF_DRAG = 50  # milliseconds: numbers may lag behind a drag, so that the drawing need not

T = TypeVar("T")


class LiveWidget(QWidget):
    """Shows a part of the session and is refreshed soon after it changed, if it can be seen."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self.desk = desk
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self.refresh)
        desk.session.changed.listen(self._soon)
        desk.session.selected.listen(self._soon)
        desk.theme_changed.listen(self._soon)

    @abstractmethod
    def refresh(self) -> None:
        """Show what the session holds now."""

    def showEvent(self, event: QShowEvent) -> None:
        self.refresh()
        super().showEvent(event)

    def _soon(self, *_: object) -> None:
        if self.isVisible() and not self._timer.isActive():
            self._timer.start(PAUSE_OF_DRAG if self.desk.session.is_previewing else PAUSE)


def common(values: Iterable[T]) -> T | None:
    """What all of them are, or None where two differ (or there are none)."""
    found: T | None = None
    for number, value in enumerate(values):
        if number and value != found:
            return None
        found = value
    return found


def title(text: str) -> QLabel:
    """A heading inside a pane."""
    label = QLabel(text)
    label.setProperty("title", True)
    return label


def quiet(text: str = "") -> QLabel:
    """A label in the quiet color that may take several lines."""
    label = QLabel(text)
    label.setProperty("quiet", True)
    label.setWordWrap(True)
    return label


def rule() -> QFrame:
    """A hairline between groups."""
    line = QFrame()
    line.setProperty("rule", True)
    line.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
    return line
