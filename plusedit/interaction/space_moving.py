"""How the pointer moves points in space: across the view, along an axis, or in a plane."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.interaction.following import FLATTEST, Follower
from plusedit.interaction.readout import number
from plusedit.interaction.snapping import AXES, decimals, to_grid
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.camera import Camera

SPACE = np.eye(3)


@dataclass(frozen=True, eq=False)
class Along:
    """An axis that a shift keeps to, such as one of the gizmo's."""

    axis: Floats
    """(3,) unit vector"""
    name: str

    def snapped(self, by: Floats, step: float) -> Floats:
        """The shift along the axis by a multiple of the step."""
        shift: Floats = to_grid(np.array([by @ self.axis]), step)[0] * self.axis
        return shift

    def text(self, by: Floats, camera: Camera) -> str:
        """Such as "u 1.25"."""
        return f"{self.name} {number(float(by @ self.axis), decimals(camera.pixel))}"


class SpaceWay:
    """In a view of space: in the plane parallel to the screen through what is held.

    With axes locked it is along one, or in the plane of two; so is what is flat, which stays in
    the plane z = 0. With Shift it keeps to the axis along which the pointer has gone.
    """

    def __init__(
        self, camera: Camera, anchor: Floats, start: Pointer, flat: bool, along: Along | None
    ) -> None:
        self._camera, self._anchor, self._start = camera, anchor, start.at
        self._flat, self._along = flat, along
        self._followers: dict[str, Follower] = {}

    def by(self, now: Pointer) -> tuple[Floats, NDArray[np.bool_]]:
        pixels = now.at - self._start
        axes = now.axis or ""
        if not axes and self._along is None and Held.SHIFT in now.held:
            axes = self._nearest_axis(pixels)
        elif not axes and self._flat:
            axes = "xy"
        if self._flat:
            axes = axes.replace("z", "") or "none"
        free = np.array([not axes or axis in axes for axis in AXES])
        if axes == "none":
            return np.zeros(3), np.zeros(3, dtype=np.bool_)
        return self._follower(axes).by(pixels), free

    def _follower(self, axes: str) -> Follower:
        if axes not in self._followers:
            basis = SPACE[[AXES.index(axis) for axis in axes]] if axes else self._own_basis
            self._followers[axes] = Follower(self._camera, self._anchor, basis)
        return self._followers[axes]

    @property
    def _own_basis(self) -> Floats:
        return self._camera.axes_of_view[:2] if self._along is None else self._along.axis[None]

    def _nearest_axis(self, pixels: Floats) -> str:
        """The axis whose picture on the screen runs most nearly as the pointer has gone."""
        step = float(self._camera.pixel_at(self._anchor[None])[0])
        at = self._camera.to_screen(self._anchor + step * np.vstack([np.zeros(3), SPACE]))
        seen = at[1:] - at[0]
        lengths = np.hypot(*seen.T)
        count = 2 if self._flat else 3
        usable = (lengths > FLATTEST) & (np.arange(3) < count)
        along = np.abs(seen @ pixels) / np.where(usable, lengths, np.inf)
        return AXES[int(along.argmax())]
