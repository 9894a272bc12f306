"""Long work off the window's thread: the window stays alive, shows progress, and can cancel."""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from typing import TypeVar

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QProgressDialog, QWidget

T = TypeVar("T")

GLANCE = 5  # milliseconds between looks whether the work is done
QUICK = 0.05  # seconds: what is done by then needs no event loop


class CancelledError(Exception):
    """The person gave up waiting."""


def in_background(parent: QWidget, text: str, work: Callable[[], T]) -> T:
    """What `work` returns or raises, done in a thread; CancelledError if the person gave up.

    A dialog appears where it takes longer than a moment. Work that was given up runs to its end
    unheeded, so it must have no effect but its result.
    """
    pool = ThreadPoolExecutor(max_workers=1, thread_name_prefix="work")
    future = pool.submit(work)
    pool.shutdown(wait=False)
    try:
        return future.result(timeout=QUICK)
    except TimeoutError:
        if future.done():
            return future.result()  # the work itself ran into a time limit
    _wait(parent, text, future)
    return future.result()


def _wait(parent: QWidget, text: str, future: "Future[T]") -> None:
    dialog = QProgressDialog(text, "Cancel", 0, 0, parent)
    dialog.setWindowTitle("PlusEdit")
    dialog.setWindowModality(Qt.WindowModality.WindowModal)
    dialog.setMinimumDuration(250)
    loop = QEventLoop()
    timer = QTimer()
    timer.timeout.connect(lambda: loop.quit() if future.done() else dialog.setValue(0))
    dialog.canceled.connect(loop.quit)
    timer.start(GLANCE)
    loop.exec()
    timer.stop()
    was_cancelled = dialog.wasCanceled() and not future.done()
    dialog.close()
    dialog.deleteLater()
    if was_cancelled:
        raise CancelledError
