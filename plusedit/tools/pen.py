"""Draw curves: every click or drag places a control line."""

from math import atan2, sqrt
from typing import ClassVar

import numpy as np

from plusedit.commands.base import Command, fitted
from plusedit.commands.directions import quarter_exact
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.drawing import (
    Placed,
    Stroke,
    begun,
    can_close,
    closed,
    continued,
    shortened,
)
from plusedit.interaction.moving import snaps
from plusedit.interaction.places import on_sheet, seen_axes, seen_plane, sheet_of
from plusedit.interaction.readout import ring, shift_text, thread
from plusedit.interaction.snapping import PEN_ANGLE, to_grid, to_step
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
from plusedit.scene.items import Item, Polyline

PREVIEW = Grid.uniform(257)

SQRT_HALF = sqrt(0.5)
AT_REST = 3.0  # pixels

START_HINT = "Click to place the first control line, drag to direct it · Ctrl snaps to the grid"
DRAW_HINT = (
    "Click to place, drag to direct · C or the first point closes · Enter ends · "
    "Backspace takes back · Ctrl snaps · Shift keeps to 45°"
)


@register("pen")
class Pen:
    """Continues the curve whose end is the only selected line, else begins a new one."""

    title: ClassVar[str] = "Pen"
    shortcut: ClassVar[str] = "P"
    order: ClassVar[int] = 20

    def __init__(self) -> None:
        self._first: Placed | None = None
        """where a new curve begins; kept, so that taking back the second line leaves it"""
        self._stroke: Stroke | None = None
        """what was drawn last, to be gone on with after undo has taken its selection"""

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Place a line and direct it; with Alt its handle is as long as drawn."""
        stroke = self._continued(stage)
        if stroke is not None and self._closes(start, stroke, stage):
            return
        point = self._point(start, stroke, stage)
        now = yield Shown(feedback=Feedback(hint=DRAW_HINT, cursor="cross"))
        while True:
            tip = on_sheet(now.at, point, stage.camera)
            placed = Placed(point, self._direction(point, tip, now, stroke, stage))
            edit = self._edit(placed, stroke, stage)
            arm = np.stack([2.0 * point - tip, tip])
            items: tuple[Item, ...] = (thread(arm), ring(point[None]))
            now = yield Shown(edit, Feedback(items, DRAW_HINT, cursor="cross"))

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Place a line, or close the curve on its first point."""
        stroke = self._continued(stage)
        if stroke is not None and self._closes(at, stroke, stage):
            return self._ended(closed(stroke, stage.design, stage.new_curves))
        return self._edit(Placed(self._point(at, stroke, stage)), stroke, stage)

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """The curve is done; its last line came with the first click."""
        return self._end(stage) or stage.selection

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """The curve as it would be with a line at the pointer."""
        stroke = self._continued(stage)
        first = self._pending(stage)
        if stroke is None and first is None:
            point = self._point(at, None, stage)
            return Feedback((ring(point[None]),), START_HINT, cursor="cross")
        if stroke is not None and self._closes(at, stroke, stage):
            return self._closing(stroke, stage)
        point = self._point(at, stroke, stage)
        before = self._last_point(stroke, stage)
        if before is not None and _is_there(point, before, stage):
            # Just clicked: a second line at the same place is hardly what comes next.
            return Feedback((ring(point[None]),), DRAW_HINT, cursor="cross")
        edit = self._edit_of(Placed(point), stroke, stage)
        items: list[Item] = [ring(point[None])]
        text = ""
        if before is not None:
            items.insert(0, thread(np.stack([fitted(before, len(point)), point])))
            text = shift_text(fitted(point, 3) - fitted(before, 3), stage.camera)
        if edit is not None:
            items.insert(0, _preview(edit, stage.design))
        return Feedback(tuple(items), DRAW_HINT, text, "cross")

    def keys(self, stage: Stage) -> frozenset[str]:
        """Those that end, close or take back, while there is something drawn."""
        stroke = self._continued(stage)
        if stroke is None and self._pending(stage) is None:
            return frozenset()
        keys = {"Enter", "Escape", "Backspace"}
        if stroke is not None and can_close(stroke, stage.design):
            keys.add("C")
        return frozenset(keys)

    def key(self, key: str, stage: Stage) -> Outcome:
        """End, close, or take the last line back."""
        stroke = self._continued(stage)
        if key in ("Enter", "Escape"):
            return self._end(stage)
        if stroke is None:
            self._first = None
            return None
        if key == "C":
            return self._ended(closed(stroke, stage.design, stage.new_curves))
        return self._taken_back(stroke, stage)

    def reset(self) -> None:
        """Forget the first point of a curve that has no second one yet."""
        self._first = self._stroke = None

    # What is drawn

    def _continued(self, stage: Stage) -> Stroke | None:
        """The open curve whose end is the only selected line, or the one drawn just now."""
        selection, design = stage.selection, stage.design
        if len(selection.lines) == 1 and len(selection.shapes) == 1:
            (line,) = selection.lines
            curve = design[line.shape].curve
            if curve is None or curve.closed or not design[line.shape].editable:
                return None
            if line.number not in (0, len(curve.lines) - 1):
                return None
            return Stroke(line.shape, line.number != 0)
        stroke = self._stroke
        if stroke is None or selection.lines or selection.shapes - {stroke.shape}:
            return None
        shape = design.shapes.get(stroke.shape)
        if shape is None or not shape.editable or shape.curve is None or shape.curve.closed:
            return None
        return stroke

    def _pending(self, stage: Stage) -> Placed | None:
        """The first point of a curve that is not there yet, or no longer."""
        if self._stroke is not None and self._stroke.shape in stage.design:
            return None
        return self._first

    def _edit(self, placed: Placed, stroke: Stroke | None, stage: Stage) -> Command | None:
        """The edit that places a line; the first of a curve is only remembered."""
        edit = self._edit_of(placed, stroke, stage)
        if edit is None:
            self._first, self._stroke = placed, None
        elif stroke is None:
            shape_id = stage.design.unused_id("curve")
            self._stroke = Stroke(shape_id, True)
        else:
            self._stroke = stroke
        return edit

    def _edit_of(self, placed: Placed, stroke: Stroke | None, stage: Stage) -> Command | None:
        if stroke is not None:
            return continued(stroke, placed, stage.design, stage.new_curves)
        first = self._pending(stage)
        if first is None or (first.point == placed.point).all():
            return None
        return begun(first, placed, stage.design, stage.new_curves)

    def _end(self, stage: Stage) -> Outcome:
        """Done: the curve is selected as a whole, closed if new curves are to be."""
        stroke = self._continued(stage)
        if stroke is None:
            self._first = None
            return None
        if stage.new_curves.closed and can_close(stroke, stage.design):
            return self._ended(closed(stroke, stage.design, stage.new_curves))
        return self._ended(Selection.of_shapes([stroke.shape]))

    def _ended(self, outcome: Outcome) -> Outcome:
        self._first = self._stroke = None
        return outcome

    def _taken_back(self, stroke: Stroke, stage: Stage) -> Command:
        curve = stage.design.curve(stroke.shape)
        self._stroke = stroke
        if len(curve.lines) == 2:
            row = stroke.start(curve)
            given = None if curve.lines.automatic[row] else curve.lines.given[row]
            self._first = Placed(curve.lines.points[row], given)
        return shortened(stroke, stage.design)

    # Where the pointer means

    def _last_point(self, stroke: Stroke | None, stage: Stage) -> Floats | None:
        if stroke is None:
            first = self._pending(stage)
            return None if first is None else first.point
        curve = stage.design.curve(stroke.shape)
        point: Floats = curve.lines.points[stroke.end(curve)]
        return point

    def _point(self, at: Pointer, stroke: Stroke | None, stage: Stage) -> Floats:
        """(dim,) the point meant: on the grid with Ctrl, at 45 degrees to the last with Shift."""
        before = self._last_point(stroke, stage)
        like = before if before is not None else sheet_of(stage.camera)
        point = on_sheet(at.at, like, stage.camera)
        if before is not None and Held.SHIFT in at.held:
            point = _at_round_angle(point, before, seen_plane(stage.camera))
        elif snaps(at, stage):
            axes = [axis for axis in seen_axes(stage.camera) if axis < len(point)]
            point[axes] = to_grid(point[axes], stage.grid_step)
        return point

    def _direction(
        self, point: Floats, tip: Floats, now: Pointer, stroke: Stroke | None, stage: Stage
    ) -> Floats | None:
        """From the point to the pointer: of length 1, or with Alt as long as its handle."""
        way = tip - point
        if not way.any():
            return None
        if Held.SHIFT in now.held:
            way = _at_round_angle(tip, point, seen_plane(stage.camera)) - point
        if Held.ALT not in now.held:
            return unit(way)
        edit = self._edit_of(Placed(point), stroke, stage)
        if edit is None:
            return unit(way)
        curve = _curve_of(edit, stage.design)
        reach = curve.spacing * abs(curve.s)
        return way / reach if reach > 0.0 else unit(way)

    def _closes(self, at: Pointer, stroke: Stroke, stage: Stage) -> bool:
        """Whether a press here is on the first point of a curve that can be closed."""
        if not can_close(stroke, stage.design):
            return False
        curve = stage.design.curve(stroke.shape)
        first = curve.lines.points[[stroke.start(curve)]]
        return bool(np.hypot(*(stage.camera.to_screen(first)[0] - at.at)) <= REACH)

    def _closing(self, stroke: Stroke, stage: Stage) -> Feedback:
        curve = stage.design.curve(stroke.shape)
        mark = ring(curve.lines.points[[stroke.start(curve)]])
        try:
            shown = _preview(closed(stroke, stage.design, stage.new_curves), stage.design)
        except EditError as error:
            return Feedback((mark,), str(error), cursor="cross")
        return Feedback((shown, mark), "Click to close the curve", cursor="cross")


def _is_there(point: Floats, before: Floats, stage: Stage) -> bool:
    """Whether two points are one on the screen, as far as a hand at rest can tell."""
    there = np.stack([point, fitted(before, len(point))])
    return bool(np.hypot(*np.diff(stage.camera.to_screen(there), axis=0)[0]) <= AT_REST)


def _at_round_angle(point: Floats, about: Floats, plane: tuple[int, int]) -> Floats:
    """The point brought to the nearest line through another at a multiple of 45 degrees."""
    if max(plane) >= len(point):
        return point
    columns = list(plane)
    x, y = point[columns] - about[columns]
    along = np.array(quarter_exact(to_step(atan2(y, x), PEN_ANGLE)))
    if along.all():
        along = np.sign(along) * SQRT_HALF  # the same number twice, so that x and y agree
    result = point.copy()
    result[columns] = about[columns] + (x * along[0] + y * along[1]) * along
    return result


def _curve_of(edit: Command, design: Design) -> PlusCurve:
    """The curve that the edit changes or adds."""
    after = edit.apply(design)
    (changed,) = (i for i in after if after.shapes[i] is not design.shapes.get(i))
    return after.curve(changed)


def _preview(edit: Command, design: Design) -> Item:
    return Polyline(_curve_of(edit, design).sample(PREVIEW), "hover", 1.5)
