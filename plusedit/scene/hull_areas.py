"""Convex hulls of points as areas of the plane and bodies of space.

A body in space takes much longer than the rest of a frame: it is kept with the shape that it is
the hull of.
"""

from collections.abc import Callable, Iterator
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.shape import PlusGeometry
from plusedit.geometry.arrays import Floats
from plusedit.geometry.convex_hull import HullMesh, hull_mesh
from plusedit.geometry.hulls import convex_hull
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.items import Item, Mesh, Polygon

_KEPT: "WeakKeyDictionary[PlusGeometry, dict[str, HullMesh | None]]" = WeakKeyDictionary()
_MESHES: "WeakKeyDictionary[HullMesh, Mesh]" = WeakKeyDictionary()


def kept_hull(
    owner: PlusGeometry, name: str, make: Callable[[], HullMesh | Floats]
) -> HullMesh | None:
    """The hull of that name of a shape, from `make` or from what it gave before.

    `make` gives a hull, or the points (m, 3) in it; it is None where that raises ValueError.
    """
    hulls = _KEPT.setdefault(owner, {})
    if name not in hulls:
        try:
            made = make()
        except ValueError:
            hulls[name] = None
        else:
            hulls[name] = made if isinstance(made, HullMesh) else hull_mesh(made)
    return hulls[name]


def hull_area(hull: HullMesh | Floats, camera: Camera, fill: str, outline: str = "") -> Item:
    """A hull, or that of points (m, dim), as that camera sees it, outlined in `fill` if need be.

    In the plane it is the hull of what is seen; in space a body, or flat of points of a plane.
    """
    points = hull.points if isinstance(hull, HullMesh) else hull
    if isinstance(camera, PlaneCamera):
        flat = convex_hull(camera.plane(points))
        return Polygon(camera.placed(flat), fill, outline or fill, 1.0)
    if points.shape[1] == 2:
        return Polygon(convex_hull(points), fill, outline or fill, 1.0)
    return _body(hull if isinstance(hull, HullMesh) else hull_mesh(hull), fill)


def _body(hull: HullMesh, fill: str) -> Mesh:
    mesh = _MESHES.get(hull)
    if mesh is None or mesh.front != fill:
        triangles = hull.triangles.astype(np.int32)
        mesh = _MESHES[hull] = Mesh(hull.points, triangles, None, fill, fill)
    return mesh


def hull_of(
    owner: PlusGeometry, name: str, points: Floats, camera: Camera, fill: str, outline: str = ""
) -> Iterator[Item]:
    """The hull of points (m, dim) of a shape, kept with it where it is a body."""
    if isinstance(camera, PlaneCamera) or points.shape[1] == 2:
        yield hull_area(points, camera, fill, outline)
    elif (hull := kept_hull(owner, name, lambda: points)) is not None:
        yield hull_area(hull, camera, fill, outline)
