"""Pictures of pixels, without a window."""

import pytest
from PySide6.QtGui import QColor, QImage

from plusedit.document.design import Design
from plusedit.scene.theme import DARK, LIGHT
from plusedit.views.picture import image_of, png_of
from tests.designs import a_design

pytestmark = [pytest.mark.gui, pytest.mark.usefixtures("qapp")]


def colors(image):
    return {
        image.pixelColor(x, y).name() for x in range(image.width()) for y in range(image.height())
    }


@pytest.mark.parametrize("theme", [LIGHT, DARK])
def test_a_picture_shows_curves_on_the_canvas_of_its_theme(theme):
    image = image_of(a_design(), (240, 160), theme)
    assert image.pixelColor(0, 0) == QColor(theme.color("canvas"))
    assert QColor(theme.color("plus")).name() in colors(image)


def test_a_transparent_picture_has_no_ground():
    image = image_of(a_design(), (240, 160), transparent=True)
    assert image.pixelColor(0, 0).alpha() == 0
    assert any(image.pixelColor(x, 80).alpha() for x in range(240))


def test_a_png_file_has_the_size_that_was_asked_for():
    image = QImage.fromData(png_of(a_design(), (123, 45)))
    assert (image.width(), image.height()) == (123, 45)


def test_a_finer_picture_has_more_pixels_of_the_same():
    image = image_of(a_design(), (120, 80), ratio=2.0)
    assert (image.width(), image.height()) == (240, 160)


def test_an_empty_design_makes_an_empty_picture():
    assert colors(image_of(Design(), (60, 40))) == {LIGHT.color("canvas").lower()}


def test_a_name_can_be_read():
    named = Design(a_design().shapes, view={"overlays": ["names"]})
    bare = Design(a_design().shapes, view={"overlays": []})
    assert QColor(LIGHT.color("text")).name() in colors(image_of(named, (400, 300)))
    assert QColor(LIGHT.color("text")).name() not in colors(image_of(bare, (400, 300)))
