"""The questions about files that the window asks. Tests put their own answers in their place."""

from collections.abc import Iterable
from pathlib import Path
from typing import Literal

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from plusedit.app.errors import message
from plusedit.app.mesh_opening import mesh_suffixes
from plusedit.io.formats import Format, formats

Answer = Literal["save", "discard", "cancel"]

DESIGN_SUFFIX = ".plus.json"


def patterns(format_: Format) -> str:
    """A line of a file dialog, such as "SVG drawing (*.svg)"."""
    return f"{format_.title} ({' '.join('*' + suffix for suffix in format_.suffixes)})"


def complete() -> list[Format]:
    """The formats that lose nothing of a design."""
    return [format_ for format_ in formats.values() if format_.keeps_all]


class Dialogs:
    """Native dialogs over one window."""

    def __init__(self, parent: QWidget) -> None:
        self._parent = parent

    def open_path(self, folder: Path) -> Path | None:
        """The file to open."""
        ours = (*known_suffixes(), *mesh_suffixes())
        all_of_ours = f"All that can be opened ({' '.join('*' + s for s in ours)})"
        filters = [all_of_ours, *map(patterns, formats.values()), of_meshes(), "All files (*)"]
        return self._path(
            QFileDialog.getOpenFileName(self._parent, "Open", str(folder), ";;".join(filters))
        )

    def import_path(self, folder: Path) -> Path | None:
        """The SVG to import."""
        return self._path(
            QFileDialog.getOpenFileName(
                self._parent, "Import SVG", str(folder), patterns(formats["svg"])
            )
        )

    def mesh_path(self, folder: Path) -> Path | None:
        """The mesh or terrain to import."""
        return self._path(
            QFileDialog.getOpenFileName(self._parent, "Import mesh", str(folder), of_meshes())
        )

    def save_path(self, suggested: Path) -> Path | None:
        """The name under which to save the design."""
        filters = [*map(patterns, complete()), "All files (*)"]
        answer = QFileDialog.getSaveFileName(
            self._parent, "Save design", str(suggested), ";;".join(filters)
        )
        return self._completed(self._path(answer), DESIGN_SUFFIX, known_suffixes())

    def export_path(self, suggested: Path, title: str, filters: str) -> Path | None:
        """The name of a picture or drawing to write."""
        answer = QFileDialog.getSaveFileName(self._parent, title, str(suggested), filters)
        return self._completed(self._path(answer), suggested.suffix)

    def unsaved(self, name: str) -> Answer:
        """What is to become of changes that are not saved."""
        box = QMessageBox(self._parent)
        box.setIcon(QMessageBox.Icon.Question)
        box.setWindowTitle("PlusEdit")
        box.setText(f"Save the changes to {name}?")
        box.setInformativeText("They are lost otherwise.")
        button = QMessageBox.StandardButton
        box.setStandardButtons(button.Save | button.Discard | button.Cancel)
        box.setDefaultButton(button.Save)
        answers: dict[int, Answer] = {
            button.Save.value: "save",
            button.Discard.value: "discard",
        }
        return answers.get(box.exec(), "cancel")

    def wants_export(self, path: Path) -> bool:
        """Whether a copy in a format that loses control lines is what was meant."""
        box = QMessageBox(self._parent)
        box.setIcon(QMessageBox.Icon.Question)
        box.setWindowTitle("PlusEdit")
        box.setText(f"{path.suffix.upper()[1:]} keeps the shapes, but not their control lines.")
        box.setInformativeText(
            f"Export a copy to {path.name}? The design itself is saved as a {DESIGN_SUFFIX} file."
        )
        export = box.addButton("Export a copy", QMessageBox.ButtonRole.AcceptRole)
        box.addButton(QMessageBox.StandardButton.Cancel)
        box.exec()
        return box.clickedButton() is export

    def error(self, sentence: str) -> None:
        """Say what went wrong."""
        message(self._parent, sentence).exec()

    def may_replace(self, path: Path) -> bool:
        """Whether a file that is there already may be written over."""
        button = QMessageBox.StandardButton
        question = f"{path.name} is there already. Replace it?"
        chosen = button.Yes | button.Cancel
        answer = QMessageBox.question(self._parent, "PlusEdit", question, chosen, button.Cancel)
        return answer == button.Yes

    def _completed(
        self, path: Path | None, suffix: str, known: tuple[str, ...] = ()
    ) -> Path | None:
        """The path with its suffix; the file dialog could not ask about a name it never saw."""
        whole = with_suffix(path, suffix, known)
        if whole is None or whole == path or not whole.exists() or self.may_replace(whole):
            return whole
        return None

    def _path(self, answer: Iterable[object]) -> Path | None:
        name = str(next(iter(answer)))
        return Path(name) if name else None


def of_meshes() -> str:
    """The line of a file dialog for all meshes and terrains."""
    return f"Meshes and terrains ({' '.join('*' + suffix for suffix in mesh_suffixes())})"


def known_suffixes() -> tuple[str, ...]:
    """Those of all formats."""
    return tuple(suffix for format_ in formats.values() for suffix in format_.suffixes)


def with_suffix(path: Path | None, suffix: str, known: tuple[str, ...] = ()) -> Path | None:
    """`path` with that suffix behind it, unless it ends with it or with a known one.

    What follows a dot in a name such as "wing v1.2" is no suffix.
    """
    if path is None or path.name.lower().endswith((suffix, *known)):
        return path
    return path.with_name(path.name + suffix)
