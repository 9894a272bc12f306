"""`python -m plusedit`, `plusedit` and `plusedit-gui`: finds the command and runs it.

Nothing heavy is imported here or by building the parsers: commands import what they need once
they run. A person sees sentences; what nobody expected goes to a log file.
"""

import argparse
import contextlib
import importlib
import os
import pkgutil
import sys
import time
import traceback
from typing import NoReturn, Protocol, cast

import plusedit.cli
from plusedit import __version__
from plusedit.machine import log_file

WRONG, UNEXPECTED, INTERRUPTED = 2, 70, 130  # exit codes


class Command(Protocol):
    """A module on the shelf `plusedit.cli`."""

    NAME: str
    HELP: str

    def add_arguments(self, parser: argparse.ArgumentParser) -> None:
        """Say what the command takes."""

    def run(self, arguments: argparse.Namespace) -> int:
        """Do it; the exit code. FormatError and OSError become one line on standard error."""
        ...


class Parser(argparse.ArgumentParser):
    """Complains in one line."""

    def error(self, message: str) -> NoReturn:
        self.exit(WRONG, f"{self.prog}: {message}; see {self.prog} --help\n")


def main(argv: list[str] | None = None) -> int:
    """Run a command line, without the program's name; the exit code."""
    words = sys.argv[1:] if argv is None else argv
    # Read by numpy when it is first imported. Our products are small: waking threads for one can
    # take fifty times as long as the product, and a drag makes several for every frame.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    _open_closed_streams()
    try:
        try:
            code = _run(words)
        finally:
            sys.stdout.flush()
    except KeyboardInterrupt:
        return INTERRUPTED
    except BrokenPipeError:
        # Whoever read has enough; what is still buffered must not fail once more at the end.
        with contextlib.suppress(OSError, ValueError):
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except OSError as error:
        return _complain(f"plusedit: {error.strerror or error}".rstrip("."))
    except MemoryError:
        return _complain("plusedit: that takes more memory than there is")
    except Exception as error:
        return _unexpected(error)
    return code


def main_window() -> int:
    """What starts without a terminal: the window, which shows itself what is wrong with files."""
    return main(["open", "--window-tells", *sys.argv[1:]])


def commands() -> dict[str, Command]:
    """The commands by name."""
    names = [module.name for module in pkgutil.iter_modules(plusedit.cli.__path__)]
    modules = [cast(Command, importlib.import_module(f"plusedit.cli.{name}")) for name in names]
    return {module.NAME: module for module in modules}


def parser(known: dict[str, Command]) -> Parser:
    """What understands the whole command line."""
    top = Parser(
        prog="plusedit",
        usage="plusedit [FILE ...]\n       plusedit COMMAND [ARGUMENTS]",
        description="An editor for plus curves. Without a command: opens files in the editor.",
        epilog="plusedit COMMAND --help tells more about a command.",
    )
    top.add_argument("--version", action="version", version=f"PlusEdit {__version__}")
    below = top.add_subparsers(title="commands", metavar="COMMAND", required=True, prog="plusedit")
    for name, command in known.items():
        sub = below.add_parser(name, help=command.HELP, description=_sentence(command.HELP))
        command.add_arguments(sub)
        sub.set_defaults(run=command.run)
    return top


def _sentence(words: str) -> str:
    return f"{words[:1].upper()}{words[1:]}."


def _run(words: list[str]) -> int:
    known = commands()
    if not words or words[0] not in {*known, "-h", "--help", "--version"}:
        words = ["open", *words]
    try:
        arguments = parser(known).parse_args(words)
    except SystemExit as end:
        return end.code if isinstance(end.code, int) else 0
    try:
        return int(arguments.run(arguments))
    except ValueError as error:
        if not _is_told(error):
            raise
        return _complain(str(error))


def _is_told(error: ValueError) -> bool:
    """Whether it was raised for a person to read: about a file, or about an edit."""
    from plusedit.document.design import EditError
    from plusedit.io.formats import FormatError

    return isinstance(error, FormatError | EditError)


def _complain(sentence: str) -> int:
    with contextlib.suppress(OSError):
        print(" ".join(sentence.splitlines()), file=sys.stderr)
    return WRONG


def _unexpected(error: Exception) -> int:
    """Write an error down where it can be sent from, and say so."""
    place = log_file()
    try:
        place.parent.mkdir(parents=True, exist_ok=True)
        with place.open("a", encoding="utf-8", errors="backslashreplace") as log:
            log.write(f"{time.strftime('%Y-%m-%d %H:%M:%S')} ERROR {sys.argv!r}\n")
            log.writelines(traceback.format_exception(error))
        where = f"the details are in {place}"
    except OSError:
        where = f"{type(error).__name__}: {error}"
    _complain(f"plusedit: something went wrong inside; {where}")
    return UNEXPECTED


def _open_closed_streams() -> None:
    """Let what nobody listens to go nowhere: started by `>&-`, or without a terminal.

    Otherwise the next file to be written would get the number of the closed stream, and with it
    whatever a library says there.
    """
    for name, mode in {"stdin": "r", "stdout": "w", "stderr": "w"}.items():
        if getattr(sys, name) is None:
            setattr(sys, name, os.fdopen(os.open(os.devnull, os.O_RDWR), mode, encoding="utf-8"))


if __name__ == "__main__":
    sys.exit(main())
