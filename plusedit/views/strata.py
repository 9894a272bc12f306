"""The layers of a plane view, and which of them stay as they are from frame to frame.

While a shape is edited everything else comes from one pixmap, so that a frame costs what that
shape costs, however many others there are.
"""

from collections.abc import Collection
from dataclasses import dataclass, replace
from time import perf_counter

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QPainter, QPixmap

from plusedit.document.design import Design, changed
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Caption, Legend
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import Layers, design_items, scene_items
from plusedit.scene.theme import Theme
from plusedit.views.ground import RULER, paint_grid, paint_rulers
from plusedit.views.painter import ItemPainter, color_of, painting

SLOW = 0.012  # seconds, for a frame
FEW = 4  # shapes that may be drawn anew in every frame after an edit


@dataclass(frozen=True)
class Look:
    """All but the design that decides what a view shows."""

    camera: PlaneCamera
    options: ViewOptions
    theme: Theme
    selection: Selection
    ratio: float
    """pixels of the device to a logical pixel"""
    draft: bool = False
    """whether the view is on its way elsewhere, and speed counts for more than smoothness"""


class Strata:
    """What is drawn, split into what moves and what does not."""

    def __init__(self) -> None:
        self._look: Look | None = None
        self._still = Design()
        """the design of which the pixmap shows all but the moving shapes"""
        self._moving: frozenset[ShapeId] = frozenset()
        self._last: Design | None = None
        """the design of the last frame"""
        self._pixmap = QPixmap()
        self._drawings: dict[ShapeId, MeshDrawing] = {}
        """the surfaces of meshes that the pixmap shows"""
        self._legends: tuple[Legend, ...] = ()
        self._captions: tuple[Caption, ...] = ()
        """those of what the pixmap shows"""
        self._seconds = 0.0

    @property
    def is_slow(self) -> bool:
        """Whether drawing everything took too long to be done in every frame."""
        return self._seconds > SLOW

    @property
    def is_apart(self) -> bool:
        """Whether some shapes are drawn in front of the rest, wherever their places are."""
        return bool(self._moving)

    def forget(self) -> None:
        """Draw everything anew in the next frame, each shape in its place."""
        self._look = None

    def refresh(self, design: Design) -> None:
        """More is known of surfaces of meshes: draw those anew of which that is so."""
        if self._look is not None and self._drawings != _drawings(design, self._drawings):
            self.forget()

    def paint(
        self, painter: QPainter, design: Design, look: Look, *, previewed: bool
    ) -> list[Legend | Caption]:
        """Draw the ground, all shapes and the rulers; what follows stays beside the rulers.

        `previewed` tells of an edit that is still going on. What is left to be written into the
        corners, in front of all else, comes back.
        """
        words: list[Legend | Caption] = [*self._legends, *self._captions]
        if look.draft and self._paint_shifted(painter, design, look):
            return words
        self._settle(design, look, previewed)
        painter.drawPixmap(0, 0, self._pixmap)
        painter.setClipRect(beside_rulers(look))
        words = [*self._legends, *self._captions]
        if self._moving:
            for layers in (
                design_items(design, look.camera, look.options, look.selection, hurried=previewed),
                # Without a glow what is dragged is seen better, and drawn in half the time.
                _layers(design, look, self._moving, glow=not previewed),
            ):
                _paint(painter, layers, look)
                words += [*layers.legends, *layers.captions]
        self._last = design
        return words

    def _paint_shifted(self, painter: QPainter, design: Design, look: Look) -> bool:
        """Draw the last picture where a view on its way has it now; False if it shows others.

        Where thousands of curves take a second to draw, panning and zooming go smoothly all the
        same; what was outside, and what has become coarse, follows once the view is at rest.
        """
        old = self._look
        if old is None or design is not self._still or self._moving:
            return False
        if replace(look, camera=old.camera, draft=old.draft) != old:
            return False
        if look.camera.size != old.camera.size or look.camera.projection != old.camera.projection:
            return False
        seen, beside = beside_rulers(old), beside_rulers(look)
        source = QRectF(seen.topLeft() * look.ratio, seen.size() * look.ratio)
        painter.fillRect(beside, color_of(look.theme.color("canvas")))
        if look.options.grid:
            paint_grid(painter, look.camera, look.theme)
        painter.setClipRect(beside)
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
        painter.drawPixmap(_followed(seen, old.camera, look.camera), self._pixmap, source)
        painter.setClipping(False)
        if look.options.rulers:
            paint_rulers(painter, look.camera, look.theme)
        painter.setClipRect(beside)
        return True

    def _settle(self, design: Design, look: Look, previewed: bool) -> None:
        """Draw what does not move anew, unless the pixmap still shows it."""
        since = changed(self._still, design) if design is not self._still else set()
        if look == self._look and since <= self._moving and not _reordered(self._still, design):
            return
        moving = set() if self._last is None else changed(self._last, design)
        moving |= self._moving if previewed else set()
        # What was opened or edited as a whole comes to rest at once; dragged, it moves on.
        self._moving = frozenset(moving if previewed or len(moving) <= FEW else ())
        self._look, self._still = look, design
        start = perf_counter()
        self._draw_still(design, look)
        if not look.draft:
            self._seconds = perf_counter() - start

    def _draw_still(self, design: Design, look: Look) -> None:
        self._pixmap = _new_pixmap(look)
        still = [shape_id for shape_id in design if shape_id not in self._moving]
        self._drawings = _drawings(design, still)
        with painting(self._pixmap) as painter:
            if look.options.grid:
                paint_grid(painter, look.camera, look.theme)
            layers = [_layers(design, look, still)]
            if not self._moving:
                # Else they are drawn with what moves: they may tell of it, too.
                whole = design_items(design, look.camera, look.options, look.selection)
                layers.insert(0, whole)
            for each in layers:
                _paint(painter, each, look)
            self._legends = tuple(legend for each in layers for legend in each.legends)
            self._captions = tuple(caption for each in layers for caption in each.captions)
            if look.options.rulers:
                paint_rulers(painter, look.camera, look.theme)


def _drawings(design: Design, shapes: Collection[ShapeId]) -> dict[ShapeId, MeshDrawing]:
    """How the meshes among those shapes are drawn by now."""
    return {i: drawing_of(mesh, wait=False) for i, mesh in design.meshes() if i in shapes}


def _followed(rect: QRectF, old: PlaneCamera, new: PlaneCamera) -> QRectF:
    """Where the new camera sees what the old one saw in `rect`."""
    corners = np.array([[rect.left(), rect.top()], [rect.right(), rect.bottom()]])
    (left, top), (right, bottom) = new.to_screen(new.placed(old.in_plane(corners)))
    return QRectF(left, top, right - left, bottom - top)


def beside_rulers(look: Look) -> QRectF:
    """The part of the view that the rulers leave free."""
    edge = RULER if look.options.rulers else 0.0
    width, height = look.camera.size
    return QRectF(edge, edge, width - edge, height - edge)


def _reordered(old: Design, new: Design) -> bool:
    """Whether shapes that both have lie in another order; nothing else counts here."""
    if len(old) != len(new) or old.shapes.keys() != new.shapes.keys():
        return False
    return list(old) != list(new)


def _new_pixmap(look: Look) -> QPixmap:
    width, height = look.camera.size
    pixmap = QPixmap(round(width * look.ratio), round(height * look.ratio))
    pixmap.setDevicePixelRatio(look.ratio)
    pixmap.fill(color_of(look.theme.color("canvas")))
    return pixmap


def _layers(
    design: Design, look: Look, shapes: Collection[ShapeId], *, glow: bool = True
) -> Layers:
    return scene_items(
        design,
        look.camera,
        look.options,
        look.selection,
        only=frozenset(shapes),
        glow=glow,
        wait=False,
    )


def _paint(painter: QPainter, layers: Layers, look: Look) -> None:
    """Draw all but legends and captions."""
    ItemPainter(painter, look.camera, look.theme, look.draft).paint(layers.drawing())
