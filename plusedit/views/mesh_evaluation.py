"""Evaluates surfaces of meshes beside the window's thread: the newest wish first.

While a slider moves, wishes come faster than surfaces are evaluated. One thread at a time works on
one surface; what was wished for meanwhile and is no longer shown is never begun.
"""

from collections.abc import Iterable
from dataclasses import dataclass, field
from threading import Thread
from weakref import WeakSet

from PySide6.QtCore import QObject, QTimer

from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.drawn_mesh import MeshDrawing, evaluated, keep, known_drawing
from plusedit.views.workers import start_worker

GLANCE = 4  # milliseconds between looks whether a surface is done
PAUSE = 150  # milliseconds without an edit, after which accuracy comes before speed


@dataclass(eq=False)
class _Job:
    """One surface to evaluate, and what came of it."""

    surface: MeshSurface
    is_quick: bool
    found: list[MeshDrawing] = field(default_factory=list)

    def do(self) -> None:
        """In a thread; without a result where the numbers make no surface."""
        try:
            self.found.append(_evaluated(self.surface, quick=self.is_quick))
        except (ValueError, MemoryError):
            return


class MeshEvaluation(QObject):
    """Has the meshes of a session evaluated as they are edited."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.ready: Event[()] = Event()
        """another surface can be drawn as it is now"""
        self._session = session
        self._job: _Job | None = None
        self._thread: Thread | None = None
        self._failed: WeakSet[MeshSurface] = WeakSet()
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)
        self._rest = QTimer(self, singleShot=True, interval=PAUSE)
        self._rest.timeout.connect(self._begin)
        session.changed.listen(self._changed)

    @property
    def is_busy(self) -> bool:
        """Whether a surface on the screen is still to be evaluated."""
        return self._job is not None or self._rest.isActive() or self._wanted() is not None

    def _changed(self, old: Design, new: Design) -> None:
        if any(old.shapes.get(i) is not new.shapes[i] for i, _ in new.meshes()):
            self._rest.start()
            self._begin()

    def _begin(self) -> None:
        """Start on what is wanted most, unless a thread is at work."""
        job = None if self._job is not None else self._wanted()
        if job is not None:
            self._job = job
            self._thread = start_worker(job.do, "mesh", daemon=True)
            self._glance.start()

    def _wanted(self) -> _Job | None:
        """First what can't be drawn at all, quickly; once the design rests, all accurately."""
        design = self._session.design
        shown = [mesh for i, mesh in design.meshes() if design[i].visible]
        missing = [mesh for mesh in self._left(shown) if known_drawing(mesh) is None]
        if missing:
            return _Job(missing[0], is_quick=True)
        if self._session.is_previewing or self._rest.isActive():
            return None
        rough = [m for m in self._left(shown) if (d := known_drawing(m)) and not d.is_exact]
        return _Job(rough[0], is_quick=False) if rough else None

    def _left(self, meshes: Iterable[MeshSurface]) -> list[MeshSurface]:
        return [mesh for mesh in meshes if mesh not in self._failed]

    def _look(self) -> None:
        job = self._job
        if job is None or self._thread is None or self._thread.is_alive():
            return
        self._job = self._thread = None
        self._glance.stop()
        if job.found:
            keep(job.surface, job.found[0])
            self.ready.emit()
        else:
            self._failed.add(job.surface)
        self._begin()


def _evaluated(surface: MeshSurface, *, quick: bool) -> MeshDrawing:
    drawing = evaluated(surface, quick=MeshSurface.at if quick else None)
    # Worked out here and not when it is drawn, which is in the window's thread.
    _ = drawing.normals
    return drawing
