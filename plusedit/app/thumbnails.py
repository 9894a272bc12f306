"""Small pictures of designs, drawn as the window draws them."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QImage, QPixmap

from plusedit.document.design import Design
from plusedit.io.formats import FormatError
from plusedit.resources import is_shipped, picture_of_example
from plusedit.scene.options import options_of, view_tree
from plusedit.scene.theme import Theme
from plusedit.views.picture import image_of
from plusedit.views.sketch import sketch_of

REDUCED = 2  # pictures are drawn for twice their size, so that lines and dots are finer


def small_image_of(design: Design, size: QSize, theme: Theme, pixel_ratio: float = 1.0) -> QImage:
    """A picture of a design on a transparent ground, `size` logical pixels large.

    As an image, which may be drawn in whatever thread.
    """
    large = (size.width() * REDUCED, size.height() * REDUCED)
    draw = sketch_of if design.is_spatial else image_of
    image = draw(without_words(design), large, theme, transparent=True, ratio=pixel_ratio / REDUCED)
    image.setDevicePixelRatio(pixel_ratio)
    return image


def without_words(design: Design) -> Design:
    """The design without names beside its curves: in a small picture they can't be read."""
    kept = options_of(design.view)
    options = replace(kept, overlays=kept.overlays - {"names"})
    return replace(design, view=view_tree(options, old=design.view))


def picture_of_file(
    path: Path, size: QSize, theme: Theme, pixel_ratio: float = 1.0
) -> QPixmap | None:
    """A picture of the design in a file, or None if it can't be read.

    Of shipped designs it is the one that is shipped with them, where there is one.
    """
    image = image_of_file(path, size, theme, pixel_ratio)
    return None if image is None else QPixmap.fromImage(image)


def image_of_file(path: Path, size: QSize, theme: Theme, pixel_ratio: float = 1.0) -> QImage | None:
    """The same as an image, which may be drawn in whatever thread."""
    from plusedit.io.files import load

    shipped = picture_of_example(path, theme.name)
    if is_shipped(path) and shipped.exists():
        return _scaled(QImage(str(shipped)), size, pixel_ratio)
    try:
        design = load(path).design
    except (FormatError, OSError):
        return None
    return small_image_of(design, size, theme, pixel_ratio)


def _scaled(image: QImage, size: QSize, pixel_ratio: float) -> QImage:
    smooth = Qt.TransformationMode.SmoothTransformation
    scaled = image.scaled(size * pixel_ratio, Qt.AspectRatioMode.KeepAspectRatio, smooth)
    scaled.setDevicePixelRatio(pixel_ratio)
    return scaled
