"""What the views of the plane and of space have in common in finding one's way about.

The wheel and pinching zoom at the pointer; the middle button, Space and drag, and two fingers take
hold of the view. What such a hold does is said by the view.
"""

from typing import TYPE_CHECKING, Generic

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QKeyEvent,
    QMouseEvent,
    QNativeGestureEvent,
    QResizeEvent,
    QWheelEvent,
)
from PySide6.QtWidgets import QWidget

from plusedit.scene.graduation import graduation
from plusedit.views.cursors import cursor_of
from plusedit.views.navigation import C, Navigation

ZOOM_STEP = 1.2  # for one notch of the wheel
NOTCH = 120.0  # in Qt's eighths of a degree

if TYPE_CHECKING:
    Base = QWidget
else:

    class Base:
        """Nothing: the widget itself, which may be one of OpenGL, is inherited beside."""


class Wayfinding(Base, Generic[C]):
    """A widget whose camera follows the mouse; to be inherited beside a kind of QWidget."""

    camera_changed = Signal()

    def _begin_wayfinding(self, navigation: Navigation[C]) -> None:
        """To be called once the widget is made."""
        self._navigation = navigation
        self._navigation.changed.connect(self._camera_moved)
        self._hold = ""
        """what the mouse does to the view just now, such as "pan"; empty if it holds nothing"""
        self._held_at = QPointF()
        self._space_held = False
        self._tool_cursor = "arrow"
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)

    @property
    def camera(self) -> C:
        """What is seen now."""
        return self._navigation.camera

    @property
    def grid_step(self) -> float:
        """The distance of the lines of the grid, once the view has come to rest."""
        return graduation(self._navigation.target.pixel).minor

    @property
    def is_panned(self) -> bool:
        """Whether the mouse moves the view just now."""
        return bool(self._hold)

    @property
    def is_animated(self) -> bool:
        """Whether the view glides from one camera to the next."""
        return self._navigation.is_animated

    @is_animated.setter
    def is_animated(self, animated: bool) -> None:
        self._navigation.is_animated = animated

    def set_camera(self, camera: C) -> None:
        """See that, in the size that the view has."""
        width, height = self.camera.size
        self._navigation.go(camera)
        self._navigation.resize(width, height)

    def pan(self, right: float, down: float) -> None:
        """Shift what is seen by that many pixels."""
        self._navigation.go(self.camera.panned((right, down)))

    def zoom(self, factor: float) -> None:
        """Nearer by that factor, at the middle of the view."""
        width, height = self.camera.size
        middle = QPointF(width / 2.0, height / 2.0)
        self._navigation.glide(self._zoomed(self._navigation.target, middle, factor))

    def may_navigate(self) -> bool:
        """Whether the view may move now; not in the midst of a drag, which would lose its hold."""
        return True

    def show_cursor(self, name: str) -> None:
        """The mouse pointer to show while the mouse does not hold the view."""
        self._tool_cursor = name
        if self._hold:
            name = "grab"
        elif self._space_held:
            name = "hand"
        self.setCursor(cursor_of(name, self.devicePixelRatioF()))

    # What a view says

    def _zoomed(self, camera: C, at: QPointF, factor: float) -> C:
        """That camera nearer by that factor; what is under the pixel stays there."""
        raise NotImplementedError

    def _taken(self, event: QMouseEvent) -> str:
        """What a press takes hold of the view for; empty if it is for somebody else."""
        by_space = self._space_held and event.button() == Qt.MouseButton.LeftButton
        return "pan" if by_space or event.button() == Qt.MouseButton.MiddleButton else ""

    def _follow(self, hold: str, by: QPointF, event: QMouseEvent) -> None:
        """The mouse that holds the view moved by that many pixels."""
        self.pan(by.x(), by.y())

    def _camera_moved(self) -> None:
        self.camera_changed.emit()
        self.update()

    # What Qt tells

    def resizeEvent(self, event: QResizeEvent) -> None:
        size = event.size()
        self._navigation.resize(float(size.width()), float(size.height()))
        super().resizeEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.accept()
        if not self.may_navigate():
            return
        at, turned = event.position(), event.angleDelta()
        ctrl = bool(event.modifiers() & Qt.KeyboardModifier.ControlModifier)
        # A phase is told by touchpads alone: two fingers push the paper, a wheel has to zoom.
        if event.phase() != Qt.ScrollPhase.NoScrollPhase and not ctrl:
            by = event.pixelDelta()
            by = turned / 4 if by.isNull() else by
            self.pan(float(by.x()), float(by.y()))
            return
        # Alt turns the wheel sideways on some platforms.
        notches = (turned.y() or turned.x()) / NOTCH
        self._navigation.go(self._zoomed(self.camera, at, ZOOM_STEP**notches))

    def mousePressEvent(self, event: QMouseEvent) -> None:
        hold = self._taken(event) if self.may_navigate() else ""
        if hold:
            self._hold, self._held_at = hold, event.position()
            self.show_cursor(self._tool_cursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._hold:
            by = event.position() - self._held_at
            self._held_at = event.position()
            self._follow(self._hold, by, event)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._hold and event.button() in (
            Qt.MouseButton.MiddleButton,
            Qt.MouseButton.LeftButton,
        ):
            self._hold = ""
            self.show_cursor(self._tool_cursor)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and self.may_navigate():
            self._hold_space(True)
        else:
            super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Space and not event.isAutoRepeat():
            self._hold_space(False)
        else:
            super().keyReleaseEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._hold_space(False)
        super().focusOutEvent(event)

    def event(self, event: QEvent) -> bool:
        pinch = Qt.NativeGestureType.ZoomNativeGesture
        if isinstance(event, QNativeGestureEvent) and event.gestureType() == pinch:
            if self.may_navigate():
                factor = max(0.1, 1.0 + event.value())
                self._navigation.go(self._zoomed(self.camera, event.position(), factor))
            return True
        return super().event(event)

    def _hold_space(self, held: bool) -> None:
        if held != self._space_held:
            self._space_held = held
            self.show_cursor(self._tool_cursor)
