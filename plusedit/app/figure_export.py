"""Export figure: asks how, shows what comes of it, and writes the file."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QWidget

from plusedit.app.files import Files
from plusedit.app.settings import Settings
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.figure import Figure
from plusedit.views.desk import Desk
from plusedit.views.panes import Panes

if TYPE_CHECKING:
    from plusedit.app.figure_dialog import FigureWish

NAME = "Export figure"


class FigureExport:
    """What is seen, or all of the design, as a figure for print."""

    def __init__(
        self, desk: Desk, panes: Panes, files: Files, settings: Settings, parent: QWidget
    ) -> None:
        self._desk, self._panes, self._files = desk, panes, files
        self._settings, self._parent = settings, parent
        self.ask: Callable[[FigureWish], FigureWish | None] = self._ask
        """how the figure is to be"""

    def export(self) -> None:
        """Ask how the figure is to be, then for a name, and write it."""
        from plusedit.app.figure_dialog import FigureWish

        self._desk.gestures.cancel()
        wish = self.ask(FigureWish.of(self._settings.figure))
        if wish is None:
            return
        self._settings.figure = wish.tree()
        # Drawn here and not in the background: OpenGL wants the thread of the window.
        data = self._drawn(wish)
        if data is not None:
            kind = {".pdf": "PDF document", ".svg": "SVG drawing", ".png": "PNG picture"}
            self._files.export_with(
                wish.suffix, NAME, lambda path: _write(data, path), kind[wish.suffix]
            )

    def compose(self, wish: "FigureWish") -> Figure:
        """The figure that is wished for, of the design as it is seen now."""
        from plusedit.scene.figure_composition import plane_figure, space_figure

        design, selection = self._files.seen(), self._desk.session.selection
        camera = self._panes.active.camera
        if wish.part == "seen" and isinstance(camera, PlaneCamera):
            return plane_figure(design, wish.form, camera=camera, selection=selection)
        if wish.part == "seen" and not isinstance(camera, PlaneCamera):
            return space_figure(design, wish.form, camera=camera, selection=selection)
        make = space_figure if wish.part == "space" else plane_figure
        return make(design, wish.form, selection=selection)

    def _ask(self, wish: "FigureWish") -> "FigureWish | None":
        from plusedit.app.figure_dialog import FigureDialog

        has_space = self._panes.space is not None
        dialog = FigureDialog(self._parent, wish, self.compose, has_space=has_space)
        return dialog.read() if dialog.exec() else None

    def _drawn(self, wish: "FigureWish") -> bytes | None:
        """The bytes of the file; None where it can't be made, which is told."""
        from plusedit.views.figure_files import figure_file
        from plusedit.views.gl.functions import OpenGLError

        QApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)
        try:
            figure = self.compose(wish)
            return figure_file(figure, wish.suffix, wish.resolution, self._files.name)
        except (ValueError, OpenGLError, MemoryError) as error:
            problem = str(error)
        finally:
            QApplication.restoreOverrideCursor()
        self._files.dialogs.error(problem)
        return None


def _write(data: bytes, path: Path) -> None:
    from plusedit.io.files import write_file

    write_file(data, path)
