"""Work beside the window's thread of which only the newest is wanted.

While something moves, wishes come faster than they are fulfilled: one is worked on, the newest one
waits, and what was wished for between is never begun.
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Thread
from typing import Any

from PySide6.QtCore import QObject, QTimer

from plusedit.views.workers import start_worker

GLANCE = 4  # milliseconds between looks whether the work is done


@dataclass(eq=False)
class _Wish:
    work: Callable[[], Any]
    take: Callable[[Any], None]
    found: list[Any] = field(default_factory=list)
    errors: list[Exception] = field(default_factory=list)

    def do(self) -> None:
        """In a thread."""
        try:
            self.found.append(self.work())
        except Exception as error:  # raised again in the window's thread
            self.errors.append(error)


class Newest(QObject):
    """Has one piece of work done at a time."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._at_work: _Wish | None = None
        self._waiting: _Wish | None = None
        self._thread: Thread | None = None
        self._glance = QTimer(self, interval=GLANCE)
        self._glance.timeout.connect(self._look)

    @property
    def is_busy(self) -> bool:
        """Whether something is being worked on."""
        return self._at_work is not None

    def ask(self, work: Callable[[], Any], take: Callable[[Any], None]) -> None:
        """Do `work` in a thread and hand what it returns to `take`, in the window's thread.

        In place of what waits to be begun. What it raises is raised in the window's thread.
        """
        self._waiting = _Wish(work, take)
        self._begin()

    def forget(self) -> None:
        """Begin nothing that waits, and take nothing that is being worked on."""
        self._waiting = None
        if self._at_work is not None:
            self._at_work.take = _leave

    def _begin(self) -> None:
        if self._at_work is None and self._waiting is not None:
            self._at_work, self._waiting = self._waiting, None
            self._thread = start_worker(self._at_work.do, "newest", daemon=True)
            self._glance.start()

    def _look(self) -> None:
        wish = self._at_work
        if wish is None or self._thread is None or self._thread.is_alive():
            return
        self._at_work = self._thread = None
        self._glance.stop()
        self._begin()
        if wish.errors:
            raise wish.errors[0]
        wish.take(wish.found[0])


def _leave(found: object) -> None:
    """What came of it is not wanted any more."""
