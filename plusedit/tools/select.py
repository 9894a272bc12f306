"""Select, move control points and curves, turn and stretch directions, select by a box."""

from typing import ClassVar

import numpy as np

from plusedit.commands.base import Targets
from plusedit.commands.directions import ResetDirections
from plusedit.document.joints import joined
from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.interaction.gizmo_picking import gizmo_in
from plusedit.interaction.highlighting import highlight
from plusedit.interaction.hits import Hit
from plusedit.interaction.moving import move_drag
from plusedit.interaction.net_picking import edge_under, planes_along
from plusedit.interaction.picking import all_under, inside, under
from plusedit.interaction.readout import box
from plusedit.interaction.space_moving import Along
from plusedit.interaction.space_turning import Axis, axis_drag
from plusedit.interaction.tool import (
    REACH,
    Drag,
    Feedback,
    Held,
    Outcome,
    Pointer,
    Shown,
    Stage,
    register,
)
from plusedit.interaction.turning import pull_drag, side_of, turn_drag
from plusedit.scene.camera import PlaneCamera

EMPTY = 2.0 * REACH  # pixels to anything: only a click farther off clears the selection

BOX_HINT = "Select by a box · Shift adds · Ctrl takes out · Esc"
HINTS = {
    "dot": "Drag to move · click selects, Shift adds · Alt takes what lies below",
    "grip": "Drag to rotate · Ctrl snaps to 15° · Shift is slow · Alt stretches · "
    "double-click: automatic again",
    "curve": "Drag to move the shape · click selects, Shift adds · double-click: all its lines",
    "surface": "Drag to move the shape · click selects, Shift adds · "
    "double-click: all its planes, or the row or column of a net edge",
    "mesh": "Drag to move the shape · click selects, Shift adds · double-click: the face there",
    "face": "Click selects this control plane, Shift adds · drag moves the shape · "
    "Shift or Ctrl + drag selects by a box · Esc: the shape",
    "held": "Drag to move the control plane · click selects, Shift takes out · "
    "Shift or Ctrl + drag selects by a box · Esc: the shape",
    "arrow": "Drag to move along this axis · Ctrl snaps to the grid · type a distance",
    "ring": "Drag to turn the plane about this axis · Ctrl snaps to 15° · Shift is slow · "
    "type degrees",
    "edge": "Double-click selects the {row} of control planes along this edge, Shift adds it",
    "": "Click or drag a box to select · V P B D I H choose tools · G R S move, rotate, scale",
}
SPACE_HINT = (
    "Click or drag a box to select · middle drag or Alt + drag orbits, Shift + middle drag pans, "
    "wheel zooms"
)
CURSORS = {"grip": "turn", "ring": "turn", "edge": "arrow"}


@register("select")
class Select:
    """The tool for what is there already."""

    title: ClassVar[str] = "Select"
    shortcut: ClassVar[str] = "V"
    order: ClassVar[int] = 10

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Whatever was pressed on: a dot, a grip, the gizmo, a shape, or empty ground."""
        hit = under(start.at, stage)
        if hit is None:
            return box_drag(start, stage)
        if hit.kind in ("arrow", "ring"):
            return gizmo_drag(hit, start, stage)
        if hit.kind == "face" and not _is_held(hit, start, stage):
            return _drag_beside(hit, start, stage)
        if hit.line is None:
            return _shape_drag(hit, start, stage)
        selection = stage.selection
        if hit.line not in selection.lines:
            # A line of a shape that is selected as a whole stands for itself once it is grabbed.
            selection = _taken(hit, stage, adding=Held.SHIFT in start.held)
        targets = _editable(selection, stage)
        if hit.kind == "grip":
            return turn_drag(start, stage, targets, hit.line, hit.side, selection)
        if Held.ALT in start.held and not _has_directions(hit.line, stage):
            return pull_drag(start, stage, hit.line, selection)
        return move_drag(start, stage, targets, hit.line, selection)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Select what is under the pointer; far from everything, nothing."""
        if Held.ALT in at.held:
            return _below(at, stage)
        hit = under(at.at, stage)
        if hit is not None:
            return _taken(hit, stage, adding=_adds(hit, at))
        if Held.SHIFT in at.held or under(at.at, stage, EMPTY) is not None:
            return None
        return NOTHING_SELECTED

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """On a grip: back to automatic. On the edge of a net: its row. On a mesh: the face there.

        On another shape: all of it. Elsewhere it is a press.
        """
        hit = under(at.at, stage)
        if hit is not None and hit.kind == "grip":
            side = side_of(stage.design[hit.shape].geometry, hit.side)
            return ResetDirections({hit.shape: (hit.number,)}, side)
        if hit is not None and hit.kind == "mesh" and hit.number >= 0:
            return Selection.of_lines([LineId(hit.shape, hit.number)])
        if hit is not None and hit.kind in ("dot", "arrow", "ring", "mesh", "face"):
            return None
        edge = edge_under(at.at, stage) if hit is None or hit.kind == "surface" else None
        if edge is not None:
            row = planes_along(edge, stage)
            return stage.selection | row if Held.SHIFT in at.held else row
        if hit is None:
            return None
        count = len(stage.design.plus(hit.shape).net)
        return Selection.of_lines(LineId(hit.shape, row) for row in range(count))

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """What a press would take, highlighted."""
        hit = under(at.at, stage)
        if hit is None or hit.kind == "surface":
            hit = edge_under(at.at, stage) or hit
        if hit is None:
            in_plane = isinstance(stage.camera, PlaneCamera)
            return Feedback(hint=HINTS[""] if in_plane else SPACE_HINT)
        # The planes along which u runs are those of one node by v.
        kind = "held" if hit.kind == "face" and hit.line in stage.selection.lines else hit.kind
        hint = HINTS[kind].format(row="row" if hit.axis else "column")
        return Feedback(tuple(highlight(hit, stage)), hint, cursor=CURSORS.get(hit.kind, "move"))

    def keys(self, stage: Stage) -> frozenset[str]:
        """Escape, where faces of a mesh are selected."""
        meshes = [i for i in stage.selection.by_shape() if stage.design[i].mesh is not None]
        return frozenset({"Escape"} if meshes else ())

    def key(self, key: str, stage: Stage) -> Outcome:
        """The shapes that are selected, none of their faces any more."""
        return Selection.of_shapes(stage.selection.shapes)

    def reset(self) -> None:
        """Nothing is remembered between gestures."""


def box_drag(start: Pointer, stage: Stage) -> Drag:
    """Select what lies in a rectangle, live; Shift adds to what was selected, Ctrl takes out."""
    now = yield Shown(feedback=Feedback(hint=BOX_HINT, cursor="cross"))
    while True:
        found = inside(start.at, now.at, stage)
        if Held.SHIFT in now.held:
            found = stage.selection | found
        elif Held.CTRL in now.held:
            found = without(stage.selection, found)
        frame = box(start.at, now.at, stage.camera)
        now = yield Shown(found, Feedback((frame,), BOX_HINT, cursor="cross"))


def without(selection: Selection, other: Selection) -> Selection:
    """What is left of a selection; a shape all of whose selected lines go is gone too."""
    lines = selection.lines - other.lines
    emptied = {line.shape for line in selection.lines} - {line.shape for line in lines}
    whole = other.shapes - {line.shape for line in other.lines}
    shapes = selection.shapes - emptied - whole - {s for s in other.shapes if not _of(s, lines)}
    return Selection(lines, shapes, selection.active)


def _of(shape_id: ShapeId, lines: frozenset[LineId]) -> bool:
    return any(line.shape == shape_id for line in lines)


def gizmo_drag(hit: Hit, start: Pointer, stage: Stage) -> Drag:
    """Move what is selected along an arrow of the gizmo, or turn its planes about a ring."""
    gizmo = gizmo_in(stage)
    if gizmo is None:
        return box_drag(start, stage)
    targets = _editable(stage.selection, stage)
    axis, name = gizmo.axes[hit.axis], gizmo.names[hit.axis]
    if hit.kind == "arrow":
        return move_drag(start, stage, targets, gizmo.line, along=Along(axis, name))
    return axis_drag(start, stage, targets, Axis(gizmo.point, axis, name))


def _shape_drag(hit: Hit, start: Pointer, stage: Stage) -> Drag:
    """Move whole shapes: all that are selected if this one is among them, else this one."""
    among = hit.shape in stage.selection.shapes
    selection = stage.selection if among else Selection.of_shapes([hit.shape])
    targets = Selection.of_shapes(selection.shapes).targets(stage.design)
    if stage.design[hit.shape].mesh is not None:
        return move_drag(start, stage, targets, None, selection)
    points = stage.camera.to_screen(stage.design.plus(hit.shape).net.control_points)
    nearest = int(np.hypot(*(points - start.at).T).argmin())
    return move_drag(start, stage, targets, LineId(hit.shape, nearest), selection)


def _is_held(hit: Hit, start: Pointer, stage: Stage) -> bool:
    """Whether a drag moves the face that was pressed on: it is selected, and no key is held."""
    return hit.line in stage.selection.lines and not _boxes(start)


def _boxes(start: Pointer) -> bool:
    """Whether a drag that begins on the surface of a selected mesh is a box."""
    return bool(start.held & (Held.SHIFT | Held.CTRL))


def _drag_beside(hit: Hit, start: Pointer, stage: Stage) -> Drag:
    """On faces that are not selected: a box, or all of the mesh. Views of a plane see through."""
    if _boxes(start) or isinstance(stage.camera, PlaneCamera):
        return box_drag(start, stage)
    return _shape_drag(hit, start, stage)


def _adds(hit: Hit, at: Pointer) -> bool:
    """Whether a click adds to the selection; to faces Ctrl does so too, as there are many."""
    return Held.SHIFT in at.held or (hit.kind == "face" and Held.CTRL in at.held)


def _editable(selection: Selection, stage: Stage) -> Targets:
    """The selected lines and planes of shapes that can be edited."""
    return {i: rows for i, rows in selection.by_shape().items() if stage.design[i].editable}


def _taken(hit: Hit, stage: Stage, *, adding: bool) -> Selection:
    """The selection after a click on something; a line comes with those it is joined to."""
    selection = stage.selection
    if hit.kind in ("arrow", "ring"):
        return selection
    if hit.line is None:
        return selection.toggled_shape(hit.shape) if adding else Selection.of_shapes([hit.shape])
    lines = joined(stage.design, hit.line)
    if not adding:
        return Selection.of_lines(lines, hit.line)
    if hit.line in selection.lines:
        return Selection(selection.lines - lines, selection.shapes)
    return selection | Selection.of_lines(lines, hit.line)


def _alone(hit: Hit) -> Selection:
    """What was hit and nothing that it is joined to."""
    return Selection.of_shapes([hit.shape]) if hit.line is None else Selection.of_lines([hit.line])


def _below(at: Pointer, stage: Stage) -> Outcome:
    """The next of all that lie under the pointer, after the one that is selected."""
    found: list[Selection] = []
    for hit in all_under(at.at, stage):
        selection = _alone(hit)
        if selection not in found:
            found.append(selection)
    if not found:
        return None
    place = found.index(stage.selection) + 1 if stage.selection in found else 0
    chosen = found[place % len(found)]
    return stage.selection | chosen if Held.SHIFT in at.held else chosen


def _has_directions(line: LineId, stage: Stage) -> bool:
    vectors = stage.design[line.shape].geometry.vectors[:, line.number]
    return bool(vectors.any(axis=1).all())
