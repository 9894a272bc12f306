"""Designs as pictures of pixels, drawn as the window draws them, without a window."""

import os
import sys

from PySide6.QtCore import QBuffer, QIODevice
from PySide6.QtGui import QGuiApplication, QImage

from plusedit.document.design import Design
from plusedit.machine import is_linux
from plusedit.scene.camera import Projection
from plusedit.scene.composition import SIZE, composed
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.painter import ItemPainter, color_of, painting


def image_of(
    design: Design,
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
    *,
    transparent: bool = False,
    ratio: float = 1.0,
    projection: Projection | None = None,
) -> QImage:
    """The design framed in `size` logical pixels, `ratio` pixels of the image to each.

    It is seen as the design's own plane view sees it, or in that projection. Without a running
    QGuiApplication there is no text; `png_of` sees to one.
    """
    image = blank_image(size, theme, transparent=transparent, ratio=ratio)
    picture = composed(design, (float(size[0]), float(size[1])), projection)
    with painting(image) as painter:
        ItemPainter(painter, picture.camera, theme).paint(picture)
    return image


def blank_image(size: tuple[int, int], theme: Theme, *, transparent: bool, ratio: float) -> QImage:
    width, height = round(size[0] * ratio), round(size[1] * ratio)
    image = QImage(width, height, QImage.Format.Format_ARGB32_Premultiplied)
    if image.isNull():
        raise MemoryError(
            f"a picture of {width} by {height} pixels takes more memory than there is"
        )
    image.setDevicePixelRatio(ratio)
    image.fill(color_of(theme.color("canvas@0" if transparent else "canvas")))
    return image


def png_of(
    design: Design,
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
    *,
    transparent: bool = False,
    projection: Projection | None = None,
) -> bytes:
    """The bytes of a PNG file; needs neither a display nor a running application."""
    application = running_application()
    image = image_of(design, size, theme, transparent=transparent, projection=projection)
    data = png_bytes(image)
    # Fonts and pixels belong to the application: it has to live until here.
    del application
    return data


def png_bytes(image: QImage) -> bytes:
    """The bytes of a PNG file of an image."""
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    if not image.save(buffer, "PNG"):  # type: ignore[call-overload]
        raise OSError("the picture could not be made into a PNG file")
    return bytes(buffer.data().data())


def running_application(*, in_space: bool = False) -> QGuiApplication:
    """The application, or a new one that shows no windows and needs no display.

    What draws `in_space` has OpenGL without a display on Linux alone: elsewhere the new one is of
    the desktop.
    """
    running = QGuiApplication.instance()
    if isinstance(running, QGuiApplication):
        return running
    if is_linux() or not in_space:
        os.environ["QT_QPA_PLATFORM"] = "offscreen"
    return QGuiApplication(sys.argv[:1])
