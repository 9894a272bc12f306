"""The faces in a view of the parameters as an image that follows the camera.

Beside the window's thread the faces are drawn into an array of face numbers, a little larger than
the view; that is colored here. While the view moves, the image moves with it and a new one is made.
"""

from dataclasses import replace
from operator import is_

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QObject, QRectF
from PySide6.QtGui import QImage, QPainter

from plusedit.events import Event
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.unfolding import NONE
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.parameter_colors import FaceColors, Measure, painted
from plusedit.scene.parameter_raster import FaceRaster, face_raster
from plusedit.scene.parameter_sheet import ParameterSheet
from plusedit.scene.theme import Theme
from plusedit.views.newest import Newest

BEYOND = 0.2  # of the view, on every side


class ParameterPicture(QObject):
    """The faces of one mesh at a time."""

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.ready: Event[()] = Event()
        """there is something else to be seen"""
        self.sheet: ParameterSheet | None = None
        """of the surface that is shown; None until it is known"""
        self._surface: MeshSurface | None = None
        self._newest = Newest(self)
        self._raster: FaceRaster | None = None
        self._asked: PlaneCamera | None = None
        self._image = QImage()
        self._colored: tuple[object, ...] = ()
        """what the image was colored by"""
        self._colors: tuple[ParameterSheet, Measure, FaceColors] | None = None

    @property
    def is_busy(self) -> bool:
        """Whether something is still to be made."""
        return self._newest.is_busy

    def show_surface(self, surface: MeshSurface | None) -> None:
        """Show that one, or nothing."""
        self._surface = surface
        sheet = self.sheet
        if surface is None or sheet is None or not sheet.mapping.lays_out(surface):
            self.sheet = self._raster = None
        if surface is None or sheet is None or not sheet.mapping.serves(surface):
            self._asked = None
            self._newest.forget()

    def see(self, camera: PlaneCamera, ratio: float) -> None:
        """Make what a camera sees, at so many pixels of the screen to each of its own."""
        surface, sheet = self._surface, self.sheet
        wanted = _wider(camera, ratio)
        if surface is None or self._serves(camera, wanted):
            return
        self._asked = wanted
        if sheet is None or not sheet.mapping.serves(surface):
            self._newest.ask(lambda: ParameterSheet.of(surface), self._take_sheet)
        else:
            self._newest.ask(
                lambda: face_raster(sheet.unfolding, wanted, sheet.flipped), self._take_raster
            )

    def face_at(self, place: Floats) -> int:
        """The face that is seen at a place (2,); -1 where there is none."""
        raster, sheet = self._raster, self.sheet
        if sheet is None:
            return NONE
        if raster is not None:
            column, row = np.floor(raster.camera.to_screen(place[None])[0]).astype(int).tolist()
            height, width = raster.numbers.shape
            if 0 <= row < height and 0 <= column < width:
                number = int(raster.numbers[row, column])
                return number if number == NONE else number % sheet.face_count
        return sheet.unfolding.face_at(place)

    def paint(
        self,
        painter: QPainter,
        camera: PlaneCamera,
        measure: Measure,
        theme: Theme,
        chosen: NDArray[np.intp],
    ) -> None:
        """Draw what there is where the camera sees it; `chosen` is compared by identity."""
        raster, sheet = self._raster, self.sheet
        if raster is None or sheet is None:
            return
        colors = self._face_colors(sheet, measure, theme)
        look = raster, sheet, colors, chosen
        if not (self._colored and all(map(is_, self._colored, look))):
            self._image = _image_of(painted(raster, sheet, colors, chosen))
            self._colored = look
        low, high = raster.camera.window
        (left, bottom), (right, top) = camera.to_screen(np.stack([low, high])).tolist()
        is_still = abs(raster.camera.scale / camera.scale - painter.device().devicePixelRatio())
        painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform, is_still > 1e-9)
        painter.drawImage(QRectF(left, top, right - left, bottom - top), self._image)

    def _face_colors(self, sheet: ParameterSheet, measure: Measure, theme: Theme) -> FaceColors:
        kept = self._colors
        if kept is None or kept[0] is not sheet or kept[1] != measure or kept[2].theme != theme:
            kept = self._colors = sheet, measure, FaceColors.of(sheet, measure, theme)
        return kept[2]

    def _take_sheet(self, sheet: ParameterSheet) -> None:
        self.sheet, self._asked = sheet, None
        self.ready.emit()

    def _take_raster(self, raster: FaceRaster) -> None:
        self._raster = raster
        self.ready.emit()

    def _serves(self, camera: PlaneCamera, wanted: PlaneCamera) -> bool:
        """Whether what was asked for last shows all that the camera sees, as sharp."""
        asked = self._asked
        if asked is None:
            return False
        (low, high), (left, right) = camera.window, asked.window
        is_within = (low >= left).all() and (high <= right).all()
        return bool(is_within) and asked.scale == wanted.scale and asked.size == wanted.size


def _wider(camera: PlaneCamera, ratio: float) -> PlaneCamera:
    """A camera for a raster: with some more around, and one pixel to each of the screen."""
    width, height = (2.0 * round((0.5 + BEYOND) * ratio * side) for side in camera.size)
    return replace(camera, size=(width, height), scale=camera.scale * ratio)


def _image_of(pixels: NDArray[np.uint32]) -> QImage:
    height, width = pixels.shape
    kind = QImage.Format.Format_ARGB32_Premultiplied
    # Copied: Qt would go on reading memory that Python may free.
    return QImage(pixels.tobytes(), width, height, 4 * width, kind).copy()
