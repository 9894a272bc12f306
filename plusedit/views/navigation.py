"""How a view gets from one camera to the next: panned, zoomed, framed, gliding there."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any, ClassVar, Generic, Protocol, Self, TypeVar

import numpy as np
from PySide6.QtCore import QEasingCurve, QObject, QVariantAnimation, Signal

from plusedit.scene.camera import Camera, PlaneCamera

GLIDE = 160  # milliseconds


class MovingCamera(Camera, Protocol):
    """A camera that a view can be moved with."""

    __dataclass_fields__: ClassVar[dict[str, Any]]

    def panned(self, by: tuple[float, float]) -> Self:
        """Moved so that what is seen shifts by that many pixels to the right and downwards."""
        ...


C = TypeVar("C", bound=MovingCamera)


class Navigation(QObject, Generic[C]):
    """Holds the camera of a view and tells when it changes."""

    changed = Signal()

    def __init__(self, parent: QObject, camera: C, between: Callable[[C, C, float], C]) -> None:
        """`between` gives the camera from 0, the first, to 1, the second, on the way."""
        super().__init__(parent)
        self.is_animated = True
        """whether `glide` takes its time"""
        self._between = between
        self._camera = camera
        self._from = self._to = self._camera
        self._animation = QVariantAnimation(self)
        self._animation.setDuration(GLIDE)
        self._animation.setStartValue(0.0)
        self._animation.setEndValue(1.0)
        self._animation.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._animation.valueChanged.connect(self._step)

    @property
    def camera(self) -> C:
        """What the view sees now."""
        return self._camera

    @property
    def target(self) -> C:
        """What it will see once it has arrived."""
        return self._to if self.is_gliding else self._camera

    @property
    def is_gliding(self) -> bool:
        """Whether it is on its way."""
        return self._animation.state() == QVariantAnimation.State.Running

    def go(self, camera: C) -> None:
        """See that, at once."""
        self._animation.stop()
        self._set(camera)

    def glide(self, camera: C) -> None:
        """See that in a moment; on the way the eye keeps its bearings."""
        self._animation.stop()
        if not self.is_animated:
            self._set(camera)
        elif camera != self._camera:
            self._from, self._to = self._camera, camera
            self._animation.start()

    def resize(self, width: float, height: float) -> None:
        """The view has another size; what is in its middle stays there."""
        size = (max(width, 1.0), max(height, 1.0))
        self._to = replace(self._to, size=size)
        self._from = replace(self._from, size=size)
        self._set(replace(self._camera, size=size))

    def _step(self, share: float) -> None:
        if share >= 1.0:
            self._set(self._to)
        else:
            self._set(self._between(self._from, self._to, share))

    def _set(self, camera: C) -> None:
        if camera != self._camera:
            self._camera = camera
            self.changed.emit()


def between_planes(start: PlaneCamera, end: PlaneCamera, share: float) -> PlaneCamera:
    """A camera on the way: what both see at one pixel stays there all the way."""
    scale = start.scale * (end.scale / start.scale) ** share
    weight = share
    if start.scale != end.scale:
        weight = (1.0 / scale - 1.0 / start.scale) / (1.0 / end.scale - 1.0 / start.scale)
    x, y = (1.0 - weight) * np.array(start.center) + weight * np.array(end.center)
    return replace(end, center=(float(x), float(y)), scale=float(scale))
