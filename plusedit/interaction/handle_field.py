"""All dots and grips of a design in a few arrays."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.places import in_space
from plusedit.scene.camera import Camera
from plusedit.scene.handles import Handled, handles
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
def field_of(design: Design, shown: tuple[Handled, ...], camera: Camera) -> Field:
    """The dots and grips of those control lines and planes."""
    at, world = [np.zeros((0, 2))], [np.zeros((0, 3))]
    depths = [np.zeros(0)]
    sides, owners, numbers = ([np.zeros(0, np.intp)] for _ in range(3))
    for place, (shape_id, faces) in enumerate(shown):
        for side, seen, there, dots, rows in _marks(design[shape_id].geometry, faces, camera):
            at.append(seen)
            world.append(there)
            depths.append(np.round(camera.depths(dots) / camera.pixel))
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
        tuple(shape_id for shape_id, _ in shown),
    )


Marks: TypeAlias = tuple[int, Floats, Floats, Floats, NDArray[np.intp]]
"""Side, pixels (k, 2), places (k, 3), those of their dots, and numbers (k,) of dots or grips."""


def _marks(geometry: Geometry, faces: tuple[int, ...] | None, camera: Camera) -> Iterator[Marks]:
    if isinstance(geometry, PlusCurve):
        yield from _marks_of_lines(geometry, camera)
        return
    at = plane_handles(geometry, camera, faces)
    yield 0, at.points, at.world, at.world, at.numbers
    for way in (0, 1):
        rows = np.flatnonzero(at.drawn[way])
        tips = at.tips[way][rows], at.tips_world[way][rows]
        yield way + 1, *tips, at.world[rows], at.numbers[rows]


def _marks_of_lines(curve: PlusCurve, camera: Camera) -> Iterator[Marks]:
    points, at = in_space(curve.lines.points), handles(curve, camera)
    yield 0, at.points, points, points, np.arange(len(points))
    rows, arms = np.flatnonzero(at.drawn), in_space(at.arms)
    for place, side in enumerate((1, -1)):
        yield side, at.tips[place][rows], (points + side * arms)[rows], points[rows], rows
