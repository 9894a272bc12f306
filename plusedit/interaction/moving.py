"""Drags that move control points."""

from collections.abc import Iterable
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from plusedit.commands.base import Command, Targets
from plusedit.commands.lines import Landing, MovePoints
from plusedit.commands.soft_move import SoftMove
from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.interaction.places import in_space, seen_axes
from plusedit.interaction.readout import number, shift_text, sphere
from plusedit.interaction.snapping import AXES, along_axis, along_longer, to_grid
from plusedit.interaction.space_moving import Along, SpaceWay
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.scene.camera import PlaneCamera

HINT = (
    "Ctrl snaps to the grid · Shift keeps to an axis · X, Y lock it · type dx Tab dy · "
    "O moves neighbors softly · Esc"
)
SPACE_HINT = (
    "Ctrl snaps to the grid · X, Y, Z lock an axis, with Shift the plane across it · "
    "type dx Tab dy Tab dz · O moves neighbors softly · Esc"
)
SOFT_HINT = "The wheel, [ and ] change the radius, or type it last · O moves single points · Esc"

Mask = NDArray[np.bool_]


class Way(Protocol):
    """How the pointer moves what is held."""

    def by(self, now: Pointer) -> tuple[Floats, Mask]:
        """The shift (3,) that the pointer means, and along which axes (3,) it is free."""
        ...


def move_drag(
    start: Pointer,
    stage: Stage,
    targets: Targets,
    grabbed: LineId | None,
    selection: Selection | None = None,
    along: Along | None = None,
) -> Drag:
    """Move `targets` with the pointer; snapped, the control point `grabbed` lands on the grid.

    Without a grabbed line the shift itself is snapped. `selection` takes effect at once. `along`
    is an axis of the gizmo: the shift keeps to it as long as no other one is locked.
    """
    anchor = anchor_of(stage.design, targets, grabbed)
    is_plane = isinstance(stage.camera, PlaneCamera)
    flat = is_flat(stage, targets if grabbed is None else [grabbed.shape])
    way: Way = (
        PlaneWay(stage, anchor, start)
        if is_plane
        else SpaceWay(stage.camera, anchor, start, flat, along)
    )
    hint = HINT if is_plane else SPACE_HINT
    now = yield Shown(selection, Feedback(hint=hint, cursor="move"))
    while True:
        by, landing = _shift(now, way, anchor, grabbed, stage, along)
        radius = soft_radius(now, anchor, stage)
        text = along.text(by, stage.camera) if along and not now.axis else None
        feedback = Feedback(hint=hint, readout=text or shift_text(by, stage.camera), cursor="move")
        command: Command = MovePoints(targets, by, landing)
        if radius is not None:
            command = SoftMove(targets, by, radius, landing)
            feedback = _softly(feedback, anchor + by, radius, stage)
        now = yield Shown(command, feedback)


def _shift(
    now: Pointer,
    way: Way,
    anchor: Floats,
    grabbed: LineId | None,
    stage: Stage,
    along: Along | None,
) -> tuple[Floats, Landing | None]:
    """The shift that is meant: as typed, else that of the pointer with its constraints."""
    typed = typed_shift(now, seen_axes(stage.camera), along)
    if typed is not None:
        return typed, None
    by, free = way.by(now)
    if not snaps(now, stage):
        return by, None
    if along is not None and now.axis is None:
        return along.snapped(by, stage.grid_step), None
    return snapped(by, anchor, grabbed, free, stage)


def typed_shift(now: Pointer, axes: tuple[int, ...], along: Along | None = None) -> Floats | None:
    """The shift (3,) that has been typed; None where nothing has."""
    values = [0.0 if value is None else value for value in now.typed[: len(axes)]]
    if all(value is None for value in now.typed[: len(axes)]):
        return None
    if now.axis is None and along is not None:
        return values[0] * along.axis
    shift = np.zeros(3)
    if now.axis is not None:
        locked = [axis for axis, name in enumerate(AXES) if name in now.axis]
        shift[locked] = values[: len(locked)]
    else:
        shift[list(axes)] = values
    return shift


class PlaneWay:
    """In a view of a plane: by what the pointer moves in it."""

    def __init__(self, stage: Stage, anchor: Floats, start: Pointer) -> None:
        self._camera, self._anchor = stage.camera, anchor
        self._origin = stage.camera.to_world(start.at, anchor)

    def by(self, now: Pointer) -> tuple[Floats, Mask]:
        by = self._camera.to_world(now.at, self._anchor) - self._origin
        free = np.zeros(3, dtype=np.bool_)
        free[list(seen_axes(self._camera))] = True
        if now.axis is not None:
            free &= [axis in now.axis for axis in AXES]
            return along_axis(by, now.axis), free
        if Held.SHIFT in now.held:
            return along_longer(by), free & (np.arange(3) == np.abs(by).argmax())
        return by, free


def anchor_of(design: Design, targets: Targets, grabbed: LineId | None) -> Floats:
    """(3,) the control point that was taken hold of, or the middle of all that are moved."""
    if grabbed is None:
        return centroid(design, targets)
    point: Floats = in_space(points_meant(design, grabbed.shape, (grabbed.number,)))[0]
    return point


def centroid(design: Design, targets: Targets) -> Floats:
    """(3,) the mean of the control points, and of the vertices of whole meshes."""
    rows = [in_space(points_meant(design, *meant)) for meant in targets.items()]
    mean: Floats = np.concatenate(rows).mean(axis=0)
    return mean


def points_meant(design: Design, shape_id: ShapeId, numbers: tuple[int, ...]) -> Floats:
    """(k, dim) those control points; the vertices of a mesh that is meant as a whole."""
    mesh = design[shape_id].mesh
    if mesh is not None and not numbers:
        return mesh.mesh.vertices
    points: Floats = design[shape_id].geometry.net.control_points[list(numbers)]
    return points


def is_flat(stage: Stage, shapes: Iterable[ShapeId]) -> bool:
    """Whether all of the shapes are plane curves, which stay in z = 0."""
    found = [stage.design[shape_id].plus for shape_id in shapes]
    return all(geometry is not None and geometry.dimension == 2 for geometry in found)


def snaps(now: Pointer, stage: Stage) -> bool:
    """Whether points go to the grid: with Ctrl, or without where the view snaps by itself."""
    return (Held.CTRL in now.held) != stage.options.snap


def snapped(
    by: Floats, anchor: Floats, grabbed: LineId | None, free: Mask, stage: Stage
) -> tuple[Floats, Landing | None]:
    """The shift that brings the grabbed point to the grid along the axes that are free."""
    if grabbed is None:
        return np.where(free, to_grid(by, stage.grid_step), 0.0), None
    goal = np.where(free, to_grid(anchor + by, stage.grid_step), anchor)
    return goal - anchor, Landing(grabbed.shape, grabbed.number, goal)


def soft_radius(now: Pointer, anchor: Floats, stage: Stage) -> float | None:
    """How far a soft move reaches in the world, as typed or as seen; None where it is not soft."""
    if now.reach is None:
        return None
    typed = now.typed[-1] if len(now.typed) > len(seen_axes(stage.camera)) else None
    if typed is not None:
        return abs(typed)
    return now.reach * float(stage.camera.pixel_at(anchor[None])[0])


def _softly(feedback: Feedback, center: Floats, radius: float, stage: Stage) -> Feedback:
    text = f"{feedback.readout}  radius {number(radius, 3)}"
    around = sphere(center, radius, stage.camera)
    return Feedback((around,), SOFT_HINT, text, feedback.cursor)
