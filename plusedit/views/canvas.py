"""The 2D view: a canvas that draws the design of a session and forwards what is done to it."""

from collections.abc import Collection
from dataclasses import replace

import numpy as np
from PySide6.QtCore import QPoint, QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QWidget

from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.tool import Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.captions import boxes_of, in_corners
from plusedit.scene.framing import framed
from plusedit.scene.items import Caption, Legend
from plusedit.views.editing import MARGIN, Editing
from plusedit.views.ground import RULER, paint_marks
from plusedit.views.notices import paint_empty, paint_readout
from plusedit.views.painter import ItemPainter, painting
from plusedit.views.plane_view import PlaneView
from plusedit.views.settings_strip import EDGE
from plusedit.views.strata import Look, Strata, beside_rulers


class PlaneCanvas(Editing[PlaneCamera], PlaneView):
    """Shows the shapes of a session in a plane, and edits them through gestures."""

    pointer_moved = Signal(float, float)
    """coordinates of the pointer in the plane that is seen"""

    def __init__(self, session: Session, gestures: Gestures, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._strata = Strata()
        self._begin_editing(session, gestures)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setAccessibleName("Drawing")
        self.setAccessibleDescription("The shapes of the design and their control lines and planes")

    # What it shows

    def paintEvent(self, event: QPaintEvent) -> None:
        self._frame_first()
        look = Look(
            self.camera,
            self._options,
            self._theme.legible(),
            self._session.selection,
            self.devicePixelRatioF(),
            draft=self._is_moving,
        )
        previewed = self._session.is_previewing
        with painting(self) as painter:
            words = self._strata.paint(painter, self._session.design, look, previewed=previewed)
            items = ItemPainter(painter, self.camera, self._theme.legible())
            spotted = self._spotted()
            items.paint(item for item in spotted if not isinstance(item, Legend | Caption))
            ItemPainter(painter, self.camera, self._theme).paint(self._feedback.items)
            words += [item for item in spotted if isinstance(item, Legend | Caption)]
            written = in_corners(words, RULER if self._options.rulers else 0.0)
            items.paint(written)
            self._strip.keep_clear_of(boxes_of(written, self.camera.size))
            self._paint_words(painter, beside_rulers(look))
        if self._strata.is_apart and not previewed and not self._rest.isActive():
            self._rest.start()

    def _paint_words(self, painter: QPainter, view: QRectF) -> None:
        design = self._session.design
        if not len(design) and not self._feedback.items:
            paint_empty(painter, view, self._theme)
        if self._pointer is not None:
            at = QPointF(self._pointer.x, self._pointer.y)
            if self._feedback.readout:
                paint_readout(painter, view, at, self._feedback.readout, self._theme)
            if self._options.rulers:
                painter.setClipping(False)
                paint_marks(painter, at.x(), at.y(), self._theme)

    def redraw(self) -> None:
        self._strata.forget()
        super().redraw()

    def redraw_meshes(self) -> None:
        self._strata.refresh(self._session.design)
        super().redraw_meshes()

    def _strip_corners(self, size: QSize) -> tuple[QPoint, ...]:
        edge = int(RULER) + EDGE if self._options.rulers else EDGE
        right = self.width() - size.width() - EDGE
        return QPoint(right, edge), QPoint(edge, edge), QPoint((edge + right) // 2, edge)

    @property
    def _is_slow(self) -> bool:
        return self._strata.is_slow

    def _at_rest(self) -> None:
        if not self._session.is_previewing:
            self._strata.forget()
        super()._at_rest()

    def _framing(self, shapes: Collection[ShapeId] | None) -> PlaneCamera:
        """The camera that sees those shapes beside the rulers."""
        seen: PlaneCamera = self._navigation.target
        edge = RULER if self._options.rulers else 0.0
        width, height = seen.size
        inner = replace(seen, size=(max(width - edge, 1.0), max(height - edge, 1.0)))
        found = framed(self._session.design, inner, self._options, only=shapes, margin=MARGIN)
        if found is inner:
            return seen
        return replace(found, size=seen.size).panned((edge / 2.0, edge / 2.0))

    def _tell_pointer(self, at: Pointer) -> None:
        x, y = self.camera.in_plane(np.array([[at.x, at.y]]))[0]
        self.pointer_moved.emit(float(x), float(y))

    # What Qt tells

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        if self._options.rulers:
            self.update()
