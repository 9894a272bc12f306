"""The tool bar: the tools, what the pen will draw, undo and redo, and a few switches."""

from dataclasses import replace

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QLabel,
    QSizePolicy,
    QSpinBox,
    QToolBar,
    QWidget,
)

from plusedit.app.actions import ActionTable
from plusedit.interaction.tool import NewCurves, tools
from plusedit.views.family_form import family_titles
from plusedit.views.hands import Hands
from plusedit.views.live import quiet

ICON = QSize(24, 24)
PEN = "pen"  # the tool that draws new curves
HIGHEST_ORDER = 20


class NewCurveOptions(QWidget):
    """What kind of curve the pen draws; seen while the pen is chosen."""

    def __init__(self, gestures: Hands) -> None:
        super().__init__()
        self._gestures = gestures
        self.family = QComboBox()
        self.family.setAccessibleName("family of new curves")
        for name, text in family_titles().items():
            self.family.addItem(text, name)
        self.order = QSpinBox()
        self.order.setRange(2, HIGHEST_ORDER)
        self.order.setAccessibleName("order of new curves")
        self.closed = QCheckBox("Closed")
        for widget in (self.family, self.order, self.closed):
            widget.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self._order_label = quiet("Order")
        row = QHBoxLayout(self)
        row.setContentsMargins(4, 0, 4, 0)
        row.setSpacing(8)
        row.addWidget(QLabel("New curve"))
        for part in (self.family, self._order_label, self.order, self.closed):
            row.addWidget(part)
        self.show_kind(gestures.new_curves)
        self.family.activated.connect(lambda _: self._chosen())
        self.order.valueChanged.connect(lambda _: self._chosen())
        self.closed.toggled.connect(lambda _: self._chosen())

    def show_kind(self, kind: NewCurves) -> None:
        """Show what the pen draws."""
        self.family.setCurrentIndex(self.family.findData(kind.family))
        self.order.setValue(kind.order)
        self.closed.setChecked(kind.closed)
        self._enable()

    def _chosen(self) -> None:
        self._gestures.new_curves = replace(
            self._gestures.new_curves,
            family=str(self.family.currentData()),
            order=self.order.value(),
            closed=self.closed.isChecked(),
        )
        self._enable()

    def _enable(self) -> None:
        has_order = self.family.currentData() == "bspline"
        self.order.setVisible(has_order)
        self._order_label.setVisible(has_order)
        self.closed.setEnabled(self.family.currentData() != "bezier")


def tools_in_order() -> list[str]:
    """The names of the tools from left to right."""
    return sorted(tools, key=lambda name: (tools[name].order, name))


def make_toolbar(table: ActionTable, gestures: Hands) -> QToolBar:
    """The tool bar of the window."""
    bar = QToolBar("Tools")
    bar.setObjectName("tools")
    bar.setMovable(False)
    bar.setIconSize(ICON)
    bar.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
    for name in (*(f"tool.{tool}" for tool in tools_in_order()), "", "undo", "redo", ""):
        if name:
            table.show_icon(name)
            bar.addAction(table[name])
        else:
            bar.addSeparator()
    kinds = NewCurveOptions(gestures)
    shown = bar.addWidget(kinds)
    shown.setVisible(gestures.tool_name == PEN)
    gestures.tool_changed.listen(lambda name: shown.setVisible(name == PEN))
    bar.kinds = kinds  # type: ignore[attr-defined]
    spacer = QWidget()
    spacer.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    bar.addWidget(spacer)
    for name in ("view.grid", "view.snap", "frame_all", "palette"):
        table.show_icon(name)
        bar.addAction(table[name])
    for child in bar.findChildren(QWidget):
        if child.metaObject().className() == "QToolButton":
            child.setFocusPolicy(Qt.FocusPolicy.NoFocus)
    return bar
