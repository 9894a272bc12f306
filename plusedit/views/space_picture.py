"""Designs in space as pictures of pixels, drawn by the artist of the 3D view, without a window."""

from collections.abc import Iterator
from math import ceil

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from plusedit.document.design import Design
from plusedit.scene.composition import SIZE
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_composition import composed_in_space
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.stripes import stripes_of
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.gl.artist import Look, SpaceArtist
from plusedit.views.gl.context import context_for_pictures
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.sight import Crop
from plusedit.views.gl.targets import Target
from plusedit.views.painter import ItemPainter, painting
from plusedit.views.picture import png_bytes, running_application

SAMPLES = 4  # of each pixel that is drawn
FINER = 2  # pixels that are drawn for one of the picture, each way
TILE = 1024  # pixels of the picture, each way, that are drawn at once

Pixels = NDArray[np.uint8]


def space_image_of(
    design: Design,
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
    *,
    transparent: bool = False,
    view: str | None = None,
    ratio: float = 1.0,
) -> QImage:
    """The design in space framed in `size` logical pixels, `ratio` pixels of the image to each.

    It is seen as the design's own 3D view sees it, or from the named `view`. OpenGLError where
    there is no OpenGL to draw with; without a running QGuiApplication there is no text.
    """
    picture = composed_in_space(design, (float(size[0]), float(size[1])), view)
    look = Look(
        ground=picture.options.ground,
        shading=picture.options.shading,
        stripes=stripes_of(picture.options),
        transparent=transparent,
    )
    with context_for_pictures() as gl:
        image = shaded_image(gl, picture.layers, picture.camera, theme, look, ratio)
    image.setDevicePixelRatio(ratio)
    if words := tuple(picture.layers.words()):
        with painting(image) as painter:
            ItemPainter(painter, picture.camera, theme).paint(words)
    return image


def space_png(
    design: Design,
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
    transparent: bool = False,
    view: str | None = None,
) -> bytes:
    """The bytes of a PNG file; needs neither a display nor a running application."""
    application = running_application(in_space=True)
    image = space_image_of(design, size, theme, transparent=transparent, view=view)
    data = png_bytes(image)
    # Fonts and pixels belong to the application: it has to live until here.
    del application
    return data


def shaded_image(
    gl: Functions,
    layers: SpaceLayers,
    camera: SpaceCamera,
    theme: Theme,
    look: Look,
    ratio: float,
    rows: range | None = None,
) -> QImage:
    """What the artist draws in a view, labels left out; with `rows`, those rows of pixels of it.

    `ratio` pixels to each logical one. MemoryError where it takes more memory than there is.
    """
    pixels = _drawn(gl, layers, camera, theme, look, ratio, rows)
    height, width, _ = pixels.shape
    kind = QImage.Format.Format_RGBA8888_Premultiplied
    image = QImage(pixels.data, width, height, 4 * width, kind).copy()
    if image.isNull():
        raise MemoryError(
            f"a picture of {width} by {height} pixels takes more memory than there is"
        )
    return image


def _drawn(
    gl: Functions,
    layers: SpaceLayers,
    camera: SpaceCamera,
    theme: Theme,
    look: Look,
    ratio: float,
    rows: range | None,
) -> Pixels:
    """(height, width, 4) the picture, tile by tile: cards limit what can be drawn at once."""
    width, height = (round(side * ratio) for side in camera.size)
    wanted = rows or range(height)
    pixels = np.empty((len(wanted), width, 4), np.uint8)
    tile = min(TILE, max(width, len(wanted)))
    target = Target(gl, FINER * tile, FINER * tile, SAMPLES)
    artist = SpaceArtist(gl)
    try:
        for down, across in _tiles(width, len(wanted), tile):
            target.bind()
            place = slice(wanted.start + down.start, wanted.start + down.stop)
            crop = _crop(place, across, width, height, tile)
            artist.paint(layers, camera, theme, look, ratio=FINER * ratio, crop=crop)
            drawn = _averaged(target.read())
            pixels[down, across] = drawn[: down.stop - down.start, : across.stop - across.start]
    finally:
        artist.release()
        target.release()
    return pixels


def _tiles(width: int, height: int, tile: int) -> Iterator[tuple[slice, slice]]:
    """Rows and columns."""
    for row in range(ceil(height / tile)):
        for column in range(ceil(width / tile)):
            yield (
                slice(row * tile, min((row + 1) * tile, height)),
                slice(column * tile, min((column + 1) * tile, width)),
            )


def _crop(rows: slice, columns: slice, width: int, height: int, tile: int) -> Crop:
    """What brings the tile at those pixels to the whole of clip space."""
    across, upwards = width / tile, height / tile
    left = 2.0 * columns.start / width - 1.0
    top = 1.0 - 2.0 * rows.start / height
    return across, upwards, -1.0 - left * across, 1.0 - top * upwards


def _averaged(pixels: Pixels) -> Pixels:
    """Means of squares of FINER by FINER pixels; their colors are times opacity already."""
    height, width, _ = pixels.shape
    squares = pixels.reshape(height // FINER, FINER, width // FINER, FINER, 4)
    sums = squares.astype(np.uint16).sum(axis=(1, 3), dtype=np.uint16)
    means: Pixels = ((sums + FINER * FINER // 2) // (FINER * FINER)).astype(np.uint8)
    return means
