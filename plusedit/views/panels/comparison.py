"""What the selected shapes are made of, side by side."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStackedLayout, QTableWidget
from PySide6.QtWidgets import QTableWidgetItem as Cell

from plusedit.document.shape import Shape
from plusedit.scene.shape_account import HEADS, HINTS, account_of
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.look import tabular
from plusedit.views.panels import panel

MOST = 8  # shapes side by side
EMPTY = (
    "Nothing is selected.\n\n"
    "Select shapes to see, side by side, their degrees, control elements and how many numbers are "
    "stored, and what the exact classical shape would take."
)


@panel(
    "comparison",
    title="Comparison",
    area="below",
    order=14,
    menu="View",
    shortcut="Ctrl+8",
    is_shown=False,
    least_width=480,
)
class Comparison(LiveWidget):
    """A table with a row for each shape, and a column for each thing it is made of."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.table = QTableWidget(0, len(HEADS))
        self.table.setAccessibleName("comparison")
        for column, hint in enumerate(HINTS):
            head = Cell(HEADS[column])
            head.setToolTip(hint)
            self.table.setHorizontalHeaderItem(column, head)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.table.setShowGrid(False)
        self.table.setFont(tabular(self.table.font()))
        self.table.verticalHeader().setDefaultSectionSize(24)
        self.table.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        self.table.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        empty = quiet(EMPTY)
        empty.setProperty("panel", True)
        empty.setContentsMargins(12, 12, 12, 12)
        empty.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self.table)
        self._stack.addWidget(empty)
        self._shown: list[Shape] = []

    def refresh(self) -> None:
        shapes = self._shapes()
        self._stack.setCurrentIndex(int(not shapes))
        if len(shapes) == len(self._shown) and all(map(_are_same, shapes, self._shown)):
            return
        self._shown = shapes
        self.table.setRowCount(len(shapes))
        self.table.setVerticalHeaderLabels([shape.name for shape in shapes])
        for row, shape in enumerate(shapes):
            for column, text in enumerate(account_of(shape.geometry)):
                cell = Cell(text)
                cell.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                self.table.setItem(row, column, cell)

    def _shapes(self) -> list[Shape]:
        """The selected shapes, those in front first; all, where there are few and none selected."""
        session = self.desk.session
        shapes = [session.design[i] for i in reversed(list(session.design))]
        chosen = [s for i, s in session.design.shapes.items() if i in session.selection.shapes]
        if chosen:
            return chosen[::-1][:MOST]
        return shapes if len(shapes) <= MOST else []


def _are_same(one: Shape, other: Shape) -> bool:
    return one is other
