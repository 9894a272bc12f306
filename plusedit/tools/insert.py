"""Put control lines on a curve, and rows and columns of control planes on a surface."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from plusedit.commands.base import Command, Together
from plusedit.commands.planes import InsertRow
from plusedit.commands.shapes import InsertLine
from plusedit.document.design import Design
from plusedit.geometry.blend import Grid
from plusedit.geometry.surface import PlusSurface, Way
from plusedit.interaction.facets import surfaces_under
from plusedit.interaction.moving import move_drag
from plusedit.interaction.picking import curves_under
from plusedit.interaction.readout import number, ring
from plusedit.interaction.tool import (
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

REACH = 20.0  # pixels to a curve
STEPS = 64  # of the line where a row would come

HINT = "Click a curve to insert a control line; its shape stays as far as it can · drag moves it"
SPATIAL_HINT = "Click a curve to insert a control line, a surface to insert a row of planes"
ROW_HINT = "Click to insert a row of planes here, with Shift a column · drag moves it"


@dataclass(frozen=True, eq=False)
class Place:
    """Where something would be inserted."""

    edit: InsertLine | InsertRow
    marks: tuple[Item, ...]
    """what shows it in the view"""
    hint: str
    text: str


@register("insert")
class Insert:
    """Shows what would come where, on the nearest curve or a surface, and puts it there."""

    title: ClassVar[str] = "Insert line or row"
    shortcut: ClassVar[str] = "I"
    order: ClassVar[int] = 30

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Insert a line, or a row of planes, and move it in one step."""
        place = _place_under(start, stage)
        if place is None:
            return
        insert = place.edit
        after = insert.apply(stage.design)
        selection = insert.reselect(stage.selection, stage.design, after)
        line = selection.active or min(selection.lines)
        there = replace(stage, design=after)
        moving = move_drag(start, there, selection.by_shape(), line)
        shown = next(moving)
        while True:
            now = yield Shown(_both(insert, shown.outcome), shown.feedback)
            shown = moving.send(now)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Insert on the nearest curve, if one is near, else on the surface there."""
        place = _place_under(at, stage)
        return None if place is None else place.edit

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """Nothing more: the first click has inserted."""
        return stage.selection

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """Where the line or row would come."""
        place = _place_under(at, stage)
        if place is None:
            hint = SPATIAL_HINT if _has_surfaces(stage.design) else HINT
            return Feedback(hint=hint, cursor="cross")
        return Feedback(place.marks, place.hint, place.text, "cross")

    def keys(self, stage: Stage) -> frozenset[str]:
        """None of its own."""
        return frozenset()

    def key(self, key: str, stage: Stage) -> Outcome:
        """Never called."""
        return None

    def reset(self) -> None:
        """Nothing is remembered between gestures."""


def _place_under(at: Pointer, stage: Stage) -> Place | None:
    for hit in curves_under(at.at, stage, REACH)[:1]:
        point = stage.design.curve(hit.shape).at([hit.u])
        text = f"u {number(hit.u, 3)}"
        return Place(InsertLine(hit.shape, hit.u), (ring(point),), HINT, text)
    found = surfaces_under(at.at, stage)[:1]
    for hit in (hit for hit in found if hit.kind == "surface"):
        way: Way = "v" if Held.SHIFT in at.held else "u"
        value = hit.v if way == "v" else hit.u
        marks = tuple(_line_of(stage.design.surface(hit.shape), way, value))
        edit = InsertRow(hit.shape, way, value)
        return Place(edit, marks, ROW_HINT, f"{way} {number(value, 3)}")
    return None


def _line_of(surface: PlusSurface, way: Way, value: float) -> Iterator[Item]:
    """The line of the surface on which a parameter has that value."""
    here, along = Grid(np.array([value])), Grid.uniform(STEPS + 1)
    points = surface.sample(here, along)[0] if way == "u" else surface.sample(along, here)[:, 0]
    yield Polyline(np.ascontiguousarray(points), "hover", 2.0)


def _has_surfaces(design: Design) -> bool:
    return any(True for _ in design.surfaces())


def _both(insert: InsertLine | InsertRow, then: Outcome) -> Command:
    if not isinstance(then, Command):
        return insert
    return Together(insert.label, (insert, then))
