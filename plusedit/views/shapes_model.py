"""The shapes of the design as rows, front to back, for the outliner."""

from PySide6.QtCore import (
    QAbstractListModel,
    QMimeData,
    QModelIndex,
    QPersistentModelIndex,
    Qt,
)

from plusedit.commands.shapes import Rename, Reorder
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.views.desk import Desk

Index = QModelIndex | QPersistentModelIndex
Role = Qt.ItemDataRole

ROWS = "application/x-plusedit-rows"


class ShapesModel(QAbstractListModel):
    """Names of shapes, the one in front first. Renaming and reordering are commands."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._ids: list[ShapeId] = []
        self._looks: list[tuple[object, ...]] = []
        """what the rows show, so that a drag repaints nothing here"""

    @property
    def ids(self) -> list[ShapeId]:
        """The shapes from top to bottom, which is front to back."""
        return self._ids

    def shape(self, index: Index) -> Shape | None:
        """The shape in that row; None if it has just gone."""
        if not 0 <= index.row() < len(self._ids):
            return None
        return self._desk.session.design.shapes.get(self._ids[index.row()])

    def refresh(self) -> bool:
        """Show the shapes as they are now; whether they are others, or in another order."""
        shapes = self._desk.session.design.shapes
        ids = list(shapes)[::-1]
        looks = [look_of(shapes[shape_id]) for shape_id in ids]
        if ids == self._ids:
            old, self._looks = self._looks, looks
            for row, (before, now) in enumerate(zip(old, looks, strict=True)):
                if before != now:
                    self.dataChanged.emit(self.index(row), self.index(row))
            return False
        self.beginResetModel()
        self._ids, self._looks = ids, looks
        self.endResetModel()
        return True

    def rowCount(self, parent: Index = QModelIndex()) -> int:  # noqa: B008
        return 0 if parent.isValid() else len(self._ids)

    def data(self, index: Index, role: int = Role.DisplayRole) -> object:
        shape = self.shape(index)
        if shape is None:
            return None
        if role in (Role.DisplayRole, Role.EditRole):
            return shape.name
        if role == Role.ToolTipRole:
            return described(shape)
        if role == Role.AccessibleTextRole:
            states = [
                word
                for word, holds in (("hidden", not shape.visible), ("locked", shape.locked))
                if holds
            ]
            return ", ".join([shape.name, *states])
        return None

    def flags(self, index: Index) -> Qt.ItemFlag:
        base = Qt.ItemFlag.ItemIsDropEnabled
        if not index.isValid():
            return base
        return (
            Qt.ItemFlag.ItemIsEnabled
            | Qt.ItemFlag.ItemIsSelectable
            | Qt.ItemFlag.ItemIsEditable
            | Qt.ItemFlag.ItemIsDragEnabled
        )

    def setData(self, index: Index, value: object, role: int = Role.EditRole) -> bool:
        if role != Role.EditRole or self.shape(index) is None:
            return False
        return not self._desk.commit(Rename(self._ids[index.row()], str(value)))

    def supportedDropActions(self) -> Qt.DropAction:
        return Qt.DropAction.MoveAction

    def mimeTypes(self) -> list[str]:
        return [ROWS]

    def mimeData(self, indexes: list[QModelIndex]) -> QMimeData:  # type: ignore[override]
        data = QMimeData()
        rows = sorted(index.row() for index in indexes)
        data.setData(ROWS, ",".join(map(str, rows)).encode())
        return data

    def dropMimeData(
        self, data: QMimeData, action: Qt.DropAction, row: int, column: int, parent: Index
    ) -> bool:
        if not data.hasFormat(ROWS) or action != Qt.DropAction.MoveAction:
            return False
        words = bytes(data.data(ROWS).data()).decode("ascii", "replace").split(",")
        rows = [int(word) for word in words if word.isdigit() and int(word) < len(self._ids)]
        self.move(rows, row if row >= 0 else len(self._ids))
        return False  # the command has moved them; the view must not take the old rows out

    def move(self, rows: list[int], before: int) -> None:
        """Put those rows, in their order, before the row `before`."""
        moved = [self._ids[row] for row in rows]
        above = [i for i in self._ids[:before] if i not in moved]
        below = [i for i in self._ids[before:] if i not in moved]
        self._desk.commit(Reorder(tuple([*above, *moved, *below][::-1])))


def look_of(shape: Shape) -> tuple[object, ...]:
    """All that a row shows of a shape."""
    return shape.name, shape.visible, shape.locked, shape.style, shape.plus is None


def described(shape: Shape) -> str:
    """A shape in a few words, for its tooltip."""
    if isinstance(shape.geometry, MeshSurface):
        count = shape.geometry.mesh.face_count
        return f"{shape.name}: mesh of {count} face{'' if count == 1 else 's'}"
    if isinstance(shape.geometry, PlusSurface):
        return f"{shape.name}: {of_planes(shape.geometry)}"
    curve = shape.geometry
    kind = "closed curve" if curve.closed else "curve"
    space = " in space" if curve.dimension == 3 else ""
    return f"{shape.name}: {kind}{space} of {len(curve.lines)} control lines"


KINDS = {(False, False): "surface", (True, True): "torus"}
"""What a surface that closes by u and by v is called; one that closes one way is a tube."""


def of_planes(surface: PlusSurface) -> str:
    """Such as "tube of 6 × 4 control planes"."""
    rows, columns = surface.planes.shape
    return f"{KINDS.get(surface.closed, 'tube')} of {rows} × {columns} control planes"
