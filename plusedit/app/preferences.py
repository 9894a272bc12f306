"""What a person may set up once: look, grid, new curves, shortcuts."""

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLineEdit,
    QTabWidget,
    QVBoxLayout,
    QWidget,
)

from plusedit.app.actions import ActionTable
from plusedit.app.settings import Settings
from plusedit.app.shortcut_editor import ShortcutEditor
from plusedit.interaction.tool import NewCurves
from plusedit.views.arithmetic import calculated, written
from plusedit.views.family_form import family_titles
from plusedit.views.live import quiet

LOOKS = {"system": "As the desktop", "light": "Light", "dark": "Dark"}
HIGHEST_ORDER = 20


class Preferences(QDialog):
    """Nothing changes until OK; then everything is remembered at once."""

    def __init__(self, settings: Settings, table: ActionTable, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Preferences")
        self._settings = settings
        self.look = QComboBox()
        for key, name in LOOKS.items():
            self.look.addItem(name, key)
        self.look.setCurrentIndex(self.look.findData(settings.look))
        step = settings.grid_step
        self.grid_step = QLineEdit("" if step is None else written(step, 12))
        self.grid_step.setPlaceholderText("follows the zoom")
        self.animated = QCheckBox("Cameras glide from one view to the next")
        self.animated.setChecked(settings.animated)
        self._curves(settings.new_curves)
        self.shortcuts = ShortcutEditor(table)
        self._reason = quiet()
        self._reason.setProperty("wrong", True)
        tabs = QTabWidget()
        tabs.setDocumentMode(True)
        tabs.addTab(self._general(), "General")
        tabs.addTab(self.shortcuts, "Shortcuts")
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.accepted.connect(self._take)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.setContentsMargins(16, 16, 16, 16)
        column.setSpacing(8)
        column.addWidget(tabs)
        column.addWidget(self._reason)
        column.addWidget(buttons)
        self.resize(560, 560)

    def _curves(self, curves: NewCurves) -> None:
        self.family = QComboBox()
        for key, name in family_titles().items():
            self.family.addItem(name, key)
        self.family.setCurrentIndex(self.family.findData(curves.family))
        self.order = QLineEdit(str(curves.order))
        self.closed = QCheckBox("Closed")
        self.closed.setChecked(curves.closed)

    def _general(self) -> QWidget:
        page = QWidget()
        form = QFormLayout(page)
        form.setContentsMargins(0, 16, 0, 0)
        form.setSpacing(8)
        form.addRow("Theme", self.look)
        form.addRow("Grid step", self.grid_step)
        form.addRow("", quiet("What points snap to and arrow keys move by."))
        form.addRow("Views", self.animated)
        form.addRow("New curves", self.family)
        form.addRow("Order", self.order)
        form.addRow("", quiet("Of new B-splines; a cubic has order 4."))
        form.addRow("", self.closed)
        return page

    def _take(self) -> None:
        try:
            text = self.grid_step.text().strip()
            step = calculated(text) if text else None
            if step is not None and step <= 0.0:
                raise ValueError("The grid step must be above zero.")
            order = calculated(self.order.text())
            if order != round(order) or not 2 <= order <= HIGHEST_ORDER:
                raise ValueError(f"The order is a whole number from 2 to {HIGHEST_ORDER}.")
        except ValueError as error:
            self._reason.setText(str(error))
            return
        self._settings.look = str(self.look.currentData())
        self._settings.grid_step = step
        self._settings.animated = self.animated.isChecked()
        self._settings.new_curves = NewCurves(
            str(self.family.currentData()), round(order), self.closed.isChecked()
        )
        self.shortcuts.settle()
        self._settings.shortcuts = self.shortcuts.changed()
        self._settings.sync()
        self.accept()
