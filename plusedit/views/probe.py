"""Numbers at the point of a shape that the pointer is nearest to."""

import numpy as np

from plusedit.document.shape import Geometry
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.options import USUAL, ViewOptions
from plusedit.views.surface_probe import mesh_reading, surface_reading, written


def reading(geometry: Geometry, camera: Camera, pixel: Floats, options: ViewOptions = USUAL) -> str:
    """Such as "u 0.2500   κ 1.25", or what `surface_reading` says; empty where there is none.

    κ is the curvature of a curve.
    """
    with np.errstate(all="ignore"):
        if isinstance(geometry, PlusCurve):
            return _of_curve(geometry, camera, pixel)
        if isinstance(geometry, MeshSurface):
            return mesh_reading(geometry, camera, pixel, options)
        return surface_reading(geometry, camera, pixel, options)


def _of_curve(curve: PlusCurve, camera: Camera, pixel: Floats) -> str:
    from plusedit.geometry.frames import curvature, space_curvature

    u = _nearest(curve, camera, pixel)
    if u is None:
        return ""
    _, velocity, acceleration = curve.derivatives([u])
    bend = (curvature if curve.dimension == 2 else space_curvature)(velocity, acceleration)[0]
    return f"u {u:.4f}   κ {written(float(bend))}"


def _nearest(curve: PlusCurve, camera: Camera, pixel: Floats) -> float | None:
    from plusedit.geometry.nearest import nearest_parameter

    if isinstance(camera, PlaneCamera):
        if max(camera.axes) >= curve.dimension:
            return None
        return nearest_parameter(curve, camera.in_plane(pixel[None])[0], axes=camera.axes)
    from plusedit.geometry.nearest import nearest_to_ray

    return nearest_to_ray(curve, *camera.ray(pixel))
