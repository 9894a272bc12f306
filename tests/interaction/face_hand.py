"""A hand that works on the faces of a hill."""

import numpy as np

from plusedit.document.selection import LineId, Selection
from plusedit.interaction.tool import Held, Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.space_hand import SpaceHand
from tests.scene.meshes import HILL, a_hill, a_landscape

ABOVE = SpaceCamera((1000.0, 800.0), (0.5, 0.5, 0.2), 1.3, pitch=1.2)
TOP = PlaneCamera((1000.0, 800.0), (0.5, 0.5), 700.0)
MANY, FEW = a_hill(15), a_hill()
"""Hills of 225 and of 36 faces: of the first not all planes are shown."""


class FaceHand(SpaceHand):
    """A hand over a hill, which is selected as a whole."""

    def __init__(self, camera=ABOVE, surface=MANY, **shape):
        super().__init__(a_landscape(surface, **shape), camera)
        drawing_of(surface)
        self.session.select(Selection.of_shapes([HILL]))

    @property
    def surface(self):
        return self.session.design.mesh(HILL)

    @property
    def planes(self):
        """The control points of the faces, (f, 3)."""
        return self.surface.net.control_points

    @property
    def chosen(self):
        """The numbers of the selected faces."""
        return self.session.selection.by_shape().get(HILL, ())

    def pick(self, *numbers):
        """Select faces; the last one is active."""
        lines = [LineId(HILL, number) for number in numbers]
        self.session.select(Selection.of_lines(lines, lines[-1]))

    def on_face(self, number, held=Held.NONE):
        """The pointer over a face, beside its dot."""
        center = self.surface.planes.centers[number] + 0.025
        return Pointer(*self.gestures.camera.to_screen(self.surface.at([center]))[0], held)

    def click_face(self, number, held=Held.NONE):
        self.tap(self.on_face(number, held))

    def tap(self, pointer):
        self.gestures.press(pointer)
        self.gestures.release(pointer)

    def pull(self, start, *by):
        """Press at a pointer and move by pixels, without letting go."""
        self.gestures.press(start)
        for x, y in by:
            self.gestures.move(Pointer(start.x + x, start.y + y, start.held))

    def let_go(self):
        self.gestures.release(self.gestures._pointer)

    @property
    def moved(self):
        """The numbers of the faces that are elsewhere than they were at first."""
        return np.flatnonzero((self.planes != MANY.planes.points).any(axis=1)).tolist()
