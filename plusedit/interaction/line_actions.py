"""Actions on the selected control lines: nudges, turns, directions, mirrors."""

from collections.abc import Callable, Iterator
from math import radians

import numpy as np

from plusedit.commands.lines import (
    MovePoints,
    ResetDirections,
    ReverseDirections,
    SetLength,
    Transform,
    Turn,
)
from plusedit.document.design import EditError
from plusedit.interaction.actions import EditAction
from plusedit.interaction.modal import chosen
from plusedit.interaction.picking import seen_plane
from plusedit.interaction.tool import Outcome, Stage

MENU = "Control lines"

SPEEDS = (("", "", 1.0), ("Shift+", " far", 10.0), ("Ctrl+", " a little", 0.1))
"""modifier, what it adds to the title, and the factor of the grid step"""

TURNS = (("", "", 5.0), ("Shift+", " far", 15.0), ("Ctrl+", " a little", 0.5))
"""modifier, what it adds to the title, and degrees"""

NUDGES = (
    ("left", "Left", 0, -1.0),
    ("right", "Right", 0, 1.0),
    ("up", "Up", 1, 1.0),
    ("down", "Down", 1, -1.0),
    ("nearer", "PgUp", 2, 1.0),
    ("farther", "PgDown", 2, -1.0),
)
"""name, key, direction in the view (to the right, upwards, out of it) and sign"""


def nudge(stage: Stage, way: int, steps: float) -> Outcome:
    """Move what is selected by steps of the grid, to the right, upwards or out of the view."""
    targets = chosen(stage)
    plane = seen_plane(stage.camera)
    axis = (*plane, 3 - sum(plane))[way]
    if all(stage.design.curve(i).dimension <= axis for i in targets):
        raise EditError("A plane curve can't leave its plane.")
    # Seen from the front the y axis runs away from the eye, all others towards it.
    towards = -1.0 if axis == 1 and way == 2 else 1.0
    by = np.zeros(3)
    by[axis] = towards * steps * stage.grid_step
    return MovePoints(targets, by)


def turn(stage: Stage, degrees: float) -> Outcome:
    """Turn the selected directions, counter-clockwise as seen."""
    return Turn(chosen(stage), radians(degrees), seen_plane(stage.camera))


def mirror(stage: Stage, way: int) -> Outcome:
    """Mirror what is selected about the middle of its control points, left-right or up-down."""
    targets = chosen(stage)
    axis = seen_plane(stage.camera)[way]
    values = [
        stage.design.curve(i).lines.points[list(rows), axis]
        for i, rows in targets.items()
        if axis < stage.design.curve(i).dimension
    ]
    if not values:
        raise EditError("A plane curve can't be mirrored out of its plane.")
    row = np.concatenate(values)
    matrix, offset = np.eye(3), np.zeros(3)
    matrix[axis, axis] = -1.0
    offset[axis] = row.min() + row.max()
    return Transform(targets, matrix, offset, "Mirror")


def _nudges() -> Iterator[EditAction]:
    for name, key, way, sign in NUDGES:
        for modifier, more, factor in SPEEDS:
            yield EditAction(
                f"nudge_{name}{more.replace(' ', '_')}",
                f"Nudge {name}{more}",
                (modifier + key,),
                f"{MENU}/Nudge",
                _nudge_by(way, sign * factor),
            )


def _nudge_by(way: int, steps: float) -> Callable[[Stage], Outcome]:
    return lambda stage: nudge(stage, way, steps)


def _turns() -> Iterator[EditAction]:
    for name, key, sign in (("left", "[", 1.0), ("right", "]", -1.0)):
        for modifier, more, degrees in TURNS:
            yield EditAction(
                f"turn_{name}{more.replace(' ', '_')}",
                f"Turn {name} by {degrees:g}°",
                (modifier + key,),
                f"{MENU}/Turn",
                _turn_by(sign * degrees),
            )


def _turn_by(degrees: float) -> Callable[[Stage], Outcome]:
    return lambda stage: turn(stage, degrees)


ACTIONS = (
    *_nudges(),
    *_turns(),
    EditAction(
        "reverse_directions",
        "Reverse direction",
        ("Shift+R",),
        MENU,
        lambda stage: ReverseDirections(chosen(stage)),
    ),
    EditAction(
        "reset_directions",
        "Reset to automatic",
        ("Shift+A",),
        MENU,
        lambda stage: ResetDirections(chosen(stage)),
    ),
    EditAction(
        "unit_length",
        "Make direction of length 1",
        (),
        MENU,
        lambda stage: SetLength(chosen(stage), 1.0),
    ),
    EditAction(
        "mirror_horizontally", "Mirror left to right", (), MENU, lambda stage: mirror(stage, 0)
    ),
    EditAction(
        "mirror_vertically", "Mirror top to bottom", (), MENU, lambda stage: mirror(stage, 1)
    ),
)
