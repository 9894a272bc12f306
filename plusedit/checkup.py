"""The doctor's examination: Python, packages, libraries, display, OpenGL.

Qt is tried in a process of its own: a library that is missing there ends that process, not this.
"""

import json
import os
import platform
import signal
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

from plusedit.machine import display, install_command, missing, needed_libraries

OLDEST_PYTHON = (3, 11)
PACKAGES = {
    "numpy": "numpy >=1.26, <3",
    "PySide6-Essentials": "PySide6-Essentials >=6.8, !=6.11.0, !=6.11.1, <6.12",
    "svgelements": "svgelements >=1.9.6, <2",
    "pyqtgraph": "pyqtgraph >=0.14, <0.15",
    "PyOpenGL": "PyOpenGL >=3.1.7, <4",
    "numba": "numba >=0.61, <1",
}
DRIVERS = ("libegl-mesa0", "libglx-mesa0", "libgl1-mesa-dri")
PATIENCE = 60  # seconds; the first start of Qt on a cold disk takes several

QT = """
import json
from pathlib import Path
import PySide6
from PySide6.QtCore import QLibraryInfo, qVersion
from PySide6 import QtGui, QtWidgets
folder = Path(QLibraryInfo.path(QLibraryInfo.LibraryPath.PluginsPath)) / "platforms"
names = sorted(file.stem.removeprefix("lib").removeprefix("q") for file in folder.glob("*q*"))
print(json.dumps({"version": qVersion(), "platforms": names}))
"""
OPENGL = """
import json
from PySide6.QtGui import QGuiApplication, QOffscreenSurface, QOpenGLContext
app = QGuiApplication([])
surface, context = QOffscreenSurface(), QOpenGLContext()
surface.create()
made = context.create() and context.makeCurrent(surface)
words = [context.functions().glGetString(code) for code in (0x1F02, 0x1F01)] if made else []
print(json.dumps({"platform": QGuiApplication.platformName(), "opengl": words}))
"""
PICTURES = """
import json
from plusedit.views.gl.egl import context_without_display
from plusedit.views.gl.functions import RENDERER, VERSION
with context_without_display() as gl:
    print(json.dumps({"platform": "no display", "opengl": [gl.text(VERSION), gl.text(RENDERER)]}))
"""
SCREENLESS = ("offscreen", "minimal", "vnc", "linuxfb")


@dataclass(frozen=True)
class Finding:
    """One line of the report."""

    title: str
    text: str
    remedy: str | None = None
    """what to do about it; None if all is well"""


@dataclass(frozen=True)
class Trial:
    """How a small program went."""

    answer: dict[str, object] | None
    """what it said; None if it failed"""
    why: str = ""
    """why it failed, in a few words"""


def findings() -> Iterator[Finding]:
    """Everything that matters, in the order in which it is needed."""
    yield _python()
    yield Finding("System", platform.platform())
    packages = [_package(name) for name in PACKAGES]
    yield from packages
    yield _libraries()
    yield _display()
    if packages[1].text != "missing":
        yield _qt()
        yield _opengl()


def _python() -> Finding:
    text = f"{platform.python_version()} ({sys.executable})"
    wanted = ".".join(map(str, OLDEST_PYTHON))
    new_enough = sys.version_info >= OLDEST_PYTHON
    return Finding("Python", text, None if new_enough else f"Python {wanted} or newer is needed")


def _package(name: str) -> Finding:
    title = name.removesuffix("-Essentials")
    remedy = f"{sys.executable} -m pip install '{PACKAGES[name]}'"
    try:
        found = version(name)
    except PackageNotFoundError:
        return Finding(title, "missing", remedy)
    if name.startswith("PySide6") and not works(found):
        return Finding(title, f"{found}, which is known not to work", remedy)
    return Finding(title, found)


def works(pyside: str) -> bool:
    """Whether that version of PySide6 is one the program is made for."""
    numbers = tuple(int(part) for part in pyside.split(".")[:3] if part.isdecimal())
    return (6, 8) <= numbers < (6, 12) and numbers not in ((6, 11, 0), (6, 11, 1))


def _libraries() -> Finding:
    libraries = needed_libraries()
    gone = missing(libraries)
    if not gone:
        return Finding("Libraries", "all there")
    return Finding(
        "Libraries",
        f"missing: {', '.join(gone)}",
        install_command(libraries[name] for name in gone) + "   (Debian, Ubuntu)",
    )


def _display() -> Finding:
    found = display()
    if found is not None:
        return Finding("Display", found)
    remedy = "log in to a desktop (or ssh -X); plusedit render works without"
    return Finding("Display", "none: neither DISPLAY nor WAYLAND_DISPLAY is set", remedy)


def _qt() -> Finding:
    trial = _tried(QT)
    if trial.answer is None:
        return Finding("Qt", f"can't be loaded: {trial.why}", "install what is missing above")
    platforms = trial.answer["platforms"]
    names = ", ".join(map(str, platforms)) if isinstance(platforms, list) else "none"
    return Finding("Qt", f"{trial.answer['version']}; platforms: {names}")


def _opengl() -> Finding:
    platform = os.environ.get("QT_QPA_PLATFORM", "").partition(":")[0]
    if display() is None or platform in SCREENLESS:
        return _opengl_of(PICTURES, "for pictures of designs in space there is none")
    return _opengl_of(OPENGL, "no window could be opened")


def _opengl_of(program: str, failure: str) -> Finding:
    trial = _tried(program)
    remedy = install_command(DRIVERS) + "   (drawing in 2D needs none)"
    if trial.answer is None:
        return Finding("OpenGL", f"{failure}: {trial.why}", remedy)
    words = trial.answer["opengl"]
    if isinstance(words, list) and words:
        return Finding("OpenGL", f"{', '.join(map(str, words))} ({trial.answer['platform']})")
    return Finding("OpenGL", "no context can be made", remedy)


def _tried(program: str) -> Trial:
    """Run a small program that prints one line of JSON."""
    try:
        done = subprocess.run(
            [sys.executable, "-c", program], capture_output=True, text=True, timeout=PATIENCE
        )
    except subprocess.TimeoutExpired:
        return Trial(None, f"no answer for {PATIENCE} seconds")
    except OSError as error:
        return Trial(None, str(error))
    if done.returncode < 0:
        last = _last_line(done.stderr)
        return Trial(None, f"it crashed ({signal.Signals(-done.returncode).name}); {last}")
    try:
        return Trial(json.loads(done.stdout.splitlines()[-1]))
    except (ValueError, IndexError):
        return Trial(None, _last_line(done.stderr))


def _last_line(text: str) -> str:
    lines = [line.strip() for line in text.splitlines() if line.strip()]
    return lines[-1] if lines else "it said nothing"
