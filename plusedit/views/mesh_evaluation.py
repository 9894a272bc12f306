"""Evaluates surfaces of meshes beside the window's thread: the newest wish first.

While a slider moves, wishes come faster than surfaces are evaluated. One thread at a time works on
one surface, nearly right at first; what was wished for meanwhile and is no longer shown is never
begun. Once the design rests, surfaces are evaluated to full accuracy, which ends at the next wish.
"""

from dataclasses import dataclass, field
from threading import Thread
from time import perf_counter
from weakref import WeakSet

from PySide6.QtCore import QObject, QTimer

from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from plusedit.events import Event
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.drawn_mesh import (
    Known,
    evaluated,
    keep,
    known_before,
    known_drawing,
    previewed,
)
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.views.workers import start_worker

GLANCE = 4  # milliseconds between looks whether a surface is done
PAUSE = 150  # milliseconds without an edit, after which accuracy comes before speed
MANY = 8  # surfaces: of more, what is ready is told together
TOGETHER = 1.0  # seconds

Wish = tuple[ShapeId, MeshSurface]


class _UnwantedError(Exception):
    """Ends an evaluation of which nobody will see the result."""


@dataclass(eq=False)
class _Job:
    """One surface to evaluate, and what came of it."""

    shape: ShapeId
    surface: MeshSurface
    before: Known | None
    is_quick: bool
    is_unwanted: bool = False
    found: list[MeshDrawing] = field(default_factory=list)

    def do(self) -> None:
        """In a thread; without a result where the numbers make no surface."""
        try:
            self.found.append(self._evaluated())
        except (ValueError, MemoryError, _UnwantedError):
            return

    def _evaluated(self) -> MeshDrawing:
        if self.is_quick:
            return previewed(self.surface, self.before)
        return evaluated(self.surface, self.before, self._check)

    def _check(self) -> None:
        if self.is_unwanted:
            raise _UnwantedError


class MeshEvaluation(QObject):
    """Has the meshes of a session evaluated as they are edited."""

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.ready: Event[()] = Event()
        """another surface can be drawn as it is now"""
        self._session = session
        self._job: _Job | None = None
        self._thread: Thread | None = None
        self._is_news, self._told = False, 0.0
        """whether something is ready that is not told yet, and when something was"""
        self._last: ShapeId | None = None
        """the shape that was evaluated last"""
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
        job = self._job
        if job is not None and not job.is_quick:
            is_shown = any(surface is job.surface for _, surface in self._shown())
            job.is_unwanted = not is_shown or bool(self._missing())
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
        wishes = self._missing()
        is_quick = bool(wishes)
        if not wishes and not self._rest.isActive():
            wishes = [wish for wish in self._shown() if not _is_exact(wish[1])]
        if not wishes:
            return None
        # Of several that are edited together each gets its turn.
        places = [shape_id for shape_id, _ in wishes]
        turn = places.index(self._last) + 1 if self._last in places else 0
        shape_id, surface = wishes[turn % len(wishes)]
        return _Job(shape_id, surface, known_before(surface), is_quick)

    def _missing(self) -> list[Wish]:
        return [wish for wish in self._shown() if known_drawing(wish[1]) is None]

    def _shown(self) -> list[Wish]:
        design = self._session.design
        return [
            (shape_id, mesh)
            for shape_id, mesh in design.meshes()
            if design[shape_id].visible and mesh not in self._failed
        ]

    def _look(self) -> None:
        job = self._job
        if job is None or self._thread is None or self._thread.is_alive():
            return
        self._job = self._thread = None
        self._glance.stop()
        self._last = job.shape
        if job.found:
            keep(job.surface, job.found[0])
            self._is_news = True
        elif not job.is_unwanted:
            self._failed.add(job.surface)
        self._begin()
        self._tell()

    def _tell(self) -> None:
        """Say that something is ready; of many surfaces not each, for each makes all be drawn."""
        is_time = perf_counter() - self._told > TOGETHER or self._job is None
        if self._is_news and (is_time or len(self._shown()) <= MANY):
            self._is_news = False
            self.ready.emit()
            self._told = perf_counter()


def _is_exact(surface: MeshSurface) -> bool:
    drawing = known_drawing(surface)
    return drawing is not None and drawing.is_exact
