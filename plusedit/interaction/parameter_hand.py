"""What the pointer does in a view of the parameters of a mesh: faces are selected, cone points of
a pillow dragged to other vertices."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import hypot

import numpy as np

from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.events import Event
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.unfolding import NONE
from plusedit.interaction.gesture import DRAG_STARTS_AT
from plusedit.interaction.readout import box
from plusedit.interaction.tool import REACH, Held, Pointer
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item
from plusedit.scene.parameter_items import (
    Spot,
    cone_items,
    cone_spots,
    hover_items,
    landing_items,
)
from plusedit.scene.parameter_sheet import ParameterSheet


@dataclass(frozen=True, eq=False)
class ParameterStage:
    """What there is to point at."""

    shape_id: ShapeId
    sheet: ParameterSheet
    camera: PlaneCamera
    selection: Selection
    face_at: Callable[[Floats], int]
    """the face that is seen at a place (2,), -1 for none"""

    def place(self, at: Pointer) -> Floats:
        """(2,) the parameters under the pointer."""
        found: Floats = self.camera.in_plane(np.array([at.at]))[0]
        return found

    @property
    def spots(self) -> tuple[Spot, ...]:
        """The cone points that are seen."""
        images = self.sheet.unfolding.images_within(*self.camera.window)
        return cone_spots(self.sheet, images)


class ParameterHand:
    """From presses and moves to selections and cone points."""

    def __init__(self) -> None:
        self.selected: Event[Selection] = Event()
        self.cones_chosen: Event[tuple[int, ...]] = Event()
        """four vertices: a cone point was dragged to another one"""
        self._pressed: Pointer | None = None
        self._pointer: Pointer | None = None
        self._is_dragging = False
        self._held: Spot | None = None

    @property
    def is_dragging(self) -> bool:
        """Whether a box or a cone point follows the pointer."""
        return self._is_dragging

    def press(self, at: Pointer, stage: ParameterStage) -> None:
        """The left button went down."""
        self._pressed = self._pointer = at
        self._held = _spot_under(at, stage)

    def move(self, to: Pointer) -> None:
        """The pointer moved, with the button down or up."""
        self._pointer, start = to, self._pressed
        if start is not None and hypot(to.x - start.x, to.y - start.y) >= DRAG_STARTS_AT:
            self._is_dragging = True

    def release(self, at: Pointer, stage: ParameterStage) -> None:
        """The button was let go: a drag is over, or it was a click."""
        self.move(at)
        start, held, was_dragging = self._pressed, self._held, self._is_dragging
        self.cancel()
        if start is None:
            return
        if held is not None:
            if was_dragging:
                self._land(held, at, stage)
        elif was_dragging:
            self.selected.emit(_boxed(start, at, stage))
        else:
            self.selected.emit(_clicked(at, stage))

    def leave(self) -> None:
        """The pointer left the view; a drag goes on."""
        if not self._is_dragging:
            self._pointer = None

    def cancel(self) -> bool:
        """Drop what is under way; whether there was something."""
        was_busy = self._is_dragging
        self._pressed = self._held = None
        self._is_dragging = False
        return was_busy

    def face(self, stage: ParameterStage) -> int:
        """The face under the pointer; -1 where there is none, or a drag is under way."""
        at = self._pointer
        if at is None or self._is_dragging or _spot_under(at, stage) is not None:
            return NONE
        return stage.face_at(stage.place(at))

    def items(self, stage: ParameterStage) -> Iterator[Item]:
        """What shows where the pointer is and what it drags, upon all else."""
        at, spots = self._pointer, stage.spots
        face = self.face(stage)
        if at is not None and face != NONE:
            yield from hover_items(stage.sheet, face, stage.place(at))
        over = None if at is None or self._is_dragging else _spot_under(at, stage)
        held = self._held or over
        yield from cone_items(spots, None if held is None else held.number)
        if at is None or not self._is_dragging or self._pressed is None:
            return
        if self._held is not None:
            yield from landing_items(self._held, _landing(at, stage)[1])
        else:
            corners = np.array(self._pressed.at), np.array(at.at)
            yield box(*corners, stage.camera)

    def hint(self, stage: ParameterStage) -> str:
        """What can be done here, for the status bar."""
        if self._is_dragging:
            return CONE_DRAG if self._held is not None else BOX
        at = self._pointer
        return CONE if at is not None and _spot_under(at, stage) is not None else HINT

    def _land(self, held: Spot, at: Pointer, stage: ParameterStage) -> None:
        points = list(stage.sheet.cone_points)
        vertex = _landing(at, stage)[0]
        if vertex != points[held.number]:
            points[held.number] = vertex
            self.cones_chosen.emit(tuple(points))


HINT = "Click or drag a box to select faces · Shift adds · wheel zooms, middle drag pans"
BOX = "Select by a box · Shift adds · Ctrl takes out · Esc"
CONE = "Drag this cone point of the pillow to another vertex"
CONE_DRAG = "Let go over the vertex where the cone point is to be · Esc"


def _spot_under(at: Pointer, stage: ParameterStage) -> Spot | None:
    spots = stage.spots
    if not spots:
        return None
    places = stage.camera.to_screen(np.stack([spot.place for spot in spots]))
    away = np.hypot(*(places - at.at).T)
    nearest = int(away.argmin())
    return spots[nearest] if away[nearest] <= REACH else None


def _landing(at: Pointer, stage: ParameterStage) -> tuple[int, Floats]:
    """The vertex nearest to the pointer, and where it is seen."""
    place, unfolding = stage.place(at), stage.sheet.unfolding
    face = stage.face_at(place)
    if face != NONE:
        return unfolding.vertex_of_face(face, place)
    vertex = unfolding.vertex_near(place)
    own = unfolding.vertex_places[[vertex]]
    return vertex, unfolding.domain.nearest(own, place[None])[0]


def _clicked(at: Pointer, stage: ParameterStage) -> Selection:
    face, selection = stage.face_at(stage.place(at)), stage.selection
    adds = Held.SHIFT in at.held
    if face == NONE:
        return selection if adds else Selection.of_shapes([stage.shape_id])
    line = LineId(stage.shape_id, face)
    return selection.toggled(line) if adds else Selection.of_lines([line])


def _boxed(start: Pointer, end: Pointer, stage: ParameterStage) -> Selection:
    low, high = np.sort(np.stack([stage.place(start), stage.place(end)]), axis=0)
    faces = stage.sheet.unfolding.faces_within(low, high).tolist()
    lines = {LineId(stage.shape_id, face) for face in faces}
    selection = stage.selection
    if Held.CTRL in end.held:
        return Selection(selection.lines - lines, selection.shapes)
    if Held.SHIFT in end.held:
        return Selection(selection.lines | lines, selection.shapes, selection.active)
    return Selection.of_lines(lines) if lines else Selection.of_shapes([stage.shape_id])
