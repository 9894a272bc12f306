"""Designs kept safe, and offered again after a crash."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from socket import gethostname

import pytest
from PySide6.QtWidgets import QLabel, QPushButton

from plusedit.app import autosave
from plusedit.app.autosave import Autosave, has_left_behind, left_behind, lock_of, write
from plusedit.app.recovery import RecoveryDialog
from plusedit.commands.curves import SetMagnitude
from plusedit.document.session import Session
from tests.designs import WING, a_design

pytestmark = pytest.mark.gui

PROGRAM = """
import sys
from pathlib import Path
from PySide6.QtCore import QTimer
from plusedit.app.main import make_application
from plusedit.app.settings import Settings
from plusedit.app.window import MainWindow
from plusedit.commands.curves import SetMagnitude
from tests.designs import WING, a_design

application = make_application(["plusedit"])
window = MainWindow(Settings(Path(sys.argv[1]) / "settings.ini"), Path(sys.argv[1]))
window.show()
window.files.show(a_design(), None)
window.session.commit(SetMagnitude({WING: 4.5}))
window.autosave._idle.setInterval(0)
window.autosave._idle.start()
told = QTimer()
told.timeout.connect(lambda: window.autosave.file.exists() and print("kept", flush=True))
told.start(10)
application.exec()
"""


@pytest.fixture
def place(tmp_path):
    return tmp_path


@pytest.fixture
def session():
    return Session(a_design())


@pytest.fixture
def keeper(qapp, session, place):
    keeper = Autosave(session, lambda: None, place)
    yield keeper
    keeper.close()


def left_by_a_crash(place, path=None, s=4.5):
    """What a program leaves that ends without a word, its lock being held by nobody."""
    file = place / f"crashed{autosave.SUFFIX}"
    write(file, SetMagnitude({WING: s}).apply(a_design()), path)
    return file


def test_an_edit_is_kept_once_nothing_happens_any_more(session, keeper):
    session.commit(SetMagnitude({WING: 4.5}))
    assert keeper._idle.isActive() and keeper._idle.interval() == 3_000
    assert keeper._at_most.isActive() and keeper._at_most.interval() == 30_000
    keeper._idle.timeout.emit()
    keeper.finish()
    assert keeper.file.exists()
    assert not keeper._at_most.isActive()


def test_editing_without_a_pause_does_not_put_it_off_for_ever(session, keeper):
    session.commit(SetMagnitude({WING: 4.5}))
    began = keeper._at_most.remainingTime()
    session.commit(SetMagnitude({WING: 5.5}))
    assert keeper._at_most.remainingTime() <= began
    keeper._at_most.timeout.emit()
    keeper.finish()
    assert keeper.file.exists()


def test_saving_and_undoing_to_what_was_saved_take_the_file_away(session, keeper):
    session.commit(SetMagnitude({WING: 4.5}))
    keeper.keep()
    assert keeper.file.exists()
    session.undo()
    assert not keeper.file.exists()
    session.redo()
    keeper.keep()
    session.mark_saved()
    assert not keeper.file.exists()


def test_a_clean_end_leaves_nothing_behind(session, keeper, place):
    session.commit(SetMagnitude({WING: 4.5}))
    keeper.keep()
    keeper.close()
    assert list(place.iterdir()) == []


def test_a_folder_that_cant_be_written_is_no_error(session, qapp, place):
    keeper = Autosave(session, lambda: None, place / "gone")
    session.commit(SetMagnitude({WING: 4.5}))
    keeper.keep()
    assert not keeper.file.exists()
    keeper.close()


def test_a_living_program_keeps_what_is_its_own(session, keeper, place):
    session.commit(SetMagnitude({WING: 4.5}))
    keeper.keep()
    assert has_left_behind(place)
    assert left_behind(place) == []
    assert keeper.file.exists()


def test_what_cant_be_read_is_passed_over_and_kept(place, qapp):
    broken = place / f"broken{autosave.SUFFIX}"
    broken.write_bytes(b'{"path": 3}\n{')
    good = left_by_a_crash(place)
    (left,) = left_behind(place)
    assert left.file == good
    assert broken.exists()
    left.leave()


def test_two_starts_at_once_do_not_both_take_it(place, qapp):
    file = left_by_a_crash(place)
    other = lock_of(file)
    assert other.tryLock(0)
    assert left_behind(place) == []
    other.unlock()
    (left,) = left_behind(place)
    left.remove()
    assert list(place.iterdir()) == []


def test_a_recovered_design_is_not_saved_and_is_kept_again(window):
    place = window.autosave.file.parent
    place.mkdir(exist_ok=True)
    left_by_a_crash(place)
    window.flows.ask_version = lambda left: "recovered"
    assert window.flows.recover(place)
    assert window.session.design.curve(WING).s == 4.5
    assert not window.session.is_saved
    assert window.autosave.file.exists()
    assert not (place / f"crashed{autosave.SUFFIX}").exists()


def test_the_saved_version_may_be_chosen(window, document):
    place = window.autosave.file.parent
    place.mkdir(exist_ok=True)
    left_by_a_crash(place, document)
    window.flows.ask_version = lambda left: "saved"
    assert window.flows.recover(place)
    assert window.files.path == document
    assert window.session.design.curve(WING).s == 2.5
    assert not (place / f"crashed{autosave.SUFFIX}").exists()


def test_deciding_later_keeps_it_for_the_next_start(window):
    place = window.autosave.file.parent
    place.mkdir(exist_ok=True)
    file = left_by_a_crash(place)
    window.flows.ask_version = lambda left: "later"
    assert not window.flows.recover(place)
    assert file.exists()
    (left,) = left_behind(place)
    left.leave()


def test_the_question_shows_both_versions_with_date_and_picture(qtbot, window, document, place):
    file = left_by_a_crash(place, document)
    (left,) = left_behind(place)
    dialog = RecoveryDialog(left, window.desk.theme, window)
    qtbot.addWidget(dialog)
    pictures = [w for w in dialog.findChildren(QLabel) if not w.pixmap().isNull()]
    assert len(pictures) == 2
    texts = " ".join(w.text() for w in dialog.findChildren(QLabel))
    assert str(time.localtime(file.stat().st_mtime).tm_year) in texts
    buttons = {w.text(): w for w in dialog.findChildren(QPushButton)}
    buttons["Open recovered version"].click()
    assert dialog.choice == "recovered"
    left.leave()


def test_of_a_mesh_on_disk_it_is_told_that_it_can_be_opened_again(qtbot, window, tmp_path, place):
    mesh = tmp_path / "hill.obj"
    mesh.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    left_by_a_crash(place, mesh)
    (left,) = left_behind(place)
    dialog = RecoveryDialog(left, window.desk.theme, window)
    qtbot.addWidget(dialog)
    assert "Open the mesh again" in {w.text() for w in dialog.findChildren(QPushButton)}
    left.leave()


def test_a_killed_program_leaves_its_design_to_the_next(window, place):
    environment = {**os.environ, "QT_QPA_PLATFORM": "offscreen"}
    root = Path(__file__).parents[2]
    program = subprocess.Popen(
        [sys.executable, "-c", PROGRAM, str(place)],
        cwd=root,
        env=environment,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert program.stdout.readline() == "kept\n"
        assert left_behind(place) == []
    finally:
        program.send_signal(signal.SIGKILL)
        program.wait()
        program.stdout.close()
    (left,) = left_behind(place)
    assert left.design.curve(WING).s == 4.5
    assert left.path is None
    left.leave()
    window.flows.ask_version = lambda left: "recovered"
    assert window.flows.recover(place)
    assert window.session.design.curve(WING).s == 4.5
    assert window.files.name == "Untitled"


def test_a_lock_without_a_design_is_swept_away_once_its_owner_is_dead(tmp_path):
    orphan = tmp_path / "1-a.autosave.lock"
    orphan.write_text(f"999999999\nplusedit\n{gethostname()}\n")
    mine = lock_of(tmp_path / "2-b.autosave")
    assert mine.tryLock(0)
    assert left_behind(tmp_path) == []
    assert not orphan.exists()
    assert (tmp_path / "2-b.autosave.lock").exists()
    mine.unlock()
