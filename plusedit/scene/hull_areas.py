"""Convex hulls of points as areas of the plane and solids of space."""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.hulls import convex_hull
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.items import Item, Polygon


def hull_area(points: Floats, camera: Camera, fill: str, outline: str = "") -> Item:
    """The hull of points (m, dim) as that camera sees it; outlined in `fill` if nothing is said.

    In the plane it is the hull of what is seen of the points, in space their hull itself.
    """
    outline = outline or fill
    if isinstance(camera, PlaneCamera):
        return Polygon(camera.placed(convex_hull(camera.plane(points))), fill, outline, 1.0)
    return Polygon(convex_hull(points[:, :2]), fill, outline, 1.0)
