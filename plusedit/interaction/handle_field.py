"""All dots and grips of a design in a few arrays."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.places import in_space
from plusedit.scene.camera import Camera
from plusedit.scene.handles import handles
from plusedit.scene.plane_handles import plane_handles


@dataclass(frozen=True, eq=False)
class Field:
    """Dots, then grips, of many curves and surfaces in pixels of the view."""

    at: Floats
    """(k, 2)"""
    world: Floats
    """(k, 3)"""
    depths: Floats
    """(k,) of their dots, in whole pixels"""
    sides: NDArray[np.int8]
    """(k,) 0 for a dot; of grips 1 and -1 on a line, 1 and 2 on a plane"""
    owners: NDArray[np.intp]
    """(k,) which of `shapes`"""
    numbers: NDArray[np.intp]
    """(k,) of the control lines and planes"""
    shapes: tuple[ShapeId, ...]

    @cached_property
    def x(self) -> Floats:
        """(k,) the first column of `at`, side by side in memory."""
        return np.ascontiguousarray(self.at[:, 0])


@lru_cache(maxsize=4)
def field_of(design: Design, shapes: tuple[ShapeId, ...], camera: Camera) -> Field:
    """The dots and grips of those shapes."""
    at, world = [np.zeros((0, 2))], [np.zeros((0, 3))]
    depths = [np.zeros(0)]
    sides, owners, numbers = ([np.zeros(0, np.intp)] for _ in range(3))
    for place, shape_id in enumerate(shapes):
        geometry = design.plus(shape_id)
        points = in_space(geometry.net.control_points)
        deep = np.round(camera.depths(points) / camera.pixel)
        for side, seen, there, rows in _marks(geometry, points, camera):
            at.append(seen)
            world.append(there)
            depths.append(deep[rows])
            sides.append(np.full(len(rows), side))
            owners.append(np.full(len(rows), place))
            numbers.append(rows)
    return Field(
        np.concatenate(at),
        np.concatenate(world),
        np.concatenate(depths),
        np.concatenate(sides).astype(np.int8),
        np.concatenate(owners),
        np.concatenate(numbers),
        shapes,
    )


Marks: TypeAlias = tuple[int, Floats, Floats, NDArray[np.intp]]
"""Side, pixels (k, 2), places (k, 3) and numbers (k,) of dots or grips."""


def _marks(geometry: PlusGeometry, points: Floats, camera: Camera) -> Iterator[Marks]:
    rows = np.arange(len(points))
    if isinstance(geometry, PlusSurface):
        planes = plane_handles(geometry, camera)
        yield 0, planes.points, points, rows
        for way in (0, 1):
            gripped = np.flatnonzero(planes.drawn[way])
            yield way + 1, planes.tips[way][gripped], planes.tips_world[way][gripped], gripped
        return
    stand = handles(geometry, camera)
    yield 0, stand.points, points, rows
    gripped, arms = np.flatnonzero(stand.drawn), in_space(stand.arms)
    for place, side in enumerate((1, -1)):
        yield side, stand.tips[place][gripped], (points + side * arms)[gripped], gripped
