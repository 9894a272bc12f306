"""A view of a plane that can be panned and zoomed; what else a mouse does is for who inherits."""

from dataclasses import replace

from PySide6.QtCore import QPointF
from PySide6.QtWidgets import QWidget

from plusedit.scene.camera import PlaneCamera, Projection
from plusedit.views.navigation import Navigation, between_planes
from plusedit.views.wayfinding import Wayfinding


class PlaneView(Wayfinding[PlaneCamera], QWidget):
    """Wheel and pinch zoom at the pointer; middle drag, Space and drag, and two fingers pan."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._begin_wayfinding(Navigation(self, PlaneCamera((1.0, 1.0)), between_planes))

    def set_projection(self, projection: Projection) -> None:
        """Look along another axis, at the same place as far as the two share it."""
        old = self._navigation.target
        center = dict(zip(old.axes, old.center, strict=True))
        other = replace(old, projection=projection)
        across, up = other.axes
        self._navigation.go(replace(other, center=(center.get(across, 0.0), center.get(up, 0.0))))

    def _zoomed(self, camera: PlaneCamera, at: QPointF, factor: float) -> PlaneCamera:
        return camera.zoomed(factor, (at.x(), at.y()))
