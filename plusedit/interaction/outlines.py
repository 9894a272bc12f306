"""All curves of a design, and the lines on its surfaces, as segments in pixels."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.camera import Camera
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.isolines import isolines
from plusedit.scene.mesh_shapes import mesh_silhouette


@dataclass(frozen=True, eq=False)
class Outlines:
    """Curves, and the lines on surfaces, as segments in pixels of the view."""

    starts: Floats
    """(k, 2)"""
    ends: Floats
    parameters: Floats
    """(k, 2) at start and end"""
    owners: NDArray[np.intp]
    shapes: tuple[ShapeId, ...]

    @cached_property
    def sides(self) -> tuple[Floats, Floats]:
        """(k,) the smaller and the larger x of each segment."""
        x, y = self.starts[:, 0], self.ends[:, 0]
        return np.minimum(x, y), np.maximum(x, y)


@lru_cache(maxsize=4)
def outlines_of(design: Design, camera: Camera) -> Outlines:
    """All curves, and lines on surfaces, that are seen and can be edited."""
    shapes: list[ShapeId] = []
    starts, ends, parameters = ([np.zeros((0, 2))] for _ in range(3))
    owners = [np.zeros(0, np.intp)]
    for shape_id, geometry in design.drawn():
        if design[shape_id].editable:
            for u, screen in _polylines(geometry, camera):
                starts.append(screen[:-1])
                ends.append(screen[1:])
                parameters.append(np.stack([u[:-1], u[1:]], axis=1))
                owners.append(np.full(len(u) - 1, len(shapes)))
            shapes.append(shape_id)
    for shape_id, surface in design.meshes():
        if design[shape_id].editable:
            first, last = _mesh_segments(surface, camera)
            starts.append(first)
            ends.append(last)
            parameters.append(np.zeros((len(first), 2)))
            owners.append(np.full(len(first), len(shapes)))
            shapes.append(shape_id)
    return Outlines(
        np.concatenate(starts),
        np.concatenate(ends),
        np.concatenate(parameters),
        np.concatenate(owners),
        tuple(shapes),
    )


def _polylines(geometry: PlusGeometry, camera: Camera) -> Iterator[tuple[Floats, Floats]]:
    """Parameters (m,) and pixels (m, 2) of a curve; of a surface the lines on it, with none."""
    if isinstance(geometry, PlusCurve):
        shown = drawn(geometry, camera)
        yield shown.grid.parameters, shown.screen
        return
    lines = isolines(geometry, surface_grids(geometry, camera))
    for points in (*lines.along_u, *lines.along_v, *lines.edges):
        yield np.zeros(len(points)), camera.to_screen(points)


def _mesh_segments(surface: MeshSurface, camera: Camera) -> tuple[Floats, Floats]:
    """Pixels (k, 2) and (k, 2) between which the outline of the surface of a mesh runs."""
    drawing = drawing_of(surface, wait=False)
    lines = [camera.to_screen(points) for points in mesh_silhouette(drawing, camera)]
    first, last = (camera.to_screen(ends) for ends in drawing.lines(drawing.net.boundary))
    starts, ends = [first, *(line[:-1] for line in lines)], [last, *(line[1:] for line in lines)]
    return np.concatenate(starts), np.concatenate(ends)
