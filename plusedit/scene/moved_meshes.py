"""Drawings of surfaces that were moved with their meshes, without evaluating them again.

A surface follows every affine map of its mesh and its edited planes exactly.
"""

from typing import NamedTuple

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.face_net import EditedPlanes
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.scene.mesh_drawing import MeshDrawing

LOOKED_AT = 64  # vertices that tell by which map a mesh was moved
SLACK = 1e-9  # of the diagonal, within which a map is the one


class Way(NamedTuple):
    """x -> (x - middle) linear + image."""

    linear: Floats
    """(3, 3)"""
    middle: Floats
    image: Floats

    def moved(self, points: Floats) -> Floats:
        """The images of points (n, 3)."""
        found: Floats = (points - self.middle) @ self.linear + self.image
        return found

    def turned(self, normals: Floats) -> Floats:
        """The normals (n, 3) of the images."""
        first, second, third = self.linear
        cofactors = np.stack(
            [np.cross(second, third), np.cross(third, first), np.cross(first, second)]
        )
        return unit(normals @ cofactors)


def moved_drawing(
    surface: MeshSurface, other: MeshSurface, drawing: MeshDrawing
) -> MeshDrawing | None:
    """The drawing of a surface that is the image of another one; None where it is not."""
    if not _has_same_numbers(surface, other):
        return None
    way = _way(surface, other)
    if way is None:
        return None
    normals = None if drawing.given is None else way.turned(drawing.given)
    return MeshDrawing(drawing.net, way.moved(drawing.points), normals, drawing.is_exact)


def _has_same_numbers(one: MeshSurface, other: MeshSurface) -> bool:
    return (
        one.parameters is other.parameters
        and one.mesh is not other.mesh
        and one.mesh.vertices.shape == other.mesh.vertices.shape
        and one.domain == other.domain
        and (one.smoothness, one.s, one.area_weights)
        == (other.smoothness, other.s, other.area_weights)
        and one.factors is other.factors
    )


def _way(surface: MeshSurface, other: MeshSurface) -> Way | None:
    """The affine map from the other surface; None where there is none."""
    way, slack = affine_way(other.mesh.vertices, surface.mesh), SLACK * surface.mesh.diagonal
    if way is None:
        return None
    old, new = EditedPlanes.of(other.edited), EditedPlanes.of(surface.edited)
    return way if _moves_edits(way, old, new, slack) else None


def affine_way(old: Floats, mesh: PolygonMesh) -> Way | None:
    """The affine map from places (n, 3) to the vertices of a mesh; None where there is none."""
    new = mesh.vertices
    looked_at = np.unique(np.linspace(0, len(old) - 1, LOOKED_AT).astype(int))
    middle, image = old[looked_at].mean(axis=0), new[looked_at].mean(axis=0)
    linear = np.linalg.lstsq(old[looked_at] - middle, new[looked_at] - image, rcond=None)[0]
    way, slack = Way(linear, middle, image), SLACK * mesh.diagonal
    if not _are_near(way.moved(old[looked_at]), new[looked_at], slack):
        return None
    return way if _are_near(way.moved(old), new, slack) else None


def _moves_edits(way: Way, old: EditedPlanes, new: EditedPlanes, slack: float) -> bool:
    """Whether the map brings edited planes to those of the same faces."""
    if not (np.array_equal(old.faces, new.faces) and np.array_equal(old.given, new.given)):
        return False
    (points, vectors), (images, turned) = (
        (edited.parts[0][edited.given[0]], edited.parts[1:][edited.given[1:]])
        for edited in (old, new)
    )
    slack_of_vectors = SLACK * float(np.abs(turned).max(initial=0.0))
    return _are_near(way.moved(points), images, slack) and _are_near(
        vectors @ way.linear, turned, slack_of_vectors
    )


def _are_near(images: Floats, wanted: Floats, slack: float) -> bool:
    return bool(np.abs(images - wanted).max(initial=0.0) <= slack)
