"""Compares two shapes of a session beside the window's thread, where that takes a while.

As of meshes that are measured, nothing is begun while edits go on.
"""

from threading import Thread

from PySide6.QtCore import QObject, QTimer

from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import overlays
from plusedit.scene.shape_pairs import Party, compare, known_comparison, pair_of, parties_of
from plusedit.views.workers import start_worker

GLANCE = 20  # milliseconds between looks whether it is done
PAUSE = 120  # milliseconds without an edit, after which there is time


class _Job:
    """Two shapes as they are drawn."""

    def __init__(self, first: Party, second: Party) -> None:
        self.parties = first, second
        self.has_failed = False

    def do(self) -> None:
        """In a thread; what is found is kept with the shapes."""
        try:
            compare(*self.parties)
        except (ValueError, MemoryError):
            self.has_failed = True


class PairMeasuring(QObject):
    """Has the pair of a session compared that an overlay shows."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.ready: Event[()] = Event()
        """the pair that is shown is known"""
        self._session = session
        self._is_shown = False
        self._job: _Job | None = None
        self._failed: _Job | None = None
        self._thread: Thread | None = None
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)
        self._rest = QTimer(self, singleShot=True, interval=PAUSE)
        self._rest.timeout.connect(self.begin)
        session.changed.listen(lambda old, new: self._rest.start())
        session.selected.listen(lambda *_: self._rest.start())

    @property
    def is_busy(self) -> bool:
        """Whether something is still to be found."""
        return self._job is not None or self._rest.isActive() or self._wanted() is not None

    def set_options(self, options: ViewOptions) -> None:
        """Compare if that shows it."""
        self._is_shown = any(
            overlays[name].compares for name in options.overlays if name in overlays
        )
        self.begin()

    def begin(self) -> None:
        """Compare what is shown, unless it is known, a thread is at work, or edits go on."""
        if self._job is not None or self._rest.isActive():
            return
        self._job = self._wanted()
        if self._job is not None:
            self._thread = start_worker(self._job.do, "comparing", daemon=True)
            self._glance.start()

    def _wanted(self) -> _Job | None:
        design = self._session.design
        pair = pair_of(design, self._session.selection.shapes) if self._is_shown else None
        if pair is None:
            return None
        parties = parties_of(design, pair)
        if known_comparison(*parties) is not None:
            return None
        if self._failed is not None and self._failed.parties == parties:
            return None
        return _Job(*parties)

    def _look(self) -> None:
        if self._job is None or self._thread is None or self._thread.is_alive():
            return
        if self._job.has_failed:
            self._failed = self._job
        self._job = self._thread = None
        self._glance.stop()
        self.ready.emit()
        self.begin()
