"""Which face is seen at which pixel of a view of the parameters: triangles as rows of pixels.

A large mesh is drawn into an array of face numbers once for a view, off the window's thread; to
color it anew, or to find the face under the pointer, is then to look numbers up.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.unfolding import NONE, Unfolding
from plusedit.scene.camera import PlaneCamera

FaceNumbers = NDArray[np.int32]


@dataclass(frozen=True, eq=False)
class FaceRaster:
    """The faces that a camera sees, by pixel."""

    camera: PlaneCamera
    """with sizes in the pixels of the raster"""
    numbers: FaceNumbers
    """(h, w) the face; face + f for images of faces outside of the cell; -1 for none"""

    @cached_property
    def rims(self) -> NDArray[np.bool_]:
        """(h, w) true at pixels whose right or lower neighbor belongs to another face."""
        return rims_of(self.numbers)


def rims_of(values: NDArray[np.generic]) -> NDArray[np.bool_]:
    """(h, w) true where the next value to the right or below is another one."""
    marks = np.zeros(values.shape, dtype=np.bool_)
    np.not_equal(values[:, :-1], values[:, 1:], out=marks[:, :-1])
    marks[:-1] |= values[:-1] != values[1:]
    return marks


def face_raster(unfolding: Unfolding, camera: PlaneCamera, on_top: NDArray[np.bool_]) -> FaceRaster:
    """The faces as `camera` sees them, and their images around the cell behind.

    Where faces lie upon each other, those marked `on_top` (f,) are seen.
    """
    owners, count = unfolding.mesh.triangulation.owners, unfolding.mesh.face_count
    triangles = unfolding.triangles
    low, high = camera.window
    images = unfolding.images_within(low, high)
    width, height = (round(side) for side in camera.size)
    numbers = np.full((height, width), NONE, dtype=np.int32)
    for k in reversed(range(len(images.shifts))):
        sign, shift = images.signs[k], images.shifts[k]
        # What is seen of the image, moved to the cell.
        ends = np.sort(sign * (np.stack([low, high]) - shift), axis=0)
        seen = unfolding.triangles_within(*ends)
        seen = seen[np.argsort(on_top[owners[seen]], kind="stable")]
        moved = (sign * triangles[seen] + shift).reshape(-1, 2)
        screen = camera.to_screen(moved).reshape(-1, 3, 2)
        fill(numbers, screen, owners[seen] + (0 if k == 0 else count))
    return FaceRaster(camera, numbers)


def fill(pixels: FaceNumbers, triangles: Floats, values: FaceNumbers) -> None:
    """Write the value of each triangle (t, 3, 2) into the pixels whose middles lie in it.

    Later triangles cover earlier ones. Pixel (row, column) has its middle at column + 1/2 to the
    right and row + 1/2 down. Triangles that share an edge share no pixel and leave none open.
    """
    height, width = pixels.shape
    first, stop = _between(triangles[..., 1].min(axis=1), triangles[..., 1].max(axis=1), height)
    chosen = np.flatnonzero(stop > first)
    which, row = _runs(first[chosen], stop[chosen])
    ends = _crossings(triangles[chosen], which, row.astype(np.float64) + 0.5)
    start, end = _between(*ends, width)
    some = np.flatnonzero(end > start)
    of_pixel, column = _runs(start[some], end[some])
    places = (row[some] * width)[of_pixel] + column
    pixels.reshape(-1)[places] = values[chosen[which[some]]][of_pixel]


def _between(low: Floats, high: Floats, most: int) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The first number whose middle, number + 1/2, is not below `low`, and the first not below
    `high`; from 0 to `most`."""
    ends = (np.clip(np.ceil(side - 0.5), 0, most).astype(np.intp) for side in (low, high))
    return next(ends), next(ends)


def _runs(
    first: NDArray[np.intp], stop: NDArray[np.intp]
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """All numbers of ranges, range after range: which range, and the number."""
    lengths = stop - first
    which = np.repeat(np.arange(len(first)), lengths)
    before = np.cumsum(lengths) - lengths
    return which, np.arange(len(which)) + (first - before)[which]


def _crossings(triangles: Floats, which: NDArray[np.intp], levels: Floats) -> tuple[Floats, Floats]:
    """Where level lines enter and leave the triangles that they cross."""
    # From above downwards: both triangles at an edge must find the same crossing.
    order = np.argsort(triangles[..., 1], axis=1, kind="stable")
    x, y = np.take_along_axis(triangles, order[..., None], axis=1).transpose(2, 1, 0)

    def along(a: int, b: int) -> tuple[Floats, Floats, Floats]:
        fall = y[b] - y[a]
        slope = np.divide(x[b] - x[a], fall, out=np.zeros_like(fall), where=fall > 0.0)
        return x[a], y[a], slope

    upper, lower, whole = along(0, 1), along(1, 2), along(0, 2)
    is_upper = levels < y[1][which]
    short = (np.where(is_upper, a[which], b[which]) for a, b in zip(upper, lower, strict=True))
    crossings = []
    for start, height, slope in (short, (part[which] for part in whole)):
        crossings.append(start + (levels - height) * slope)
    return np.minimum(*crossings), np.maximum(*crossings)
