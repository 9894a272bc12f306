"""A hand that works on a known surface and a space curve, in any view."""

import numpy as np

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.space_turning import tip_of
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.gizmo import gizmo_of
from plusedit.scene.plane_handles import plane_handles
from plusedit.scene.space_camera import SpaceCamera
from tests.interaction.hand import Hand, bow

SAIL, HELIX, BOW = ShapeId("sail"), ShapeId("helix"), ShapeId("bow")
SIZE = (1000.0, 800.0)
SPACE = SpaceCamera(SIZE, (1.5, 1.5, 0.3), 6.0)
PARALLEL = SpaceCamera(SIZE, (1.5, 1.5, 0.3), 6.0, perspective=False)
VIEWS = (
    PlaneCamera(SIZE, (1.5, 1.5), 110.0),
    PlaneCamera(SIZE, (1.5, 0.0), 110.0, "front"),
    PlaneCamera(SIZE, (1.5, 0.0), 110.0, "right"),
    SPACE,
    PARALLEL,
)


def sail(s=1.0):
    """4 x 4 control planes over [0, 3] x [0, 3], one of them with directions of its own."""
    x, y = np.meshgrid(np.arange(4.0), np.arange(4.0), indexing="ij")
    points = np.stack([x, y, 0.4 * np.sin(1.3 * x) * np.cos(y)], axis=-1)
    rows_u, rows_v = ([[None] * 4 for _ in range(4)] for _ in range(2))
    rows_u[1][2], rows_v[1][2] = [2.0, 0.0, 0.5], [0.3, 1.0, 0.0]
    return PlusSurface(BSpline(4, 4), BSpline(4, 4), ControlPlanes.of(points, rows_u, rows_v), s)


def helix():
    """A space curve beside the sail, the second of its lines directed by hand."""
    points = [[4.0, 0.0, 0.0], [4.5, 1.0, 0.5], [3.8, 2.0, 1.0], [4.4, 3.0, 1.5]]
    lines = ControlLines.of(points, [None, [0.0, 1.0, 1.0], None, None])
    return PlusCurve(BSpline(4, 4), lines, 2.0)


def scene():
    """The sail, the helix and a plane curve."""
    return Design(
        {SAIL: Shape(sail(), "Sail"), HELIX: Shape(helix(), "Helix"), BOW: Shape(bow(), "Bow")}
    )


class SpaceHand(Hand):
    """A hand over the scene; places are points of space."""

    def __init__(self, start=None, camera=SPACE, tool="select"):
        super().__init__(scene() if start is None else start, camera, tool)

    @property
    def surface(self):
        return self.session.design.surface(SAIL)

    @property
    def planes(self):
        """The control points of the sail, (16, 3)."""
        return self.surface.planes.control_points

    @property
    def vectors(self):
        """The directions of the sail, (2, 16, 3)."""
        return self.surface.vectors

    def pick(self, *numbers):
        """Select control planes of the sail; the last one is active."""
        lines = [LineId(SAIL, number) for number in numbers]
        self.session.select(Selection.of_lines(lines, lines[-1]))

    def on_surface(self, u, v):
        """A point of the sail."""
        return self.surface.at([u], [v]).reshape(3)

    def grip(self, number, side=1):
        """Where the grip by u (1) or by v (2) of a plane stands."""
        return plane_handles(self.surface, self.gestures.camera).tips_world[side - 1, number]

    def tip_in_space(self, shape, number, side):
        """Where a grip of a control line stands."""
        return tip_of(self.session.design.plus(shape), number, side, self.gestures.camera)

    @property
    def gizmo(self):
        session = self.session
        return gizmo_of(session.design, session.selection, self.gestures.camera)

    def on_ring(self, axis, degrees):
        """A point of a ring of the gizmo, as it stands now."""
        ring = self.gizmo.ring(axis)
        return ring[round(degrees / 360.0 * (len(ring) - 1)) % (len(ring) - 1)]

    def on_arrow(self, axis):
        """The tip of an arrow of the gizmo."""
        return self.gizmo.arrow(axis)[1]

    def nudge(self, place, *pixels, **how):
        """Drag from a place by pixels to the right and downwards, and let go."""
        at = self.at(place, **how)
        self.gestures.press(at)
        for by in pixels:
            self.gestures.move(type(at)(at.x + by[0], at.y + by[1], at.held))
        last = pixels[-1]
        self.gestures.release(type(at)(at.x + last[0], at.y + last[1], at.held))


def angles_between(first, second):
    """Degrees between vectors (..., 3)."""
    along = np.einsum("...d,...d->...", first, second)
    lengths = np.linalg.norm(first, axis=-1) * np.linalg.norm(second, axis=-1)
    return np.degrees(np.arccos(np.clip(along / lengths, -1.0, 1.0)))
