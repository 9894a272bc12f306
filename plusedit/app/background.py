"""Long work off the window's thread: the window stays alive, shows progress, and can cancel."""

import gc
from collections.abc import Callable
from concurrent.futures import Future
from threading import Thread
from typing import TypeVar

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QProgressDialog, QPushButton, QWidget

T = TypeVar("T")

GLANCE = 5  # milliseconds between looks whether the work is done
QUICK = 0.05  # seconds: what is done by then needs no event loop
SHOWN_AFTER = 250  # milliseconds until there is a dialog


class CancelledError(Exception):
    """The person gave up waiting."""


def in_background(
    parent: QWidget, text: str, work: Callable[[], T], *, can_cancel: bool = True
) -> T:
    """What `work` returns or raises, done in a thread; CancelledError if the person gave up.

    A dialog appears where it takes longer than a moment. Work that was given up runs to its end
    unheeded, so what can be cancelled must have no effect but its result.
    """
    future: Future[T] = Future()
    # The collector runs in whatever thread allocates, and would there free widgets that only the
    # window's thread may free.
    gc.disable()
    # A daemon: work that was given up must not keep the program from ending.
    Thread(target=_do, args=(work, future), name="work", daemon=True).start()
    try:
        return future.result(timeout=QUICK)
    except TimeoutError:
        if future.done():
            return future.result()  # the work itself ran into a time limit
    _wait(parent, text, future, can_cancel=can_cancel)
    return future.result()


def _do(work: Callable[[], T], future: "Future[T]") -> None:
    try:
        future.set_result(work())
    except BaseException as error:
        future.set_exception(error)
    finally:
        gc.enable()


def _wait(parent: QWidget, text: str, future: "Future[T]", *, can_cancel: bool) -> None:
    dialog = QProgressDialog(text, "Cancel", 0, 0, parent)
    dialog.setWindowTitle("PlusEdit")
    dialog.setWindowModality(Qt.WindowModality.WindowModal)
    dialog.setMinimumDuration(SHOWN_AFTER)
    loop = QEventLoop()
    timer = QTimer()
    timer.timeout.connect(lambda: loop.quit() if future.done() else dialog.setValue(0))
    if can_cancel:
        dialog.canceled.connect(loop.quit)
    else:
        for button in dialog.findChildren(QPushButton):
            button.hide()
    timer.start(GLANCE)
    while not future.done():
        loop.exec()
        if can_cancel and dialog.wasCanceled():
            break
    timer.stop()
    dialog.close()
    dialog.deleteLater()
    if not future.done():
        raise CancelledError
