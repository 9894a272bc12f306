"""How a row of the outliner is drawn, and where its switches are."""

from typing import Literal

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from plusedit.document.shape import Shape
from plusedit.views.color_button import draw_chip
from plusedit.views.desk import Desk
from plusedit.views.icons import tinted
from plusedit.views.shapes_model import ShapesModel

Switch = Literal["eye", "lock"]
SWITCHES: tuple[Switch, ...] = ("eye", "lock")

HEIGHT, MARGIN, CHIP, ICON = 28, 12, 12, 16  # logical pixels
FAINT = 0.45  # opacity of what is hidden


class ShapeRows(QStyledItemDelegate):
    """A chip in the shape's color, the name, and a lock and an eye at the right end."""

    def __init__(self, desk: Desk, model: ShapesModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._desk, self._model = desk, model

    def sizeHint(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> QSize:
        return QSize(80, HEIGHT)

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        shape = self._model.shape(index)
        if shape is None:
            return
        painter.save()
        row: QRect = option.rect
        state: QStyle.StateFlag = option.state
        style = option.widget.style()
        style.drawPrimitive(
            QStyle.PrimitiveElement.PE_PanelItemViewItem,
            option,
            painter,
            option.widget,
        )
        is_pointed_at = bool(state & QStyle.StateFlag.State_MouseOver)
        self._switches(painter, row, shape, show_all=is_pointed_at)
        painter.setOpacity(1.0 if shape.visible else FAINT)
        self._chip(painter, row, shape)
        self._name(painter, row, shape, option)
        painter.restore()

    def createEditor(
        self,
        parent: QWidget,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> QWidget:
        editor = super().createEditor(parent, option, index)
        editor.setAccessibleName("name of the shape")
        return editor

    def updateEditorGeometry(
        self,
        editor: QWidget,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        editor.setGeometry(name_place(option.rect).adjusted(-4, 2, 0, -2))

    def _chip(self, painter: QPainter, row: QRect, shape: Shape) -> None:
        place = QRectF(row.left() + MARGIN, row.center().y() - CHIP / 2 + 1, CHIP, CHIP)
        is_surface = shape.curve is None
        # The warm gray of surfaces would hardly be seen as a thin outline.
        usual = "quiet" if is_surface else "plus"
        color = QColor(shape.style.color or self._desk.theme.color(usual))
        hollow = shape.style.color is None
        draw_chip(painter, place, color, hollow=hollow, is_surface=is_surface)

    def _name(
        self, painter: QPainter, row: QRect, shape: Shape, option: QStyleOptionViewItem
    ) -> None:
        place = name_place(row)
        text = shape.name
        metrics = option.fontMetrics
        painter.setFont(option.font)
        painter.setPen(QColor(self._desk.theme.color("text")))
        align = Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft
        fitting = metrics.elidedText(text, Qt.TextElideMode.ElideRight, place.width())
        painter.drawText(place, int(align), fitting)

    def _switches(self, painter: QPainter, row: QRect, shape: Shape, *, show_all: bool) -> None:
        color = QColor(self._desk.theme.color("quiet"))
        states: dict[Switch, tuple[str, bool]] = {
            "lock": ("lock" if shape.locked else "unlock", shape.locked),
            "eye": ("eye" if shape.visible else "eye-off", not shape.visible),
        }
        for switch, (name, is_unusual) in states.items():
            # What is as usual stays out of sight until the row is pointed at.
            if is_unusual or show_all or switch == "eye":
                painter.setOpacity(1.0 if is_unusual or show_all else FAINT)
                place = switch_place(row, switch)
                painter.drawPixmap(place, tinted(name, color, ICON))
        painter.setOpacity(1.0)


def switch_place(row: QRect, switch: Switch) -> QRect:
    """Where in a row the icon of a switch is drawn."""
    right = row.right() - MARGIN - ICON + (4 if switch == "eye" else -20)
    return QRect(right, row.center().y() - ICON // 2 + 1, ICON, ICON)


def name_place(row: QRect) -> QRect:
    """Where in a row the name is written."""
    left = row.left() + MARGIN + CHIP + 8
    return QRect(left, row.top(), switch_place(row, "lock").left() - left - 4, row.height())


def switch_at(row: QRect, at: QPoint) -> Switch | None:
    """Which switch of a row lies there."""
    for switch in SWITCHES:
        if switch_place(row, switch).adjusted(-4, -8, 4, 8).contains(at):
            return switch
    return None
