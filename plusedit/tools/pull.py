"""Take hold of a curve or surface itself and pull it: what shapes it changes as little as does."""

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from plusedit.commands.pulling import Pull
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.influence import Place
from plusedit.geometry.pulling import Change
from plusedit.interaction.facets import surfaces_under
from plusedit.interaction.moving import PlaneWay, Way, snaps, typed_shift
from plusedit.interaction.picking import curves_under
from plusedit.interaction.places import in_space, seen_axes
from plusedit.interaction.readout import ring, shift_text
from plusedit.interaction.snapping import to_grid
from plusedit.interaction.space_moving import SpaceWay
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
from plusedit.scene.camera import PlaneCamera

REACH = 20.0  # pixels to a curve

CHANGES: tuple[Change, ...] = ("points", "gradients", "both")
WORDS: dict[Change, str] = {
    "points": "control points move",
    "gradients": "control lines turn",
    "both": "control points move and lines turn",
}
SWITCH: dict[Change, str] = {
    "points": "by points  W",
    "gradients": "by directions  W",
    "both": "by points and directions  W",
}
"""what is read beside the pointer, with the key that switches"""
HINT = "Drag a curve or surface to pull it: {now} · W: {then}"
DRAGGED = "{now} · Alt turns lines alone · Ctrl snaps · Shift keeps to an axis · type dx Tab dy"


@dataclass(frozen=True)
class Grip:
    """What is taken hold of."""

    shape: ShapeId
    place: Place


@register("pull")
class PullShape:
    """Drags any point of a shape; a switch says whether points, gradients or both change."""

    title: ClassVar[str] = "Pull the shape"
    shortcut: ClassVar[str] = "D"
    order: ClassVar[int] = 25

    change: ClassVar[Change] = "points"
    """what a person has chosen: for the tools of all views, and for the next time, too"""

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Pull the nearest curve, or the surface under the pointer, from where it was pressed."""
        grip = _grip_under(start.at, stage)
        if grip is None:
            return
        anchor = _point(grip, stage)
        way = _way(grip, anchor, start, stage)
        now = yield Shown(
            Selection.of_shapes([grip.shape]), Feedback((ring(anchor[None]),), self._dragged(start))
        )
        while True:
            goal = _goal(now, way, anchor, stage)
            feedback = Feedback(
                (ring(goal[None]),),
                self._dragged(now),
                shift_text(goal - anchor, stage.camera),
                "grab",
            )
            command = Pull(grip.shape, grip.place, goal, self._meant(now))
            now = yield Shown(command, feedback)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Select the shape that a drag would pull."""
        grip = _grip_under(at.at, stage)
        return None if grip is None else Selection.of_shapes([grip.shape])

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """Nothing more."""
        return None

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """The point that a press would take hold of."""
        then = CHANGES[(CHANGES.index(self.change) + 1) % len(CHANGES)]
        hint = HINT.format(now=WORDS[self.change], then=WORDS[then])
        grip = _grip_under(at.at, stage)
        if grip is None:
            return Feedback(hint=hint)
        mark = ring(_point(grip, stage)[None])
        return Feedback((mark,), hint, SWITCH[self.change], cursor="hand")

    def keys(self, stage: Stage) -> frozenset[str]:
        """The one that switches what changes."""
        return frozenset({"W"})

    def key(self, key: str, stage: Stage) -> Outcome:
        """Let something else change from now on."""
        PullShape.change = CHANGES[(CHANGES.index(self.change) + 1) % len(CHANGES)]
        return None

    def reset(self) -> None:
        """What changes stays as it was chosen."""

    def _meant(self, now: Pointer) -> Change:
        return "gradients" if Held.ALT in now.held else self.change

    def _dragged(self, now: Pointer) -> str:
        words = WORDS[self._meant(now)]
        return DRAGGED.format(now=words[:1].upper() + words[1:])


def _grip_under(at: Floats, stage: Stage) -> Grip | None:
    """On the nearest curve, if one is near, else on the surface there."""
    for hit in curves_under(at, stage, REACH)[:1]:
        return Grip(hit.shape, (hit.u,))
    for hit in surfaces_under(at, stage)[:1]:
        return Grip(hit.shape, (hit.u, hit.v))
    return None


def _point(grip: Grip, stage: Stage) -> Floats:
    """(3,) the point of the shape as it is."""
    if len(grip.place) == 1:
        point: Floats = in_space(stage.design.curve(grip.shape).at([grip.place[0]]))[0]
        return point
    mesh = stage.design[grip.shape].mesh
    if mesh is not None:
        return np.array(mesh.at([grip.place])[0])
    surface = stage.design.surface(grip.shape)
    return np.array(surface.derivatives_at([grip.place], highest=0)[0][0])


def _way(grip: Grip, anchor: Floats, start: Pointer, stage: Stage) -> Way:
    # The pull begins at the shape, not beside it where the pointer may be.
    start = replace(start, **dict(zip("xy", stage.camera.to_screen(anchor[None])[0], strict=True)))
    if isinstance(stage.camera, PlaneCamera):
        return PlaneWay(stage, anchor, start)
    flat = stage.design[grip.shape].geometry.dimension == 2
    return SpaceWay(stage.camera, anchor, start, flat, None)


def _goal(now: Pointer, way: Way, anchor: Floats, stage: Stage) -> Floats:
    """(3,) where the point is to come: as typed, else under the pointer, snapped if wished."""
    typed = typed_shift(now, seen_axes(stage.camera))
    if typed is not None:
        return anchor + typed
    by, free = way.by(now)
    goal: Floats = anchor + by
    if snaps(now, stage):
        goal = np.where(free, to_grid(goal, stage.grid_step), anchor)
    return goal
