"""How a plane view gets from one camera to the next: panned, zoomed, framed, gliding there."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import QEasingCurve, QObject, QVariantAnimation, Signal

from plusedit.scene.camera import PlaneCamera, Projection

GLIDE = 160  # milliseconds


class Navigation(QObject):
    """Holds the camera of a view and tells when it changes."""

    changed = Signal()

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._camera = PlaneCamera((1.0, 1.0))
        self._from = self._to = self._camera
        self._animation = QVariantAnimation(self)
        self._animation.setDuration(GLIDE)
        self._animation.setStartValue(0.0)
        self._animation.setEndValue(1.0)
        self._animation.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._animation.valueChanged.connect(self._step)

    @property
    def camera(self) -> PlaneCamera:
        """What the view sees now."""
        return self._camera

    @property
    def target(self) -> PlaneCamera:
        """What it will see once it has arrived."""
        gliding = self._animation.state() == QVariantAnimation.State.Running
        return self._to if gliding else self._camera

    def go(self, camera: PlaneCamera) -> None:
        """See that, at once."""
        self._animation.stop()
        self._set(camera)

    def glide(self, camera: PlaneCamera) -> None:
        """See that in a moment; on the way the eye keeps its bearings."""
        self._animation.stop()
        if camera != self._camera:
            self._from, self._to = self._camera, camera
            self._animation.start()

    def resize(self, width: float, height: float) -> None:
        """The view has another size; what is in its middle stays there."""
        size = (max(width, 1.0), max(height, 1.0))
        self._to = replace(self._to, size=size)
        self._from = replace(self._from, size=size)
        self._set(replace(self._camera, size=size))

    def project(self, projection: Projection) -> None:
        """Look along another axis, at the same place as far as the two share it."""
        old = self.target
        center = dict(zip(old.axes, old.center, strict=True))
        other = replace(old, projection=projection)
        across, up = other.axes
        self.go(replace(other, center=(center.get(across, 0.0), center.get(up, 0.0))))

    def _step(self, share: float) -> None:
        if share >= 1.0:
            self._set(self._to)
            return
        start, end = self._from, self._to
        scale = start.scale * (end.scale / start.scale) ** share
        # Weighted so that what both cameras see at one pixel stays there all the way.
        weight = share
        if start.scale != end.scale:
            weight = (1.0 / scale - 1.0 / start.scale) / (1.0 / end.scale - 1.0 / start.scale)
        x, y = (1.0 - weight) * np.array(start.center) + weight * np.array(end.center)
        self._set(replace(end, center=(float(x), float(y)), scale=float(scale)))

    def _set(self, camera: PlaneCamera) -> None:
        if camera != self._camera:
            self._camera = camera
            self.changed.emit()
