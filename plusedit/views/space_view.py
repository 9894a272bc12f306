"""A view of space that is turned, panned and zoomed; what else a mouse does is for who inherits.

It is pyqtgraph's widget for OpenGL with a camera and mouse of our own: its items can be shown
beside ours, but none of its ways about are left.
"""

from dataclasses import replace
from math import exp, radians

import numpy as np
from pyqtgraph.opengl import GLViewWidget
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QKeyEvent, QMatrix4x4, QMouseEvent
from PySide6.QtWidgets import QWidget

from plusedit.geometry.arrays import Floats
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.navigation import Navigation
from plusedit.views.opengl import is_software, surface_format
from plusedit.views.wayfinding import Wayfinding

TURN = radians(0.4)  # by which a pixel of a drag turns the view
ZOOM = 0.008  # for a pixel of a drag upwards: the view comes nearer by that part
SAMPLES = 4  # to a pixel
PRESSED = 3.0  # pixels; a press that is let go within them did not turn the view


class _BareView(GLViewWidget):  # type: ignore[misc]
    """The widget without its own keys."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        QWidget.keyPressEvent(self, event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        QWidget.keyReleaseEvent(self, event)


class SpaceView(Wayfinding[SpaceCamera], _BareView):
    """Middle drag turns, with Shift it pans, with Ctrl it zooms; the wheel zooms at the pointer."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        # Where the processor draws, four samples to a pixel take three times as long.
        self.setFormat(surface_format(samples=0 if is_software() else SAMPLES))
        self._begin_wayfinding(Navigation(self, SpaceCamera((1.0, 1.0)), SpaceCamera.blended))
        self._pressed_at = QPointF()
        self._has_moved = False
        """whether the mouse that holds the view has moved"""
        self._anchor: tuple[QPointF, Floats] | None = None
        """a pixel, and the point of the world that zooming keeps there"""
        self._came_from_perspective = False
        """whether a view along an axis stands for one in perspective until it is turned"""

    # What a window asks for

    def look_from(self, name: str) -> None:
        """Turn to "top", "front", "right", their opposites, or "iso", about the same place."""
        seen = self._navigation.target
        there = seen.looking(name)
        self._came_from_perspective = there.perspective < (
            seen.perspective or self._came_from_perspective
        )
        self._navigation.glide(there)

    def toggle_perspective(self) -> None:
        """From perspective to parallel and back; what is in the middle keeps its size."""
        seen = self._navigation.target
        self._came_from_perspective = False
        self._navigation.go(replace(seen, perspective=not seen.perspective))

    def orbit(self, right: float, down: float) -> None:
        """Turn the view as if what is seen was dragged by that many pixels."""
        camera = self.camera.orbited(-TURN * right, TURN * down)
        if self._came_from_perspective:
            self._came_from_perspective = False
            camera = replace(camera, perspective=True)
        self._navigation.go(camera)

    def point_at(self, at: QPointF) -> Floats:
        """(3,) what of the world zooming keeps under a pixel: as deep as the target."""
        return self.camera.to_world(np.array([at.x(), at.y()]), np.array(self.camera.target))

    # What pyqtgraph's items ask for

    def viewMatrix(self) -> QMatrix4x4:
        view = np.eye(4)
        camera = self.camera
        view[:3, :3] = camera.axes_of_view
        view[:3, 3] = -camera.axes_of_view @ np.array(camera.target)
        return QMatrix4x4(view.ravel().tolist())

    def projectionMatrix(self, region: object, viewport: object) -> QMatrix4x4:
        view = np.array(self.viewMatrix().copyDataTo()).reshape(4, 4)
        reach = 10.0 * self.camera.height
        return QMatrix4x4(
            (self.camera.matrix(-reach, reach) @ np.linalg.inv(view)).ravel().tolist()
        )

    # How the view follows the mouse

    def _zoomed(self, camera: SpaceCamera, at: QPointF, factor: float) -> SpaceCamera:
        if self._anchor is None or self._anchor[0] != at:
            self._anchor = at, self.point_at(at)
        return camera.zoomed(factor, self._anchor[1])

    def _taken(self, event: QMouseEvent) -> str:
        if event.button() != Qt.MouseButton.MiddleButton:
            return super()._taken(event)
        held = event.modifiers()
        if held & Qt.KeyboardModifier.ShiftModifier:
            return "pan"
        return "zoom" if held & Qt.KeyboardModifier.ControlModifier else "orbit"

    def _follow(self, hold: str, by: QPointF, event: QMouseEvent) -> None:
        if hold == "orbit":
            self.orbit(by.x(), by.y())
        elif hold == "zoom":
            factor = exp(-ZOOM * by.y())
            self._navigation.go(self._zoomed(self.camera, self._pressed_at, factor))
        elif self._anchor is not None:
            # What was taken hold of stays under the pointer, however deep it lies.
            deeper = self.camera.pixel_at(self._anchor[1][None])[0] / self.camera.pixel
            self.pan(deeper * by.x(), deeper * by.y())

    # What Qt tells

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        if self._hold:
            at = event.position()
            self._pressed_at, self._has_moved = at, False
            self._anchor = at, self.point_at(at)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._hold and not self._has_moved:
            off = event.position() - self._pressed_at
            if off.manhattanLength() < PRESSED:
                return
            self._has_moved = True
        super().mouseMoveEvent(event)
        if not self._hold:
            self._anchor = None
