"""The question after a crash: the design as it was kept, or the file as it was saved."""

from datetime import datetime
from pathlib import Path
from typing import Literal

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from plusedit.app.autosave import Left
from plusedit.app.background import in_background
from plusedit.app.mesh_opening import is_mesh
from plusedit.app.thumbnails import image_of_file, small_image_of
from plusedit.scene.theme import Theme
from plusedit.views.live import quiet, title

Choice = Literal["recovered", "saved", "later"]

NAMELESS = "a design without a name"
PICTURE = QSize(288, 200)


class RecoveryDialog(QDialog):
    """Both versions side by side, with date and picture; one click chooses."""

    def __init__(self, left: Left, theme: Theme, parent: QWidget | None) -> None:
        super().__init__(parent)
        self.choice: Choice = "later"
        ratio = self.devicePixelRatioF()
        # Those of large meshes take their time.
        self._images = in_background(
            parent or self,
            "Drawing what was left …",
            lambda: _images(left, theme, ratio),
            can_cancel=False,
        )
        name = NAMELESS if left.path is None else left.path.name
        self.setWindowTitle("PlusEdit")
        column = QVBoxLayout(self)
        column.setContentsMargins(24, 24, 24, 16)
        column.setSpacing(16)
        head = title(f"PlusEdit ended before {name} was saved")
        column.addWidget(head)
        versions = QHBoxLayout()
        versions.setSpacing(24)
        versions.addLayout(self._recovered(left))
        versions.addLayout(self._saved(left.path))
        column.addLayout(versions)
        later = QPushButton("Decide later")
        later.setToolTip("Both versions stay; the question comes again at the next start")
        later.clicked.connect(self.reject)
        column.addWidget(later, 0, Qt.AlignmentFlag.AlignRight)

    def _recovered(self, left: Left) -> QVBoxLayout:
        picture = framed()
        picture.setPixmap(QPixmap.fromImage(self._images[0]))
        button = QPushButton("Open recovered version")
        button.setDefault(True)
        button.clicked.connect(lambda: self._choose("recovered"))
        return self._version("Recovered", when(left.time), picture, button)

    def _saved(self, path: Path | None) -> QVBoxLayout:
        picture = framed("Nothing")
        date = "never saved"
        button = QPushButton("Discard recovered version")
        if path is not None and path.exists():
            date = when(path.stat().st_mtime)
            image = self._images[1]
            if image is not None:
                picture.setPixmap(QPixmap.fromImage(image))
                button.setText("Open saved version")
            elif is_mesh(path):
                picture.setText("The mesh as it was before.")
                button.setText("Open the mesh again")
            else:
                picture.setText("The file can’t be read.")
        elif path is not None:
            date = "the file is gone"
        button.setToolTip("The recovered version is deleted")
        button.clicked.connect(lambda: self._choose("saved"))
        return self._version("On disk", date, picture, button)

    def _version(self, name: str, date: str, picture: QLabel, button: QPushButton) -> QVBoxLayout:
        column = QVBoxLayout()
        column.setSpacing(8)
        picture.setAccessibleName(f"Picture of the version: {name}")
        column.addWidget(picture)
        column.addWidget(title(name))
        column.addWidget(quiet(date))
        column.addWidget(button)
        return column

    def _choose(self, choice: Choice) -> None:
        self.choice = choice
        self.accept()


def _images(left: Left, theme: Theme, ratio: float) -> tuple[QImage, QImage | None]:
    """Of what was kept, and of what is on disk where that is a design."""
    kept = small_image_of(left.design, PICTURE, theme, ratio)
    has_design = left.path is not None and left.path.exists() and not is_mesh(left.path)
    saved = image_of_file(left.path, PICTURE, theme, ratio) if left.path and has_design else None
    return kept, saved


def framed(text: str = "") -> QLabel:
    """The place of a picture, with words where there is none."""
    label = QLabel(text)
    label.setFixedSize(PICTURE + QSize(2, 2))
    label.setAlignment(Qt.AlignmentFlag.AlignCenter)
    label.setProperty("framed", True)
    label.setProperty("quiet", True)
    return label


def when(seconds: float) -> str:
    """A time as day and time of day, such as "Sunday 22 November 2026, 14:05:09"."""
    return f"{datetime.fromtimestamp(seconds):%A %d %B %Y, %H:%M:%S}"


def ask(left: Left, theme: Theme, parent: QWidget | None) -> Choice:
    """Ask which version of a design to go on with."""
    dialog = RecoveryDialog(left, theme, parent)
    dialog.exec()
    return dialog.choice
