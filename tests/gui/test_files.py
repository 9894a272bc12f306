"""Opening, saving, and what is asked before anything is lost."""

import json
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QCloseEvent, QDropEvent
from PySide6.QtWidgets import QApplication

from plusedit.app.export_dialogs import Picture, PictureDialog, Reading, ReadingDialog
from plusedit.commands.curves import SetMagnitude
from plusedit.io.files import load
from tests.designs import WING, a_design
from tests.gui.conftest import example

pytestmark = pytest.mark.gui

SVG = b"""<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10">
<path d="M1 1 C 2 5 6 5 8 1 S 9 2 9 9" stroke="#123456" fill="none"/></svg>"""


@pytest.fixture
def edited(window):
    """The window with an unnamed design that is not saved."""
    window.files.show(a_design(), None)
    window.session.commit(SetMagnitude({WING: 3.25}))
    return window


@pytest.fixture
def drawing(tmp_path):
    path = tmp_path / "drawing.svg"
    path.write_bytes(SVG)
    return path


def close(window):
    event = QCloseEvent()
    window.closeEvent(event)
    return event.isAccepted()


def test_a_saved_design_opens_again_to_the_last_bit(edited, answers, tmp_path):
    answers.save = tmp_path / "kept.plus.json"
    assert edited.files.save()
    assert not edited.isWindowModified()
    before = edited.session.committed.curve(WING)
    assert edited.files.open(answers.save)
    after = edited.session.committed.curve(WING)
    assert (after.s, after.lines.points.tobytes()) == (before.s, before.lines.points.tobytes())


def test_the_title_names_the_file_and_marks_what_is_not_saved(edited, answers, tmp_path):
    assert edited.isWindowModified()
    assert edited.windowTitle() == "Untitled[*] — PlusEdit"
    answers.save = tmp_path / "kept.plus.json"
    edited.files.save()
    assert edited.windowTitle() == "kept.plus.json[*] — PlusEdit"
    edited.session.undo()
    assert edited.isWindowModified()
    edited.session.redo()
    assert not edited.isWindowModified()


def test_saving_again_asks_for_no_name(edited, answers, tmp_path):
    answers.save = path = tmp_path / "kept.plus.json"
    edited.files.save()
    answers.save = None
    edited.session.commit(SetMagnitude({WING: 7.5}))
    assert edited.files.save()
    assert load(path).design.curve(WING).s == 7.5


def test_a_name_without_a_suffix_gets_ours():
    from plusedit.app.dialogs import DESIGN_SUFFIX, known_suffixes, with_suffix

    known = known_suffixes()
    assert with_suffix(Path("/a/b"), DESIGN_SUFFIX, known) == Path("/a/b.plus.json")
    assert with_suffix(Path("/a/b.json"), DESIGN_SUFFIX, known) == Path("/a/b.json")
    assert with_suffix(Path("/a/b.svg"), DESIGN_SUFFIX, known) == Path("/a/b.svg")
    assert with_suffix(Path("/a/wing v1.2"), DESIGN_SUFFIX, known) == Path("/a/wing v1.2.plus.json")
    assert with_suffix(Path("/a/b.png"), ".svg") == Path("/a/b.png.svg")
    assert with_suffix(None, DESIGN_SUFFIX) is None


@pytest.mark.parametrize(
    ("answer", "goes"), [("cancel", False), ("discard", True), ("save", False)]
)
def test_closing_asks_about_changes(edited, answers, answer, goes):
    # "save" without a name to save under is as good as cancelling.
    answers.on_unsaved = answer
    assert close(edited) is goes
    assert answers.asked == ["Untitled"]


def test_closing_with_save_saves(edited, answers, tmp_path):
    answers.on_unsaved, answers.save = "save", tmp_path / "last.plus.json"
    assert close(edited)
    assert load(answers.save).design.curve(WING).s == 3.25


def test_a_saved_design_closes_without_a_question(window, answers):
    window.files.show(a_design(), None)
    assert close(window)
    assert answers.asked == []


@pytest.mark.parametrize(
    "data", [b"", b"{", b'{"format": "else"}', b"\xff\xfe", b'{"format": "plusedit-design"}']
)
def test_a_file_that_cant_be_read_leaves_the_design_alone(edited, answers, tmp_path, data):
    path = tmp_path / "bad.json"
    path.write_bytes(data)
    before = edited.session.design
    assert not edited.files.open(path)
    assert edited.session.design is before
    (sentence,) = answers.errors
    assert sentence.startswith("bad.json: ")
    assert "\n" not in sentence
    assert answers.asked == []


def test_a_file_that_is_gone_leaves_the_recent_ones_too(edited, answers, tmp_path):
    gone = tmp_path / "gone.json"
    edited.settings.remember_file(gone)
    assert not edited.files.open(gone)
    assert gone not in edited.settings.recent
    assert len(answers.errors) == 1


def test_a_folder_that_cant_be_written_says_so_and_keeps_the_changes(edited, answers, tmp_path):
    answers.save = tmp_path / "no" / "such" / "folder.plus.json"
    assert not edited.files.save()
    assert len(answers.errors) == 1
    assert not edited.session.is_saved


def test_opening_over_changes_asks_first(edited, answers, document):
    before = edited.session.design
    assert not edited.files.open(document)
    assert edited.session.design is before
    answers.on_unsaved = "discard"
    assert edited.files.open(document)
    assert WING in edited.session.design
    assert edited.session.design is not before


def test_recent_files_are_in_the_menu_and_open(window, document):
    window.files.open(document)
    window._recent.aboutToShow.emit()
    (action,) = window._recent.actions()
    assert action.text() == "bow.json"
    window.files.new()
    action.trigger()
    assert window.files.path == document


def test_notes_on_a_file_are_shown_until_dismissed(opened):
    opened.files.notes.emit("bow.json", ("a key was left out",))
    assert opened.notes.isVisible()
    assert "bow.json" in opened.notes.text.text()
    opened.notes.close_button.click()
    assert not opened.notes.isVisible()


def test_a_dropped_file_is_opened(window, document):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(document))])
    event = QDropEvent(
        QPointF(5, 5),
        Qt.DropAction.CopyAction,
        data,
        Qt.MouseButton.LeftButton,
        Qt.KeyboardModifier.NoModifier,
    )
    window.dropEvent(event)
    assert window.files.path == document


def test_saving_a_drawing_asks_for_a_design_name(window, answers, drawing, tmp_path):
    assert window.files.open(drawing)
    answers.save = tmp_path / "drawing.plus.json"
    assert window.files.save()
    assert answers.suggested.name == "drawing.plus.json"
    assert drawing.read_bytes() == SVG
    assert window.files.path == answers.save


def test_saving_as_a_drawing_is_an_export_and_not_a_save(edited, answers, tmp_path):
    answers.save = tmp_path / "out.svg"
    assert not edited.files.save_as()
    assert not answers.save.exists()
    answers.export_wanted = True
    assert not edited.files.save_as()
    assert answers.save.read_bytes().lstrip().startswith(b"<")
    assert edited.files.path is None
    assert not edited.session.is_saved


def test_a_picture_is_exported_in_the_size_asked_for(edited, answers, tmp_path):
    from PySide6.QtGui import QImage

    path = tmp_path / "picture.png"
    edited.flows.write_picture(path, Picture((320, 200), "dark", True))
    image = QImage(str(path))
    assert (image.width(), image.height()) == (320, 200)
    assert image.pixelColor(0, 0).alpha() == 0


def test_sizes_that_make_no_picture_are_refused(qtbot):
    dialog = PictureDialog(None, (800, 600), "light")
    qtbot.addWidget(dialog)
    dialog.width_field.setText("0")
    with pytest.raises(ValueError, match="pixels"):
        dialog.read()
    dialog.width_field.setText("400*2")
    assert dialog.read() == Picture((800, 600), "light", False)


@pytest.mark.parametrize(("how", "count"), [("segments", 2), ("paths", 1), ("fitted", 1)])
def test_a_drawing_is_imported_in_one_step(qtbot, edited, drawing, how, count):
    before = edited.session.design
    edited.flows.add_drawing(drawing, Reading(how, 0.001))
    assert len(edited.session.design) == len(before) + count
    assert len(edited.session.selection.shapes) == count
    chosen = [edited.session.design.curve(i) for i in edited.session.selection.shapes]
    points = np.concatenate([curve.lines.points for curve in chosen])

    def is_in_sight():
        camera = edited.canvas.camera
        seen = camera.to_screen(points)
        return bool(((seen > 0.0) & (seen < camera.size)).all())

    qtbot.waitUntil(is_in_sight)
    edited.session.undo()
    assert edited.session.design is before


def test_the_import_dialog_asks_for_a_tolerance_only_where_it_counts(qtbot):
    dialog = ReadingDialog(None)
    qtbot.addWidget(dialog)
    dialog.show()
    assert not dialog.tolerance.isVisible()
    dialog.how.setCurrentIndex(dialog.how.findData("fitted"))
    assert dialog.tolerance.isVisible()
    dialog.tolerance.setText("0.5")
    assert dialog.read() == Reading("fitted", 0.005)
    dialog.tolerance.setText("-1")
    with pytest.raises(ValueError, match="above zero"):
        dialog.read()


def test_the_view_is_kept_with_the_design(edited, answers, tmp_path):
    edited.view.toggle_overlay("hulls")
    edited.view.set_handles("none")
    answers.save = path = tmp_path / "kept.plus.json"
    edited.files.save()
    tree = json.loads(path.read_text())["view"]
    assert tree["handles"] == "none"
    edited.view.toggle_overlay("hulls")
    edited.view.set_handles("auto")
    edited.files.open(path)
    assert "hulls" in edited.view.options.overlays
    assert edited.view.options.handles == "none"


def test_an_example_opens_from_the_start_page(qtbot, window):
    window.show_start_page()
    card = next(c for c in window.start_page._cards if c.path == example("figure_2.json"))
    qtbot.mouseClick(card, Qt.MouseButton.LeftButton)
    assert window.files.name == "figure_2.json"
    assert window.stack.currentWidget() is window.panes


def test_work_that_takes_longer_leaves_the_window_alive(qtbot, window):
    from threading import Event

    from PySide6.QtCore import QTimer

    from plusedit.app.background import in_background

    alive = Event()
    QTimer.singleShot(0, alive.set)
    # The work waits for the window: it would wait for ever if the window stood still.
    assert in_background(window, "Working …", lambda: alive.wait(20)) is True
    QApplication.processEvents()


def test_work_that_fails_raises_what_it_raised(window):
    from plusedit.app.background import in_background

    def fail():
        raise OSError("broken")

    with pytest.raises(OSError, match="broken"):
        in_background(window, "Working …", fail)


def test_the_collector_rests_until_the_window_has_seen_the_last_worker_end(qtbot):
    import gc
    from threading import Event

    from plusedit.views.workers import start_worker

    go = Event()
    first, second = start_worker(go.wait, "first"), start_worker(lambda: None, "second")
    second.join()
    go.set()
    first.join()
    # Had a worker let the collector go on, it could have run in that worker.
    assert not gc.isenabled()
    qtbot.waitUntil(gc.isenabled)


def test_a_shipped_example_is_saved_under_a_name_of_its_own(window, answers, tmp_path):
    shipped = example("figure_2.json")
    before = shipped.read_bytes()
    window.files.open(shipped)
    assert window.settings.recent == []
    answers.save = tmp_path / "mine.plus.json"
    assert window.files.save()
    assert answers.suggested.parent != shipped.parent
    assert shipped.read_bytes() == before
    assert window.files.path == answers.save
