"""Something to draw on, and to look at what was drawn."""

import numpy as np

from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.theme import LIGHT
from plusedit.views.gl.artist import Look, SpaceArtist
from plusedit.views.gl.targets import Target

SIZE = (200, 160)
FRONT = SpaceCamera.standard("front", (200.0, 160.0))
TOP = SpaceCamera.standard("top", (200.0, 160.0))
ISO = SpaceCamera.standard("iso", (200.0, 160.0))


class Easel:
    """An artist with a small picture to draw into, in a context that is current."""

    def __init__(self, gl, size=SIZE, samples=0):
        self.gl = gl
        self.artist = SpaceArtist(gl)
        self._target = Target(gl, *size, samples)

    def draw(self, *items, handles=(), camera=FRONT, theme=LIGHT, look=None, **options):
        """(height, width, 4) red, green, blue and opacity of a frame with those items."""
        layers = SpaceLayers(lines=items, handles=tuple(handles))
        self._target.bind()
        self.artist.paint(layers, camera, theme, look or Look(), **options)
        pixels = self._target.read().astype(int)
        assert self.gl.errors() == []
        return pixels

    def put_away(self):
        self.artist.release()
        self._target.release()
        assert self.gl.errors() == []


def at(pixels, camera, point):
    """(4,) the color where a point of the world is seen."""
    column, row = np.floor(camera.to_screen(np.array([point], dtype=float))[0]).astype(int)
    return pixels[row, column]


def color(theme, role):
    """(4,) the color of a role, opaque."""
    name = theme.color(role)
    return np.array([*(int(name[i : i + 2], 16) for i in (1, 3, 5)), 255])


def is_like(pixel, wanted, within=2):
    """Whether a pixel has that color but for rounding."""
    return bool((np.abs(pixel - wanted) <= within).all())
