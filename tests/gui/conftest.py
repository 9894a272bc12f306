"""Real widgets on Qt's offscreen platform."""

import os

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from pathlib import Path

import pytest
from PySide6.QtCore import QCoreApplication, QEvent

from plusedit.document.selection import LineId, Selection
from tests.designs import DOCUMENT


class Answers:
    """Stands in for the dialogs about files: gives answers and remembers what was said."""

    def __init__(self):
        self.open = self.save = self.exported = self.imported = None
        self.on_unsaved = "cancel"
        self.export_wanted = False
        self.asked, self.errors, self.suggested = [], [], None

    def open_path(self, folder):
        return self.open

    def import_path(self, folder):
        return self.imported

    def save_path(self, suggested):
        self.suggested = suggested
        return self.save

    def export_path(self, suggested, title, filters):
        self.suggested = suggested
        return self.exported

    def unsaved(self, name):
        self.asked.append(name)
        return self.on_unsaved

    def wants_export(self, path):
        return self.export_wanted

    def error(self, sentence):
        self.errors.append(sentence)


@pytest.fixture
def settings(tmp_path):
    """Settings of their own for every test."""
    from plusedit.app.settings import Settings

    return Settings(tmp_path / "settings.ini")


@pytest.fixture
def window(qtbot, qapp, settings, tmp_path):
    """The main window, shown, with an empty design and prepared answers."""
    from plusedit.app.window import MainWindow

    window = MainWindow(settings, tmp_path / "autosave")
    window.files.dialogs = Answers()
    qtbot.addWidget(window, before_close_func=lambda w: w.session.mark_saved())
    window.show()
    qtbot.waitExposed(window)
    yield window
    # Closed by now, but not gone: hundreds of windows would take the next style with them.
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    qapp.setStyleSheet("")


@pytest.fixture
def answers(window):
    """What the person would answer to dialogs about files."""
    return window.files.dialogs


@pytest.fixture
def opened(window, document):
    """The window with a document open that has curves, a surface and a mesh."""
    assert window.files.open(document)
    return window


def select_lines(window, shape_id, *numbers):
    """Select control lines of one shape, the last one active."""
    lines = [LineId(shape_id, number) for number in numbers]
    window.session.select(Selection.of_lines(lines, lines[-1]))


def example(name):
    """The path of a shipped design."""
    return Path(__file__).parents[2] / "assets" / "examples" / name


__all__ = ["DOCUMENT"]
