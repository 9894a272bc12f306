"""The windows beside the main one: palette, preferences, help. Loaded when they are asked for."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QDialog, QMessageBox

from plusedit import __version__

if TYPE_CHECKING:
    from plusedit.app.help_window import HelpWindow
    from plusedit.app.palette import Palette
    from plusedit.app.window import MainWindow
    from plusedit.io.mesh_report import ImportReport


class SideWindows:
    """Shows them, each from scratch."""

    def __init__(self, window: "MainWindow") -> None:
        self._window = window
        self.palette: Palette | None = None
        self.help: HelpWindow | None = None
        self.mesh_report: ImportReport | None = None
        """of the mesh that was read last"""

    def show_palette(self) -> None:
        """The command palette."""
        from plusedit.app.palette import Palette

        self._window.gestures.cancel()
        self._window.actions_table.refresh()
        self.palette = Palette(self._window.actions_table, self._window)
        self.palette.show()
        self.palette.typed.setFocus()

    def show_preferences(self) -> None:
        """The preferences; what was chosen takes effect at once."""
        from plusedit.app.preferences import Preferences

        self._window.gestures.cancel()
        dialog = Preferences(self._window.settings, self._window.actions_table, self._window)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            self._window.take_settings()

    def show_help(self) -> None:
        """Mouse, keys, and what a plus curve is, in a window that may stay open."""
        from plusedit.app.help_window import HelpWindow

        self.help = HelpWindow(self._window.actions_table, self._window)
        self.help.show()

    def keep_mesh_report(self, report: "ImportReport") -> None:
        """Have that report at hand."""
        self.mesh_report = report
        self._window.actions_table.refresh()

    def show_mesh_report(self) -> None:
        """What was found in the mesh read last, in a window that may stay open."""
        from plusedit.app.mesh_report import MeshReportWindow

        if self.mesh_report is not None:
            MeshReportWindow(self._window, self.mesh_report).show()

    def show_about(self) -> None:
        """Name, version, and what it is."""
        QMessageBox.about(
            self._window,
            "About PlusEdit",
            f"<h3>PlusEdit {__version__}</h3><p>An editor for plus curves: free-form curves "
            "shaped by control lines, points with a direction.</p>",
        )
