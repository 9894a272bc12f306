"""Fits of many curves or surfaces, one after the other, beside the window's thread."""

from collections.abc import Callable, Iterator
from threading import Thread

from PySide6.QtCore import QObject, QTimer

from plusedit.events import Event
from plusedit.geometry.comparison import Check, Fit
from plusedit.views.workers import start_worker

GLANCE = 60  # milliseconds between looks whether there are more


class _UnwantedError(Exception):
    """Ends fits that nobody will see."""


class _Job:
    """Fits that are being made."""

    def __init__(self, fits: Callable[[Check], Iterator[Fit]], count: int) -> None:
        self._fits = fits
        self.count = count
        self.found: list[Fit] = []
        self.is_unwanted = False
        self.problem = ""
        self.thread: Thread | None = None

    def do(self) -> None:
        """In a thread."""
        try:
            for fit in self._fits(self._check):
                self.found.append(fit)
        except _UnwantedError:
            return
        except (ValueError, ArithmeticError, MemoryError) as error:
            # LinAlgError, where numbers are too large to be calculated with, is a ValueError.
            self.problem = str(error) or "The points can't be calculated with."

    def _check(self) -> None:
        if self.is_unwanted:
            raise _UnwantedError


class FitRun(QObject):
    """The fits made by now, and those still to come."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.changed: Event[()] = Event()
        """there are more of them, or no more will come"""
        self._job: _Job | None = None
        self._told = 0
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)

    @property
    def is_running(self) -> bool:
        """Whether more fits will come."""
        return self._glance.isActive()

    @property
    def fits(self) -> list[Fit]:
        """All that were made."""
        return [] if self._job is None else list(self._job.found)

    @property
    def share(self) -> float:
        """How much is done, from 0 to 1."""
        return 0.0 if self._job is None else len(self._job.found) / max(self._job.count, 1)

    @property
    def problem(self) -> str:
        """Why no more fits will come, in a sentence; empty where they were all made."""
        return "" if self._job is None else self._job.problem

    def begin(self, fits: Callable[[Check], Iterator[Fit]], count: int) -> None:
        """Make so many fits, in place of any others; they may end at each call of the check."""
        self.cancel()
        self._job, self._told = _Job(fits, count), 0
        self._job.thread = start_worker(self._job.do, "fits", daemon=True)
        self._glance.start()
        self.changed.emit()

    def cancel(self) -> None:
        """Make no more; those that were made stay."""
        if self._job is not None:
            self._job.is_unwanted = True
        if self._glance.isActive():
            self._glance.stop()
            self.changed.emit()

    def _look(self) -> None:
        job = self._job
        if job is None or job.thread is None:
            return
        is_done = not job.thread.is_alive()
        if is_done:
            self._glance.stop()
        if is_done or len(job.found) > self._told:
            self._told = len(job.found)
            self.changed.emit()
