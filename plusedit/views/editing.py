"""What the views of the plane and of space have in common in editing the design of a session.

They decide nothing about the design. Mouse and keys become pointers and names for `Gestures`;
what comes back is drawn.
"""

from collections.abc import Callable, Collection
from dataclasses import replace

from PySide6.QtCore import QEvent, QPoint, QPointF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QContextMenuEvent, QFocusEvent, QKeyEvent, QMouseEvent, QWheelEvent

from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.spotting import Spot, mark_items
from plusedit.interaction.tool import Feedback, Held, Pointer
from plusedit.scene.drawn_mesh import looks_alike
from plusedit.scene.items import Item
from plusedit.scene.options import ViewOptions
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.navigation import C
from plusedit.views.pointer import held_after, key_of, pointer_of
from plusedit.views.settings_strip import SettingsStrip
from plusedit.views.spots import Spots
from plusedit.views.wayfinding import NOTCH, Wayfinding

MARGIN = 48.0  # pixels around what is framed
RESTS_AFTER = 120  # milliseconds without an edit or a move of the view


class Editing(Wayfinding[C]):
    """A view that shows a session and edits it through gestures."""

    pointer_left = Signal()
    context_menu_requested = Signal(QPoint)
    """a place in the view, for the menu of what lies there"""
    setting_changed = Signal(str, float)
    """a number of an overlay, by "overlay.setting" """

    def _begin_editing(self, session: Session, gestures: Gestures) -> None:
        """To be called once the widget is made and finds its way."""
        self._session, self._gestures = session, gestures
        self._options, self._theme = ViewOptions(), LIGHT
        self._feedback = Feedback()
        self._pointer: Pointer | None = None
        self._frame_at_first = True
        self._is_moving = False
        """whether the view is on its way elsewhere, and drawing all takes long"""
        self._spots = Spots()
        self._mark: Spot | None = None
        self._is_resting = True
        """whether neither the view nor the design has changed for a moment"""
        self._rest = QTimer(self, singleShot=True, interval=RESTS_AFTER)
        self._rest.timeout.connect(self._at_rest)
        self._strip = SettingsStrip(self, self._strip_corners)
        self._strip.changed.connect(self.setting_changed)
        self.setMinimumSize(160, 120)
        deaf = [
            self._session.changed.listen(self._edited),
            self._session.selected.listen(lambda old, new: self._selected()),
            self._gestures.feedback.listen(self._told),
            self._gestures.panned.listen(self.pan),
        ]
        # Not a method of the view: that would be gone by then.
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
        """What is shown besides the shapes."""
        return self._options

    def set_options(self, options: ViewOptions) -> None:
        """Show that besides the shapes."""
        self._options = self._gestures.options = options
        self._strip.show_options(options, self._session)
        self.update()

    @property
    def theme(self) -> Theme:
        """The colors of the drawing."""
        return self._theme

    def set_theme(self, theme: Theme) -> None:
        """Draw in those colors."""
        self._theme = theme
        self.update()

    def set_camera(self, camera: C) -> None:
        self._frame_at_first = False
        super().set_camera(camera)

    def frame_all(self) -> None:
        """See the whole design."""
        self._frame(None)

    def frame_at_next_paint(self) -> None:
        """See the whole design, in the size that the view has by then."""
        self._frame_at_first = True
        self.update()

    def frame_selected(self) -> None:
        """See the selected shapes, or the whole design if there are none."""
        self._frame(self._session.selection.shapes or None)

    def redraw(self) -> None:
        """Draw the same design anew: more of it is known."""
        self.update()

    def redraw_meshes(self) -> None:
        """Draw the same design anew: more is known of surfaces of meshes."""
        self.update()

    def show_mark(self, spot: Spot | None) -> None:
        """Mark a place of a shape that is pointed at elsewhere, or none."""
        if spot != self._mark:
            self._mark = spot
            self.update()

    def may_navigate(self) -> bool:
        return not self._gestures.is_busy

    # What a view says

    @property
    def _is_slow(self) -> bool:
        """Whether drawing everything took too long to be done in every frame."""
        raise NotImplementedError

    def _framing(self, shapes: Collection[ShapeId] | None) -> C:
        """The camera that sees those shapes."""
        raise NotImplementedError

    def _tell_pointer(self, at: Pointer) -> None:
        """Say where in the world the pointer is."""
        raise NotImplementedError

    def _show_feedback(self) -> None:
        """Draw what the tool shows now."""
        self.update()

    def _strip_corners(self, size: QSize) -> tuple[QPoint, ...]:
        """Where numbers of overlays may lie, so many pixels wide and high; the best place first."""
        raise NotImplementedError

    def _spotted(self) -> tuple[Item, ...]:
        """What overlays show at the point under the pointer."""
        stage = replace(self._gestures.stage(), design=self._session.design, camera=self.camera)
        at = None if self.is_panned else self._pointer
        items = self._spots.items(at, stage, is_busy=self._gestures.is_busy)
        return items if self._mark is None else (*items, *mark_items(self._mark, stage))

    def _at_rest(self) -> None:
        """There is time to draw all as well as can be, and to look what is under the pointer."""
        self._is_moving, self._is_resting = False, True
        self.update()
        if self._pointer is not None and not self._gestures.is_busy and not self.is_panned:
            self._gestures.move(self._pointer)

    def _edited(self, old: Design, new: Design) -> None:
        self._is_resting = False
        self._rest.start()
        self._strip.show_design(self._options, self._session)
        if not looks_alike(old, new):
            self.update()

    def _selected(self) -> None:
        self._strip.show_design(self._options, self._session)
        self.update()

    def _told(self, feedback: Feedback) -> None:
        self._feedback = feedback
        self.show_cursor(feedback.cursor)
        self._show_feedback()

    def _camera_moved(self) -> None:
        self._gestures.camera = self.camera
        self._gestures.grid_step = self.grid_step
        self._is_moving, self._is_resting = self._is_slow, False
        self._rest.start()
        super()._camera_moved()

    def _frame(self, shapes: Collection[ShapeId] | None) -> None:
        if self.isVisible():
            self._navigation.glide(self._framing(shapes))
        else:
            self._frame_at_first = True

    def _frame_first(self) -> None:
        """To be called before the first frame; until then the size may have changed many times."""
        if self._frame_at_first:
            self._navigation.go(self._framing(None))
            self._frame_at_first = False

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

    def wheelEvent(self, event: QWheelEvent) -> None:
        turned = event.angleDelta()
        if self._gestures.wheel((turned.y() or turned.x()) / NOTCH):
            event.accept()
        else:
            super().wheelEvent(event)

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
        self._tell_pointer(at)
        return at


def _call_all(functions: list[Callable[[], None]]) -> None:
    while functions:
        functions.pop()()
