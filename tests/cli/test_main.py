"""The command line as a whole: which command runs, and what a person sees of errors."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

from plusedit import __main__ as command_line
from plusedit import __version__
from plusedit.io.formats import FormatError

COMMANDS = command_line.commands()


@pytest.fixture
def opened(monkeypatch):
    """The files that would be opened in the editor, instead of opening them."""
    calls = []

    def run(arguments):
        calls.append(arguments.files)
        return 0

    monkeypatch.setattr(COMMANDS["open"], "run", run)
    return calls


def run_that(monkeypatch, error):
    """Make a command fail in that way."""

    def fail(_arguments):
        raise error

    monkeypatch.setattr(COMMANDS["schema"], "run", fail)
    return command_line.main(["schema"])


def test_without_a_command_files_are_opened(opened):
    for words in ([], ["bow.json"], ["open", "bow.json"], ["a.json", "b.svg"]):
        assert command_line.main(words) == 0
    assert opened == [[], ["bow.json"], ["bow.json"], ["a.json", "b.svg"]]


def test_a_file_named_like_a_command_can_be_opened(opened):
    command_line.main(["open", "sample"])
    command_line.main(["--", "-strange.json"])
    assert opened == [["sample"], ["-strange.json"]]


def test_the_version_is_told(capsys):
    assert command_line.main(["--version"]) == 0
    assert capsys.readouterr().out == f"PlusEdit {__version__}\n"


def test_there_is_help_for_all(capsys):
    assert command_line.main(["--help"]) == 0
    help_of_all = capsys.readouterr().out
    for name, command in COMMANDS.items():
        assert command.HELP[:20] in help_of_all
        assert command_line.main([name, "--help"]) == 0
        assert f"usage: plusedit {name} " in capsys.readouterr().out


@pytest.mark.parametrize(
    "words", [["--bogus"], ["sample"], ["sample", "a", "--count", "x"], ["schema", "more"]]
)
def test_wrong_arguments_are_told_in_one_line(words, capsys):
    assert command_line.main(words) == 2
    out, complaint = capsys.readouterr()
    assert out == ""
    assert complaint.count("\n") == 1
    assert complaint.startswith("plusedit")


def test_a_format_error_is_one_line_and_code_2(monkeypatch, capsys):
    assert run_that(monkeypatch, FormatError("bow.json: is\nempty")) == 2
    assert capsys.readouterr().err == "bow.json: is empty\n"


def test_an_error_of_the_system_is_one_line_and_code_2(monkeypatch, capsys):
    assert run_that(monkeypatch, OSError(28, "No space left on device")) == 2
    assert capsys.readouterr().err == "plusedit: No space left on device\n"


def test_too_little_memory_is_one_line_and_code_2(monkeypatch, capsys):
    assert run_that(monkeypatch, MemoryError()) == 2
    assert capsys.readouterr().err == "plusedit: that takes more memory than there is\n"


def test_an_interruption_is_quiet(monkeypatch, capsys):
    assert run_that(monkeypatch, KeyboardInterrupt()) == 130
    assert capsys.readouterr().err == ""


@pytest.mark.parametrize("error", [ValueError("bug"), RecursionError(), KeyError(1)])
def test_what_nobody_expected_goes_to_a_log(monkeypatch, capsys, tmp_path, error):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(command_line, "log_file", lambda: tmp_path / "state" / "plusedit.log")
    assert run_that(monkeypatch, error) == 70
    complaint = capsys.readouterr().err
    assert complaint.count("\n") == 1
    assert "plusedit.log" in complaint
    assert type(error).__name__ in (tmp_path / "state" / "plusedit.log").read_text()


def test_without_a_place_for_a_log_the_error_itself_is_told(monkeypatch, capsys, tmp_path):
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setattr(command_line, "log_file", lambda: tmp_path / "file" / "plusedit.log")
    assert run_that(monkeypatch, ValueError("bug")) == 70
    assert capsys.readouterr().err.endswith("ValueError: bug\n")


@pytest.mark.skipif(os.name != "posix", reason="pipes of Unix")
def test_a_reader_that_has_enough_is_no_error():
    done = subprocess.run(
        f"'{sys.executable}' -m plusedit schema | head -c 1",
        shell=True,
        capture_output=True,
        text=True,
    )
    assert (done.stdout, done.stderr) == ("{", "")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="a disk that is full")
def test_a_full_disk_behind_standard_output_is_told(document):
    with Path("/dev/full").open("wb") as full:
        done = subprocess.run(
            [sys.executable, "-m", "plusedit", "sample", str(document)],
            stdout=full,
            stderr=subprocess.PIPE,
            text=True,
        )
    assert done.returncode == 2
    assert done.stderr.splitlines()[-1] == "plusedit: No space left on device"
    assert "Traceback" not in done.stderr


@pytest.mark.skipif(os.name != "posix", reason="shells of Unix")
def test_complaints_do_not_go_among_the_output_when_nobody_hears_them(document):
    out = document.with_name("out.obj")
    command = f"'{sys.executable}' -m plusedit export '{document}' '{out}'"
    heard = subprocess.run(command, shell=True, capture_output=True, check=True)
    unheard = subprocess.run(f"{command} 2>&-", shell=True, capture_output=True, check=True)
    assert heard.stderr
    assert unheard.stdout == heard.stdout


@pytest.mark.skipif(os.name != "posix", reason="shells of Unix")
@pytest.mark.parametrize(("words", "code"), [("schema", 0), ("--version", 0), ("sample gone", 2)])
def test_closed_streams_change_no_exit_code(words, code):
    command = f"'{sys.executable}' -m plusedit {words} <&- >&- 2>&-"
    assert subprocess.run(command, shell=True, check=False).returncode == code
