"""The table of control lines and planes: every number of the selected shapes, or of all."""

from collections.abc import Iterable
from itertools import islice

from PySide6.QtCore import (
    QAbstractTableModel,
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStackedLayout,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
)

from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Geometry, Shape, ShapeId
from plusedit.scene.handles import has_many_faces
from plusedit.views.arithmetic import calculated, compact, written
from plusedit.views.desk import Desk
from plusedit.views.line_columns import Column, columns_for
from plusedit.views.line_form import element_name
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.look import tabular
from plusedit.views.own_keys import OF_NUMBERS, OwnKeys
from plusedit.views.panels import panel

Index = QModelIndex | QPersistentModelIndex
Role = Qt.ItemDataRole

WIDEST = 104  # logical pixels of the column of names
WIDE = "−0.0000"  # what has room in those of numbers: four digits and a sign, or fewer digits
AROUND = 18  # logical pixels that a cell has besides its text
SHORT = 7  # characters of the name of a large mesh
LISTED = 300  # control lines; a design with more lists those of the selected shapes only
EMPTY = (
    "No control lines yet.\n\n"
    "The control lines of curves and the control planes of surfaces are listed here; of a large "
    "mesh the planes of the faces that are selected or edited."
)


class LinesModel(QAbstractTableModel):
    """Rows are control lines and planes of the session; cells read the design as it is."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._rows: list[LineId] = []
        self._columns: list[Column] = []
        self._shown: dict[ShapeId, Shape] = {}

    @property
    def rows(self) -> list[LineId]:
        """The control lines shown, from top to bottom."""
        return self._rows

    def refresh(self) -> bool:
        """Show the shapes as they are now; whether rows, names or columns are others now."""
        shapes = self._listed_shapes()
        rows = [LineId(i, row) for i, shape in shapes.items() for row in self._listed(i, shape)]
        columns = columns_for([shape.geometry for shape in shapes.values()])
        before, self._shown = self._shown, shapes
        if rows == self._rows and columns == self._columns:
            changed = {i for i, shape in self._shown.items() if before.get(i) is not shape}
            self._tell_of(changed)
            # Meshes without a selected face have no rows: others may have come in their place.
            return any(before[i].name != shapes[i].name for i in changed & before.keys())
        self.beginResetModel()
        self._rows, self._columns = rows, columns
        self.endResetModel()
        return True

    def _listed_shapes(self) -> dict[ShapeId, Shape]:
        """All shapes, or of many lines those selected; large meshes only where selected."""
        session = self._desk.session
        chosen = session.selection.shapes
        shapes = dict(session.design.shapes)
        counts = {i: s.element_count for i, s in shapes.items() if not has_many_faces(s)}
        few = [i for i in counts if i in chosen] if sum(counts.values()) > LISTED else counts
        listed = {*(few or counts), *(i for i in chosen if has_many_faces(shapes[i]))}
        return {i: shape for i, shape in shapes.items() if i in listed}

    def _listed(self, shape_id: ShapeId, shape: Shape) -> Iterable[int]:
        """The numbers listed: of a large mesh the faces that are edited or selected.

        They stay as long as what is selected is among them, so that one can be picked of several.
        """
        if shape.mesh is None or not has_many_faces(shape):
            return range(shape.element_count)
        chosen = self._desk.session.selection.by_shape().get(shape_id, ())[:LISTED]
        before = [line.number for line in self._rows if line.shape == shape_id]
        if chosen and set(chosen) <= set(before) and before[-1] < shape.element_count:
            return before
        edited = islice(shape.mesh.edited, LISTED)
        return sorted({*edited, *chosen})[:LISTED]

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
                return self._columns[section].head
            if role == Role.ToolTipRole:
                return self._columns[section].hint
            if role == Role.TextAlignmentRole:
                return int(aligned(self._columns[section]) | Qt.AlignmentFlag.AlignVCenter)
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        column, (shape_id, _) = self._columns[index.column()], self._rows[index.row()]
        shape = self._desk.session.design.shapes.get(shape_id)
        if shape is None or not column.belongs_to(shape.geometry):
            return flags
        if column.kind == "auto":
            return flags | Qt.ItemFlag.ItemIsUserCheckable
        return flags if column.kind == "line" else flags | Qt.ItemFlag.ItemIsEditable

    def data(self, index: Index, role: int = Role.DisplayRole) -> object:
        if not index.isValid() or index.row() >= len(self._rows):
            return None
        column, (shape_id, row) = self._columns[index.column()], self._rows[index.row()]
        shape = self._desk.session.design.shapes.get(shape_id)
        if shape is None or row >= shape.element_count:
            return None  # a moment before `refresh` has caught up with the design
        geometry = shape.geometry
        if role == Role.TextAlignmentRole and column.kind != "line":
            return int(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        if column.kind == "auto":
            if role != Role.CheckStateRole or not column.belongs_to(geometry):
                return None
            automatic = geometry.net.automatic_vectors[column.way, row]
            return Qt.CheckState.Checked if automatic else Qt.CheckState.Unchecked
        if role not in (Role.DisplayRole, Role.EditRole):
            return None
        if column.kind == "line":
            name = shortened(shape.name) if has_many_faces(shape) else shape.name
            return f"{name} {numbered(geometry, row)}"
        value = column.number_of(geometry, row)
        if value is None:
            return ""
        return written(value, 12) if role == Role.EditRole else compact(value, len(WIDE))

    def setData(self, index: Index, value: object, role: int = Role.EditRole) -> bool:
        line, column = self._rows[index.row()], self._columns[index.column()]
        if role == Role.CheckStateRole:
            geometry = self._desk.session.design[line.shape].geometry
            return not self._desk.commit(column.switched(line, geometry))
        if role != Role.EditRole or str(value) == str(self.data(index, Role.EditRole)):
            return False
        try:
            number = calculated(str(value))
        except ValueError as error:
            self._desk.say(str(error))
            return False
        return not self._desk.commit(column.edit(line, number))


def shortened(name: str) -> str:
    """So much of a name that a number of five digits has room beside it."""
    return name if len(name) <= SHORT else f"{name[: SHORT - 1]}…"


def aligned(column: Column) -> Qt.AlignmentFlag:
    """Where the head of a column stands."""
    if column.kind == "line":
        return Qt.AlignmentFlag.AlignLeft
    return Qt.AlignmentFlag.AlignHCenter if column.kind == "auto" else Qt.AlignmentFlag.AlignRight


def numbered(geometry: Geometry, row: int) -> str:
    """Such as "3", or "2, 1" of a control plane; counted from 1."""
    return element_name(geometry, row).partition(" ")[2]


class _NameCell(QStyledItemDelegate):
    """A name with a number at its end: "wing 12" must not become "wing…"."""

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        option.textElideMode = Qt.TextElideMode.ElideMiddle


@panel("lines_table", title="Control lines and planes", area="left", order=2)
class LinesTable(LiveWidget):
    """The table, its selection being the session's."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.model = LinesModel(desk)
        self.table = QTableView()
        self.table.setModel(self.model)
        self.table.setAccessibleName("control lines")
        self._own_keys = OwnKeys(self.table, {Qt.Key.Key_F2, *OF_NUMBERS})
        self.table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.table.setFont(tabular(self.table.font()))
        self.table.setShowGrid(False)
        self.table.setWordWrap(False)
        self.table.setItemDelegateForColumn(0, _NameCell(self.table))
        self.table.verticalHeader().hide()
        self.table.verticalHeader().setDefaultSectionSize(24)
        header = self.table.horizontalHeader()
        header.setDefaultSectionSize(self.table.fontMetrics().horizontalAdvance(WIDE) + AROUND)
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
