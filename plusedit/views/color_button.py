"""A chip that shows the color of shapes and lets another be chosen."""

from collections.abc import Callable

from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPen, QPixmap
from PySide6.QtWidgets import QColorDialog, QMenu, QSizePolicy, QToolButton

SWATCHES = {
    "Green": "#12824A",
    "Teal": "#0E7C86",
    "Blue": "#2563EB",
    "Violet": "#7C3AED",
    "Magenta": "#B5379E",
    "Red": "#C8372D",
    "Orange": "#C2570C",
    "Ocher": "#9A6B00",
    "Gray": "#5B6472",
}
CHIP = 14  # logical pixels


def draw_chip(
    painter: QPainter,
    place: QRectF,
    color: QColor,
    *,
    hollow: bool = False,
    is_surface: bool = False,
) -> None:
    """A chip of a color, round for a curve, a sheet for a surface; hollow: the theme decides."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    # A rim, so that black is seen on a dark panel and white on a light one.
    rim = color if hollow else QColor(128, 136, 150)
    painter.setPen(QPen(rim, 1.5 if hollow else 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush if hollow else color)
    inside = place.adjusted(1, 1, -1, -1)
    if not is_surface:
        painter.drawEllipse(inside)
        return
    lean, low = inside.width() / 4.0, inside.height() / 6.0
    top, bottom = inside.top() + low, inside.bottom() - low
    left, right = inside.left(), inside.right()
    painter.drawPolygon(
        [
            QPointF(left + lean, top),
            QPointF(right, top),
            QPointF(right - lean, bottom),
            QPointF(left, bottom),
        ]
    )


def chip_icon(color: QColor | None, *, hollow: bool = False) -> QIcon:
    """A chip as an icon; a dashed ring for None, where colors differ."""
    pixmap = QPixmap(CHIP * 3, CHIP * 3)
    pixmap.setDevicePixelRatio(3)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    if color is None:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor("#888888"), 1.5, Qt.PenStyle.DotLine))
        painter.drawEllipse(QPointF(CHIP / 2, CHIP / 2), CHIP / 2 - 2, CHIP / 2 - 2)
    else:
        draw_chip(painter, QRectF(0, 0, CHIP, CHIP), color, hollow=hollow)
    painter.end()
    return QIcon(pixmap)


class ColorButton(QToolButton):
    """Shows a color; a click offers swatches, any other color, and the theme's own."""

    def __init__(self, apply: Callable[[str | None], str]) -> None:
        super().__init__()
        self._apply = apply
        self._color = QColor()
        self.setAccessibleName("color")
        self.setProperty("field", True)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setToolTip("Color of the shape")
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setIconSize(QSize(CHIP, CHIP))
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        menu = QMenu(self)
        menu.addAction("Theme’s color", lambda: self._apply(None))
        menu.addSeparator()
        for name, color in SWATCHES.items():
            menu.addAction(chip_icon(QColor(color)), name, lambda c=color: self._apply(c))
        menu.addSeparator()
        menu.addAction("Other…", self._ask)
        self.setMenu(menu)

    def show_color(self, colors: list[str | None], usual: str) -> None:
        """Show the one color of `colors`, None being the theme's `usual`, or that they differ."""
        first = colors[0]
        if any(color != first for color in colors):
            self.setIcon(chip_icon(None))
            self.setText("mixed")
            return
        self._color = QColor(first or usual)
        self.setIcon(chip_icon(self._color, hollow=first is None))
        self.setText(self._color.name().upper() if first else "Theme’s color")

    def _ask(self) -> None:
        color = QColorDialog.getColor(self._color, self, "Color of the shape")
        if color.isValid():
            self._apply(color.name())
