"""Designs side by side in one picture, without a window."""

from collections.abc import Callable, Sequence
from itertools import accumulate
from typing import TypeAlias

from PySide6.QtGui import QImage, QPainter

from plusedit.document.design import Design
from plusedit.views.picture import png_bytes, running_application

Draw: TypeAlias = Callable[[Design, tuple[int, int]], QImage]


def row_png(
    designs: Sequence[Design], size: tuple[int, int], draw: Draw, *, in_space: bool
) -> bytes:
    """The bytes of a PNG file of that size with the designs from left to right, drawn by `draw`.

    Needs neither a display nor a running application; with one design it is the picture of that.
    """
    application = running_application(in_space=in_space)
    width, height = size
    ends = [width * number // len(designs) for number in range(1, len(designs) + 1)]
    widths = [end - start for start, end in zip([0, *ends], ends, strict=False)]
    images = [draw(design, (each, height)) for design, each in zip(designs, widths, strict=True)]
    data = png_bytes(joined(images))
    # Fonts and pixels belong to the application: it has to live until here.
    del application
    return data


def joined(images: Sequence[QImage]) -> QImage:
    """One image of images of the same height, from left to right."""
    if len(images) == 1:
        return images[0]
    widths = [image.width() for image in images]
    row = QImage(sum(widths), images[0].height(), QImage.Format.Format_ARGB32_Premultiplied)
    if row.isNull():
        raise MemoryError("the pictures side by side take more memory than there is")
    row.fill(0)
    painter = QPainter(row)
    for image, end in zip(images, accumulate(widths), strict=True):
        painter.drawImage(end - image.width(), 0, image)
    painter.end()
    return row
