"""How far surfaces are from the meshes of a file: measured beside the work, part by part."""

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from threading import Thread

from PySide6.QtCore import QObject, QTimer

from plusedit.events import Event
from plusedit.geometry.mesh.deviation import Deviation, deviation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.mesh_report import ImportReport
from plusedit.views.workers import start_worker

GLANCE = 50  # milliseconds between looks whether another part is done
BEFORE = 1000  # milliseconds in which the first picture is drawn, without anybody in its way


@dataclass(eq=False)
class _Job:
    """Some surfaces, and what is known of them by now."""

    surfaces: tuple[MeshSurface, ...]
    found: list[Deviation | None] = field(default_factory=list)
    is_cancelled: bool = False

    def do(self) -> None:
        """In a thread; nothing of a surface that can't be measured."""
        for surface in self.surfaces:
            if self.is_cancelled:
                return
            try:
                self.found.append(deviation(surface))
            except (ValueError, MemoryError):
                self.found.append(None)


class MeasuredReport(QObject):
    """A report to which the distances are added as they become known."""

    def __init__(
        self, report: ImportReport, surfaces: Iterable[MeshSurface], parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.changed: Event[()] = Event()
        """more is known"""
        self._report = report
        self._job = _Job(tuple(surfaces))
        self._told = 0
        self._thread: Thread | None = None
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)

    @property
    def report(self) -> ImportReport:
        """With all that is known by now."""
        found = list(self._job.found)
        parts = [
            replace(part, deviation=part.deviation or known)
            for part, known in zip(self._report.parts, found, strict=False)
        ]
        return replace(self._report, parts=(*parts, *self._report.parts[len(parts) :]))

    @property
    def is_measuring(self) -> bool:
        """Whether more will be known."""
        return self._thread is not None

    def begin_soon(self) -> None:
        """Measure, once the window has drawn what was read."""
        QTimer.singleShot(BEFORE, self, self.begin)

    def begin(self) -> None:
        """Measure, unless that is done."""
        is_done = len(self._job.found) == len(self._job.surfaces)
        if self._thread is None and not self._job.is_cancelled and not is_done:
            self._thread = start_worker(self._job.do, "deviation", daemon=True)
            self._glance.start()
            self.changed.emit()

    def cancel(self) -> None:
        """Leave the rest unknown: another mesh has been read."""
        self._job.is_cancelled = True
        self._glance.stop()
        self._thread = None

    def _look(self) -> None:
        known, is_alive = len(self._job.found), self._thread is not None and self._thread.is_alive()
        if not is_alive:
            self._thread = None
            self._glance.stop()
        if known > self._told or not is_alive:
            self._told = known
            self.changed.emit()
