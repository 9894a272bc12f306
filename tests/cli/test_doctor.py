"""`plusedit doctor`: what is there, and what helps where something is not."""

import signal

import pytest

from plusedit import checkup
from plusedit.__main__ import main
from plusedit.checkup import findings, works


def found(title):
    [finding] = [finding for finding in findings() if finding.title == title]
    return finding


@pytest.fixture
def offscreen(monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")


@pytest.mark.usefixtures("offscreen")
def test_all_is_well_where_everything_is_there(capsys):
    assert main(["doctor"]) == 0
    report = capsys.readouterr().out
    for word in ("Python", "numpy", "PySide6", "svgelements", "platforms: ", "All is well."):
        assert word in report


@pytest.mark.usefixtures("offscreen")
def test_what_is_missing_is_marked_and_told_with_what_helps(monkeypatch, capsys):
    monkeypatch.setattr(checkup, "missing", lambda libraries: ["libGL.so.1"])
    monkeypatch.setattr(checkup, "_tried", lambda program: checkup.Trial(None, "libGL.so.1: ..."))
    assert main(["doctor"]) == 1
    report = capsys.readouterr().out
    assert "! Libraries   missing: libGL.so.1" in report
    assert "sudo apt-get install libgl1" in report
    assert "! Qt          can't be loaded: libGL.so.1: ..." in report


def test_a_missing_package_is_told_with_what_installs_it(monkeypatch):
    monkeypatch.setattr(checkup, "PACKAGES", {"nobody-has-this": "nobody-has-this >=1"})
    finding = checkup._package("nobody-has-this")
    assert finding.text == "missing"
    assert finding.remedy is not None
    assert finding.remedy.endswith("-m pip install 'nobody-has-this >=1'")


def test_without_a_display_opengl_is_tried_for_pictures(monkeypatch):
    monkeypatch.setattr(checkup, "display", lambda: None)
    monkeypatch.setattr(checkup, "OPENGL", "raise AssertionError")
    assert checkup._display().remedy is not None
    finding = checkup._opengl()
    assert finding.remedy is None
    assert finding.text.endswith("(no display)")


def test_a_crash_is_a_finding(monkeypatch):
    monkeypatch.delenv("QT_QPA_PLATFORM", raising=False)
    monkeypatch.setattr(checkup, "display", lambda: ":0")
    monkeypatch.setattr(checkup, "OPENGL", "import os; os.kill(os.getpid(), 11)")
    finding = checkup._opengl()
    assert signal.Signals(11).name in finding.text
    assert finding.remedy is not None


def test_no_context_is_a_finding(monkeypatch):
    monkeypatch.delenv("QT_QPA_PLATFORM", raising=False)
    monkeypatch.setattr(checkup, "display", lambda: ":0")
    monkeypatch.setattr(checkup, "OPENGL", """print('{"platform": "xcb", "opengl": []}')""")
    assert checkup._opengl().text == "no context can be made"


def test_a_program_that_fails_says_why():
    trial = checkup._tried("raise ImportError('libGL.so.1: cannot open')")
    assert trial.answer is None
    assert trial.why == "ImportError: libGL.so.1: cannot open"


def test_a_program_that_hangs_is_given_up(monkeypatch):
    monkeypatch.setattr(checkup, "PATIENCE", 0.1)
    assert "no answer" in checkup._tried("import threading; threading.Event().wait()").why


@pytest.mark.parametrize(
    ("version", "well"),
    [("6.8.0", True), ("6.11.3", True), ("6.11.0", False), ("6.12.0", False), ("5.15.2", False)],
)
def test_versions_that_are_known_to_fail_are_known(version, well):
    assert works(version) is well
