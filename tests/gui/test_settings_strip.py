"""Numbers of overlays over the view: shown while they mean something, set by dragging."""

import pytest
from PySide6.QtCore import QPoint, QPointF, QRectF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel

from plusedit.commands.shapes import SetVisible
from plusedit.document.selection import Selection
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.captions import boxes_of, in_corners
from plusedit.scene.options import ViewOptions, options_of
from plusedit.scene.scene import scene_items
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.ground import RULER
from plusedit.views.settings_strip import DOUBLES, NOTCH, SettingField, SettingsStrip
from tests.gui.test_canvas import LEFT, move

pytestmark = pytest.mark.gui


@pytest.fixture
def strip(opened):
    """The strip of the 2D view, with the numbers of combs of curves among other shapes."""
    if "comb" not in opened.view.options.overlays:
        opened.view.toggle_overlay("comb")
    return opened.canvas.findChild(SettingsStrip)


@pytest.fixture
def scale(strip):
    return strip.findChildren(SettingField)[0]


def number(window):
    return window.view.options.settings.get("comb.scale", 1.0)


def dragged(field, right):
    middle = field.rect().center()
    QTest.mousePress(field, Qt.MouseButton.LeftButton, pos=middle)
    move(field, middle + QPoint(right, 0), LEFT)
    QTest.mouseRelease(field, Qt.MouseButton.LeftButton, pos=middle + QPoint(right, 0))


def test_it_is_there_while_an_overlay_with_numbers_is_on(window, strip):
    assert strip.isVisible()
    window.view.toggle_overlay("comb")
    assert not strip.isVisible()


def hide(window, *, unless):
    """Leave shapes of that kind alone in sight."""
    design = window.session.design
    others = [i for i, shape in design.shapes.items() if getattr(shape, unless) is None]
    window.session.commit(SetVisible(others, False))


def titles(strip):
    return [label.text() for label in strip.findChildren(QLabel) if label.isVisible()]


def test_numbers_of_what_draws_nothing_are_not_there(window, strip):
    hide(window, unless="mesh")
    assert not strip.isVisible()
    window.undo()
    assert strip.isVisible()


def test_numbers_of_what_compares_two_curves_are_there_while_there_are_two(window, strip):
    window.view.toggle_overlay("comb")
    window.view.toggle_overlay("two_shapes")
    design = window.session.design
    curves = [i for i, shape in design.shapes.items() if shape.curve is not None]
    window.session.commit(SetVisible(curves, True))
    window.session.select(Selection.of_shapes(curves[:2]))
    assert strip.isVisible()
    window.session.select(Selection.of_shapes(design.shapes))
    assert not strip.isVisible()


def test_numbers_of_maps_are_there_for_their_level_lines(window, strip):
    window.view.toggle_overlay("comb")
    window.view.toggle_overlay("zebra")
    assert strip.isVisible()
    hide(window, unless="curve")
    assert not strip.isVisible()


def test_numbers_of_several_overlays_stand_below_their_names(window, strip):
    assert "Curvature comb" not in titles(strip)
    window.view.toggle_overlay("normals")
    window.view.toggle_overlay("principal")
    assert titles(strip).count("Density") == 2
    assert {"Curvature comb", "Normals", "Principal directions"} <= {*titles(strip)}


def test_numbers_that_replace_others_have_room(window, strip):
    window.view.toggle_overlay("comb")
    window.view.toggle_overlay("normals")
    QApplication.processEvents()
    window.view.toggle_overlay("normals")
    window.view.toggle_overlay("decomposition")
    [field] = [found for found in strip.findChildren(SettingField) if found.isVisible()]
    assert strip.rect().contains(field.geometry())
    assert field.geometry().height() >= field.minimumSizeHint().height()


def test_it_keeps_to_the_corner_of_the_view(window, strip):
    window.resize(1100, 700)
    QApplication.processEvents()
    assert window.canvas.rect().contains(strip.geometry())
    assert strip.geometry().center().x() > window.canvas.width() / 2


@pytest.mark.parametrize(("height", "is_right"), [(700, True), (270, False)])
def test_it_covers_neither_legend_nor_captions_in_a_low_view(qtbot, opened, height, is_right):
    canvas = PlaneCanvas(opened.session, Gestures(opened.session, PlaneCamera((800.0, 600.0))))
    qtbot.addWidget(canvas)
    canvas.resize(700, height)
    canvas.set_options(ViewOptions(frozenset({"gaussian", "comb"})))
    canvas.show()
    strip = canvas.findChild(SettingsStrip)
    layers = scene_items(opened.session.design, canvas.camera, canvas.options)
    words = in_corners((*layers.legends, *layers.captions), RULER)
    boxes = [QRectF(*box) for box in boxes_of(words, (700.0, float(height)))]
    assert layers.legends
    assert boxes

    def is_clear():
        return not any(box.intersects(QRectF(strip.geometry())) for box in boxes)

    qtbot.waitUntil(is_clear)
    assert (strip.geometry().center().x() > canvas.width() / 2) == is_right


def test_it_stays_under_the_mouse_that_drags_it(qtbot, opened, strip, scale):
    before = strip.pos()
    QTest.mousePress(scale, LEFT)
    strip.keep_clear_of([(float(before.x()), float(before.y()), 300.0, 300.0)])
    QApplication.processEvents()
    assert strip.pos() == before
    QTest.mouseRelease(scale, LEFT)


@pytest.mark.parametrize(("right", "times"), [(1.0, 2.0), (-1.0, 0.5), (2.0, 4.0)])
def test_so_far_to_the_right_is_twice_as_much(window, scale, right, times):
    dragged(scale, round(right * DOUBLES))
    assert number(window) == pytest.approx(times)
    assert scale.text() == f"{times:g}"


def test_a_design_keeps_it(window, scale):
    dragged(scale, round(DOUBLES))
    kept = window.view.kept_with(window.session.design)
    assert options_of(kept.view).settings == window.view.options.settings


def test_the_wheel_changes_it_by_even_ratios(window, scale):
    at = QPointF(scale.rect().center())
    for turned in (120, 120, -120):
        event = QWheelEvent(
            at,
            QPointF(scale.mapToGlobal(at.toPoint())),
            QPoint(),
            QPoint(0, turned),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(scale, event)
    assert number(window) == pytest.approx(NOTCH)


def test_a_double_click_gives_the_usual_number_back(window, scale):
    dragged(scale, 200)
    QTest.mouseDClick(scale, Qt.MouseButton.LeftButton, pos=scale.rect().center())
    assert "comb.scale" not in window.view.options.settings
    assert scale.text() == "1"


def test_a_click_lets_a_number_be_typed(window, scale):
    QTest.mouseClick(scale, Qt.MouseButton.LeftButton, pos=scale.rect().center())
    QTest.keyClicks(scale, "2*1.5")
    QTest.keyClick(scale, Qt.Key.Key_Return)
    assert number(window) == pytest.approx(3.0)


def test_what_makes_no_sense_is_refused(window, scale):
    QTest.mouseClick(scale, Qt.MouseButton.LeftButton, pos=scale.rect().center())
    QTest.keyClicks(scale, "-2")
    QTest.keyClick(scale, Qt.Key.Key_Return)
    assert number(window) == 1.0
    assert scale.text() == "1"
