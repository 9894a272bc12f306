"""The Shapes panel: every shape of the design, the one in front on top."""

from PySide6.QtCore import (
    QItemSelection,
    QItemSelectionModel,
    QModelIndex,
    QPoint,
    QRect,
    Qt,
)
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence, QMouseEvent
from PySide6.QtWidgets import QAbstractItemView, QListView, QMenu, QStackedLayout

from plusedit.commands.shapes import DeleteShapes, Duplicate, SetLocked, SetVisible
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.own_keys import OwnKeys
from plusedit.views.panels import panel
from plusedit.views.shape_rows import ShapeRows, Switch, switch_at
from plusedit.views.shapes_model import ShapesModel

EMPTY = (
    "No shapes yet.\n\nPress P and click in the view to draw a curve, take a surface from "
    "Surface > New, or open a file."
)
SHIFTED = 2.0  # grid steps to the right and downwards for a duplicate


class ShapeList(QListView):
    """The list itself: clicks on an eye or a lock switch it and select nothing."""

    def __init__(self, desk: Desk, model: ShapesModel) -> None:
        super().__init__()
        self._desk, self._shapes = desk, model
        self.setModel(model)
        self.setItemDelegate(ShapeRows(desk, model, self))
        self.setAccessibleName("shapes")
        self.setMouseTracking(True)
        self._own_keys = OwnKeys(self, {Qt.Key.Key_F2})
        self.setUniformItemSizes(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
        )
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.CustomContextMenu)
        self.customContextMenuRequested.connect(self._menu)

    def chosen(self) -> tuple[ShapeId, ...]:
        """The shapes of the selected rows, front to back."""
        rows = sorted(index.row() for index in self.selectionModel().selectedIndexes())
        return tuple(self._shapes.ids[row] for row in rows)

    def toggle(self, shape_id: ShapeId, switch: Switch) -> None:
        """Switch a shape's eye or lock, and that of all selected ones if it is one of them."""
        shape = self._desk.session.design[shape_id]
        ids = self.chosen() if shape_id in self.chosen() else (shape_id,)
        if switch == "eye":
            self._desk.commit(SetVisible(ids, not shape.visible))
        else:
            self._desk.commit(SetLocked(ids, not shape.locked))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if not self._switched(event):
            super().mousePressEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if not self._switched(event):
            super().mouseDoubleClickEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_delete = event.matches(QKeySequence.StandardKey.Delete)
        if is_delete or event.key() == Qt.Key.Key_Backspace:
            self._delete()
        elif event.text().isprintable() and event.text().strip():
            # Signs are for the views, not for a search among names.
            event.ignore()
        else:
            super().keyPressEvent(event)

    def _switched(self, event: QMouseEvent) -> bool:
        at = event.position().toPoint()
        index = self.indexAt(at)
        if event.button() != Qt.MouseButton.LeftButton or not index.isValid():
            return False
        switch = switch_at(self._row(index), at)
        if switch is None:
            return False
        self.toggle(self._shapes.ids[index.row()], switch)
        return True

    def _row(self, index: QModelIndex) -> QRect:
        return self.visualRect(index)

    def _delete(self) -> None:
        if ids := self.chosen():
            self._desk.commit(DeleteShapes(ids))

    def _duplicate(self) -> None:
        import numpy as np

        step = SHIFTED * self._desk.gestures.grid_step
        offset: Floats = np.array([step, -step])
        self._desk.commit(Duplicate(self.chosen(), offset))

    def _menu(self, at: QPoint) -> None:
        ids = self.chosen()
        if not ids:
            return
        shapes = [self._desk.session.design[i] for i in ids]
        menu = QMenu(self)
        rename = QAction("Rename", menu)
        rename.triggered.connect(lambda: self.edit(self.selectionModel().selectedIndexes()[0]))
        rename.setEnabled(len(ids) == 1)
        menu.addAction(rename)
        menu.addAction("Duplicate", self._duplicate)
        menu.addSeparator()
        shown, locked = all(s.visible for s in shapes), all(s.locked for s in shapes)
        menu.addAction(
            "Hide" if shown else "Show",
            lambda: self._desk.commit(SetVisible(ids, not shown)),
        )
        menu.addAction(
            "Unlock" if locked else "Lock",
            lambda: self._desk.commit(SetLocked(ids, not locked)),
        )
        menu.addSeparator()
        menu.addAction("Bring to front", lambda: self._shapes.move(self._rows(ids), 0))
        menu.addAction(
            "Send to back", lambda: self._shapes.move(self._rows(ids), len(self._shapes.ids))
        )
        menu.addSeparator()
        menu.addAction("Delete", self._delete)
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(self.viewport().mapToGlobal(at))

    def _rows(self, ids: tuple[ShapeId, ...]) -> list[int]:
        return [self._shapes.ids.index(shape_id) for shape_id in ids]


@panel("outliner", title="Shapes", area="left", order=1)
class Outliner(LiveWidget):
    """The list of shapes, its selection being the session's."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.setMinimumWidth(180)
        self.model = ShapesModel(desk)
        self.list = ShapeList(desk, self.model)
        self._empty = quiet(EMPTY)
        self._empty.setProperty("panel", True)
        self._empty.setIndent(0)
        self._empty.setContentsMargins(12, 12, 12, 12)
        self._empty.setAlignment(Qt.AlignmentFlag.AlignTop)
        self._stack = QStackedLayout(self)
        self._stack.addWidget(self.list)
        self._stack.addWidget(self._empty)
        self._is_showing = False
        self.list.selectionModel().selectionChanged.connect(self._select)

    def refresh(self) -> None:
        self._is_showing = True
        self.model.refresh()
        self._stack.setCurrentIndex(0 if self.model.ids else 1)
        self._show_selection()
        self._is_showing = False

    def _show_selection(self) -> None:
        wanted = self.desk.session.selection.shapes
        if wanted == set(self.list.chosen()):
            return
        selection = QItemSelection()
        for row, shape_id in enumerate(self.model.ids):
            if shape_id in wanted:
                selection.select(self.model.index(row), self.model.index(row))
        flag = QItemSelectionModel.SelectionFlag.ClearAndSelect
        self.list.selectionModel().select(selection, flag)
        if len(wanted) == 1 and selection.indexes():
            self.list.scrollTo(selection.indexes()[0])

    def _select(self) -> None:
        if self._is_showing:
            return
        now, ids = self.desk.session.selection, set(self.list.chosen())
        lines = frozenset(line for line in now.lines if line.shape in ids)
        # Lines stay selected only while their shapes are what they were.
        keep = lines if ids == now.shapes else frozenset()
        self.desk.select(Selection(keep, frozenset(ids), now.active))
