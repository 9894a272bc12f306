"""Places spread evenly over surfaces, at which something is drawn: hairs, crosses."""

from dataclasses import dataclass
from typing import TypeAlias
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.mesh.evaluation import jets
from plusedit.geometry.mesh.foundation import Foundation
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera
from plusedit.scene.drawn_mesh import AT_ONCE, NEAR, WIDE
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing
from plusedit.scene.overlays import Setting
from plusedit.scene.silhouettes import lifted
from plusedit.scene.space_camera import SpaceCamera

DENSITY = Setting("density", "Density", 16.0, 3.0, 60.0)
MEASURED = 49  # samples each way by which distances on a surface are judged
THINNEST = 5  # halvings of the spots in a row
MOST = 400  # spots in a row

Rows: TypeAlias = NDArray[np.intp]
_FACES: "WeakKeyDictionary[Foundation, dict[float, Rows]]" = WeakKeyDictionary()
_VERTICES: "WeakKeyDictionary[DrawnNet, dict[float, Rows]]" = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class Spots:
    """Places of a surface and its derivatives there."""

    derivatives: tuple[Floats, ...]
    """(k, 3) each: S, S_u, S_v, and so on"""
    sides: Floats
    """(k,) 1, or -1 where the front of a mesh looks against S_u x S_v"""
    step: float
    """about how far they are apart"""


def spots_on_surface(surface: PlusSurface, density: float, *, highest: int) -> Spots:
    """In the middles of cells that are about as long as wide, at most the square of the density.

    None at edges, where there may be no normal. Rows that are shorter, as toward a pole, have half
    as many, or a quarter, and so on: so spots keep in line.
    """
    grid = Grid.uniform(MEASURED)
    points = surface.sample(grid, grid)
    by_u, by_v = (np.linalg.norm(np.diff(points, axis=axis), axis=2) for axis in (0, 1))
    rounds, lengths = by_u.sum(axis=0), by_v.sum(axis=1)
    step = float(np.sqrt(rounds.max() * lengths.max())) / density or 1.0
    across, along = (
        min(max(1, round(float(each.max()) / step)), MOST) for each in (rounds, lengths)
    )
    places = []
    for v in _evenly(by_v.mean(axis=0), along):
        share = float(np.interp(v, grid.parameters, rounds)) / step / across
        halvings = np.clip(np.round(-np.log2(max(share, 1e-9))), 0, THINNEST)
        count = max(1, round(across / 2.0**halvings))
        places += [(u, v) for u in _evenly(by_u.mean(axis=1), count)]
    found = surface.derivatives_at(places, highest=highest)
    return Spots(found, np.ones(len(places)), step)


def _evenly(lengths: Floats, count: int) -> Floats:
    """(count,) parameters in the middles of equal parts of a way of that many steps."""
    passed = np.append(0.0, np.cumsum(lengths))
    wanted = (np.arange(count) + 0.5) / count
    if passed[-1] <= 0.0:
        return wanted
    # A way that stands still for a while has many parameters at one length: the first will do.
    rising = np.append(True, np.diff(passed) > 0.0)
    parameters = np.linspace(0.0, 1.0, len(passed))
    found: Floats = np.interp(wanted, passed[rising] / passed[-1], parameters[rising])
    return found


def spots_on_mesh(surface: MeshSurface, density: float, *, highest: int) -> Spots:
    """In the middles of some faces, as far apart in space as the density says.

    Fewer where the surface takes long to evaluate.
    """
    near = NEAR + WIDE * surface.smoothness**2
    faces = faces_apart(surface.foundation, density)
    most = max(1, int(AT_ONCE / near))
    if len(faces) > most:
        faces = faces[np.linspace(0, len(faces) - 1, most).astype(np.intp)]
    planes = surface.foundation.planes
    found = jets(surface, planes.centers[faces], highest=highest)
    step = float(np.ptp(planes.points[planes.used], axis=0).max()) / density
    return Spots(found, sides_of_faces(surface, faces), step)


def sides_of_faces(surface: MeshSurface, faces: Rows) -> Floats:
    """(k,) 1, or -1 where the front of a face looks against S_u x S_v."""
    planes = surface.foundation.planes
    across = np.cross(planes.gradients_u[faces], planes.gradients_v[faces])
    fronts = np.einsum("kd,kd->k", across, surface.mesh.area_vectors[faces])
    return np.where(fronts < 0.0, -1.0, 1.0)


def faces_apart(foundation: Foundation, density: float) -> Rows:
    """One face in each of the cubes that divide the longest extent of a mesh so many times."""
    kept = _FACES.setdefault(foundation, {})
    if density not in kept:
        used = foundation.planes.used
        kept.clear()
        kept[density] = used[_apart(foundation.planes.points[used], density)]
    return kept[density]


def vertices_apart(drawing: MeshDrawing, density: float) -> Rows:
    """One of the points that are drawn in each such cube; the same as long as the net is."""
    kept = _VERTICES.setdefault(drawing.net, {})
    if density not in kept:
        kept.clear()
        kept[density] = _apart(drawing.points, density)
    return kept[density]


def _apart(points: Floats, density: float) -> Rows:
    low, extent = points.min(axis=0), float(np.ptp(points, axis=0).max()) or 1.0
    cubes = np.floor((points - low) / extent * density).astype(np.int64)
    wide = int(density) + 2
    _, first = np.unique(cubes @ np.array([wide * wide, wide, 1]), return_index=True)
    return np.asarray(first, dtype=np.intp)


def in_front(points: Floats, camera: Camera) -> Floats:
    """The points, in space a little nearer to the eye than the surface that they lie on."""
    return lifted(points, camera) if isinstance(camera, SpaceCamera) else points
