"""Numbers at the point of a shape that the pointer is nearest to."""

from math import isfinite

import numpy as np

from plusedit.document.shape import PlusGeometry
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera, PlaneCamera


def reading(geometry: PlusGeometry, camera: Camera, pixel: Floats) -> str:
    """Such as "u 0.2500   κ 1.25", or "u 0.25  v 0.50   K 0.1  H 0.3"; empty where there is none.

    κ is the curvature of a curve, K and H are the Gaussian and mean curvature of a surface.
    """
    with np.errstate(all="ignore"):
        if isinstance(geometry, PlusCurve):
            return _of_curve(geometry, camera, pixel)
        return _of_surface(geometry, camera, pixel)


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


def _of_surface(surface: PlusSurface, camera: Camera, pixel: Floats) -> str:
    from plusedit.geometry.surface_frames import gaussian_curvature, mean_curvature
    from plusedit.interaction.spotting import place_under

    place = place_under(surface, pixel, camera)
    if place is None:
        return ""
    found = surface.derivatives_at([place])
    gauss, mean = float(gaussian_curvature(found)[0]), float(mean_curvature(found)[0])
    return f"u {place[0]:.4f}  v {place[1]:.4f}   K {written(gauss)}  H {written(mean)}"


def written(value: float) -> str:
    """Four digits, or a dash where there is no such number."""
    return f"{value + 0.0:.4g}" if isfinite(value) else "–"
