"""Items drawn with a QPainter: what windows and pictures have in common.

The painter's own transformation is only that of the device's pixels; the camera has turned
everything into logical pixels before.
"""

from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, lru_cache, singledispatch
from itertools import groupby

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QFont, QFontMetricsF, QPaintDevice, QPainter, QPen

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera
from plusedit.scene.captions import clear_of_legends, placed_caption
from plusedit.scene.clipping import (
    Box,
    clipped_polygon,
    clipped_polyline,
    clipped_segments,
    reaches_beyond,
)
from plusedit.scene.items import (
    Caption,
    Item,
    Label,
    Legend,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.legends import placed
from plusedit.scene.theme import Theme
from plusedit.views.arrays import polygon_of

BEYOND = 2000.0  # pixels around the view within which lines are drawn as they are
THIN = 1.0  # pixels; Qt has a quick way of its own for lines up to that
SHARPEST = 4.0  # widths that the tip of a corner may stand out by
DASHES = {"dash": [6.0, 4.0], "dot": [2.0, 3.0]}  # pixels


@contextmanager
def painting(device: QPaintDevice) -> Iterator[QPainter]:
    """A painter on a device for as long as the block lasts.

    It ends whatever is raised in there: a widget whose painter outlives its paint event takes the
    program down with it.
    """
    painter = QPainter(device)
    try:
        yield painter
    finally:
        painter.end()


@dataclass(frozen=True, eq=False)
class ItemPainter:
    """Draws items as one camera sees them, in the colors of one theme."""

    painter: QPainter
    camera: Camera
    theme: Theme
    draft: bool = False
    """whether to save time where only a still picture would show it"""

    def paint(self, items: Iterable[Item]) -> None:
        """Draw the items, the first one farthest back."""
        self.painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        items = clear_of_legends(items, self.camera.size)
        for is_solid, group in groupby(items, lambda item: isinstance(item, Patch | Mesh)):
            if is_solid:
                self._solids([item for item in group if isinstance(item, Patch | Mesh)])
                continue
            for item in group:
                _draw(item, self)

    def _solids(self, items: list[Patch | Mesh]) -> None:
        """Surfaces, together: one may lie in front of a part of another."""
        from plusedit.views.shaded import draw_patches

        draw_patches(items, self)

    def pen(self, role: str, width: float, dash: str = "solid") -> None:
        """Draw lines like that from now on."""
        self.painter.setPen(pen_of(self.theme.color(role), width, dash))

    @cached_property
    def box(self) -> Box:
        """What is near enough to be drawn as it is, in pixels."""
        return np.full(2, -BEYOND), np.array(self.camera.size) + BEYOND

    def segments(self, starts: Floats, ends: Floats) -> None:
        """Separate segments between pixels (m, 2) and (m, 2)."""
        if len(starts):
            pairs = polygon_of(np.stack([starts, ends], axis=1).reshape(-1, 2))
            self.painter.drawLines(pairs.data(), len(starts))

    def circles(self, screen: Floats, size: float, color: str) -> None:
        """Filled circles at pixels (m, 2): points drawn with a wide pen."""
        pen = QPen(color_of(color), size)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        self.painter.setPen(pen)
        self.painter.drawPoints(polygon_of(screen))

    def squares(self, screen: Floats, size: float, color: str) -> None:
        """Filled squares at pixels (m, 2). Points with square caps would be nothing in a PDF."""
        self.painter.setPen(Qt.PenStyle.NoPen)
        self.painter.setBrush(color_of(color))
        corners = (screen - size / 2.0).tolist()
        self.painter.drawRects([QRectF(x, y, size, size) for x, y in corners])
        self.painter.setBrush(Qt.BrushStyle.NoBrush)

    def outlines(self, screen: Floats, item: Markers, fill: str | None) -> None:
        """Rings or diamonds at pixels (m, 2), one by one."""
        radius = (item.size - item.width) / 2.0
        self.pen(item.outline, item.width)
        if fill is not None:
            self.painter.setBrush(color_of(fill))
        for at in screen:
            if item.mark == "ring":
                self.painter.drawEllipse(QPointF(*at), radius, radius)
            else:
                self.painter.drawPolygon(polygon_of(at + radius * _DIAMOND))
        self.painter.setBrush(Qt.BrushStyle.NoBrush)


@singledispatch
def _draw(item: Item, to: ItemPainter) -> None:
    raise TypeError(f"the painter draws no {type(item).__name__}")


@_draw.register
def _(item: Polyline, to: ItemPainter) -> None:
    screen = to.camera.to_screen(item.points)
    pieces = clipped_polyline(screen, to.box) if reaches_beyond(screen, to.box) else [screen]
    to.pen(item.color, item.width, item.dash)
    # Chords on their own, without joins, take a quarter of the time.
    alone = to.draft and item.width > THIN and item.dash == "solid"
    if alone:
        to.painter.setPen(_with_flat_ends(to.painter.pen()))
    for piece in pieces:
        if alone:
            to.segments(piece[:-1], piece[1:])
        else:
            to.painter.drawPolyline(polygon_of(piece))


@_draw.register
def _(item: Polygon, to: ItemPainter) -> None:
    screen = to.camera.to_screen(item.points)
    if reaches_beyond(screen, to.box):
        screen = clipped_polygon(screen, to.box)
    if item.outline is None:
        to.painter.setPen(Qt.PenStyle.NoPen)
    else:
        to.pen(item.outline, item.width)
    to.painter.setBrush(color_of(to.theme.color(item.fill)))
    to.painter.drawPolygon(polygon_of(screen))
    to.painter.setBrush(Qt.BrushStyle.NoBrush)


@_draw.register
def _(item: Segments, to: ItemPainter) -> None:
    if not len(item.starts):
        return
    starts, ends = to.camera.to_screen(item.starts), to.camera.to_screen(item.ends)
    if reaches_beyond(starts, to.box) or reaches_beyond(ends, to.box):
        starts, ends = clipped_segments(starts, ends, to.box)
    to.pen(item.color, item.width, item.dash)
    to.segments(starts, ends)


@_draw.register
def _(item: Markers, to: ItemPainter) -> None:
    screen = to.camera.to_screen(item.points)
    low, high = to.box
    screen = screen[((screen >= low) & (screen <= high)).all(axis=1)]
    if not len(screen):
        return
    outline = to.theme.color(item.outline)
    fill = to.theme.color("canvas" if item.fill is None else item.fill)
    match item.mark:
        case "circle" | "square":
            spots = to.circles if item.mark == "circle" else to.squares
            spots(screen, item.size, outline)
            if fill != outline:
                spots(screen, item.size - 2.0 * item.width, fill)
        case "ring":
            to.outlines(screen, item, None)
        case "diamond":
            to.outlines(screen, item, fill)
        case "cross":
            arm = np.full(2, item.size / 2.0)
            across = arm * (1.0, -1.0)
            to.pen(item.outline, item.width)
            to.segments(screen - arm, screen + arm)
            to.segments(screen - across, screen + across)


@_draw.register
def _(item: Label, to: ItemPainter) -> None:
    at = to.camera.to_screen(item.at[None])[0] + item.offset
    low, high = to.box
    if not ((at >= low) & (at <= high)).all():
        return
    font = font_of(item.size)
    width = QFontMetricsF(font).horizontalAdvance(item.text)
    shift = {"left": 0.0, "center": width / 2.0, "right": width}[item.anchor]
    to.painter.setFont(font)
    to.painter.setPen(color_of(to.theme.color(item.color)))
    to.painter.drawText(QPointF(at[0] - shift, at[1]), item.text)


@_draw.register
def _(item: Legend, to: ItemPainter) -> None:
    from plusedit.views.legend import paint_legend

    legend = placed(item, to.camera.size)
    if legend is not None:
        paint_legend(to.painter, legend, to.theme)


@_draw.register
def _(item: Caption, to: ItemPainter) -> None:
    from plusedit.views.legend import paint_caption

    caption = placed_caption(item, to.camera.size)
    if caption is not None:
        paint_caption(to.painter, caption, to.theme)


_DIAMOND = np.array([[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]])


@lru_cache(maxsize=256)
def color_of(color: str) -> QColor:
    """The color "#rrggbb" or "#rrggbbaa"; Qt itself would read the latter as "#aarrggbb"."""
    made = QColor(color[:7])
    if len(color) == 9:
        made.setAlpha(int(color[7:], 16))
    return made


@lru_cache(maxsize=256)
def pen_of(color: str, width: float, dash: str) -> QPen:
    """A pen of that many logical pixels; dashes are in pixels, too."""
    pen = QPen(color_of(color), width)
    # Round joins take half as long again, and between the short chords of a curve nobody sees them.
    pen.setJoinStyle(Qt.PenJoinStyle.MiterJoin)
    pen.setMiterLimit(SHARPEST)
    pen.setCapStyle(Qt.PenCapStyle.RoundCap if dash == "solid" else Qt.PenCapStyle.FlatCap)
    if dash != "solid":
        pen.setDashPattern([length / max(width, 1.0) for length in DASHES[dash]])
    return pen


def _with_flat_ends(pen: QPen) -> QPen:
    flat = QPen(pen)
    flat.setCapStyle(Qt.PenCapStyle.FlatCap)
    return flat


@lru_cache(maxsize=16)
def font_of(size: float) -> QFont:
    """The program's font, that many pixels high."""
    font = QFont()
    font.setPixelSize(round(size))
    return font
