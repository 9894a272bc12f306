"""Starts the editor."""

import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QTimer
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QApplication

from plusedit import __version__
from plusedit.app import errors
from plusedit.app.settings import Settings
from plusedit.resources import icon_file
from plusedit.views.opengl import prepare_opengl

if TYPE_CHECKING:
    from plusedit.app.window import MainWindow


def run(paths: list[str]) -> int:
    """Open a window, and the first of `paths` in it; further ones get windows of their own."""
    application = make_application(sys.argv[:1])
    errors.install()
    # Ctrl+C in the terminal ends the program; what was not saved is offered at the next start.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    from plusedit.app.window import MainWindow

    window = MainWindow(Settings())
    # What to begin with is no question to whom a file was given.
    window.start_page.set_blank(bool(paths))
    window.show()
    QTimer.singleShot(0, lambda: begin(window, [Path(path) for path in paths]))
    return application.exec()


def make_application(arguments: list[str]) -> QApplication:
    """The application, in our style."""
    # The kind of context that is shared can't be chosen once there is an application.
    prepare_opengl()
    application = QApplication(arguments)
    application.setApplicationName("plusedit")
    application.setApplicationDisplayName("PlusEdit")
    application.setApplicationVersion(__version__)
    application.setDesktopFileName("plusedit")
    application.setWindowIcon(QIcon(str(icon_file("plusedit"))))
    application.setStyle("Fusion")
    return application


def begin(window: "MainWindow", paths: list[Path]) -> None:
    """Offer what a crash left behind, then open files: the first here unless that is here now."""
    from plusedit.app.autosave import has_left_behind
    from plusedit.app.flows import open_elsewhere

    is_taken = has_left_behind() and window.flows.recover()
    if paths and not is_taken:
        window.files.open(paths.pop(0))
    window.start_page.set_blank(False)
    for path in paths:
        if path.absolute() != window.files.path:
            open_elsewhere(path)
