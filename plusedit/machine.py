"""What the machine has for windows: a display, and the libraries that Qt loads. No Qt here."""

import os
import sys
from collections.abc import Iterable
from pathlib import Path

# By the name the loader knows: the Debian and Ubuntu packages, the newer name first.
QT = {
    "libEGL.so.1": "libegl1",
    "libGL.so.1": "libgl1",
    "libdbus-1.so.3": "libdbus-1-3",
    "libfontconfig.so.1": "libfontconfig1",
    "libfreetype.so.6": "libfreetype6",
    "libglib-2.0.so.0": "libglib2.0-0",
    "libxkbcommon.so.0": "libxkbcommon0",
}
X11 = {
    "libX11.so.6": "libx11-6",
    "libX11-xcb.so.1": "libx11-xcb1",
    "libxcb.so.1": "libxcb1",
    "libxcb-cursor.so.0": "libxcb-cursor0",
    "libxcb-glx.so.0": "libxcb-glx0",
    "libxcb-icccm.so.4": "libxcb-icccm4",
    "libxcb-image.so.0": "libxcb-image0",
    "libxcb-keysyms.so.1": "libxcb-keysyms1",
    "libxcb-randr.so.0": "libxcb-randr0",
    "libxcb-render.so.0": "libxcb-render0",
    "libxcb-render-util.so.0": "libxcb-render-util0",
    "libxcb-shape.so.0": "libxcb-shape0",
    "libxcb-shm.so.0": "libxcb-shm0",
    "libxcb-sync.so.1": "libxcb-sync1",
    "libxcb-util.so.1": "libxcb-util1",
    "libxcb-xfixes.so.0": "libxcb-xfixes0",
    "libxcb-xkb.so.1": "libxcb-xkb1",
    "libxkbcommon-x11.so.0": "libxkbcommon-x11-0",
}
WAYLAND = {
    "libwayland-client.so.0": "libwayland-client0",
    "libwayland-cursor.so.0": "libwayland-cursor0",
    "libwayland-egl.so.1": "libwayland-egl1",
}


def is_linux() -> bool:
    """Whether windows need an X or Wayland display here, and libraries of the system."""
    return sys.platform.startswith(("linux", "freebsd"))


def display() -> str | None:
    """What windows would be shown on, in words; None if there is nothing."""
    if platform := os.environ.get("QT_QPA_PLATFORM"):
        return f"Qt platform {platform} (from QT_QPA_PLATFORM)"
    if not is_linux():
        return "the desktop"
    for variable in ("WAYLAND_DISPLAY", "DISPLAY"):
        if value := os.environ.get(variable):
            return f"{variable}={value}"
    return None


def needed_libraries() -> dict[str, str]:
    """The libraries for windows on the display there is, or on X: library to package."""
    if not is_linux():
        return {}
    platform = os.environ.get("QT_QPA_PLATFORM", "").partition(":")[0]
    if platform and platform not in ("xcb", "wayland"):
        return QT
    on_wayland = platform == "wayland" or (not platform and "WAYLAND_DISPLAY" in os.environ)
    return {**QT, **(WAYLAND if on_wayland else X11)}


def missing(libraries: Iterable[str]) -> list[str]:
    """Those of the libraries that can't be loaded."""
    return [name for name in libraries if not _loads(name)]


def install_command(packages: Iterable[str]) -> str:
    """What installs packages on Debian and Ubuntu."""
    return f"sudo apt-get install {' '.join(packages)}"


def log_file() -> Path:
    """Where errors that nobody expected are written down."""
    if given := os.environ.get("XDG_STATE_HOME"):
        return Path(given) / "plusedit" / "plusedit.log"
    if os.name == "nt":
        return Path(os.environ.get("LOCALAPPDATA", Path.home())) / "plusedit" / "plusedit.log"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "plusedit" / "plusedit.log"
    return Path.home() / ".local" / "state" / "plusedit" / "plusedit.log"


def _loads(name: str) -> bool:
    import ctypes  # 10 ms that most commands can do without

    try:
        ctypes.CDLL(name)
    except OSError:
        return False
    return True
