"""Draft angles: by how much walls lean so that a part leaves its mold, pulled one way.

The angle between the pull and the tangent plane, that is 90 degrees less the angle between the pull
and the normal: 90 where the front faces the pull, 0 on walls along it, negative on undercuts. The
pull is upwards, along z, unless it is set to lean.
"""

from collections.abc import Mapping

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import normals
from plusedit.scene.bearings import vector_at
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.overlays import Coloring, Setting, overlay

draft = overlay(
    "draft",
    title="Draft angle",
    order=75,
    shortcut="F5",
    group="Surface analysis",
    coloring=Coloring("Draft angle", "° to the pull", "diverging", fixed=(-90.0, 90.0)),
    settings=(
        Setting("height", "Pull above the ground, °", 90.0, 1.0, 90.0),
        Setting("bearing", "Pull turned from x, °", 360.0, 1.0, 360.0),
    ),
)


@draft.coloring_of_surfaces
def of_surface(surface: PlusSurface, u: Floats, v: Floats, numbers: Mapping[str, float]) -> Floats:
    """(m_u, m_v) degrees; nan where the surface has no normal."""
    _, by_u, by_v = surface.derivatives(u, v, highest=1)
    return _angles(normals(by_u, by_v), numbers)


@draft.coloring_of_meshes
def of_mesh(surface: MeshSurface, drawing: MeshDrawing, numbers: Mapping[str, float]) -> Floats:
    """(n,) the same of a mesh."""
    return _angles(drawing.normals, numbers)


def _angles(across: Floats, numbers: Mapping[str, float]) -> Floats:
    pull = np.array(vector_at(numbers["height"], numbers["bearing"]))
    sines = np.where(across.any(axis=-1), across @ pull, np.nan)
    angles: Floats = np.degrees(np.arcsin(np.clip(sines, -1.0, 1.0)))
    return angles
