"""Between views and panels: where the pointer is in a view, and what a panel points at."""

from PySide6.QtCore import QObject, QTimer

from plusedit.interaction.spotting import Spot
from plusedit.views.desk import Desk
from plusedit.views.panes import Panes

PAUSE = 30  # milliseconds between two places that are told


class PointerLink(QObject):
    """Tells panels that listen of the pointer, and views of marks."""

    def __init__(self, desk: Desk, panes: Panes) -> None:
        super().__init__(panes)
        self._desk, self._panes = desk, panes
        self._is_inside = False
        self._timer = QTimer(self)
        self._timer.setSingleShot(True)
        self._timer.setInterval(PAUSE)
        self._timer.timeout.connect(self._tell)
        panes.pointer_moved.connect(lambda at: self._soon(is_inside=True))
        panes.pointer_left.connect(lambda: self._soon(is_inside=False))
        desk.marked.listen(self._mark)

    def _soon(self, *, is_inside: bool) -> None:
        self._is_inside = is_inside
        if self._desk.pointer_moved.is_heard and not self._timer.isActive():
            self._timer.start()

    def _tell(self) -> None:
        at = self._panes.active.pointer if self._is_inside else None
        self._desk.pointer_moved.emit(at, self._desk.gestures.stage())

    def _mark(self, spot: Spot | None) -> None:
        for canvas in self._panes.canvases:
            canvas.show_mark(spot)
