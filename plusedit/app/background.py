"""Long work off the window's thread: the window stays alive, shows progress, and can cancel."""

from collections.abc import Callable
from threading import Thread
from typing import Generic, TypeVar

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QProgressDialog, QPushButton, QWidget

from plusedit.views.workers import start_worker

T = TypeVar("T")

GLANCE = 5  # milliseconds between looks whether the work is done
QUICK = 0.05  # seconds: what is done by then needs no event loop
STEPS = 1000  # of a bar of progress
WIDTH = 360  # logical pixels: words of different lengths don't move its sides
SHOWN_AFTER = 250  # milliseconds until there is a dialog


class CancelledError(Exception):
    """The person gave up waiting."""


class Progress:
    """How far work has come: told in its thread, shown in the window's."""

    def __init__(self) -> None:
        self.share, self.words = 0.0, ""
        self.is_cancelled = False

    def tell(self, share: float, words: str) -> None:
        """So much is done, from 0 to 1, and that comes next; CancelledError if that is in vain."""
        if self.is_cancelled:
            raise CancelledError
        self.share, self.words = share, words


def in_background(
    parent: QWidget,
    text: str,
    work: Callable[[], T],
    *,
    can_cancel: bool = True,
    progress: Progress | None = None,
) -> T:
    """What `work` returns or raises, done in a thread; CancelledError if the person gave up.

    A dialog appears where it takes longer than a moment. Work that was given up runs to its end
    unheeded, so what can be cancelled must have no effect but its result; work that tells its
    `progress` ends as it does so next.
    """
    job = _Job(work)
    # A daemon: work that was given up must not keep the program from ending.
    thread = start_worker(job.do, "work", daemon=True)
    thread.join(QUICK)
    if thread.is_alive():
        try:
            _wait(parent, text, thread, progress, can_cancel=can_cancel)
        except CancelledError:
            if progress is not None:
                progress.is_cancelled = True
            raise
    return job.outcome()


class _Job(Generic[T]):
    """Work, and what came of it."""

    def __init__(self, work: Callable[[], T]) -> None:
        self._work = work
        self._results: list[T] = []
        self._error: BaseException | None = None

    def outcome(self) -> T:
        """What the work, which is done, returned or raised."""
        if self._error is not None:
            raise self._error
        return self._results[0]

    def do(self) -> None:
        """Do the work; whatever it raises waits for `outcome`."""
        try:
            self._results.append(self._work())
        except BaseException as error:
            self._error = error


def _wait(
    parent: QWidget, text: str, work: Thread, progress: Progress | None, *, can_cancel: bool
) -> None:
    dialog = QProgressDialog(text, "Cancel", 0, 0 if progress is None else STEPS, parent)
    dialog.setAutoReset(False)
    dialog.setMinimumWidth(WIDTH)
    dialog.setWindowTitle("PlusEdit")
    dialog.setWindowModality(Qt.WindowModality.WindowModal)
    dialog.setMinimumDuration(SHOWN_AFTER)
    loop = QEventLoop()
    timer = QTimer()

    def glance() -> None:
        if not work.is_alive():
            loop.quit()
        elif progress is None:
            dialog.setValue(0)
        else:
            dialog.setLabelText(f"{text}\n{progress.words}")
            dialog.setValue(round(progress.share * (STEPS - 1)))

    timer.timeout.connect(glance)
    if can_cancel:
        dialog.canceled.connect(loop.quit)
    else:
        for button in dialog.findChildren(QPushButton):
            button.hide()
    timer.start(GLANCE)
    while work.is_alive():
        loop.exec()
        if can_cancel and dialog.wasCanceled():
            break
    timer.stop()
    dialog.close()
    dialog.deleteLater()
    if work.is_alive():
        raise CancelledError
