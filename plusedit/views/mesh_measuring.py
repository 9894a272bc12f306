"""Finds beside the window's thread what is known of surfaces of meshes only after a while.

How far they are from their meshes, and the values that an overlay colors them by. What is found is
of the very points that are drawn. While a slider moves nothing is begun, for the picture comes
first; of what was wished for meanwhile only what is still drawn is found. Previews are measured
only where they stay all that there is: the accurate surface is on its way.
"""

from dataclasses import dataclass
from threading import Thread
from time import perf_counter
from typing import TypeAlias
from weakref import WeakSet

from PySide6.QtCore import QObject, QTimer

from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.beside import findings, has_findings
from plusedit.scene.coloring import coloring_overlay, has_values, mesh_values
from plusedit.scene.drawn_deviation import drawn_deviation, known_deviation
from plusedit.scene.drawn_mesh import known_drawing
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Numbers, Overlay, in_order
from plusedit.views.mesh_evaluation import MANY, TOGETHER, MeshEvaluation
from plusedit.views.workers import start_worker

GLANCE = 10  # milliseconds between looks whether a surface is done
PAUSE = 120  # milliseconds without an edit, after which there is time
PATIENCE = 3000  # milliseconds without an edit, after which previews are measured as well

Finding: TypeAlias = tuple[tuple[Overlay, Numbers], ...]
"""What else overlays want to know, each with its settings."""


@dataclass(eq=False)
class _Job:
    """One surface as it is drawn, and what is to be found of it."""

    surface: MeshSurface
    drawing: MeshDrawing
    entry: Overlay | None
    """what it is colored by, if by anything"""
    numbers: Numbers
    """its settings"""
    finding: Finding
    has_failed: bool = False

    def do(self) -> None:
        """In a thread; what is found is kept with the drawing."""
        try:
            if self.entry is not None:
                mesh_values(self.entry, self.surface, self.drawing, self.numbers)
            for entry, numbers in self.finding:
                findings(entry, self.surface, numbers)
            drawn_deviation(self.surface, self.drawing)
        except (ValueError, MemoryError):
            self.has_failed = True


class MeshMeasuring(QObject):
    """Has the meshes of a session measured as they are drawn."""

    def __init__(
        self, session: Session, evaluation: MeshEvaluation, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self.ready: Event[()] = Event()
        """more is known of what is drawn"""
        self._session = session
        self._entry: Overlay | None = None
        self._numbers: Numbers = {}
        self._finding: Finding = ()
        self._job: _Job | None = None
        self._thread: Thread | None = None
        self._told = 0.0
        """when something was ready last"""
        self._failed: WeakSet[MeshDrawing] = WeakSet()
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)
        self._rest = QTimer(self, singleShot=True, interval=PAUSE)
        self._rest.timeout.connect(self._begin)
        self._patience = QTimer(self, singleShot=True, interval=PATIENCE)
        self._patience.timeout.connect(self._begin)
        self._patience.start()
        session.changed.listen(lambda old, new: self._wait())
        evaluation.ready.listen(self._begin)

    @property
    def is_busy(self) -> bool:
        """Whether something of what is drawn is still to be found."""
        if self._job is not None or self._rest.isActive():
            return True
        return self._wanted(even_previews=True) is not None

    @property
    def serves_overlays(self) -> bool:
        """Whether an overlay that is switched on draws what is found."""
        return self._entry is not None or bool(self._finding)

    def set_options(self, options: ViewOptions) -> None:
        """Find what that shows."""
        entry = coloring_overlay(options.overlays)
        self._entry = entry if entry is not None and "mesh" in entry.colors else None
        self._numbers = {} if entry is None else entry.numbers(options.settings)
        self._finding = tuple(
            (each, each.numbers(options.settings))
            for each in in_order()
            if each.finds and each.name in options.overlays
        )
        self._begin()

    def _wait(self) -> None:
        self._rest.start()
        self._patience.start()

    def _begin(self) -> None:
        """Start on the first of what is wanted, unless a thread is at work or edits go on."""
        if self._job is not None or self._rest.isActive():
            return
        job = self._wanted(even_previews=not self._patience.isActive())
        if job is not None:
            self._job = job
            self._thread = start_worker(job.do, "measuring", daemon=True)
            self._glance.start()

    def _wanted(self, *, even_previews: bool) -> _Job | None:
        """What is still to be found, of selected shapes first."""
        design, chosen = self._session.design, self._session.selection.shapes
        shown = [(i, mesh) for i, mesh in design.meshes() if design[i].visible]
        for _, surface in sorted(shown, key=lambda pair: pair[0] not in chosen):
            drawing = known_drawing(surface)
            if drawing is None or drawing in self._failed:
                continue
            if not drawing.is_exact and not even_previews:
                continue
            is_colored = self._entry is None or has_values(self._entry, drawing, self._numbers)
            is_found = all(has_findings(each, surface, by) for each, by in self._finding)
            if known_deviation(drawing) is None or not is_colored or not is_found:
                return _Job(surface, drawing, self._entry, self._numbers, self._finding)
        return None

    def _look(self) -> None:
        job = self._job
        if job is None or self._thread is None or self._thread.is_alive():
            return
        self._job = self._thread = None
        self._glance.stop()
        if job.has_failed:
            self._failed.add(job.drawing)
        self._begin()
        # Each time all is drawn again: not for each of many.
        is_time = perf_counter() - self._told > TOGETHER or self._job is None
        if is_time or len(list(self._session.design.meshes())) <= MANY:
            self.ready.emit()
            self._told = perf_counter()
