"""Mouse pointers by the names that tools use."""

from functools import cache

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QCursor, QPainter, QPainterPath, QPen, QPixmap

SHAPES = {
    "arrow": Qt.CursorShape.ArrowCursor,
    "cross": Qt.CursorShape.CrossCursor,
    "move": Qt.CursorShape.SizeAllCursor,
    "hand": Qt.CursorShape.OpenHandCursor,
    "grab": Qt.CursorShape.ClosedHandCursor,
}
SIZE = 24  # pixels
RADIUS = 7.0
BARB = 4.0


@cache
def cursor_of(name: str, ratio: float = 1.0) -> QCursor:
    """The mouse pointer of that name; an arrow if it has none of its own."""
    if name == "turn":
        return QCursor(_turning(ratio), SIZE // 2, SIZE // 2)
    return QCursor(SHAPES.get(name, Qt.CursorShape.ArrowCursor))


def _turning(ratio: float) -> QPixmap:
    """Three quarters of a circle with an arrow head, dark with a light rim: seen on any ground."""
    pixmap = QPixmap(round(SIZE * ratio), round(SIZE * ratio))
    pixmap.setDevicePixelRatio(ratio)
    pixmap.fill(Qt.GlobalColor.transparent)
    middle = SIZE / 2.0
    path = QPainterPath()
    box = QRectF(middle - RADIUS, middle - RADIUS, 2.0 * RADIUS, 2.0 * RADIUS)
    path.arcMoveTo(box, 90.0)
    path.arcTo(box, 90.0, -270.0)
    end = QPointF(middle - RADIUS, middle)
    path.moveTo(end + QPointF(-BARB, BARB))
    path.lineTo(end)
    path.lineTo(end + QPointF(BARB, BARB))
    painter = QPainter(pixmap)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    for color, width in ((QColor("#FFFFFF"), 4.0), (QColor("#1F2430"), 1.75)):
        pen = QPen(color, width)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
        painter.strokePath(path, pen)
    painter.end()
    return pixmap
