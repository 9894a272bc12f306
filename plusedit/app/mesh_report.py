"""What was found in a file of a mesh, and what was done to it."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from plusedit.io.mesh_report import ImportReport
from plusedit.views.live import quiet, title

SIZE = (560, 420)  # logical pixels
UNFOLDED = 4  # parts, up to which all of them are


class MeshReportWindow(QDialog):
    """The parts with their numbers, and notes on repairs; stays open beside the window."""

    def __init__(self, parent: QWidget, report: ImportReport) -> None:
        super().__init__(parent)
        self.setWindowTitle("Mesh report")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(*SIZE)
        self.parts = QTreeWidget()
        self.parts.setColumnCount(2)
        self.parts.setHeaderHidden(True)
        self.parts.setAccessibleName("parts of the mesh")
        for part in report.parts:
            item = QTreeWidgetItem([part.name])
            for what, how in part.rows:
                row = QTreeWidgetItem([what, how])
                row.setToolTip(1, how)
                item.addChild(row)
            self.parts.addTopLevelItem(item)
            item.setExpanded(len(report.parts) <= UNFOLDED)
        self.parts.resizeColumnToContents(0)
        self.notes = quiet("\n".join(f"• {note}" for note in report.notes))
        self.notes.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.notes.setVisible(bool(report.notes))
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        buttons.rejected.connect(self.close)
        column = QVBoxLayout(self)
        column.addWidget(title(f"{report.name}: {report.summary}"))
        column.addWidget(self.parts, 1)
        column.addWidget(self.notes)
        column.addWidget(buttons)
