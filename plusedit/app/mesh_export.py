"""How shapes are to be written as a mesh: which kind of file, and how fine."""

from collections.abc import Callable
from dataclasses import dataclass
from threading import Thread

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QWidget

from plusedit.app.export_dialogs import Question
from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.events import Event
from plusedit.geometry.mesh.rectangle import rectangle
from plusedit.io.export_pieces import BY_TOLERANCE, Fineness, even_cells
from plusedit.io.export_size import expected
from plusedit.io.exporting import Tolerance
from plusedit.io.exports import exports
from plusedit.io.formats import FormatError
from plusedit.views.arithmetic import calculated
from plusedit.views.live import quiet
from plusedit.views.workers import start_worker

USUAL_KIND = "obj"
USUAL_STRAY = "0.05%"
STRAY = "How far the mesh may stray: a length, or a percentage of the size of what is exported."
MOST_TIMES = 4  # offered
MOST_CELLS = 20_000  # along one side
GRID, TOLERANCE = -1, -2  # beside numbers of times
TIMES = ("At the vertices of the mesh", "Each face split once", "Each face split twice")
GLANCE = 30  # milliseconds between looks whether the numbers are known
COUNTING = "counting …"


@dataclass(frozen=True)
class MeshExport:
    """How shapes are written as a mesh."""

    kind: str
    """a name on the shelf of exports"""
    tolerance: Tolerance
    only_selected: bool
    fineness: Fineness = BY_TOLERANCE
    """of surfaces of meshes"""


class MeshDialog(Question):
    """Which kind of mesh, of what, and how near to the shapes; how large it will be."""

    def __init__(
        self, parent: QWidget | None, design: Design, selected: tuple[ShapeId, ...]
    ) -> None:
        super().__init__(parent, "Export mesh", "Export…")
        self._design, self._selected = design, selected
        self.kind = QComboBox()
        for name, entry in exports.items():
            self.kind.addItem(f"{entry.title} (*{entry.suffixes[0]})", name)
        self.kind.setCurrentIndex(self.kind.findData(USUAL_KIND))
        self.tolerance = QLineEdit(USUAL_STRAY)
        self.tolerance.setAccessibleName("tolerance")
        self._stray = quiet(STRAY)
        self.only_selected = QCheckBox("Only what is selected")
        self.only_selected.setEnabled(bool(selected))
        self._make_fineness()
        self.size_of_file = quiet(COUNTING)
        self.size_of_file.setAccessibleName("size of the file")
        self.form.addRow("File", self.kind)
        self.form.addRow("Meshes", self.fineness)
        self.form.addRow("Cells, u × v", self.cells)
        self.form.addRow("Tolerance", self.tolerance)
        self.form.addRow("", self._stray)
        self.form.addRow("", self.only_selected)
        self.form.addRow("Size", self.size_of_file)
        self._counter = Counter(self)
        self._counter.counted.listen(self.size_of_file.setText)
        for signal in (
            self.kind.currentIndexChanged,
            self.fineness.currentIndexChanged,
            self.cells.textChanged,
            self.tolerance.textChanged,
            self.only_selected.toggled,
        ):
            signal.connect(self._show)
        self._show()

    def _make_fineness(self) -> None:
        """What can be chosen for meshes, and how many cells a grid would have."""
        self.fineness = QComboBox()
        self.fineness.addItem("As fine as the tolerance asks", TOLERANCE)
        for times in range(MOST_TIMES + 1):
            words = TIMES[times] if times < len(TIMES) else f"Each face split {times} times"
            self.fineness.addItem(words, times)
        found = ((s, rectangle(s)) for _, s in self._design.meshes())
        even = next(((s, over) for s, over in found if over is not None), None)
        self.cells = QLineEdit()
        self.cells.setAccessibleName("cells")
        if even is not None:
            self.fineness.addItem("Even grid, where the map suits it", GRID)
            self.cells.setText("{} × {}".format(*even_cells(*even)))

    def read(self) -> MeshExport:
        return MeshExport(
            str(self.kind.currentData()),
            Tolerance.of(self.tolerance.text()) if self._is_by_tolerance else Tolerance(1.0),
            self.only_selected.isChecked(),
            self._fineness(),
        )

    @property
    def _shapes(self) -> tuple[ShapeId, ...]:
        """What would be written."""
        visible = tuple(i for i in self._design if self._design[i].visible)
        return self._selected if self.only_selected.isChecked() else visible

    @property
    def _has_meshes(self) -> bool:
        return any(self._design[i].mesh is not None for i in self._shapes)

    @property
    def _is_by_tolerance(self) -> bool:
        """Whether the tolerance matters to any of them."""
        others = any(self._design[i].mesh is None for i in self._shapes)
        return others or self.fineness.currentData() == TOLERANCE

    def _fineness(self) -> Fineness:
        chosen: int = self.fineness.currentData()
        if not self._has_meshes or chosen == TOLERANCE:
            return BY_TOLERANCE
        if chosen == GRID:
            cells = cells_of(self.cells.text())
            return Fineness(cells=lambda surface, over: cells)
        return Fineness(times=lambda mesh: chosen)

    def _show(self) -> None:
        """Show what matters now, and have the rest counted."""
        has_meshes = self._has_meshes
        self.form.setRowVisible(self.fineness, has_meshes)
        self.form.setRowVisible(self.cells, has_meshes and self.fineness.currentData() == GRID)
        for field in (self.tolerance, self._stray):
            self.form.setRowVisible(field, self._is_by_tolerance)
        try:
            wish = self.read()
        except ValueError as error:
            self._counter.forget()
            self.size_of_file.setText(str(error))
            return
        design, entry = self._design, exports[wish.kind]
        ids = self._selected if wish.only_selected else None
        self.size_of_file.setText(COUNTING)
        self._counter.count(
            lambda: str(expected(design, entry, ids, wish.tolerance, wish.fineness))
        )


class Counter(QObject):
    """Has something counted in a thread; of several wishes the last is the one that matters."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.counted: Event[str] = Event()
        self._wish: Callable[[], str] | None = None
        self._thread: Thread | None = None
        self._words: list[str] = []
        self._is_stale = False
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)

    def count(self, wish: Callable[[], str]) -> None:
        """Have `wish` called, and what comes of it told; in place of all wishes before."""
        self._wish, self._is_stale = wish, True
        self._begin()

    def forget(self) -> None:
        """Tell nothing of what is being counted."""
        self._wish, self._is_stale = None, True

    def _begin(self) -> None:
        if self._thread is None and self._wish is not None:
            wish, self._wish, self._is_stale = self._wish, None, False
            self._thread = start_worker(
                lambda: self._words.append(_tried(wish)), "count", daemon=True
            )
            self._glance.start()

    def _look(self) -> None:
        if self._thread is None or self._thread.is_alive():
            return
        self._thread = None
        self._glance.stop()
        words = self._words.pop()
        if not self._is_stale:
            self.counted.emit(words)
        self._begin()


def _tried(wish: Callable[[], str]) -> str:
    try:
        return wish()
    except (FormatError, ValueError, MemoryError) as error:
        return f"{str(error) or 'there is not enough memory'}"


def cells_of(text: str) -> tuple[int, int]:
    """Two numbers of cells, such as "200 x 100". ValueError if they are none for a grid."""
    words = text.replace("×", "x").replace("*", "x").split("x")
    if len(words) == 2:
        along, across = (calculated(word) for word in words)
        if all(2.0 <= number <= MOST_CELLS for number in (along, across)):
            return round(along), round(across)
    raise ValueError(f"A grid has 2 to {MOST_CELLS} cells along each side, such as 200 × 100.")
