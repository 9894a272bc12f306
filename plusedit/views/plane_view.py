"""A view of a plane that can be panned and zoomed; what else a mouse does is for who inherits."""

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

from plusedit.scene.camera import PlaneCamera, Projection
from plusedit.scene.graduation import graduation
from plusedit.views.cursors import cursor_of
from plusedit.views.navigation import Navigation

ZOOM_STEP = 1.2  # for one notch of the wheel
NOTCH = 120.0  # in Qt's eighths of a degree


class PlaneView(QWidget):
    """Wheel and pinch zoom at the pointer; middle drag, Space and drag, and two fingers pan."""

    camera_changed = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._navigation = Navigation(self)
        self._navigation.changed.connect(self._camera_moved)
        self._panned_from: QPointF | None = None
        self._space_held = False
        self._tool_cursor = "arrow"
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)

    @property
    def camera(self) -> PlaneCamera:
        """What is seen now."""
        return self._navigation.camera

    @property
    def grid_step(self) -> float:
        """The distance of the lines of the grid, once the view has come to rest."""
        return graduation(self._navigation.target.pixel).minor

    @property
    def is_panned(self) -> bool:
        """Whether the mouse moves the view just now."""
        return self._panned_from is not None

    def set_camera(self, camera: PlaneCamera) -> None:
        """See that, in the size that the view has."""
        width, height = self.camera.size
        self._navigation.go(camera)
        self._navigation.resize(width, height)

    def set_projection(self, projection: Projection) -> None:
        """Look along another axis."""
        self._navigation.project(projection)

    def zoom(self, factor: float) -> None:
        """Nearer by that factor, at the middle of the view."""
        width, height = self.camera.size
        target = self._navigation.target
        self._navigation.glide(target.zoomed(factor, (width / 2.0, height / 2.0)))

    def pan(self, right: float, down: float) -> None:
        """Shift what is seen by that many pixels."""
        self._navigation.go(self.camera.panned((right, down)))

    def may_navigate(self) -> bool:
        """Whether the view may move now; not in the midst of a drag, which would lose its hold."""
        return True

    def show_cursor(self, name: str) -> None:
        """The mouse pointer to show while the view is not panned."""
        self._tool_cursor = name
        if self.is_panned:
            name = "grab"
        elif self._space_held:
            name = "hand"
        self.setCursor(cursor_of(name, self.devicePixelRatioF()))

    def _camera_moved(self) -> None:
        self.camera_changed.emit()
        self.update()

    # What Qt tells

    def resizeEvent(self, event: QResizeEvent) -> None:
        size = event.size()
        self._navigation.resize(float(size.width()), float(size.height()))

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
        self._zoom_at(at, ZOOM_STEP**notches)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._takes_hold(event):
            self._panned_from = event.position()
            self.show_cursor(self._tool_cursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._panned_from is not None:
            by = event.position() - self._panned_from
            self._panned_from = event.position()
            self.pan(by.x(), by.y())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if self._panned_from is not None and event.button() in (
            Qt.MouseButton.MiddleButton,
            Qt.MouseButton.LeftButton,
        ):
            self._panned_from = None
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
                self._zoom_at(event.position(), max(0.1, 1.0 + event.value()))
            return True
        return super().event(event)

    def _takes_hold(self, event: QMouseEvent) -> bool:
        """Whether that press begins to pan."""
        by_space = self._space_held and event.button() == Qt.MouseButton.LeftButton
        return self.may_navigate() and (by_space or event.button() == Qt.MouseButton.MiddleButton)

    def _zoom_at(self, at: QPointF, factor: float) -> None:
        self._navigation.go(self.camera.zoomed(factor, (at.x(), at.y())))

    def _hold_space(self, held: bool) -> None:
        if held != self._space_held:
            self._space_held = held
            self.show_cursor(self._tool_cursor)
