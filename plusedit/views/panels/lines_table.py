"""The table of control lines: every number of the selected curves, or of all of them."""

from math import degrees, radians

import numpy as np
from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
)
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QStackedLayout, QTableView

from plusedit.commands.base import Command
from plusedit.commands.directions import ResetDirections, SetAngle, SetDirection, SetLength
from plusedit.commands.lines import SetCoordinate, SetWeight
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.views.arithmetic import calculated, written
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.look import tabular
from plusedit.views.panels import panel

Index = QModelIndex | QPersistentModelIndex
Role = Qt.ItemDataRole

HEADS = {
    "line": ("Line", "Curve and number of the control line"),
    "0": ("x", "Control point"),
    "1": ("y", "Control point"),
    "2": ("z", "Control point"),
    "angle": ("Angle", "Direction in degrees, seen from the top"),
    "length": ("Length", "Length of the direction"),
    "auto": ("Auto", "Whether the direction follows the neighboring points"),
    "weight": ("Weight", "Share of the control line in the curve"),
}
SIDES = {"line": Qt.AlignmentFlag.AlignLeft, "auto": Qt.AlignmentFlag.AlignHCenter}
WIDEST = 104  # logical pixels of the column of names
LISTED = 300  # control lines; a design with more lists those of the selected curves only
EMPTY = "No control lines yet.\n\nEvery curve's control lines are listed here with their numbers."


class LinesModel(QAbstractTableModel):
    """Rows are control lines of some curves of the session; cells read the design as it is."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._rows: list[LineId] = []
        self._columns: list[str] = []
        self._shown: dict[ShapeId, Shape] = {}

    @property
    def rows(self) -> list[LineId]:
        """The control lines shown, from top to bottom."""
        return self._rows

    def refresh(self) -> bool:
        """Show the curves as they are now; whether rows, names or columns are others now."""
        design = self._desk.session.design
        curves = dict(design.curves())
        if sum(len(curve.lines) for curve in curves.values()) > LISTED:
            curves = dict(self._desk.selected_curves()) or curves
        rows = [LineId(i, row) for i, curve in curves.items() for row in range(len(curve.lines))]
        is_space = any(curve.dimension == 3 for curve in curves.values())
        columns = [name for name in HEADS if name != "2" or is_space]
        before, self._shown = self._shown, {i: design[i] for i in curves}
        if rows == self._rows and columns == self._columns:
            changed = {i for i, shape in self._shown.items() if before.get(i) is not shape}
            self._tell_of(changed)
            return any(before[i].name != self._shown[i].name for i in changed)
        self.beginResetModel()
        self._rows, self._columns = rows, columns
        self.endResetModel()
        return True

    def _tell_of(self, shape_ids: set[ShapeId]) -> None:
        """The rows of these shapes show other numbers."""
        rows = [row for row, line in enumerate(self._rows) if line.shape in shape_ids]
        if rows:
            last = self.index(rows[-1], len(self._columns) - 1)
            self.dataChanged.emit(self.index(rows[0], 0), last)

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._rows)

    def columnCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._columns)

    def headerData(
        self, section: int, orientation: Qt.Orientation, role: int = Role.DisplayRole
    ) -> object:
        if orientation == Qt.Orientation.Horizontal and section < len(self._columns):
            if role == Role.DisplayRole:
                return HEADS[self._columns[section]][0]
            if role == Role.ToolTipRole:
                return HEADS[self._columns[section]][1]
            if role == Role.TextAlignmentRole:
                side = SIDES.get(self._columns[section], Qt.AlignmentFlag.AlignRight)
                return int(side | Qt.AlignmentFlag.AlignVCenter)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        name = self._columns[index.column()]
        if name == "auto":
            return flags | Qt.ItemFlag.ItemIsUserCheckable
        return flags if name == "line" else flags | Qt.ItemFlag.ItemIsEditable

    def data(self, index: Index, role: int = Role.DisplayRole) -> object:
        if not index.isValid() or index.row() >= len(self._rows):
            return None
        name, (shape_id, row) = self._columns[index.column()], self._rows[index.row()]
        shape = self._desk.session.design.shapes.get(shape_id)
        if shape is None or shape.curve is None or row >= len(shape.curve.lines):
            return None  # a moment before `refresh` has caught up with the design
        if role == Role.TextAlignmentRole and name != "line":
            return int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        if name == "auto":
            automatic = bool(shape.curve.lines.automatic[row])
            state = Qt.CheckState.Checked if automatic else Qt.CheckState.Unchecked
            return state if role == Role.CheckStateRole else None
        if role not in (Role.DisplayRole, Role.EditRole):
            return None
        if name == "line":
            return f"{shape.name} {row + 1}"
        value = number_of(shape.curve, name, row)
        if value is None:
            return ""
        return written(value, 12 if role == Role.EditRole else 4)

    def setData(self, index: Index, value: object, role: int = Role.EditRole) -> bool:
        line, name = self._rows[index.row()], self._columns[index.column()]
        if role == Role.CheckStateRole:
            return not self._desk.commit(self._switched(line))
        if role != Role.EditRole or str(value) == str(self.data(index, Role.EditRole)):
            return False
        try:
            number = calculated(str(value))
        except ValueError as error:
            self._desk.say(str(error))
            return False
        return not self._desk.commit(edit_of(line, name, number))

    def _switched(self, line: LineId) -> Command:
        curve = self._desk.session.design.curve(line.shape)
        if curve.lines.automatic[line.number]:
            return SetDirection(line.shape, line.number, curve.directions[line.number])
        return ResetDirections({line.shape: (line.number,)})


def number_of(curve: PlusCurve, name: str, row: int) -> float | None:
    """What stands in the column `name` of control line `row`; None where there is nothing."""
    lines, direction = curve.lines, curve.directions[row]
    match name:
        case "angle":
            if not direction[:2].any():
                return None
            return round(degrees(float(np.arctan2(direction[1], direction[0]))), 10)
        case "length":
            return round(float(np.linalg.norm(direction)), 12)
        case "weight":
            return 1.0 if lines.weights is None else float(lines.weights[row])
    return float(lines.points[row, int(name)]) if int(name) < curve.dimension else None


def edit_of(line: LineId, name: str, value: float) -> Command:
    """The command that puts `value` into the column `name` of a control line."""
    targets: dict[ShapeId, tuple[int, ...]] = {line.shape: (line.number,)}
    match name:
        case "angle":
            return SetAngle(targets, radians(value))
        case "length":
            return SetLength(targets, value)
        case "weight":
            return SetWeight(targets, value)
    return SetCoordinate(targets, int(name), value)


@panel("lines_table", title="Control lines", area="left", order=2)
class LinesTable(LiveWidget):
    """The table, its selection being the session's."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.model = LinesModel(desk)
        self.table = QTableView()
        self.table.setModel(self.model)
        self.table.setAccessibleName("control lines")
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setFont(tabular(self.table.font()))
        self.table.setShowGrid(False)
        # Numbers stand at the end of names: "wing 12" must not become "wing…".
        self.table.setWordWrap(False)
        self.table.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(24)
        header = self.table.horizontalHeader()
        header.setDefaultSectionSize(68)
        header.setMinimumSectionSize(36)
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        self.table.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self._empty = quiet(EMPTY)
        self._empty.setProperty("panel", True)
        self._empty.setIndent(0)
        self._empty.setContentsMargins(12, 12, 12, 12)
        self._empty.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self.table)
        self._stack.addWidget(self._empty)
        self._is_showing = False
        self._chosen: frozenset[ShapeId] = frozenset()
        self.table.selectionModel().selectionChanged.connect(self._select)

    def refresh(self) -> None:
        self._is_showing = True
        if self.model.refresh():
            self.table.resizeColumnToContents(0)
            self.table.setColumnWidth(0, min(self.table.columnWidth(0), WIDEST))
        self._stack.setCurrentIndex(0 if self.model.rows else 1)
        self._show_selection()
        self._is_showing = False

    def _show_selection(self) -> None:
        wanted = self.desk.session.selection.lines
        if not wanted:
            self._show_first()
        rows = {row for row, line in enumerate(self.model.rows) if line in wanted}
        chosen = self.table.selectionModel()
        if rows == {index.row() for index in chosen.selectedRows()}:
            return
        selection = QItemSelection()
        last = self.model.columnCount() - 1
        for row in sorted(rows):
            selection.select(self.model.index(row, 0), self.model.index(row, last))
        chosen.select(selection, QItemSelectionModel.SelectionFlag.ClearAndSelect)
        if len(rows) == 1:
            self.table.scrollTo(self.model.index(next(iter(rows)), 0))

    def _show_first(self) -> None:
        """Bring the lines of shapes that have just been selected into sight."""
        before, self._chosen = self._chosen, self.desk.session.selection.shapes
        if self._chosen == before:
            return
        first = (row for row, line in enumerate(self.model.rows) if line.shape in self._chosen)
        if (row := next(first, None)) is not None:
            hint = QAbstractItemView.ScrollHint.PositionAtTop
            self.table.scrollTo(self.model.index(row, 0), hint)

    def _select(self) -> None:
        if self._is_showing:
            return
        rows = [index.row() for index in self.table.selectionModel().selectedRows()]
        lines = [self.model.rows[row] for row in rows]
        now = self.desk.session.selection
        selection = Selection.of_lines(lines)
        # Lines picked among the selected curves leave those curves selected and listed.
        self.desk.select(Selection(selection.lines, now.shapes, selection.active))
