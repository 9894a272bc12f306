"""Actions on the selected control lines and planes: nudges, turns, directions, mirrors."""

from collections.abc import Callable, Iterator
from math import radians

import numpy as np

from plusedit.commands.base import Command, Together, named
from plusedit.commands.lines import (
    MovePoints,
    ResetDirections,
    ReverseDirections,
    Rotate,
    SetLength,
    Transform,
    Turn,
)
from plusedit.commands.rotation import rotation
from plusedit.document.design import EditError
from plusedit.interaction.actions import EditAction
from plusedit.interaction.modal import chosen
from plusedit.interaction.moving import points_meant
from plusedit.interaction.tool import Outcome, Stage
from plusedit.interaction.world_axes import lifting_axis, world_axes
from plusedit.scene.camera import PlaneCamera

MENU = "Control lines"

SPEEDS = (("", "", 1.0), ("Shift+", " far", 10.0), ("Ctrl+", " a little", 0.1))
"""modifier, what it adds to the title, and the factor of the grid step"""

TURNS = (("", "", 5.0), ("Shift+", " far", 15.0), ("Ctrl+", " a little", 0.5))
"""modifier, what it adds to the title, and degrees"""

NUDGES = (
    ("left", "left", "Left", 0, -1.0),
    ("right", "right", "Right", 0, 1.0),
    ("up", "up", "Up", 1, 1.0),
    ("down", "down", "Down", 1, -1.0),
    ("nearer", "nearer, up in space", "PgUp", 2, 1.0),
    ("farther", "farther, down in space", "PgDown", 2, -1.0),
)
"""name, words, key, direction in the view (to the right, upwards, out of it) and sign"""


def nudge(stage: Stage, way: int, steps: float) -> Outcome:
    """Move what is selected by steps of the grid, to the right, upwards or out of the view.

    In space to the right and upwards mean the axes nearest to that, and the third way is along z.
    """
    targets = chosen(stage)
    axes = (*world_axes(stage.camera)[:2], lifting_axis(stage.camera))
    axis, sign = axes[way]
    if all(stage.design[i].geometry.dimension <= axis for i in targets):
        raise EditError("A plane curve can't leave its plane.")
    by = np.zeros(3)
    by[axis] = sign * steps * stage.grid_step
    return MovePoints(targets, by)


def turn(stage: Stage, degrees: float) -> Outcome:
    """Turn the selected directions, counter-clockwise as seen.

    In space about the way of looking; plane curves turn in their plane there too.
    """
    targets, camera = chosen(stage), stage.camera
    if isinstance(camera, PlaneCamera):
        return Turn(targets, radians(degrees), camera.axes)
    toward = camera.axes_of_view[2]
    flat = {i: rows for i, rows in targets.items() if stage.design[i].geometry.dimension == 2}
    solid = {i: rows for i, rows in targets.items() if i not in flat}
    edits: list[Command] = []
    if solid:
        edits.append(Rotate(solid, rotation(toward, radians(degrees))))
    if flat:
        edits.append(Turn(flat, radians(degrees if toward[2] >= 0.0 else -degrees)))
    if len(edits) == 1:
        return edits[0]
    return Together(f"Rotate {named(stage.design, targets)}", tuple(edits))


def mirror(stage: Stage, way: int) -> Outcome:
    """Mirror what is selected about the middle of its control points, left-right or up-down."""
    targets = chosen(stage)
    axis, _ = world_axes(stage.camera)[way]
    values = [
        points_meant(stage.design, i, rows)[:, axis]
        for i, rows in targets.items()
        if axis < stage.design[i].geometry.dimension
    ]
    if not values:
        raise EditError("A plane curve can't be mirrored out of its plane.")
    row = np.concatenate(values)
    matrix, offset = np.eye(3), np.zeros(3)
    matrix[axis, axis] = -1.0
    offset[axis] = row.min() + row.max()
    return Transform(targets, matrix, offset, "Mirror")


def _nudges() -> Iterator[EditAction]:
    for name, words, key, way, sign in NUDGES:
        for modifier, more, factor in SPEEDS:
            yield EditAction(
                f"nudge_{name}{more.replace(' ', '_')}",
                f"Nudge {words}{more}",
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
