"""Designs kept safe: every design with unsaved changes is written to the state directory.

One file for each running program, with a lock beside it that dies with the program. What has no
living owner was left by a crash; the next start takes the lock over and offers the design.
"""

import json
import os
import time
import uuid
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from threading import Thread

from PySide6.QtCore import QLockFile, QObject, QTimer

from plusedit.app.errors import log
from plusedit.app.settings import state_folder
from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.io.formats import FormatError
from plusedit.views.workers import start_worker

AT_MOST = 30_000  # milliseconds from an edit until it is kept safe
IDLE = 3_000  # milliseconds without an edit after which it is kept safe at once
SUFFIX = ".autosave"


def folder() -> Path:
    """Where autosaved designs lie."""
    place = state_folder() / "autosave"
    place.mkdir(parents=True, exist_ok=True)
    return place


class Autosave(QObject):
    """Writes the design of a session soon after each edit, and takes the file away when saved."""

    def __init__(
        self, session: Session, path_of_design: Callable[[], Path | None], place: Path | None = None
    ) -> None:
        super().__init__()
        self._session, self._path_of_design = session, path_of_design
        stem = f"{os.getpid()}-{uuid.uuid4().hex[:8]}"
        self.file = (place or folder()) / f"{stem}{SUFFIX}"
        self._lock = lock_of(self.file)
        self._lock.tryLock(0)
        self._kept: Design | None = None
        self._writing: Thread | None = None
        self._idle = self._timer(IDLE)
        self._at_most = self._timer(AT_MOST)
        session.stepped.listen(self._stepped)

    def keep(self) -> None:
        """Write the design now if it has changes that are neither saved nor kept."""
        self.begin()
        self.finish()

    def begin(self) -> None:
        """The same beside the work, which a large design would hold up."""
        self._idle.stop()
        self._at_most.stop()
        design = self._session.committed
        if self._session.is_saved or design is self._kept:
            return
        self.finish()
        self._kept = design
        path = self._path_of_design()
        self._writing = start_worker(lambda: _write_or_log(self.file, design, path), "autosave")

    def finish(self) -> None:
        """Wait for what is being written."""
        if self._writing is not None:
            self._writing.join()
            self._writing = None

    def close(self) -> None:
        """The program ends as it should: nothing is left behind."""
        self._idle.stop()
        self._at_most.stop()
        self._remove()
        self._lock.unlock()

    def _stepped(self) -> None:
        if self._session.is_saved:
            self._idle.stop()
            self._at_most.stop()
            self._remove()
        elif self._session.committed is not self._kept:
            self._idle.start()
            if not self._at_most.isActive():
                self._at_most.start()

    def _remove(self) -> None:
        self.finish()
        self._kept = None
        self.file.unlink(missing_ok=True)

    def _timer(self, pause: int) -> QTimer:
        timer = QTimer(self)
        timer.setSingleShot(True)
        timer.setInterval(pause)
        timer.timeout.connect(self.begin)
        return timer


def lock_of(file: Path) -> QLockFile:
    """The lock of an autosaved design; it is stale when its owner has died, never by age."""
    lock = QLockFile(f"{file}.lock")
    lock.setStaleLockTime(0)
    return lock


def write(file: Path, design: Design, path: Path | None) -> None:
    """Write a design with where it came from, whole or not at all."""
    from plusedit.io.formats.json_document import dumps

    head = {"path": None if path is None else str(path), "time": time.time()}
    part = file.with_name(f"{file.name}.part")
    with part.open("wb") as stream:
        stream.write(json.dumps(head).encode() + b"\n" + dumps(design))
        stream.flush()
        os.fsync(stream.fileno())
    part.replace(file)


def _write_or_log(file: Path, design: Design, path: Path | None) -> None:
    try:
        write(file, design, path)
    except (OSError, FormatError) as error:
        log.warning("autosave: %s", error)


@dataclass(eq=False)
class Left:
    """A design that a crashed program left behind; its lock is ours."""

    file: Path
    path: Path | None
    """of the design it was opened from or saved to"""
    time: float
    """when it was kept, in seconds since 1970"""
    design: Design
    lock: QLockFile

    def remove(self) -> None:
        """It was recovered, or is not wanted."""
        self.file.unlink(missing_ok=True)
        self.lock.unlock()

    def leave(self) -> None:
        """Let the next start offer it again."""
        self.lock.unlock()


def has_left_behind(place: Path | None = None) -> bool:
    """Whether there are autosaved designs at all, of living or of crashed programs: quick."""
    return any((place or folder()).glob(f"*{SUFFIX}"))


def left_behind(place: Path | None = None) -> list[Left]:
    """The designs that crashed programs left, the latest first; those of living ones are not."""
    found = []
    for file in sorted((place or folder()).glob(f"*{SUFFIX}")):
        lock = lock_of(file)
        if not lock.tryLock(0):
            continue
        try:
            found.append(_read(file, lock))
        except (OSError, ValueError, TypeError, AttributeError) as error:
            log.warning("recovery: %s can't be read: %s", file.name, error)
            lock.unlock()
    _sweep(place or folder())
    return sorted(found, key=lambda left: -left.time)


def _sweep(place: Path) -> None:
    """Take away the locks of programs that died with nothing unsaved."""
    for file in place.glob(f"*{SUFFIX}.lock"):
        kept = file.with_suffix("")
        lock = lock_of(kept)
        if not kept.exists() and lock.tryLock(0):
            lock.unlock()


def _read(file: Path, lock: QLockFile) -> Left:
    from plusedit.io.formats.json_document import loads

    first, _, document = file.read_bytes().partition(b"\n")
    head = json.loads(first)
    path = head["path"] if isinstance(head, dict) else None
    design = loads(document, file.name).design
    kept = head.get("time")
    at = float(kept) if isinstance(kept, int | float) else file.stat().st_mtime
    return Left(file, Path(path) if isinstance(path, str) else None, at, design, lock)
