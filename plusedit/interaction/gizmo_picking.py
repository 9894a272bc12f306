"""The parts of the gizmo under the pointer."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.interaction.hits import Hit, nearest_on_segments
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.gizmo import Gizmo, gizmo_of, part_items
from plusedit.scene.items import Item

AWAY = 4.0  # pixels by which the far side of a ring counts as farther from the pointer


def gizmo_in(stage: Stage) -> Gizmo | None:
    """The gizmo that is shown."""
    if stage.options.handles == "none":
        return None
    return gizmo_of(stage.design, stage.selection, stage.camera)


def gizmo_under(at: Floats, stage: Stage, reach: float = REACH) -> Hit | None:
    """The nearest arrow or ring within reach; the near sides of rings before far ones."""
    gizmo = gizmo_in(stage)
    if gizmo is None:
        return None
    found = [hit for axis in range(3) for hit in _parts(at, gizmo, axis, stage)]
    near = [hit for hit in found if hit.distance <= reach]
    return min(near, key=lambda hit: hit.distance + AWAY * (hit.depth > 0.0), default=None)


def _parts(at: Floats, gizmo: Gizmo, axis: int, stage: Stage) -> list[Hit]:
    """The arrow and the ring of an axis; what is turned away has the depth 1."""
    line, camera = gizmo.line, stage.camera
    found = []
    if gizmo.shown(axis):
        ends = camera.to_screen(gizmo.arrow(axis))
        distance = float(nearest_on_segments(at, ends[:1], ends[1:])[1][0])
        found.append(Hit("arrow", *line, axis=axis, distance=distance))
    if gizmo.turns:
        ring, near = camera.to_screen(gizmo.ring(axis)), gizmo.near_side(axis)
        _, distances = nearest_on_segments(at, ring[:-1], ring[1:])
        place = int(np.argmin(distances + AWAY * ~near))
        distance, away = float(distances[place]), float(not near[place])
        found.append(Hit("ring", *line, axis=axis, distance=distance, depth=away))
    return found


def gizmo_highlight(hit: Hit, stage: Stage) -> tuple[Item, ...]:
    """The part that a press would take, in the color of that."""
    gizmo = gizmo_in(stage)
    if gizmo is None or hit.kind not in ("arrow", "ring"):
        return ()
    return part_items(gizmo, stage.camera, "ring" if hit.kind == "ring" else "arrow", hit.axis)
