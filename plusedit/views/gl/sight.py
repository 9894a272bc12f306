"""How one frame sees the world, in the numbers that shaders ask for."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.stripes import Stripes
from plusedit.views.gl.colors import Palette, Shade
from plusedit.views.gl.programs import Program

BESIDE = 16.0  # pixels before the nearest and beyond the farthest point that are drawn, too

Box = tuple[Floats, Floats]
"""The least and the largest coordinates (3,) of something"""

Crop = tuple[float, float, float, float]
"""Factors and shifts, across and upwards, of clip space: which part of the picture is drawn"""

WHOLE: Crop = (1.0, 1.0, 0.0, 0.0)


@dataclass(frozen=True, eq=False)
class Sight:
    """A camera with the depths that are drawn, the pixels of the device, colors and light."""

    camera: SpaceCamera
    matrix: Floats
    """(4, 4) from the world to clip space"""
    palette: Palette
    styles: tuple[str, ...] = ()
    """names that are defined in shaders of light"""
    ratio: float = 1.0
    """pixels of the device to a logical one"""
    crop: Crop = WHOLE
    stripes: Stripes | None = None

    @classmethod
    def of(
        cls,
        camera: SpaceCamera,
        boxes: Iterable[Box],
        palette: Palette,
        styles: tuple[str, ...] = (),
        ratio: float = 1.0,
        crop: Crop = WHOLE,
        stripes: Stripes | None = None,
    ) -> "Sight":
        """The sight of everything inside of boxes."""
        corners = [np.where(_CORNERS, high, low) for low, high in boxes]
        near = far = 0.0
        if corners:
            depths = camera.depths(np.concatenate(corners))
            near, far = float(depths.min()), float(depths.max())
        room = BESIDE * camera.pixel + 0.01 * (far - near)
        matrix = camera.matrix(near - room, far + room)
        return cls(camera, matrix, palette, styles, ratio, crop, stripes)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the whole picture in pixels of the device."""
        width, height = self.camera.size
        return width * self.ratio, height * self.ratio

    @cached_property
    def pull(self) -> tuple[float, float]:
        """What brings a depth nearer by a logical pixel: p / w + q of clip space."""
        camera, row = self.camera, self.matrix[2]
        slope = float(row[:3] @ camera.toward)
        if not camera.perspective:
            return 0.0, slope * camera.pixel
        at_target = float(row[:3] @ np.array(camera.target) + row[3])
        return (at_target + slope * camera.distance) * camera.pixel / camera.distance, 0.0

    def show(self, program: Program, origin: Floats) -> None:
        """Tell a program in use how to see places that are counted from `origin` (3,)."""
        moved = self.matrix.copy()
        moved[:, 3] = self.matrix @ np.append(origin, 1.0)
        program.set_matrix("world_to_clip", moved)
        if program.told is not self:
            program.told = self
            self._show_frame(program)

    def show_light(self, program: Program, origin: Floats, front: Shade, back: Shade) -> None:
        """Tell a program in use, besides, where the eye is, and what both sides throw back."""
        program.set("eye", *(self.camera.axes_of_view @ (self._eye - origin)).tolist())
        program.set("front", *front)
        program.set("back", *back)

    @cached_property
    def _eye(self) -> Floats:
        camera = self.camera
        return camera.eye if camera.perspective else np.array(camera.target)

    def _show_frame(self, program: Program) -> None:
        """What is the same for all that a frame draws."""
        program.set("size", *self.size)
        program.set("crop", *self.crop)
        program.set("pull", *self.pull)
        program.set("ratio", self.ratio)
        axes = self.camera.axes_of_view
        program.set_matrix("axes", axes)
        program.set("up", *axes[:, 2].tolist())
        program.set("parallel", 0.0 if self.camera.perspective else 1.0)
        if self.stripes is not None:
            program.set("stripes", self.stripes.count)
            program.set("light", *(axes @ np.array(self.stripes.light)).tolist())


_CORNERS = np.indices((2, 2, 2)).reshape(3, 8).T.astype(np.bool_)
