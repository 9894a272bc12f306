"""What was found in a file of a mesh, and what was done to it."""

from collections import Counter
from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QHeaderView,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from plusedit.app.mesh_measuring import MeasuredReport
from plusedit.io.mesh_report import ImportReport, PartReport
from plusedit.views.live import quiet, title

SIZE = (640, 460)  # logical pixels
UNFOLDED = 4  # parts, up to which all of them are
NOTES = 12  # shown below the parts; all of them are in the text that is copied
DISTANCES = ("Mesh to surface", "Surface to mesh")


class MeshReportWindow(QDialog):
    """The parts with their numbers, and notes on repairs; stays open beside the window."""

    def __init__(
        self, parent: QWidget, measured: MeasuredReport, again: Callable[[], None]
    ) -> None:
        super().__init__(parent)
        self.setWindowTitle("Mesh report")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(*SIZE)
        self._measured = measured
        report = measured.report
        self.parts = _tree()
        self._items = [_item(part, self._unknown) for part in report.parts]
        if len(report.parts) > 1:
            self.parts.addTopLevelItem(_whole(report))
        for item in self._items:
            self.parts.addTopLevelItem(item)
            item.setExpanded(len(report.parts) <= UNFOLDED)
        self.parts.resizeColumnToContents(0)
        self.notes = quiet(_listed(report.notes))
        self.notes.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.notes.setVisible(bool(report.notes))
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 16)
        column.setSpacing(8)
        column.addWidget(title(f"{report.name}: {report.summary}"))
        column.addWidget(self.parts, 1)
        column.addWidget(self.notes)
        column.addWidget(self._buttons(again))
        self.finished.connect(measured.changed.listen(self._show_distances))

    def copy(self) -> None:
        """Put all of it on the clipboard as text."""
        QGuiApplication.clipboard().setText(self._measured.report.text)

    def _buttons(self, again: Callable[[], None]) -> QDialogButtonBox:
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        copy, self.again = QPushButton("Copy as text"), QPushButton("Import again…")
        self.again.setToolTip("Read the file in another way, in place of the parts that are here")
        for button in (copy, self.again):
            button.setAutoDefault(False)
        buttons.addButton(copy, QDialogButtonBox.ButtonRole.ActionRole)
        buttons.addButton(self.again, QDialogButtonBox.ButtonRole.ActionRole)
        copy.clicked.connect(self.copy)
        self.again.clicked.connect(again)
        buttons.rejected.connect(self.close)
        return buttons

    @property
    def _unknown(self) -> str:
        return "being measured …" if self._measured.is_measuring else "not measured"

    def _show_distances(self) -> None:
        for item, part in zip(self._items, self._measured.report.parts, strict=True):
            for number, (what, how) in enumerate(_rows(part, self._unknown)):
                row = item.child(number)
                if what in DISTANCES and row is not None:
                    row.setText(1, how)
                    row.setToolTip(1, how)


def _tree() -> QTreeWidget:
    parts = QTreeWidget()
    parts.setColumnCount(2)
    parts.setHeaderHidden(True)
    parts.setAlternatingRowColors(True)
    parts.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
    parts.setAccessibleName("parts of the mesh")
    return parts


def _item(part: PartReport, unknown: str) -> QTreeWidgetItem:
    """A part with a row for each of its numbers; folded, it still tells the most important."""
    short = f"{part.face_count:,} faces, {part.map_title}"
    item = QTreeWidgetItem([part.name, short + (f", {part.flips} flipped" if part.flips else "")])
    for what, how in _rows(part, unknown):
        row = QTreeWidgetItem([what, how])
        row.setToolTip(1, how)
        item.addChild(row)
    return item


def _rows(part: PartReport, unknown: str) -> list[tuple[str, str]]:
    rows = list(part.rows)
    known = {what for what, _ in rows}
    return rows + [(what, unknown) for what in DISTANCES if what not in known]


def _whole(report: ImportReport) -> QTreeWidgetItem:
    """A row for all the parts together."""
    faces = sum(part.face_count for part in report.parts)
    by_map = Counter(part.map_title for part in report.parts)
    maps = ", ".join(f"{count} × {name}" for name, count in by_map.most_common())
    item = QTreeWidgetItem([f"All {len(report.parts)} parts", f"{faces:,} faces; {maps}"])
    item.setToolTip(1, item.text(1))
    font = item.font(0)
    font.setBold(True)
    item.setFont(0, font)
    return item


def _listed(notes: tuple[str, ...]) -> str:
    lines = [f"• {note}" for note in notes[:NOTES]]
    if len(notes) > NOTES:
        lines.append(f"• … and {len(notes) - NOTES} more, which Copy as text has as well")
    return "\n".join(lines)
