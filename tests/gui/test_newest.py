"""Work beside the window's thread of which only the newest is wanted."""

from threading import Event, current_thread, main_thread

import pytest
from PySide6.QtCore import QObject

from plusedit.views.newest import Newest

pytestmark = pytest.mark.gui


@pytest.fixture
def newest(qapp):
    parent = QObject()
    yield Newest(parent)
    parent.deleteLater()


def test_what_comes_of_work_is_taken_in_the_window_s_thread(qtbot, newest):
    found = []
    newest.ask(current_thread, lambda thread: found.append((thread, current_thread())))
    qtbot.waitUntil(lambda: len(found) > 0)
    (worker, taker) = found[0]
    assert worker is not main_thread()
    assert taker is main_thread()
    assert not newest.is_busy


def test_of_what_waits_only_the_newest_is_begun(qtbot, newest):
    go_on, begun, taken = Event(), [], []

    def work(number):
        begun.append(number)
        go_on.wait(20)
        return number

    for number in range(4):
        newest.ask(lambda number=number: work(number), taken.append)
    go_on.set()
    qtbot.waitUntil(lambda: not newest.is_busy)
    assert begun == taken == [0, 3]


def test_what_is_forgotten_is_not_taken(qtbot, newest):
    go_on, taken = Event(), []
    newest.ask(lambda: go_on.wait(20), taken.append)
    newest.ask(lambda: 2, taken.append)
    newest.forget()
    go_on.set()
    qtbot.waitUntil(lambda: not newest.is_busy)
    assert not taken


def test_errors_come_up_in_the_window_s_thread(qtbot, newest):
    def work():
        raise ValueError("too large")

    with qtbot.captureExceptions() as errors:
        newest.ask(work, print)
        qtbot.waitUntil(lambda: len(errors) > 0)
    assert str(errors[0][1]) == "too large"
