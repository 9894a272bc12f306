"""What a press would take, in the color of that."""

from collections.abc import Iterator

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.gizmo_picking import gizmo_highlight
from plusedit.interaction.hits import Hit
from plusedit.interaction.net_picking import planes_along
from plusedit.interaction.readout import ring
from plusedit.interaction.space_turning import tip_of
from plusedit.interaction.tool import Stage
from plusedit.scene.drawn import drawn
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.face_outlines import face_items
from plusedit.scene.isolines import isolines
from plusedit.scene.items import Item, Polyline, Segments
from plusedit.scene.mesh_shapes import mesh_silhouette
from plusedit.scene.silhouettes import silhouette

WIDTH = 3.0  # pixels


def highlight(hit: Hit, stage: Stage) -> Iterator[Item]:
    """A ring around a dot or grip, a wider line along all else."""
    if hit.kind == "mesh":
        drawing = drawing_of(stage.design.mesh(hit.shape), wait=False)
        for line in mesh_silhouette(drawing, stage.camera):
            yield Polyline(line, "hover", WIDTH)
        yield Segments(*drawing.lines(drawing.net.boundary), "hover", WIDTH)
        return
    geometry = stage.design[hit.shape].geometry
    if isinstance(geometry, MeshSurface) and hit.line is not None:
        yield from face_items(drawing_of(geometry, wait=False), (hit.number,), "hover", WIDTH)
    if hit.kind in ("dot", "face"):
        yield ring(geometry.net.control_points[[hit.number]])
    elif hit.kind == "grip":
        yield ring(tip_of(geometry, hit.number, hit.side, stage.camera)[None])
    elif hit.kind in ("arrow", "ring"):
        yield from gizmo_highlight(hit, stage)
    elif hit.kind == "edge":
        yield Polyline(_row(hit, stage), "hover", 2.0)
    elif isinstance(geometry, PlusCurve):
        yield Polyline(drawn(geometry, stage.camera).points, "hover", WIDTH)
    elif isinstance(geometry, PlusSurface):
        grids = surface_grids(geometry, stage.camera)
        outlines = silhouette(geometry, stage.camera, grids)
        for points in (*isolines(geometry, grids).edges, *outlines):
            yield Polyline(points, "hover", WIDTH)


def _row(hit: Hit, stage: Stage) -> Floats:
    """(m, 3) the control points that an edge of a net leads to, both ways."""
    surface = stage.design.surface(hit.shape)
    numbers = sorted(line.number for line in planes_along(hit, stage).lines)
    points: Floats = surface.planes.control_points[numbers]
    return np.vstack([points, points[:1]]) if surface.closed[hit.axis] else points
