"""`plusedit open`: what keeps the window from opening is said before."""

import pytest

from plusedit import machine
from plusedit.__main__ import main, main_window
from plusedit.cli import open as opening

WITHOUT = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")


@pytest.fixture
def no_display(monkeypatch):
    for variable in WITHOUT:
        monkeypatch.delenv(variable, raising=False)
    monkeypatch.setattr(machine.sys, "platform", "linux")


@pytest.mark.usefixtures("no_display")
def test_without_a_display_it_tells_of_render(capsys):
    assert main([]) == 2
    [line] = capsys.readouterr().err.splitlines()
    assert "no display" in line
    assert "plusedit render" in line


@pytest.mark.usefixtures("no_display")
def test_a_file_that_can_not_be_read_is_told_first(capsys, tmp_path):
    assert main([str(tmp_path / "bow.json")]) == 2
    assert capsys.readouterr().err == "bow.json: there is no such file\n"


@pytest.mark.usefixtures("no_display")
def test_missing_libraries_are_named_with_what_installs_them(monkeypatch, capsys):
    monkeypatch.setenv("DISPLAY", ":0")
    monkeypatch.setattr(opening, "missing", lambda libraries: ["libxcb-cursor.so.0"])
    assert main([]) == 2
    assert "sudo apt-get install libxcb-cursor0" in capsys.readouterr().err


@pytest.mark.usefixtures("no_display")
def test_the_window_is_left_to_tell_of_files(monkeypatch, tmp_path, capsys):
    monkeypatch.setattr("sys.argv", ["plusedit-gui", str(tmp_path / "bow.json")])
    assert main_window() == 2
    assert "no display" in capsys.readouterr().err


@pytest.mark.usefixtures("no_display")
@pytest.mark.parametrize(
    ("variable", "value", "library"),
    [
        ("DISPLAY", ":0", "libxcb-cursor.so.0"),
        ("WAYLAND_DISPLAY", "wayland-0", "libwayland-client.so.0"),
        ("QT_QPA_PLATFORM", "xcb", "libxcb-cursor.so.0"),
    ],
)
def test_each_display_needs_its_own_libraries(monkeypatch, variable, value, library):
    monkeypatch.setenv(variable, value)
    assert value in (machine.display() or "")
    assert library in machine.needed_libraries()


@pytest.mark.usefixtures("no_display")
def test_offscreen_needs_no_display_and_no_x_libraries(monkeypatch):
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    assert machine.display() is not None
    assert machine.needed_libraries() == machine.QT


def test_a_library_that_is_not_there_is_missing():
    assert machine.missing(["libnobodyhasthis.so.7"]) == ["libnobodyhasthis.so.7"]


@pytest.mark.usefixtures("no_display")
def test_other_systems_have_a_desktop(monkeypatch):
    monkeypatch.setattr(machine.sys, "platform", "darwin")
    assert machine.display() == "the desktop"
    assert machine.needed_libraries() == {}
