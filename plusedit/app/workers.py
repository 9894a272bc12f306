"""Threads beside the window's, during which Python's cyclic collector rests.

The collector runs in whatever thread happens to allocate, and would there free widgets that only
the window's thread may free.
"""

import gc
from collections.abc import Callable
from threading import Lock, Thread

_lock = Lock()
_at_work = 0


def start_worker(work: Callable[[], object], name: str, *, daemon: bool = False) -> Thread:
    """Do `work` in a thread; the collector rests until the last such thread has ended.

    The program waits at its end for a thread that is no daemon.
    """

    def do() -> None:
        try:
            work()
        finally:
            _count(-1)

    _count(1)
    thread = Thread(target=do, name=name, daemon=daemon)
    thread.start()
    return thread


def _count(by: int) -> None:
    global _at_work
    with _lock:
        _at_work += by
        if _at_work:
            gc.disable()
        else:
            gc.enable()
