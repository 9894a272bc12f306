"""The numbers of the overlays that are on, in a corner of a view: set by dragging them sideways."""

from collections.abc import Callable, Iterable, Sequence

from PySide6.QtCore import (
    QEvent,
    QObject,
    QPoint,
    QPointF,
    QRect,
    QRectF,
    QSize,
    Qt,
    QTimer,
    Signal,
)
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QGridLayout, QLabel, QWidget

from plusedit.document.session import Session
from plusedit.scene.captions import Box
from plusedit.scene.in_use import in_use
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Overlay, Setting, in_order
from plusedit.views.fields import NumberField

DOUBLES = 120.0  # pixels to the right by which a number becomes twice as large
NOTCH = 1.1  # times as large for each notch of the wheel
STARTS_AT = 3.0  # pixels; a press and release within them is a click, to type
DIGITS = 3
EDGE = 8  # pixels from the edges of the view
WIDTH = 60  # pixels of a number
THREE = 3  # columns: what is set, the number, arrows
NOTE = "Drag sideways or turn the wheel; click to type; double-click for the usual {usual:g}"


class SettingField(NumberField):
    """A positive number that is dragged in even ratios: so far to the right is twice as much."""

    def __init__(self, setting: Setting, changed: Callable[[float], None]) -> None:
        super().__init__(setting.title, self._take, digits=DIGITS)
        self._setting, self._changed = setting, changed
        self._held: tuple[QPointF, float] | None = None
        """where the button went down, and the number then"""
        self._is_dragged = False
        self.setToolTip(NOTE.format(usual=setting.usual))
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFixedWidth(WIDTH)
        # Keys are the view's, unless someone means to type.
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    @property
    def is_held(self) -> bool:
        """Whether the mouse holds it, to drag it or to click."""
        return self._held is not None

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self.hasFocus() or event.button() != Qt.MouseButton.LeftButton or self.value is None:
            super().mousePressEvent(event)
            return
        self._held, self._is_dragged = (event.globalPosition(), self.value), False

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is None:
            super().mouseMoveEvent(event)
            return
        start, value = self._held
        right = event.globalPosition().x() - start.x()
        self._is_dragged = self._is_dragged or abs(right) >= STARTS_AT
        if self._is_dragged:
            self._take(value * 2.0 ** (right / DOUBLES))

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        was_held, self._held = self._held is not None, None
        if not was_held:
            super().mouseReleaseEvent(event)
        elif not self._is_dragged:
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            self.selectAll()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self._held = None
        self._revert()
        self.clearFocus()
        self._take(self._setting.usual)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if turned := event.angleDelta().y():
            self._change_by(turned / 120.0)
        event.accept()

    def _change_by(self, amount: float) -> None:
        if self.value is not None:
            self._finish()
            self._take(self.value * NOTCH**amount)

    def _take(self, value: float) -> str:
        if value <= 0.0:
            return "a number above 0 is needed"
        value = min(max(value, self._setting.least), self._setting.most)
        self.show_value(value)
        self._changed(value)
        return ""


class SettingsStrip(QWidget):
    """A row for each number; hidden while no overlay that draws something has any."""

    changed = Signal(str, float)
    """"overlay.setting", and the number"""

    def __init__(self, view: QWidget, corners: Callable[[QSize], Sequence[QPoint]]) -> None:
        """`corners` are where a strip that large may lie, the best place first."""
        super().__init__(view)
        self._corners = corners
        self._taken: tuple[QRect, ...] = ()
        """what legends and captions cover of the view"""
        self._shown: list[Overlay] = []
        self._fields: dict[str, SettingField] = {}
        self._rows = QGridLayout(self)
        self._rows.setContentsMargins(8, 4, 6, 4)
        self._rows.setSpacing(4)
        self.setProperty("framed", True)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setCursor(Qt.CursorShape.ArrowCursor)
        self.setAccessibleName("numbers of overlays")
        view.installEventFilter(self)
        self.hide()

    def show_options(self, options: ViewOptions, session: Session) -> None:
        """Show the numbers of the overlays that are on, as far as they draw anything."""
        self.show_design(options, session)
        for owner in self._shown:
            for name, value in owner.numbers(options.settings).items():
                self._fields[f"{owner.name}.{name}"].show_value(value)
        self.place()

    def show_design(self, options: ViewOptions, session: Session) -> None:
        """The same once there are other shapes, or others are selected."""
        named = (entry for entry in in_order() if entry.name in options.overlays)
        asked = (entry for entry in named if entry.settings)
        shown = in_use(asked, session.design, session.selection.shapes)
        if shown != self._shown:
            self._shown = shown
            self._fill(shown)
            self.show_options(options, session)

    def keep_clear_of(self, boxes: Iterable[Box]) -> None:
        """Lie beside those boxes of legends and captions, as far as there is room."""
        taken = tuple(QRectF(*box).toAlignedRect() for box in boxes)
        if taken != self._taken:
            self._taken = taken
            # Asked for while the view is painted, when nothing may move.
            QTimer.singleShot(0, self, self.place)

    def place(self) -> None:
        """Take the corner that is free, if there is anything to show."""
        self.setVisible(bool(self._shown))
        # What the mouse holds stays under it.
        if self._shown and not any(field.is_held for field in self._fields.values()):
            self.adjustSize()
            self.move(min(self._corners(self.size()), key=self._covered))
            self.raise_()

    def _covered(self, corner: QPoint) -> int:
        """How many pixels of legends and captions the strip would cover there."""
        covered = [QRect(corner, self.size()) & box for box in self._taken]
        return sum(part.width() * part.height() for part in covered if not part.isEmpty())

    def _fill(self, entries: list[Overlay]) -> None:
        while (item := self._rows.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.hide()
                widget.deleteLater()
        self._fields = {}
        rows: list[tuple[str, Setting] | str] = []
        for entry in entries:
            # Settings of several overlays may have the same titles.
            rows += [entry.title] if len(entries) > 1 else []
            rows += [(f"{entry.name}.{setting.name}", setting) for setting in entry.settings]
        for place, row in enumerate(rows):
            if isinstance(row, str):
                self._put(QLabel(row), place, 0, THREE)
            else:
                self._put_setting(*row, place)

    def _put_setting(self, name: str, setting: Setting, row: int) -> None:
        label, arrows = QLabel(setting.title), QLabel("↔")
        for quiet in (label, arrows):
            quiet.setProperty("quiet", True)
        field = SettingField(setting, lambda value: self.changed.emit(name, value))
        self._fields[name] = field
        for column, widget in enumerate((label, field, arrows)):
            self._put(widget, row, column)

    def _put(self, widget: QWidget, row: int, column: int, columns: int = 1) -> None:
        self._rows.addWidget(widget, row, column, 1, columns)
        # Of a strip in sight, a layout leaves out what is not shown yet.
        widget.show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Resize:
            self.place()
        return super().eventFilter(watched, event)
