"""A hand that works on known curves without a window."""

from itertools import pairwise

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.tool import Feedback, Held, Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import handles

CAMERA = PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0)

WAVE = ShapeId("wave")
BOW = ShapeId("bow")
EMPTY = (-1.8, 3.8)  # far from every curve and handle


def wave():
    """Five lines over x = 0 ... 4, the middle one with a direction of its own."""
    points = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.0], [3.0, 2.0], [4.0, 0.0]]
    directions = [None, None, [2.0, 0.0], None, None]
    return PlusCurve(BSpline(5, 4), ControlLines.of(points, directions), 2.0)


def bow():
    """Three lines below the wave, y = -1.5 ... -1."""
    return PlusCurve(Bernstein(3), ControlLines.of([[0.0, -1.5], [2.0, -1.0], [4.0, -1.5]]), 1.0)


def design(**curves):
    """A design of those curves; the wave and the bow if none are named."""
    named = curves or {"wave": wave(), "bow": bow()}
    return Design({ShapeId(i): Shape(curve, i.capitalize()) for i, curve in named.items()})


class Hand:
    """A session, gestures for it, and the pointer in coordinates of the world."""

    def __init__(self, start=None, camera=CAMERA, tool="select"):
        self.session = Session(design() if start is None else start)
        self.gestures = Gestures(self.session, camera, tool)
        self.said = Feedback()
        self.errors = []
        self.gestures.feedback.listen(self._hear)

    def _hear(self, feedback):
        self.said = feedback
        if feedback.error:
            self.errors.append(feedback.error)

    def at(self, place, held=Held.NONE):
        """The pointer over a point of the world."""
        x, y = self.gestures.camera.to_screen(np.array([place], dtype=float))[0]
        return Pointer(float(x), float(y), held)

    def click(self, place, held=Held.NONE):
        self.gestures.press(self.at(place, held))
        self.gestures.release(self.at(place, held))

    def double_click(self, place):
        self.click(place)
        self.gestures.double_click(self.at(place))
        self.gestures.release(self.at(place))

    def drag(self, *places, held=Held.NONE, moves=1):
        """Press at the first place, go on to the others, let go at the last."""
        self.hold(*places, held=held, moves=moves)
        self.gestures.release(self.at(places[-1], held))

    def hold(self, *places, held=Held.NONE, moves=1):
        """The same without letting go."""
        self.gestures.press(self.at(places[0], held))
        for start, end in pairwise(places):
            for share in np.linspace(0.0, 1.0, moves + 1)[1:]:
                way = np.subtract(end, start)
                self.gestures.move(self.at(np.add(start, share * way), held))

    def type(self, *keys):
        return [self.gestures.key(key) for key in keys]

    def tip(self, number, side=1, shape=WAVE):
        """Where a grip stands, in the world."""
        stand = handles(self.curve(shape), self.gestures.camera)
        screen = stand.tips[0 if side > 0 else 1][[number]]
        return self.gestures.camera.in_plane(screen)[0]

    def select(self, *lines):
        """Select lines of the wave by number, or (shape, number)."""
        named = [(WAVE, line) if isinstance(line, int) else line for line in lines]
        self.session.select(Selection.of_lines(LineId(*line) for line in named))

    def curve(self, shape=WAVE):
        return self.session.design.curve(shape)

    def points(self, shape=WAVE):
        return self.curve(shape).lines.points

    def directions(self, shape=WAVE):
        return self.curve(shape).directions

    @property
    def numbers(self):
        """The numbers of the selected lines of the wave."""
        return self.session.selection.by_shape().get(WAVE, ())
