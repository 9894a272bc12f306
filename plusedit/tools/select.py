"""Select, move control points and curves, turn and stretch directions, select by a box."""

from typing import ClassVar

import numpy as np

from plusedit.commands.base import Targets
from plusedit.commands.directions import ResetDirections
from plusedit.document.joints import joined
from plusedit.document.selection import NOTHING_SELECTED, LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.interaction.hits import Hit
from plusedit.interaction.moving import move_drag
from plusedit.interaction.picking import all_under, inside, under
from plusedit.interaction.readout import box, ring
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
from plusedit.interaction.turning import pull_drag, turn_drag
from plusedit.scene.drawn import drawn
from plusedit.scene.handles import handles
from plusedit.scene.items import Item, Polyline

EMPTY = 2.0 * REACH  # pixels to anything: only a click farther off clears the selection

BOX_HINT = "Select by a box · Shift adds · Ctrl takes out · Esc"
HINTS = {
    "dot": "Drag to move · click selects, Shift adds · Alt takes what lies below",
    "grip": "Drag to rotate · Ctrl snaps to 15° · Shift is slow · Alt stretches · "
    "double-click: automatic again",
    "curve": "Drag to move the shape · click selects, Shift adds · double-click: all its lines",
    "": "Click or drag a box to select · V P I H choose tools · G R S move, rotate, scale",
}


@register("select")
class Select:
    """The tool for what is there already."""

    title: ClassVar[str] = "Select"
    shortcut: ClassVar[str] = "V"
    order: ClassVar[int] = 10

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Whatever was pressed on: a dot, a grip, a curve, or empty ground."""
        hit = under(start.at, stage)
        if hit is None:
            return box_drag(start, stage)
        if hit.line is None:
            return _curve_drag(hit, start, stage)
        selection = stage.selection
        if hit.line not in selection.lines:
            # A line of a shape that is selected as a whole stands for itself once it is grabbed.
            selection = _taken(hit, stage, adding=Held.SHIFT in start.held)
        targets = {i: rows for i, rows in selection.by_shape().items() if stage.design[i].editable}
        if hit.kind == "grip":
            return turn_drag(start, stage, targets, hit.line, hit.side, selection)
        if Held.ALT in start.held and not _has_direction(hit.line, stage):
            return pull_drag(start, stage, hit.line, selection)
        return move_drag(start, stage, targets, hit.line, selection)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Select what is under the pointer; far from everything, nothing."""
        if Held.ALT in at.held:
            return _below(at, stage)
        hit = under(at.at, stage)
        if hit is not None:
            return _taken(hit, stage, adding=Held.SHIFT in at.held)
        if Held.SHIFT in at.held or under(at.at, stage, EMPTY) is not None:
            return None
        return NOTHING_SELECTED

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """On a grip: back to automatic. On a curve: all its lines. Elsewhere a press."""
        hit = under(at.at, stage)
        if hit is None:
            return None
        if hit.kind == "grip":
            return ResetDirections({hit.shape: (hit.number,)})
        if hit.kind == "curve":
            count = len(stage.design.curve(hit.shape).lines)
            return Selection.of_lines(LineId(hit.shape, row) for row in range(count))
        return None

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """A ring around what a press would take."""
        hit = under(at.at, stage)
        if hit is None:
            return Feedback(hint=HINTS[""])
        cursor = {"dot": "move", "grip": "turn", "curve": "move"}[hit.kind]
        return Feedback((_highlight(hit, stage),), HINTS[hit.kind], cursor=cursor)

    def keys(self, stage: Stage) -> frozenset[str]:
        """None of its own."""
        return frozenset()

    def key(self, key: str, stage: Stage) -> Outcome:
        """Never called."""
        return None

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


def _curve_drag(hit: Hit, start: Pointer, stage: Stage) -> Drag:
    """Move whole shapes: all that are selected if this one is among them, else this one."""
    among = hit.shape in stage.selection.shapes
    selection = stage.selection if among else Selection.of_shapes([hit.shape])
    targets: Targets = {
        shape_id: tuple(range(len(stage.design.curve(shape_id).lines)))
        for shape_id in selection.shapes
        if stage.design[shape_id].editable
    }
    points = stage.camera.to_screen(stage.design.curve(hit.shape).lines.points)
    nearest = int(np.hypot(*(points - start.at).T).argmin())
    return move_drag(start, stage, targets, LineId(hit.shape, nearest), selection)


def _taken(hit: Hit, stage: Stage, *, adding: bool) -> Selection:
    """The selection after a click on something; a line comes with those it is joined to."""
    selection = stage.selection
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


def _has_direction(line: LineId, stage: Stage) -> bool:
    return bool(stage.design.curve(line.shape).directions[line.number].any())


def _highlight(hit: Hit, stage: Stage) -> Item:
    curve = stage.design.curve(hit.shape)
    if hit.kind == "curve":
        return Polyline(drawn(curve, stage.camera).points, "hover", 3.0)
    at: Floats = curve.lines.points[[hit.number]]
    if hit.kind == "grip":
        at = at + hit.side * handles(curve, stage.camera).arms[[hit.number]]
    return ring(at)
