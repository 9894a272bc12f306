"""Put control lines on a curve that is there."""

from dataclasses import replace
from typing import ClassVar

from plusedit.commands.base import Command, Together
from plusedit.commands.shapes import InsertLine
from plusedit.interaction.hits import Hit
from plusedit.interaction.moving import move_drag
from plusedit.interaction.picking import curves_under
from plusedit.interaction.readout import number, ring
from plusedit.interaction.tool import Drag, Feedback, Outcome, Pointer, Shown, Stage, register

REACH = 20.0  # pixels to a curve

HINT = "Click a curve to insert a control line; its shape stays as far as it can · drag moves it"


@register("insert")
class Insert:
    """Shows where on the nearest curve a line would come, and puts it there."""

    title: ClassVar[str] = "Insert control line"
    shortcut: ClassVar[str] = "I"
    order: ClassVar[int] = 30

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Insert a line and move it in one step."""
        hit = _curve_under(start, stage)
        if hit is None:
            return
        insert = InsertLine(hit.shape, hit.u)
        after = insert.apply(stage.design)
        (line,) = insert.reselect(stage.selection, stage.design, after).lines
        moving = move_drag(start, replace(stage, design=after), {line.shape: (line.number,)}, line)
        shown = next(moving)
        while True:
            now = yield Shown(_both(insert, shown.outcome), shown.feedback)
            shown = moving.send(now)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Insert a line on the nearest curve, if one is near."""
        hit = _curve_under(at, stage)
        return None if hit is None else InsertLine(hit.shape, hit.u)

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """Nothing more: the first click has inserted."""
        return stage.selection

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """Where the line would come."""
        hit = _curve_under(at, stage)
        if hit is None:
            return Feedback(hint=HINT, cursor="cross")
        point = stage.design.curve(hit.shape).at([hit.u])
        return Feedback((ring(point),), HINT, f"u {number(hit.u, 3)}", "cross")

    def keys(self, stage: Stage) -> frozenset[str]:
        """None of its own."""
        return frozenset()

    def key(self, key: str, stage: Stage) -> Outcome:
        """Never called."""
        return None

    def reset(self) -> None:
        """Nothing is remembered between gestures."""


def _curve_under(at: Pointer, stage: Stage) -> Hit | None:
    found = curves_under(at.at, stage, REACH)
    return found[0] if found else None


def _both(insert: InsertLine, then: Outcome) -> Command:
    if not isinstance(then, Command):
        return insert
    return Together(insert.label, (insert, then))
