"""The edges of control nets under the pointer: each belongs to a row or a column of planes."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.commands.planes import row_numbers
from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.interaction.hits import Hit, nearest_on_segments
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import Camera
from plusedit.scene.handles import handle_shapes

NET = "polygon"
"""The overlay that draws control nets."""


@dataclass(frozen=True, eq=False)
class Edges:
    """The edges of some control nets in pixels."""

    starts: Floats
    """(k, 2)"""
    ends: Floats
    numbers: NDArray[np.intp]
    """(k,) of the planes where they begin"""
    axes: NDArray[np.intp]
    """(k,) 0 where u runs along them, 1 where v does"""
    owners: NDArray[np.intp]
    """(k,) which of the shapes"""


def edge_under(at: Floats, stage: Stage, reach: float = REACH) -> Hit | None:
    """The nearest edge within reach of the nets that are shown and can be edited."""
    if NET not in stage.options.overlays:
        return None
    shown = handle_shapes(stage.design, stage.selection, stage.options)
    shapes = tuple(i for i in shown if stage.design[i].surface is not None)
    edges = edges_of(stage.design, shapes, stage.camera)
    if not len(edges.starts):
        return None
    _, distances = nearest_on_segments(at, edges.starts, edges.ends)
    row = int(distances.argmin())
    if not distances[row] <= reach:
        return None
    number, axis = int(edges.numbers[row]), int(edges.axes[row])
    shape = shapes[edges.owners[row]]
    return Hit("edge", shape, number, axis=axis, distance=float(distances[row]))


def planes_along(hit: Hit, stage: Stage) -> Selection:
    """The row or column of planes that an edge belongs to, the plane where it begins active."""
    shape = stage.design.surface(hit.shape).planes.shape
    i, j = divmod(hit.number, shape[1])
    numbers = row_numbers(shape, "v", j) if hit.axis == 0 else row_numbers(shape, "u", i)
    lines = [LineId(hit.shape, number) for number in numbers.tolist()]
    return Selection.of_lines(lines, LineId(hit.shape, hit.number))


@lru_cache(maxsize=4)
def edges_of(design: Design, shapes: tuple[ShapeId, ...], camera: Camera) -> Edges:
    """The edges of the nets of those surfaces."""
    starts, ends = ([np.zeros((0, 2))] for _ in range(2))
    numbers, axes, owners = ([np.zeros(0, np.intp)] for _ in range(3))
    for place, shape_id in enumerate(shapes):
        surface = design.surface(shape_id)
        screen = camera.to_screen(surface.planes.control_points)
        grid = np.arange(len(screen)).reshape(surface.planes.shape)
        for axis, closed in enumerate(surface.closed):
            after = np.roll(grid, -1, axis)
            count = grid.shape[axis] - (0 if closed else 1)
            first, second = (np.take(g, range(count), axis).ravel() for g in (grid, after))
            starts.append(screen[first])
            ends.append(screen[second])
            numbers.append(first)
            axes.append(np.full(len(first), axis))
            owners.append(np.full(len(first), place))
    return Edges(
        np.concatenate(starts),
        np.concatenate(ends),
        np.concatenate(numbers),
        np.concatenate(axes),
        np.concatenate(owners),
    )
