"""The 2D view: a canvas that draws the design of a session and forwards what is done to it.

It decides nothing about the design. Mouse and keys become pointers and names for `Gestures`;
what comes back is drawn.
"""

from collections.abc import Callable, Collection
from dataclasses import replace

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import (
    QContextMenuEvent,
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QPainter,
    QPaintEvent,
)
from PySide6.QtWidgets import QWidget

from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.tool import Feedback, Held, Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.framing import framed
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import left_out
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.ground import RULER, paint_marks
from plusedit.views.notices import paint_empty, paint_note, paint_readout
from plusedit.views.painter import ItemPainter, painting
from plusedit.views.plane_view import PlaneView
from plusedit.views.pointer import held_after, key_of, pointer_of
from plusedit.views.strata import Look, Strata, beside_rulers

MARGIN = 48.0  # pixels around what is framed
RESTS_AFTER = 120  # milliseconds without an edit or a move of the view


class PlaneCanvas(PlaneView):
    """Shows the curves of a session in a plane, and edits them through gestures."""

    pointer_moved = Signal(float, float)
    """coordinates of the pointer in the plane that is seen"""
    pointer_left = Signal()
    context_menu_requested = Signal(QPoint)
    """a place in the view, for the menu of what lies there"""

    def __init__(self, session: Session, gestures: Gestures, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._session, self._gestures = session, gestures
        self._options, self._theme = ViewOptions(), LIGHT
        self._feedback = Feedback()
        self._strata = Strata()
        self._pointer: Pointer | None = None
        self._frame_at_first = True
        self._is_moving = False
        """whether the view is on its way elsewhere, and drawing all takes long"""
        self._rest = QTimer(self, singleShot=True, interval=RESTS_AFTER)
        self._rest.timeout.connect(self._at_rest)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(160, 120)
        self.setAccessibleName("Drawing")
        self.setAccessibleDescription("The curves of the design and their control lines")
        self._listen()

    def _listen(self) -> None:
        deaf = [
            self._session.changed.listen(lambda old, new: self.update()),
            self._session.selected.listen(lambda old, new: self.update()),
            self._gestures.feedback.listen(self._told),
            self._gestures.panned.listen(self.pan),
        ]
        # Not a method of the canvas: that would be gone by then.
        self.destroyed.connect(lambda: _call_all(deaf))

    # What a window asks for

    @property
    def gestures(self) -> Gestures:
        """What the mouse and keys of this view go to."""
        return self._gestures

    @property
    def pointer(self) -> Pointer:
        """Where the pointer is; the middle of the view while it is elsewhere."""
        width, height = self.camera.size
        return self._pointer or Pointer(width / 2.0, height / 2.0)

    @property
    def options(self) -> ViewOptions:
        """What is shown besides the curves."""
        return self._options

    def set_options(self, options: ViewOptions) -> None:
        """Show that besides the curves."""
        self._options = self._gestures.options = options
        self.update()

    @property
    def theme(self) -> Theme:
        """The colors of the drawing."""
        return self._theme

    def set_theme(self, theme: Theme) -> None:
        """Draw in those colors."""
        self._theme = theme
        self.update()

    def set_camera(self, camera: PlaneCamera) -> None:
        self._frame_at_first = False
        super().set_camera(camera)

    def frame_all(self) -> None:
        """See the whole design."""
        self._frame(None)

    def frame_selected(self) -> None:
        """See the selected shapes, or the whole design if there are none."""
        self._frame(self._session.selection.shapes or None)

    def may_navigate(self) -> bool:
        return not self._gestures.is_busy

    # What it shows

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._frame_at_first:
            # Not before: until now the size may have changed many times.
            self._navigation.go(self._framing(None))
            self._frame_at_first = False
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
            self._strata.paint(painter, self._session.design, look, previewed=previewed)
            ItemPainter(painter, self.camera, self._theme).paint(self._feedback.items)
            self._paint_words(painter, beside_rulers(look))
        if self._strata.is_apart and not previewed and not self._rest.isActive():
            self._rest.start()

    def _paint_words(self, painter: QPainter, view: QRectF) -> None:
        design = self._session.design
        note = left_out(design)
        if not len(design) and not self._feedback.items:
            paint_empty(painter, view, self._theme)
        if note:
            paint_note(painter, view, note, self._theme)
        if self._pointer is not None:
            at = QPointF(self._pointer.x, self._pointer.y)
            if self._feedback.readout:
                paint_readout(painter, view, at, self._feedback.readout, self._theme)
            if self._options.rulers:
                painter.setClipping(False)
                paint_marks(painter, at.x(), at.y(), self._theme)

    def _told(self, feedback: Feedback) -> None:
        self._feedback = feedback
        self.show_cursor(feedback.cursor)
        self.update()

    def _at_rest(self) -> None:
        """There is time now to draw all as well as can be."""
        self._is_moving = False
        if not self._session.is_previewing:
            self._strata.forget()
        self.update()

    def _camera_moved(self) -> None:
        self._gestures.camera = self.camera
        self._gestures.grid_step = self.grid_step
        self._is_moving = self._strata.is_slow
        self._rest.start()
        super()._camera_moved()

    def _frame(self, shapes: Collection[ShapeId] | None) -> None:
        if self.isVisible():
            self._navigation.glide(self._framing(shapes))
        else:
            self._frame_at_first = True

    def _framing(self, shapes: Collection[ShapeId] | None) -> PlaneCamera:
        """The camera that sees those shapes beside the rulers."""
        seen = self._navigation.target
        edge = RULER if self._options.rulers else 0.0
        width, height = seen.size
        inner = replace(seen, size=(max(width - edge, 1.0), max(height - edge, 1.0)))
        found = framed(self._session.design, inner, self._options, only=shapes, margin=MARGIN)
        if found is inner:
            return seen
        return replace(found, size=seen.size).panned((edge / 2.0, edge / 2.0))

    # What Qt tells

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        at = self._noted(event)
        if self.is_panned:
            return
        if event.button() == Qt.MouseButton.LeftButton:
            self._gestures.press(at)
        elif event.button() == Qt.MouseButton.RightButton and not self._gestures.cancel():
            self.context_menu_requested.emit(event.position().toPoint())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        at = self._noted(event)
        if not self.is_panned:
            self._gestures.move(at)
        if self._options.rulers:
            self.update()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        was_panned = self.is_panned
        super().mouseReleaseEvent(event)
        at = self._noted(event)
        if event.button() == Qt.MouseButton.LeftButton and not was_panned:
            self._gestures.release(at)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        at = self._noted(event)
        if event.button() == Qt.MouseButton.LeftButton and not self._space_held:
            self._gestures.double_click(at)
        else:
            self.mousePressEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        # That of the mouse was asked for by the press, which may have ended a drag instead.
        if event.reason() != QContextMenuEvent.Reason.Mouse:
            self.context_menu_requested.emit(QPointF(self.pointer.x, self.pointer.y).toPoint())
        event.accept()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._pointer = None
        self._gestures.leave()
        self.pointer_left.emit()
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._gestures.hold(Held.NONE)
        super().focusOutEvent(event)

    def focusNextPrevChild(self, forward: bool) -> bool:
        # Tab goes through control lines and typed fields; Ctrl+Tab leaves the view.
        return False

    def event(self, event: QEvent) -> bool:
        # Without this a menu's shortcut would take the "X" that is meant for the drag.
        if event.type() == QEvent.Type.ShortcutOverride and isinstance(event, QKeyEvent):
            key = key_of(event)
            space = event.key() == Qt.Key.Key_Space
            if space or (key and self._gestures.takes(key, held_after(event, pressed=True))):
                event.accept()
                return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        held = held_after(event, pressed=True)
        self._gestures.hold(held)
        key = key_of(event)
        if key is None or not self._gestures.key(key, held):
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        self._gestures.hold(held_after(event, pressed=False))
        super().keyReleaseEvent(event)

    def _noted(self, event: QMouseEvent) -> Pointer:
        """The pointer of a mouse event, remembered and told."""
        self._pointer = at = pointer_of(event)
        x, y = self.camera.in_plane(at.at[None])[0]
        self.pointer_moved.emit(float(x), float(y))
        return at


def _call_all(functions: list[Callable[[], None]]) -> None:
    while functions:
        functions.pop()()
