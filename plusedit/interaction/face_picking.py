"""Faces of meshes under the pointer, and inside a box.

They are found where the surface is drawn, which a large S takes far away from the mesh.
"""

from functools import lru_cache
from itertools import compress

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.selection import LineId
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.interaction.hits import Hit
from plusedit.interaction.mesh_facets import MeshFacets, facets_of_mesh, mesh_crossings
from plusedit.interaction.tool import Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import has_many_faces


def meshes_under(at: Floats, stage: Stage) -> list[Hit]:
    """Every layer of every surface of a mesh under a pixel (2,), in no particular order."""
    return [
        Hit(
            "face" if shape_id in stage.selection.shapes else "mesh",
            shape_id,
            crossing.face,
            u=crossing.u,
            v=crossing.v,
            depth=crossing.depth,
        )
        for shape_id, surface in stage.design.meshes()
        if stage.design[shape_id].editable
        for crossing in mesh_crossings(at, surface, stage.camera)
    ]


def faces_under(at: Floats, stage: Stage) -> list[Hit]:
    """Those of selected meshes, the nearest to the eye first."""
    found = [hit for hit in meshes_under(at, stage) if hit.kind == "face"]
    return sorted(found, key=lambda hit: hit.depth)


def faces_inside(low: Floats, high: Floats, stage: Stage) -> frozenset[LineId]:
    """The faces of selected meshes whose middles lie in a box of pixels.

    Where all of a mesh are in it, none is: then the mesh is meant as a whole. Meshes of few faces
    are left out, as the handles of all of these are shown.
    """
    found: set[LineId] = set()
    for shape_id, surface in stage.design.meshes():
        shape = stage.design[shape_id]
        if shape_id in stage.selection.shapes and shape.editable and has_many_faces(shape):
            facets = facets_of_mesh(surface, stage.camera)
            inside = _between(low, facets.middles, high)
            if inside.all():
                continue
            if stage.options.front_only and not isinstance(stage.camera, PlaneCamera):
                inside &= ~_hidden(facets, stage.design, stage)
            found.update(compress(_lines(shape_id, len(inside)), inside.tolist()))
    return frozenset(found)


def _between(low: Floats, points: Floats, high: Floats) -> NDArray[np.bool_]:
    x, y = points.T
    inside: NDArray[np.bool_] = (x >= low[0]) & (x <= high[0]) & (y >= low[1]) & (y <= high[1])
    return inside


def _hidden(facets: MeshFacets, design: Design, stage: Stage) -> NDArray[np.bool_]:
    """(f,) which middles of faces the surface of any mesh hides from the eye."""
    hidden = np.zeros(len(facets.middles), dtype=np.bool_)
    pixels = np.full(len(hidden), stage.camera.pixel)
    for shape_id, surface in design.meshes():
        if design[shape_id].visible:
            before = facets_of_mesh(surface, stage.camera)
            hidden |= before.map.hides(facets.middles, facets.deep, pixels)
    return hidden


@lru_cache(maxsize=4)
def _lines(shape_id: ShapeId, count: int) -> tuple[LineId, ...]:
    """All faces of a mesh; made once, as a box takes in thousands with every move."""
    return tuple(LineId(shape_id, number) for number in range(count))
