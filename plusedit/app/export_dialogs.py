"""How a picture is to be drawn, and how an SVG is to be read."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFormLayout,
    QLineEdit,
    QVBoxLayout,
    QWidget,
)

from plusedit.views.arithmetic import calculated
from plusedit.views.live import quiet

How = Literal["segments", "paths", "fitted"]

LARGEST_SIDE = 16384  # pixels
USUAL_TOLERANCE = "0.1"  # percent of the size of a path
VIEWS = {
    "3d": "3D view, all of the design",
    "2d": "2D view, all of the design",
    "iso": "Isometric",
    "top": "From the top",
    "front": "From the front",
    "right": "From the right",
}
WAYS: dict[How, tuple[str, str]] = {
    "segments": (
        "One curve for each segment",
        "Each cubic becomes a Bézier+ of three control lines, exactly.",
    ),
    "paths": (
        "One curve for each path",
        "Each path becomes one B-spline+ with double knots, exactly.",
    ),
    "fitted": (
        "One smooth curve for each path, fitted",
        "Each path becomes a B-spline+ with as few control lines as the tolerance allows.",
    ),
}


@dataclass(frozen=True)
class Picture:
    """How a picture is drawn."""

    size: tuple[int, int]
    theme: str
    transparent: bool
    view: str = "2d"
    """a key of VIEWS"""


@dataclass(frozen=True)
class Reading:
    """How an SVG is read."""

    how: How
    tolerance: float
    """of the size of each path; used where curves are fitted"""


class Question(QDialog):
    """A short form with OK and Cancel, and a line for what is wrong."""

    def __init__(self, parent: QWidget | None, name: str, accept: str) -> None:
        super().__init__(parent)
        self.setWindowTitle(name)
        self.form = QFormLayout()
        self.form.setSpacing(8)
        self._reason = quiet()
        self._reason.setProperty("wrong", True)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel
        )
        buttons.button(QDialogButtonBox.StandardButton.Ok).setText(accept)
        buttons.accepted.connect(self._check)
        buttons.rejected.connect(self.reject)
        column = QVBoxLayout(self)
        column.setContentsMargins(24, 24, 24, 16)
        column.setSpacing(16)
        column.addLayout(self.form)
        column.addWidget(self._reason)
        column.addWidget(buttons)
        self.setMinimumWidth(360)

    def _check(self) -> None:
        try:
            self.read()
        except ValueError as error:
            self._reason.setText(str(error))
            return
        self.accept()

    def read(self) -> object:
        """What was filled in. ValueError says what is wrong with it."""
        raise NotImplementedError


class PictureDialog(Question):
    """View, size, theme and ground of a picture."""

    def __init__(
        self, parent: QWidget | None, size: tuple[int, int], theme: str, views: Sequence[str] = ()
    ) -> None:
        super().__init__(parent, "Export picture", "Export…")
        self.view = QComboBox()
        for name in views:
            self.view.addItem(VIEWS[name], name)
        if len(views) > 1:
            self.form.addRow("View", self.view)
        self.width_field, self.height_field = QLineEdit(str(size[0])), QLineEdit(str(size[1]))
        self.theme = QComboBox()
        for name in ("light", "dark"):
            self.theme.addItem(name.capitalize(), name)
        self.theme.setCurrentIndex(self.theme.findData(theme))
        self.transparent = QCheckBox("Transparent background")
        self.form.addRow("Width, pixels", self.width_field)
        self.form.addRow("Height, pixels", self.height_field)
        self.form.addRow("Colors", self.theme)
        self.form.addRow("", self.transparent)

    def read(self) -> Picture:
        size = (side(self.width_field.text()), side(self.height_field.text()))
        return Picture(
            size,
            str(self.theme.currentData()),
            self.transparent.isChecked(),
            self.view.currentData() or "2d",
        )


class ReadingDialog(Question):
    """How the paths of an SVG become curves."""

    def __init__(self, parent: QWidget | None) -> None:
        super().__init__(parent, "Import SVG", "Import")
        self.how = QComboBox()
        for how, (name, _) in WAYS.items():
            self.how.addItem(name, how)
        self.tolerance = QLineEdit(USUAL_TOLERANCE)
        self._remark = quiet()
        self.form.addRow("Curves", self.how)
        self.form.addRow("", self._remark)
        self.form.addRow("Tolerance, % of size", self.tolerance)
        self.how.currentIndexChanged.connect(self._show)
        self._show()

    def read(self) -> Reading:
        how: How = self.how.currentData()
        tolerance = calculated(self.tolerance.text()) / 100.0
        if how == "fitted" and tolerance <= 0.0:
            raise ValueError("The tolerance must be above zero.")
        return Reading(how, tolerance)

    def _show(self) -> None:
        how: How = self.how.currentData()
        self._remark.setText(WAYS[how][1])
        self.form.setRowVisible(self.tolerance, how == "fitted")


def side(text: str) -> int:
    """A number of pixels. ValueError if it is none that a picture can have."""
    value = calculated(text)
    if not 1.0 <= value <= LARGEST_SIDE:
        raise ValueError(f"A side of a picture has 1 to {LARGEST_SIDE} pixels.")
    return round(value)
