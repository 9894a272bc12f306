"""The windows beside the main one: palette, preferences, help. Loaded when they are asked for."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QDialog, QMessageBox

from plusedit import __version__

if TYPE_CHECKING:
    from plusedit.app.help_window import HelpWindow
    from plusedit.app.mesh_measuring import MeasuredReport
    from plusedit.app.mesh_opening import MeshReading
    from plusedit.app.palette import Palette
    from plusedit.app.window import MainWindow


class SideWindows:
    """Shows them, each from scratch."""

    def __init__(self, window: "MainWindow") -> None:
        self._window = window
        self.palette: Palette | None = None
        self.help: HelpWindow | None = None
        self.mesh_report: MeasuredReport | None = None
        """of the mesh that was read last"""
        self._reading: MeshReading | None = None
        self._shown_report: QDialog | None = None

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

        window = self._window
        self.help = HelpWindow(window.actions_table, window, window.files.open)
        self.help.show()

    def show_facts(self) -> None:
        """Where the help tells what the paper has not quite right."""
        self.show_help()
        if self.help is not None:
            self.help.show_facts()

    def keep_mesh_report(self, reading: "MeshReading") -> None:
        """Have the report of that mesh at hand; where one is shown, it is this one now."""
        from plusedit.app.mesh_measuring import MeasuredReport

        if self.mesh_report is not None:
            self.mesh_report.cancel()
        surfaces = [part.surface for part in reading.imported.parts]
        self.mesh_report = MeasuredReport(reading.report, surfaces, self._window)
        self._reading = reading
        if reading.options.measure:
            self.mesh_report.begin_soon()
        self._window.actions_table.refresh()
        self._window.notes.offer("Report…", self.show_mesh_report)
        if self._shown_report is not None:
            self.show_mesh_report()

    def show_mesh_report(self) -> None:
        """What was found in the mesh read last, in a window that may stay open."""
        from plusedit.app.mesh_report import MeshReportWindow

        if self.mesh_report is None:
            return
        self.mesh_report.begin()
        shown = MeshReportWindow(self._window, self.mesh_report, self.import_mesh_again)
        if self._shown_report is not None:
            shown.setGeometry(self._shown_report.geometry())
            self._shown_report.close()
        self._shown_report = shown
        shown.finished.connect(lambda: self._forget_report(shown))
        shown.show()

    def import_mesh_again(self) -> None:
        """Read the file of the last mesh in another way."""
        if self._reading is not None:
            self._window.flows.import_again(self._reading)

    def _forget_report(self, closed: QDialog) -> None:
        if self._shown_report is closed:
            self._shown_report = None

    def show_about(self) -> None:
        """Name, version, and what it is."""
        QMessageBox.about(
            self._window,
            "About PlusEdit",
            f"<h3>PlusEdit {__version__}</h3><p>An editor for plus curves: free-form curves "
            "shaped by control lines, points with a direction.</p>",
        )
