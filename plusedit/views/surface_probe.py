"""Numbers at the point of a surface that is under the pointer: how it bends, and what colors it."""

from math import isfinite

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.evaluation import jets
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import principal_curvatures
from plusedit.interaction.mesh_facets import Crossing, mesh_crossings
from plusedit.interaction.spotting import place_under
from plusedit.scene.camera import Camera
from plusedit.scene.coloring import coloring_overlay, known_values
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Overlay
from plusedit.scene.surface_spots import sides_of_faces
from plusedit.views.arithmetic import true_minus

TOLD_ANYWAY = frozenset({"gaussian", "mean", "largest", "smallest"})


def surface_reading(
    surface: PlusSurface, camera: Camera, pixel: Floats, options: ViewOptions
) -> str:
    """Such as "u 0.250  v 0.500   K 0.1  H 0.3  κ₁ 0.2  κ₂ 0.5"; empty where it is not.

    K and H are the Gaussian and the mean curvature, κ₁ and κ₂ the largest and the smallest. What
    the surface is colored by follows.
    """
    place = place_under(surface, pixel, camera)
    if place is None:
        return ""
    text = _bending(*place, surface.derivatives_at([place]), 1.0)
    entry = coloring_overlay(options.overlays)
    if entry is None or entry.name in TOLD_ANYWAY:
        return text
    u, v = (np.array([at]) for at in place)
    values = entry.surface_values(surface, u, v, entry.numbers(options.settings))
    return text if values is None else text + _value(entry, float(values[0, 0]))


def mesh_reading(surface: MeshSurface, camera: Camera, pixel: Floats, options: ViewOptions) -> str:
    """The same of the surface of a mesh; as seen from its front."""
    crossing = next(iter(mesh_crossings(pixel, surface, camera)), None)
    if crossing is None:
        return ""
    found = jets(surface, np.array([[crossing.u, crossing.v]]), highest=2)
    side = float(sides_of_faces(surface, np.array([crossing.face]))[0])
    text = _bending(crossing.u, crossing.v, found, side)
    entry = coloring_overlay(options.overlays)
    if entry is None or entry.name in TOLD_ANYWAY:
        return text
    value = _colored_by(entry, surface, crossing, options)
    return text if value is None else text + _value(entry, value)


def _colored_by(
    entry: Overlay, surface: MeshSurface, crossing: Crossing, options: ViewOptions
) -> float | None:
    """The mean of the values at the corners around, as the color there is; None if not known."""
    drawing = drawing_of(surface, wait=False)
    values = known_values(entry, surface, drawing, entry.numbers(options.settings))
    if values is None:
        return None
    return float(np.array(crossing.shares) @ values[drawing.net.triangles[crossing.triangle]])


def _bending(u: float, v: float, derivatives: tuple[Floats, ...], side: float) -> str:
    found = principal_curvatures(derivatives)
    both = sorted((side * float(found.smallest[0]), side * float(found.largest[0])))
    gaussian, mean = both[0] * both[1], (both[0] + both[1]) / 2.0
    numbers = (("K", gaussian), ("H", mean), ("κ₁", both[1]), ("κ₂", both[0]))
    bends = "  ".join(f"{name} {written(value)}" for name, value in numbers)
    return f"u {u:.4f}  v {v:.4f}   {bends}"


def _value(entry: Overlay, value: float) -> str:
    coloring = entry.coloring
    return f"   {coloring.title or entry.title} {written(value)} {coloring.unit}".rstrip()


def written(value: float) -> str:
    """Four digits, or a dash where there is no such number."""
    return true_minus(f"{value + 0.0:.4g}") if isfinite(value) else "–"
