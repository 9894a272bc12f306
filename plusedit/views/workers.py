"""Threads beside the window's, during which Python's cyclic collector rests.

The collector runs in whatever thread happens to allocate, and would there free widgets that only
the window's thread may free: the program would crash. So it rests from before a worker begins
until the window's thread has seen that it ended; a worker that let it go on by itself would be
the next to allocate, and collect at once.
"""

import gc
from collections.abc import Callable
from threading import Thread

from PySide6.QtCore import QTimer

GLANCE = 20  # milliseconds between looks whether the workers have ended

_at_work: list[Thread] = []


def start_worker(work: Callable[[], object], name: str, *, daemon: bool = False) -> Thread:
    """Do `work` in a thread; to be called from the window's thread.

    The program waits at its end for a thread that is no daemon.
    """
    gc.disable()
    thread = Thread(target=work, name=name, daemon=daemon)
    thread.start()
    _at_work.append(thread)
    if len(_at_work) == 1:
        QTimer.singleShot(GLANCE, _look)
    return thread


def _look() -> None:
    """In the window's thread: let the collector go on once nobody is at work."""
    _at_work[:] = [thread for thread in _at_work if thread.is_alive()]
    if _at_work:
        QTimer.singleShot(GLANCE, _look)
    else:
        gc.enable()
