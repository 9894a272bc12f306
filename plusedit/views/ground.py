"""What a plane canvas shows behind and around the drawing: the grid, its axes, the rulers."""

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt
from PySide6.QtGui import QPainter, QPolygonF

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.graduation import Graduation, graduation
from plusedit.scene.theme import Theme
from plusedit.views.painter import color_of, font_of, pen_of

RULER = 22.0  # pixels, the width of both rulers
NUMBERS = 10.0  # pixels, the height of their font
TICKS = (9.0, 4.0)  # pixels, major and minor
MARK = 4.0  # half the width of the pointer's mark on a ruler
AXES = {0: "x", 1: "y", 2: "z"}


def paint_grid(painter: QPainter, camera: PlaneCamera, theme: Theme) -> None:
    """Minor lines, major lines and the two axes, each a crisp pixel wide."""
    marks = graduation(camera.pixel)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    by_strength: list[list[tuple[int, Floats]]] = [[], []]
    for side in (0, 1):
        majors, minors = marks.between(*_range(camera, side))
        by_strength[0].append((side, minors))
        by_strength[1].append((side, majors))
    colors = (f"minor@{round(100 * marks.strength)}", "major")
    for color, groups in zip(colors, by_strength, strict=True):
        for side, lines in groups:
            _lines(painter, camera, side, lines, theme.color(color))
    for side in (0, 1):
        across = camera.axes[1 - side]
        _lines(painter, camera, side, np.zeros(1), theme.color(f"{AXES[across]}@45"))


def paint_rulers(painter: QPainter, camera: PlaneCamera, theme: Theme) -> None:
    """A ruler along the top, one along the left."""
    width, height = camera.size
    marks = graduation(camera.pixel)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing, False)
    panel = color_of(theme.color("panel"))
    painter.fillRect(QRectF(0.0, 0.0, width, RULER), panel)
    painter.fillRect(QRectF(0.0, 0.0, RULER, height), panel)
    painter.save()
    painter.setClipRect(QRectF(RULER, 0.0, width - RULER, RULER))
    _ruler(painter, camera, theme, marks, 0)
    painter.setClipRect(QRectF(0.0, RULER, RULER, height - RULER))
    _ruler(painter, camera, theme, marks, 1)
    painter.restore()
    painter.fillRect(QRectF(0.0, 0.0, RULER, RULER), panel)
    painter.setPen(pen_of(theme.color("border"), 1.0, "solid"))
    painter.drawLine(QLineF(0.0, RULER - 0.5, width, RULER - 0.5))
    painter.drawLine(QLineF(RULER - 0.5, 0.0, RULER - 0.5, height))


def paint_marks(painter: QPainter, x: float, y: float, theme: Theme) -> None:
    """Where the pointer is, on both rulers."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(color_of(theme.color("accent")))
    if x > RULER:
        corners = [(x - MARK, RULER - MARK), (x + MARK, RULER - MARK), (x, RULER)]
        painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
    if y > RULER:
        corners = [(RULER - MARK, y - MARK), (RULER - MARK, y + MARK), (RULER, y)]
        painter.drawPolygon(QPolygonF([QPointF(*corner) for corner in corners]))
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _range(camera: PlaneCamera, side: int) -> tuple[float, float]:
    low, high = camera.window
    return float(low[side]), float(high[side])


def _pixels(camera: PlaneCamera, side: int, lines: Floats) -> Floats:
    """Pixels to the right (side 0) or downwards (side 1) of coordinates."""
    offset = (lines - camera.center[side]) * (camera.scale, -camera.scale)[side]
    pixels: Floats = offset + camera.size[side] / 2.0
    return pixels


def _lines(painter: QPainter, camera: PlaneCamera, side: int, lines: Floats, color: str) -> None:
    """Upright lines for side 0, level ones for side 1; filled boxes, as they have no soft edges."""
    width, height = camera.size
    fill = color_of(color)
    hair = 1.0 / painter.device().devicePixelRatio()
    for pixel in _pixels(camera, side, lines).tolist():
        at = round(pixel / hair) * hair
        box = QRectF(at, 0.0, hair, height) if side == 0 else QRectF(0.0, at, width, hair)
        painter.fillRect(box, fill)


def _ruler(
    painter: QPainter, camera: PlaneCamera, theme: Theme, marks: Graduation, side: int
) -> None:
    majors, minors = marks.between(*_range(camera, side))
    for lines, length, color in (
        (minors, TICKS[1], f"quiet@{round(60 * marks.strength)}"),
        (majors, TICKS[0], "quiet@80"),
    ):
        fill = color_of(theme.color(color))
        hair = 1.0 / painter.device().devicePixelRatio()
        for pixel in _pixels(camera, side, lines).tolist():
            at = round(pixel / hair) * hair
            start = RULER - 1.0 - length
            upright = QRectF(at, start, hair, length)
            painter.fillRect(upright if side == 0 else QRectF(start, at, length, hair), fill)
    painter.setFont(font_of(NUMBERS))
    painter.setPen(color_of(theme.color("quiet")))
    for value, pixel in zip(majors.tolist(), _pixels(camera, side, majors).tolist(), strict=True):
        _number(painter, marks.text(value), pixel, side, camera.size[side])


def _number(painter: QPainter, text: str, pixel: float, side: int, length: float) -> None:
    """A number right of its tick, or above it and turned to be read upwards.

    Left out where an end of the ruler would cut it.
    """
    width = painter.fontMetrics().horizontalAdvance(text)
    start, end = (pixel + 4.0, pixel + 4.0 + width) if side == 0 else (pixel - 4.0 - width, pixel)
    if start < RULER or end > length:
        return
    painter.save()
    if side == 0:
        painter.drawText(QPointF(start, 10.0), text)
    else:
        painter.translate(10.0, pixel - 4.0)
        painter.rotate(-90.0)
        painter.drawText(QPointF(0.0, 0.0), text)
    painter.restore()
