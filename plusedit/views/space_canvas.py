"""The 3D view: a canvas that draws the design of a session and forwards what is done to it."""

from collections.abc import Collection
from time import perf_counter
from typing import Any

import numpy as np
from pyqtgraph.opengl.GLGraphicsItem import GLGraphicsItem
from PySide6.QtCore import QPoint, QPointF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QResizeEvent
from PySide6.QtWidgets import QWidget

from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.row_products import load_kernels_in_background
from plusedit.interaction.facets import point_of, surfaces_under
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.picking import under
from plusedit.interaction.tool import Pointer
from plusedit.scene.captions import boxes_of
from plusedit.scene.items import Caption
from plusedit.scene.legends import AXES
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_framing import framed_in_space
from plusedit.scene.space_scene import SpaceLayers, space_items
from plusedit.scene.stripes import stripes_of
from plusedit.views.editing import MARGIN, Editing
from plusedit.views.gl.artist import Look, SpaceArtist
from plusedit.views.gl.context import current_functions
from plusedit.views.gl.functions import Functions, OpenGLError
from plusedit.views.gl.half_size import HalfSize
from plusedit.views.gl.tripod import axis_under
from plusedit.views.opengl import is_software
from plusedit.views.pointer import pointer_of
from plusedit.views.settings_strip import EDGE
from plusedit.views.space_overlay import Sheet, SpaceOverlay
from plusedit.views.space_view import SpaceView

SLOW = 0.030  # seconds, for a frame
FARTHEST = 1e3  # heights of the view up to which the ground is where the pointer is


class SpaceCanvas(Editing[SpaceCamera], SpaceView):
    """Shows the shapes of a session in space, and edits them through gestures."""

    pointer_moved = Signal(float, float, float)
    """coordinates of what is under the pointer: of a surface, or else of the ground"""

    def __init__(self, session: Session, gestures: Gestures, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._drawn: _Drawn | None = None
        self._problem = ""
        """why nothing can be drawn"""
        self._seconds = 0.0
        self._hovered: str | None = None
        """the view that a click on the axes would ask for"""
        self._layers = SpaceLayers()
        self._begin_editing(session, gestures)
        self._overlay = SpaceOverlay(self)
        self.addItem(_Drawing(self))
        self.setAccessibleName("Drawing in space")
        self.setAccessibleDescription("The shapes of the design and their control lines and planes")

    # What it shows

    def initializeGL(self) -> None:
        # In another window the widget gets another context, and this is called again.
        self.context().aboutToBeDestroyed.connect(self._forget_context)

    def paintGL(self) -> None:
        self._frame_first()
        for item in self.items:
            item.paint()
        self._refresh_overlay()

    def draw(self) -> None:
        """Draw the design into the current context."""
        if self._problem:
            return
        start = perf_counter()
        is_edited = self._session.is_previewing and not self._is_resting
        is_draft = self._is_moving or (self._is_slow and is_edited)
        self._layers = space_items(
            self._session.design,
            self.camera,
            self._options,
            self._session.selection,
            draft=is_draft,
            wait=False,
            hurried=is_edited,
        )
        try:
            self._draw_layers(is_draft)
        except OpenGLError as error:
            self._problem = str(error)
        if not is_draft:
            self._seconds = perf_counter() - start
            if self._layers.solids:
                load_kernels_in_background()

    def _draw_layers(self, is_draft: bool) -> None:
        drawn = self._drawn = self._drawn or _Drawn(current_functions())
        look = Look(
            ground=self._options.ground,
            axes=True,
            hovered=self._hovered,
            shading=self._options.shading,
            stripes=stripes_of(self._options),
        )
        ratio = self.devicePixelRatioF()

        def paint(ratio: float) -> None:
            theme = self._theme.legible()
            drawn.artist.paint(self._layers, self.camera, theme, look, ratio=ratio)

        if not is_software():
            paint(ratio)
            return
        if is_draft:
            size = round(self.width() * ratio), round(self.height() * ratio)
            drawn.half_size.draw(lambda: paint(ratio / 2.0), *size)
        else:
            paint(ratio)
        # Else the time it takes would be counted as somebody else's.
        drawn.gl.Finish()

    def _forget_context(self) -> None:
        if self._drawn is not None:
            self.makeCurrent()
            self._drawn.artist.release()
            self._drawn.half_size.release()
            self.doneCurrent()
        self._drawn = None

    def update(self, *region: Any) -> None:
        super().update(*region)
        self._show_feedback()

    def _show_feedback(self) -> None:
        if hasattr(self, "_overlay"):
            self._refresh_overlay()
            self._overlay.update()

    def _refresh_overlay(self) -> None:
        design, spotted = self._session.design, self._spotted()
        captions = [item for item in spotted if isinstance(item, Caption)]
        self._strip.keep_clear_of(boxes_of(self._layers.words(captions), self.camera.size))
        self._overlay.sheet = Sheet(
            self.camera,
            self._theme,
            self._layers,
            spotted,
            self._feedback,
            self._pointer,
            self._problem,
            is_empty=not len(design) and not self._feedback.items,
        )

    def _strip_corners(self, size: QSize) -> tuple[QPoint, ...]:
        below_axes = QPoint(self.width() - size.width() - EDGE, int(AXES))
        if EDGE + size.width() > self.width() - AXES:
            return (below_axes,)
        return below_axes, QPoint(EDGE, EDGE)

    @property
    def _is_slow(self) -> bool:
        return self._seconds > SLOW

    def _framing(self, shapes: Collection[ShapeId] | None) -> SpaceCamera:
        seen = self._navigation.target
        return framed_in_space(
            self._session.design, seen, self._options, only=shapes, margin=MARGIN
        )

    # Where the pointer is

    def point_at(self, at: QPointF) -> Floats:
        """(3,) what of the world zooming keeps under a pixel: a surface, if there is one."""
        surface = self._on_surface(at)
        return super().point_at(at) if surface is None else surface

    def _on_surface(self, at: QPointF) -> Floats | None:
        stage = self._gestures.stage()
        for hit in surfaces_under(np.array([at.x(), at.y()]), stage):
            if hit.kind != "surface":
                return point_of(hit, np.array([at.x(), at.y()]), self.camera)
            surface = stage.design.surface(hit.shape)
            found: Floats = surface.derivatives_at([[hit.u, hit.v]], highest=0)[0][0]
            return found
        return None

    def _tell_pointer(self, at: Pointer) -> None:
        point = self._on_surface(QPointF(at.x, at.y))
        if point is None:
            camera = self.camera
            point = camera.on_plane(at.at, np.zeros(3), np.array([0.0, 0.0, 1.0]))
            far = FARTHEST * camera.height
            if point is None or np.abs(point - np.array(camera.target)).max() > far:
                point = super().point_at(QPointF(at.x, at.y))
        x, y, z = point.tolist()
        self.pointer_moved.emit(x, y, z)

    def _axis_at(self, at: QPointF) -> str | None:
        return axis_under(np.array([at.x(), at.y()]), self.camera)

    # How the view follows the mouse

    def _taken(self, event: QMouseEvent) -> str:
        if event.button() == Qt.MouseButton.LeftButton and not self._space_held:
            if self._axis_at(event.position()) is not None:
                return "axes"
            if event.modifiers() & Qt.KeyboardModifier.AltModifier and self._is_free(event):
                return "turn"
        return super()._taken(event)

    def _is_free(self, event: QMouseEvent) -> bool:
        """Whether nothing lies there that Alt means something else for."""
        hit = under(pointer_of(event).at, self._gestures.stage())
        return hit is None or hit.kind in ("surface", "mesh", "face")

    def _follow(self, hold: str, by: QPointF, event: QMouseEvent) -> None:
        super()._follow("orbit" if hold in ("axes", "turn") else hold, by, event)

    # What Qt tells

    def resizeEvent(self, event: QResizeEvent) -> None:
        self._overlay.setGeometry(self.rect())
        is_first = self._frame_at_first
        super().resizeEvent(event)
        # Qt draws at once with every size on the way to the first that is seen.
        self._frame_at_first = is_first

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        hovered = None if self._gestures.is_busy else self._axis_at(event.position())
        if hovered != self._hovered:
            self._hovered = hovered
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        held = "" if self._has_moved else self._hold
        super().mouseReleaseEvent(event)
        if held == "axes":
            name = self._axis_at(event.position())
            if name is not None:
                self.look_from(name)
        elif held == "turn":
            # It was a click after all, which has a meaning of its own with Alt.
            self._gestures.press(pointer_of(event))
            self._gestures.release(pointer_of(event))


class _Drawing(GLGraphicsItem):  # type: ignore[misc]
    """The design among the items of the view."""

    def __init__(self, canvas: SpaceCanvas) -> None:
        super().__init__()
        self._canvas = canvas

    def paint(self) -> None:
        self._canvas.draw()


class _Drawn:
    """What belongs to one context of OpenGL."""

    def __init__(self, gl: Functions) -> None:
        self.gl = gl
        self.artist = SpaceArtist(gl)
        self.half_size = HalfSize(gl)
