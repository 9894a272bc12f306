"""The parts of the gizmo under the pointer."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.geometry.arrays import Floats
from plusedit.interaction.hits import Hit, nearest_on_segments
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import Camera
from plusedit.scene.gizmo import Gizmo, gizmo_of, part_items
from plusedit.scene.items import Item

AWAY = 4.0  # pixels by which the far side of a ring counts as farther from the pointer


@dataclass(frozen=True, eq=False)
class Parts:
    """The arrows and rings of a gizmo as segments in pixels."""

    gizmo: Gizmo
    starts: Floats
    """(k, 2)"""
    ends: Floats
    rings: NDArray[np.bool_]
    """(k,) false where it is an arrow"""
    axes: NDArray[np.intp]
    away: NDArray[np.bool_]
    """(k,) whether it is on the side turned away from the eye"""


def gizmo_in(stage: Stage) -> Gizmo | None:
    """The gizmo that is shown."""
    parts = _parts_in(stage)
    return None if parts is None else parts.gizmo


def _parts_in(stage: Stage) -> Parts | None:
    if stage.options.handles == "none":
        return None
    return parts_of(stage.design, stage.selection, stage.camera)


@lru_cache(maxsize=4)
def parts_of(design: Design, selection: Selection, camera: Camera) -> Parts | None:
    """The gizmo of what is selected as it is seen; None where there is none."""
    gizmo = gizmo_of(design, selection, camera)
    if gizmo is None:
        return None
    arrows = [axis for axis in range(3) if gizmo.shown(axis)]
    rings = range(3) if gizmo.turns else ()
    lines = [gizmo.arrow(axis) for axis in arrows] + [gizmo.ring(axis) for axis in rings]
    screen = [camera.to_screen(line) for line in lines]
    away = [np.zeros(1, np.bool_) for _ in arrows] + [~gizmo.near_side(axis) for axis in rings]
    counts = [len(line) - 1 for line in lines]
    return Parts(
        gizmo,
        np.concatenate([np.zeros((0, 2)), *(line[:-1] for line in screen)]),
        np.concatenate([np.zeros((0, 2)), *(line[1:] for line in screen)]),
        np.repeat([False] * len(arrows) + [True] * len(rings), counts),
        np.repeat(np.array([*arrows, *rings], dtype=np.intp), counts),
        np.concatenate([np.zeros(0, np.bool_), *away]),
    )


def gizmo_under(at: Floats, stage: Stage, reach: float = REACH) -> Hit | None:
    """The nearest arrow or ring within reach; the near sides of rings before far ones."""
    parts = _parts_in(stage)
    if parts is None or not len(parts.starts):
        return None
    _, distances = nearest_on_segments(at, parts.starts, parts.ends)
    counted = np.where(distances <= reach, distances + AWAY * parts.away, np.inf)
    row = int(counted.argmin())
    if distances[row] > reach:
        return None
    return Hit(
        "ring" if parts.rings[row] else "arrow",
        *parts.gizmo.line,
        axis=int(parts.axes[row]),
        distance=float(distances[row]),
        depth=float(parts.away[row]),
    )


def gizmo_highlight(hit: Hit, stage: Stage) -> tuple[Item, ...]:
    """The part that a press would take, in the color of that."""
    gizmo = gizmo_in(stage)
    if gizmo is None or hit.kind not in ("arrow", "ring"):
        return ()
    return part_items(gizmo, stage.camera, "ring" if hit.kind == "ring" else "arrow", hit.axis)
