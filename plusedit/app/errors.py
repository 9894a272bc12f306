"""What happens when something goes wrong: a sentence for the person, the details in a log."""

import logging
import sys
import traceback
from types import TracebackType

from PySide6.QtCore import QMessageLogContext, QTimer, QtMsgType, qInstallMessageHandler
from PySide6.QtWidgets import QApplication, QMessageBox, QWidget

from plusedit.app.settings import state_folder
from plusedit.machine import log_file

log = logging.getLogger("plusedit")

LOG_SIZE = 2**19  # bytes; a log that has grown beyond becomes the old one, of which one is kept
SENTENCE = (
    "Something went wrong inside PlusEdit. Your design is as it was before; it is kept safe "
    "every half minute, and you can go on working."
)
LEVELS = {
    QtMsgType.QtDebugMsg: logging.DEBUG,
    QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING,
    QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}

_showing = False


def install() -> None:
    """Log to a file, and show a sentence for whatever nobody caught."""
    try:
        file = state_folder() / log_file().name
        if file.exists() and file.stat().st_size > LOG_SIZE:
            file.replace(file.with_suffix(".old.log"))
        handler = logging.FileHandler(file, delay=True, encoding="utf-8")
    except OSError:
        return  # a read-only home: the program works without a log
    handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(message)s"))
    log.addHandler(handler)
    log.setLevel(logging.INFO)
    sys.excepthook = caught
    qInstallMessageHandler(_qt_message)


def uninstall() -> None:
    """Let errors and messages of Qt go where they went before."""
    sys.excepthook = sys.__excepthook__
    qInstallMessageHandler(None)
    for handler in tuple(log.handlers):
        log.removeHandler(handler)
        handler.close()


def caught(kind: type[BaseException], error: BaseException, trace: TracebackType | None) -> None:
    """Log an error that nobody caught, and say so in a dialog."""
    if issubclass(kind, KeyboardInterrupt):
        QApplication.quit()
        return
    details = "".join(traceback.format_exception(kind, error, trace))
    log.error("not caught:\n%s", details)
    if QApplication.instance() is not None:
        # Not from here: the error may have come up in the midst of painting.
        QTimer.singleShot(0, lambda: show_internal(details))


def show_internal(details: str) -> None:
    """One dialog at a time, however many errors come in."""
    global _showing
    if _showing:
        return
    _showing = True
    try:
        box = message(QApplication.activeWindow(), SENTENCE, details)
        box.setInformativeText(f"The details are in {log_file()}.")
        box.exec()
    finally:
        _showing = False


def message(parent: QWidget | None, sentence: str, details: str = "") -> QMessageBox:
    """A dialog with one sentence, and details behind a button if there are any."""
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Warning)
    box.setWindowTitle("PlusEdit")
    box.setText(sentence)
    if details:
        box.setDetailedText(details)
    return box


def _qt_message(kind: QtMsgType, context: QMessageLogContext, text: str) -> None:
    log.log(LEVELS.get(kind, logging.INFO), "Qt: %s", text)
