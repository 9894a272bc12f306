"""Figures as PDF files and as pixels, drawn by the painter of the window."""

import re
from collections.abc import Sequence
from math import ceil

from PySide6.QtCore import QBuffer, QIODevice, QMarginsF, QRectF, QSizeF
from PySide6.QtGui import QImage, QPageLayout, QPageSize, QPainter, QPdfWriter

from plusedit.scene.figure import POINT, Figure
from plusedit.scene.items import Item, Legend
from plusedit.scene.legends import placed
from plusedit.views.legend import paint_legend
from plusedit.views.painter import ItemPainter, color_of, painting
from plusedit.views.picture import blank_image, png_bytes

FINE = 1200  # units of a PDF to an inch
INCH = 25.4  # millimeters


def pdf_figure(
    figure: Figure, flat: Sequence[Item], shaded: QImage | None = None, *, title: str = ""
) -> bytes:
    """The bytes of a PDF file of one page, which is the figure: these items over an image of it.

    Everything but the image is lines, areas and text of embedded fonts. A QGuiApplication has to
    be running.
    """
    buffer = QBuffer()
    buffer.open(QIODevice.OpenModeFlag.WriteOnly)
    writer = QPdfWriter(buffer)
    writer.setResolution(FINE)
    writer.setTitle(title)
    writer.setCreator("PlusEdit")
    size = tuple(side / POINT for side in figure.size)
    # Qt has pages of whole points: the figure is drawn at the foot of one, which is then cut.
    whole = QSizeF(*map(ceil, size))
    page = QPageSize(whole, QPageSize.Unit.Point, "", QPageSize.SizeMatchPolicy.ExactMatch)
    writer.setPageLayout(QPageLayout(page, QPageLayout.Orientation.Portrait, QMarginsF()))
    with painting(writer) as painter:
        painter.translate(0.0, (whole.height() - size[1]) / 72.0 * FINE)
        scale = figure.form.pixel / INCH * FINE
        painter.scale(scale, scale)
        paint_figure(painter, figure, flat, shaded)
    return _cut(bytes(buffer.data().data()), *size)


def _cut(data: bytes, width: float, height: float) -> bytes:
    """The PDF with a page of that size in points, counted from its lower left corner."""
    (old,) = re.findall(rb"/MediaBox \[[^\]]*\]", data)
    # As long as before: what follows is found by its place in the file.
    new = f"/MediaBox [0 0 {width:.6f} {height:.6f}".encode().ljust(len(old) - 1) + b"]"
    return data.replace(old, new)


def figure_image(
    figure: Figure, flat: Sequence[Item], resolution: float, shaded: QImage | None = None
) -> QImage:
    """The figure in so many pixels to an inch, which the image tells those who print it.

    A QGuiApplication has to be running. MemoryError where it takes more memory than there is.
    """
    size = figure.pixels(resolution)
    theme = figure.form.colors
    image = blank_image(size, theme, transparent=True, ratio=1.0)
    dots = round(resolution / INCH * 1000.0)
    image.setDotsPerMeterX(dots)
    image.setDotsPerMeterY(dots)
    with painting(image) as painter:
        painter.scale(size[0] / figure.frame[2], size[1] / figure.frame[3])
        paint_figure(painter, figure, flat, shaded)
    return image


def png_figure(
    figure: Figure, flat: Sequence[Item], resolution: float, shaded: QImage | None = None
) -> bytes:
    """The bytes of a PNG file that knows how large the figure is in print."""
    return png_bytes(figure_image(figure, flat, resolution, shaded))


def paint_figure(
    painter: QPainter, figure: Figure, flat: Sequence[Item], shaded: QImage | None = None
) -> None:
    """Draw a figure from the origin on, in its logical pixels."""
    theme, (left, top, width, height) = figure.form.colors, figure.frame
    whole = QRectF(0.0, 0.0, width, height)
    painter.setClipRect(whole)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    painter.setRenderHint(QPainter.RenderHint.LosslessImageRendering)
    if not figure.form.transparent:
        painter.fillRect(whole, color_of(theme.color("canvas")))
    if shaded is not None:
        painter.drawImage(QRectF(0.0, 0.0, *figure.shaded_size), shaded)
    painter.save()
    painter.translate(-left, -top)
    ItemPainter(painter, figure.camera, theme).paint(flat)
    painter.scale(figure.form.words, figure.form.words)
    ItemPainter(painter, figure.label_camera, theme).paint(figure.labels)
    painter.restore()
    painter.scale(figure.form.words, figure.form.words)
    corners = ItemPainter(painter, figure.corner_camera, theme)
    for item in figure.corners:
        if not isinstance(item, Legend):
            corners.paint([item])
        elif (legend := placed(item, figure.corner_size, 0.0)) is not None:
            paint_legend(painter, legend, theme)
