"""Words on a canvas: what to do while it is empty, what is left out, numbers of a drag."""

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QFontMetricsF, QPainter

from plusedit.scene.theme import Theme
from plusedit.views.painter import color_of, font_of, pen_of

PATH = "Surface\N{NO-BREAK SPACE}>\N{NO-BREAK SPACE}New"  # of a menu, on one line
EMPTY = f"Draw a curve with the pen (P), take a surface from {PATH}, or drop a file here"
TEXT = 12.0  # pixels, the height of the font
PADDING = (8.0, 5.0)  # pixels around the text of a chip
OFF_POINTER = (18.0, 22.0)  # pixels from the pointer to its chip: clear of the cursor
CORNER = 4.0  # pixels, the radius


def paint_empty(painter: QPainter, view: QRectF, theme: Theme, text: str = EMPTY) -> None:
    """What to do, in the middle of the view, on a ground of its own that covers the axes."""
    painter.setFont(font_of(14.0))
    flags = int(Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap)
    box = painter.boundingRect(view.adjusted(40.0, 24.0, -40.0, -24.0), flags, text)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color_of(theme.color("canvas")))
    painter.drawRoundedRect(box.adjusted(-16.0, -10.0, 16.0, 10.0), 2.0 * CORNER, 2.0 * CORNER)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setPen(color_of(theme.color("quiet")))
    painter.drawText(box, flags, text)


def paint_note(painter: QPainter, view: QRectF, text: str, theme: Theme) -> None:
    """A sentence in the lower left corner of the view."""
    width, height = _extent(text)
    at = QPointF(view.left() + 12.0, view.bottom() - 12.0 - height)
    _chip(painter, QRectF(at.x(), at.y(), width, height), text, theme, "quiet")


def paint_readout(painter: QPainter, view: QRectF, at: QPointF, text: str, theme: Theme) -> None:
    """Numbers beside the pointer, on its other side where there is no room."""
    width, height = _extent(text)
    x, y = at.x() + OFF_POINTER[0], at.y() + OFF_POINTER[1]
    if x + width > view.right():
        x = at.x() - OFF_POINTER[0] - width
    if y + height > view.bottom():
        y = at.y() - OFF_POINTER[1] - height
    x = min(max(x, view.left()), max(view.left(), view.right() - width))
    y = min(max(y, view.top()), max(view.top(), view.bottom() - height))
    _chip(painter, QRectF(x, y, width, height), text, theme, "text")


def _extent(text: str) -> tuple[float, float]:
    metrics = QFontMetricsF(font_of(TEXT))
    lines = text.split("\n")
    width = max(metrics.horizontalAdvance(line) for line in lines)
    return width + 2.0 * PADDING[0], metrics.height() * len(lines) + 2.0 * PADDING[1]


def _chip(painter: QPainter, box: QRectF, text: str, theme: Theme, color: str) -> None:
    # On whole pixels and a half, so that the hairline around it is crisp.
    box = QRectF(
        round(box.x()) + 0.5, round(box.y()) + 0.5, round(box.width()), round(box.height())
    )
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(pen_of(theme.color("border"), 1.0, "solid"))
    painter.setBrush(color_of(theme.color("panel@94")))
    painter.drawRoundedRect(box, CORNER, CORNER)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.setFont(font_of(TEXT))
    painter.setPen(color_of(theme.color(color)))
    painter.drawText(box, int(Qt.AlignmentFlag.AlignCenter), text)
