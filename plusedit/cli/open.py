"""`plusedit open`: the editor."""

import argparse
import sys
from pathlib import Path

from plusedit.machine import display, install_command, missing, needed_libraries

NAME = "open"
HELP = "open files in the editor"

NO_DISPLAY = (
    "there is no display to open a window on; plusedit render DESIGN OUT.png makes a picture "
    "without one"
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("files", metavar="FILE", nargs="*", help="designs, SVG files or meshes")
    # Where there is no terminal, a file that can't be read is told in the window.
    parser.add_argument("--window-tells", action="store_true", help=argparse.SUPPRESS)


def run(arguments: argparse.Namespace) -> int:
    if not arguments.window_tells:
        _check(arguments.files)
    if trouble := _no_window():
        print(f"plusedit: {trouble}", file=sys.stderr)
        return 2
    from plusedit.app.main import run as run_editor

    return run_editor(arguments.files)


def _check(files: list[str]) -> None:
    """FormatError if a file can't be read, while there is a terminal to say so on."""
    if files:
        from plusedit.io.files import load, read_file
        from plusedit.io.opening import is_mesh

        for file in files:
            # A mesh takes its time: the window reads it, shows how far it is, and can give up.
            if is_mesh(Path(file)):
                read_file(Path(file))
            else:
                load(file)


def _no_window() -> str | None:
    """Why no window can be opened, in one sentence with what helps; None if it can."""
    if display() is None:
        return NO_DISPLAY
    libraries = needed_libraries()
    if gone := missing(libraries):
        command = install_command(libraries[name] for name in gone)
        return f"windows need {', '.join(gone)}; on Debian and Ubuntu: {command}"
    return None
