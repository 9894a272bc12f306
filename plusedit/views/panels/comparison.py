"""What the selected shapes are made of, side by side."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStackedLayout, QTableWidget
from PySide6.QtWidgets import QTableWidgetItem as Cell

from plusedit.document.shape import Shape
from plusedit.scene.shape_account import HEADS, HINTS, NONE, account_of
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.look import tabular
from plusedit.views.panels import panel

MOST = 8  # shapes side by side
WIDEST = 96  # logical pixels of the names
FAMILY, LEAST = 0, 84  # the column of families, and its least width: they may be broken
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
            # On two lines, so that ten columns are in sight beside the panels.
            head = Cell(HEADS[column].replace(" ", "\n", 1))
            head.setToolTip(hint)
            self.table.setHorizontalHeaderItem(column, head)
        self.table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.table.setSelectionMode(QAbstractItemView.SelectionMode.NoSelection)
        self.table.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.table.setShowGrid(False)
        self.table.setFont(tabular(self.table.font()))
        self.table.setProperty("dense", True)
        names = self.table.verticalHeader()
        names.setMinimumSectionSize(24)
        names.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        names.setMaximumWidth(WIDEST)
        names.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        heads = self.table.horizontalHeader()
        heads.setSectionResizeMode(QHeaderView.ResizeMode.ResizeToContents)
        heads.setSectionResizeMode(FAMILY, QHeaderView.ResizeMode.Fixed)
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
        for row, shape in enumerate(shapes):
            name = Cell(shape.name)
            name.setToolTip(shape.name)
            self.table.setVerticalHeaderItem(row, name)
            for column, text in enumerate(account_of(shape.geometry)):
                cell = Cell(text)
                cell.setTextAlignment(Qt.AlignmentFlag.AlignCenter)
                self.table.setItem(row, column, cell)
        for column in range(len(HEADS)):
            is_known = any(account_of(shape.geometry)[column] != NONE for shape in shapes)
            self.table.setColumnHidden(column, not is_known)
        self._fit()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def _fit(self) -> None:
        """Give the families the room that the other columns leave, as far as they need it."""
        heads, wanted = self.table.horizontalHeader(), self.table.sizeHintForColumn(FAMILY)
        room = self.table.viewport().width() - heads.length() + heads.sectionSize(FAMILY)
        heads.resizeSection(FAMILY, max(LEAST, min(wanted, room)))

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
