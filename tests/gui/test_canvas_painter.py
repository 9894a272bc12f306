"""Items as pixels."""

import numpy as np
import pytest
from PySide6.QtGui import QColor, QImage, QPainter

from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.theme import LIGHT
from plusedit.views.arrays import polygon_of
from plusedit.views.painter import ItemPainter, color_of

pytestmark = [pytest.mark.gui, pytest.mark.usefixtures("qapp")]

SIDE = 100
# A unit is a pixel, and (0, 0) is in the middle.
CAMERA = PlaneCamera((float(SIDE), float(SIDE)), scale=1.0)
LEFT, RIGHT = np.array([[-30.0, 0.0]]), np.array([[30.0, 0.0]])
LEVEL = np.array([[-30.0, 0.5], [30.0, 0.5]])
MARKS = ["circle", "square", "diamond", "ring", "cross"]


def painted(*items, camera=CAMERA, ratio=1, draft=False):
    """(rows, columns, 3) red, green and blue of the items on white."""
    image = QImage(SIDE * ratio, SIDE * ratio, QImage.Format.Format_RGB32)
    image.setDevicePixelRatio(ratio)
    image.fill(QColor("white"))
    painter = QPainter(image)
    try:
        ItemPainter(painter, camera, LIGHT, draft).paint(items)
    finally:
        painter.end()
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(SIDE * ratio, SIDE * ratio, 4)
    return pixels[..., 2::-1].astype(int)


def darkness(pixels):
    """How much was painted, in pixels of black."""
    return (255 - pixels).sum() / (3 * 255)


def is_color(pixel, color):
    wanted = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
    return np.abs(pixel - wanted).max() <= 8


def test_points_reach_qt_in_their_order():
    points = np.random.default_rng(1).random((1000, 2))
    polygon = polygon_of(points[:, ::-1])
    assert polygon.size() == 1000
    assert polygon.at(999).x() == points[999, 1]
    assert polygon_of(np.zeros((0, 2))).isEmpty()


def test_opacity_comes_last_in_a_color():
    assert color_of("#11223344").getRgb() == (0x11, 0x22, 0x33, 0x44)


@pytest.mark.parametrize("draft", [False, True])
def test_a_line_has_its_color_and_width(draft):
    pixels = painted(Polyline(LEVEL, "#2563EB", 4.0), draft=draft)
    column = pixels[:, 50]
    assert is_color(column[49], "#2563EB")
    assert (column < 255).any(axis=1).sum() in (4, 5)


def test_the_same_is_drawn_on_a_finer_screen_with_more_pixels():
    item = Polyline(LEVEL, "#000000", 4.0)
    assert darkness(painted(item, ratio=2)) == pytest.approx(4.0 * darkness(painted(item)), rel=0.1)


def test_a_dashed_line_has_gaps():
    solid, dashed = (painted(Polyline(LEVEL, "#000000", 1.0, dash)) for dash in ("solid", "dash"))
    assert 0.3 < darkness(dashed) / darkness(solid) < 0.9


def test_segments_are_not_joined():
    starts, ends = np.array([[-40.0, 0.0], [20.0, 0.0]]), np.array([[-20.0, 0.0], [40.0, 0.0]])
    pixels = painted(Segments(starts, ends, "#000000", 2.0))
    assert (pixels[:, 50] == 255).all()
    assert (pixels[:, [20, 80]] < 255).any(axis=0).all()


def test_no_segments_draw_nothing():
    nothing = np.zeros((0, 2))
    assert darkness(painted(Segments(nothing, nothing, "#000000"))) == 0.0


def test_an_area_is_filled_and_its_outline_drawn():
    corners = np.array([[-20.0, -20.0], [20.0, -20.0], [20.0, 20.0], [-20.0, 20.0]])
    pixels = painted(Polygon(corners, "#FF0000", "#0000FF", 4.0))
    assert is_color(pixels[50, 50], "#FF0000")
    assert is_color(pixels[50, 30], "#0000FF")
    assert (pixels[5, 5] == 255).all()


@pytest.mark.parametrize("mark", MARKS)
def test_every_mark_stands_on_all_of_its_points(mark):
    at = np.concatenate([LEFT, RIGHT])
    pixels = painted(Markers(at, mark, 12.0, "#FF0000", "#FF0000", 2.0))
    for column in (20, 80):
        around = pixels[42:58, column - 8 : column + 8]
        assert darkness(around) > 5.0
    assert darkness(pixels[:, 40:60]) == 0.0


@pytest.mark.parametrize("mark", ["circle", "square", "diamond"])
def test_a_hollow_mark_shows_the_canvas(mark):
    pixels = painted(Markers(LEFT, mark, 14.0, None, "#000000", 2.0))
    assert is_color(pixels[50, 20], LIGHT.color("canvas"))
    assert (pixels[50, 12:16] < 128).any()


def test_a_ring_shows_what_is_below():
    below = Polygon(
        np.array([[-50.0, -50.0], [50.0, -50.0], [50.0, 50.0], [-50.0, 50.0]]), "#00FF00"
    )
    assert is_color(painted(below, Markers(LEFT, "ring", 14.0, None, "#000000"))[50, 20], "#00FF00")


@pytest.mark.parametrize(
    ("anchor", "columns"), [("left", (50, 100)), ("right", (0, 50)), ("center", (25, 75))]
)
def test_a_label_stands_on_its_anchor(anchor, columns):
    label = Label(np.zeros(2), "WWW", "#000000", (0.0, 0.0), anchor, 12.0)
    pixels = painted(label)
    seen = np.flatnonzero((pixels < 255).any(axis=(0, 2)))
    assert columns[0] - 2 <= seen.min()
    assert seen.max() <= columns[1] + 2
    assert (pixels[54:] == 255).all()


def test_at_deep_zoom_lines_come_out_as_near_ones_do():
    far = np.array([[-3e9, 0.5], [5e9, 0.5]])
    pixels = painted(Polyline(far, "#000000", 2.0))
    near = painted(Polyline(np.array([[-99.0, 0.5], [99.0, 0.5]]), "#000000", 2.0))
    assert (pixels == near).all()


def test_at_deep_zoom_areas_and_marks_come_out_as_near_ones_do():
    corners = np.array([[-1e12, -1e12], [1e12, -1e12], [1e12, 0.0], [-1e12, 0.0]])
    marks = np.array([[0.0, 20.0], [1e300, 0.0]])
    pixels = painted(
        Polygon(corners, "#FF0000"), Markers(marks, "circle", 8.0, "#000000", "#000000")
    )
    assert is_color(pixels[80, 50], "#FF0000")
    assert is_color(pixels[30, 50], "#000000")
    assert (pixels[10] == 255).all()


def test_an_unknown_item_is_an_error():
    with pytest.raises(TypeError, match="draws no"):
        painted("a string")
