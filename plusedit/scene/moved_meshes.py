"""Drawings of surfaces that were moved with their meshes, without evaluating them again.

A surface follows every affine map of its mesh and its edited planes exactly.
"""

from typing import NamedTuple

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.face_net import EditedPlanes
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.mesh_drawing import MeshDrawing

LOOKED_AT = 64  # vertices that tell by which map a mesh was moved
SLACK = 1e-9  # of the diagonal, within which a map is the one


class _Way(NamedTuple):
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
        and one.mesh.vertices.shape == other.mesh.vertices.shape
        and one.domain == other.domain
        and (one.smoothness, one.s, one.area_weights)
        == (other.smoothness, other.s, other.area_weights)
        and one.factors is other.factors
        and len(one.edited) == len(other.edited)
    )


def _way(surface: MeshSurface, other: MeshSurface) -> _Way | None:
    """The affine map from the other surface; None where there is none."""
    old, new = other.mesh.vertices, surface.mesh.vertices
    looked_at = np.unique(np.linspace(0, len(old) - 1, LOOKED_AT).astype(int))
    middle, image = old[looked_at].mean(axis=0), new[looked_at].mean(axis=0)
    linear = np.linalg.lstsq(old[looked_at] - middle, new[looked_at] - image, rcond=None)[0]
    way = _Way(linear, middle, image)
    slack = SLACK * surface.mesh.diagonal
    if not _are_near(way.moved(old), new, slack):
        return None
    one, two = EditedPlanes.of(other.edited), EditedPlanes.of(surface.edited)
    same = np.array_equal(one.faces, two.faces) and np.array_equal(one.given, two.given)
    if not same:
        return None
    points, edited_points = one.parts[0][one.given[0]], two.parts[0][one.given[0]]
    vectors, edited_vectors = one.parts[1:][one.given[1:]], two.parts[1:][one.given[1:]]
    slack_of_vectors = SLACK * float(np.abs(edited_vectors).max(initial=0.0))
    if not _are_near(way.moved(points), edited_points, slack):
        return None
    return way if _are_near(vectors @ linear, edited_vectors, slack_of_vectors) else None


def _are_near(images: Floats, wanted: Floats, slack: float) -> bool:
    off = np.abs(images - wanted)
    return bool(off.max(initial=0.0) <= slack)
