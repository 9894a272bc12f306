"""Control planes as they stand on the screen: where the dots, squares and grips are.

Control plane (i, j) is drawn as a small square about P_ij in the plane of its two directions, the
same size at any zoom, and an arm along each of them that ends in a grip: by u and by v. The square
is spanned by the two perpendicular directions nearest to d^u and d^v. Where the control points
stand closer than the squares are wide these become smaller. Drawing and picking read the same
handles. Planes of the faces of a mesh are drawn like that too; of a mesh of many faces only some,
each as if it stood by itself.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import inf
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera
from plusedit.scene.handles import ALL_UP_TO, END_ON, foreshortening

Planar: TypeAlias = PlusSurface | MeshSurface
"""What has control planes."""

SIDE = 22.0  # pixels, of a square by itself
SMALLEST = 5.0  # pixels, where control points stand close
ROOM = 0.6  # of the distance of control points that a square may take
SHORTEST, LONGEST = 26.0, 48.0  # pixels from dot to grip, seen from the side
LEAST = 16.0  # pixels on the screen, however steeply an arm is seen
STEEP = 0.08  # foreshortening down to which that holds
SPACIOUS = 56.0  # pixels between control points from which every plane shows its grips
ALIKE = 1e-6  # sine of the angle between two directions that span no plane


@dataclass(frozen=True, eq=False)
class PlaneHandles:
    """Control planes of one surface, in rows; screen pixels run right and downwards."""

    numbers: NDArray[np.intp]
    """(n,) of the planes, ascending: all of a surface, perhaps only some faces of a mesh"""
    world: Floats
    """(n, 3) the P_ij"""
    automatic: Flags
    """(2, n) which directions nobody has set"""
    points: Floats
    """(n, 2) the dots, at the P_ij"""
    corners: Floats
    """(n, 4, 3) of the squares in the world, counter-clockwise as seen from the front"""
    tips: Floats
    """(2, n, 2) the grips: tips[0] at the end of d^u, tips[1] at that of d^v"""
    tips_world: Floats
    """(2, n, 3) the same in the world"""
    drawn: NDArray[np.bool_]
    """(2, n) false where a direction is zero or seen end on: no arm and no grip there"""
    frames: Floats
    """(n, 3, 3) unit vectors in rows: the sides of the square by u and by v, and its normal"""
    flat: NDArray[np.bool_]
    """(n,) true where the directions span a plane; else the square faces the view as it can"""
    front: NDArray[np.bool_]
    """(n,) true where the normal points to the eye"""
    spacing: float
    """pixels between neighboring control points in the middle of all, seen from the side"""

    def rows_of(self, numbers: "tuple[int, ...] | NDArray[np.intp]") -> NDArray[np.intp]:
        """(k,) the rows of planes that are among them."""
        rows: NDArray[np.intp] = np.searchsorted(self.numbers, np.asarray(numbers, dtype=np.intp))
        return rows

    def among(self, numbers: tuple[int, ...]) -> Flags:
        """(n,) which of the planes those are."""
        return np.isin(self.numbers, numbers)

    def gripped(self, selected: tuple[int, ...]) -> NDArray[np.bool_]:
        """(2, n) whose grips are shown: of all planes where there is room, else of `selected`."""
        shown = self.drawn.copy()
        if self.spacing < SPACIOUS:
            shown[:, ~self.among(selected)] = False
        return shown


def handles_of_plane(geometry: Planar, number: int, camera: Camera) -> tuple[PlaneHandles, int]:
    """Handles with that plane among them, as it is drawn, and its row."""
    many = isinstance(geometry, MeshSurface) and geometry.mesh.face_count > ALL_UP_TO
    at = plane_handles(geometry, camera, (number,) if many else None)
    return at, int(at.rows_of((number,))[0])


@lru_cache(maxsize=64)
def plane_handles(
    geometry: Planar, camera: Camera, faces: tuple[int, ...] | None = None
) -> PlaneHandles:
    """Where the dots, squares and grips of a surface stand in that view; with `faces`, of those."""
    net, vectors = geometry.net, geometry.vectors
    numbers = np.arange(len(net)) if faces is None else np.array(faces, dtype=np.intp)
    points, directions, automatic = net.control_points, vectors, net.automatic_vectors
    if faces is not None:
        points, directions, automatic = points[numbers], vectors[:, numbers], automatic[:, numbers]
    pixel, spacing = camera.pixel_at(points), _spacing(geometry, camera)
    frames, flat = plane_frames(directions, camera.axes_of_view)
    side = np.clip(ROOM * spacing, SMALLEST, SIDE) * pixel
    corners = points[:, None] + _CORNERS @ frames[:, :2] * (side / 2.0)[:, None, None]
    full = plane_reaches(geometry, numbers)[..., None] * directions
    arms, drawn = zip(
        *(_arms(points, full[way], directions[way], camera) for way in (0, 1)), strict=True
    )
    tips = points + np.stack(arms)
    return PlaneHandles(
        numbers,
        points,
        automatic,
        camera.to_screen(points),
        corners,
        np.stack([camera.to_screen(tip) for tip in tips]),
        tips,
        np.stack(drawn),
        frames,
        flat,
        _turns_left(camera.to_screen(corners.reshape(-1, 3)).reshape(-1, 4, 2)),
        spacing,
    )


def plane_reaches(geometry: Planar, numbers: NDArray[np.intp]) -> Floats:
    """(2, n) or (2, 1) the lengths of arms for directions of length 1, as they are by themselves.

    Of a surface to the next node; of a face as far as its parameters reach from the center.
    """
    if isinstance(geometry, PlusSurface):
        return np.array(geometry.spacings)[:, None] * abs(geometry.s)
    return np.tile(geometry.planes.radii[numbers] * abs(geometry.s), (2, 1))


_CORNERS = np.array([[1.0, 1.0], [-1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]])
"""Of a square, in halves of its sides."""


def plane_frames(directions: Floats, view: Floats) -> tuple[Floats, NDArray[np.bool_]]:
    """(n, 3, 3) perpendicular unit vectors in rows, and (n,) whether the directions give them.

    The first two lie in the plane of the `directions` (2, n, 3), one as near to the first as the
    other to the second; the third is normal to it. One direction alone is kept, and turned about
    so that the square is seen as well as can be; `view` are the axes of the view.
    """
    by_u, by_v = unit(directions)
    flat = np.linalg.norm(np.cross(by_u, by_v), axis=1) > ALIKE
    middle, across = unit(by_u + by_v), unit(by_u - by_v)
    sides = np.stack([middle + across, middle - across], axis=1) * np.sqrt(0.5)
    frames = np.concatenate([sides, np.cross(sides[:, 0], sides[:, 1])[:, None]], axis=1)
    for number in np.flatnonzero(~flat):
        frames[number] = _lone_frame(by_u[number], by_v[number], view)
    return frames, flat


def _lone_frame(by_u: Floats, by_v: Floats, view: Floats) -> Floats:
    """A frame for directions that span no plane, one or both of them zero perhaps."""
    _, up, toward = view
    if not by_u.any() and not by_v.any():
        return view
    along = by_u if by_u.any() else by_v
    beside = np.cross(toward, along)
    beside = unit(beside if np.linalg.norm(beside) > ALIKE else np.cross(up, along))
    if not by_u.any():
        return np.stack([-beside, along, np.cross(-beside, along)])
    return np.stack([along, beside, np.cross(along, beside)])


def _arms(
    points: Floats, full: Floats, directions: Floats, camera: Camera
) -> tuple[Floats, NDArray[np.bool_]]:
    """(n, 3) from the dots to the grips in the world, and (n,) which of them are drawn."""
    ways, pixel = unit(directions), camera.pixel_at(points)
    seen = foreshortening(points, ways, pixel, camera)
    length = np.clip(np.linalg.norm(full, axis=1) / pixel, SHORTEST, LONGEST)
    length = np.maximum(length, LEAST / np.maximum(seen, STEEP))
    drawn = seen > END_ON
    arms: Floats = ways * np.where(drawn, length * pixel, 0.0)[:, None]
    return arms, drawn


def _turns_left(corners: Floats) -> NDArray[np.bool_]:
    """(n,) whether polygons (n, 4, 2) run counter-clockwise on a screen whose y points down."""
    first, second = corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]
    turns: NDArray[np.bool_] = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0] < 0.0
    return turns


def _spacing(geometry: Planar, camera: Camera) -> float:
    if isinstance(geometry, MeshSurface):
        return inf if geometry.mesh.face_count > ALL_UP_TO else _edge(geometry.mesh, camera)
    points = geometry.planes.points
    pixel = camera.pixel_at(points.reshape(-1, 3)).reshape(points.shape[:2])
    along_u = np.linalg.norm(np.diff(points, axis=0), axis=2) / pixel[1:]
    along_v = np.linalg.norm(np.diff(points, axis=1), axis=2) / pixel[:, 1:]
    return float(np.median(np.concatenate([along_u.ravel(), along_v.ravel()])))


def _edge(mesh: PolygonMesh, camera: Camera) -> float:
    """Pixels along the median edge, seen from the side."""
    corners = mesh.vertices[mesh.corners]
    lengths = np.linalg.norm(corners[mesh.following] - corners, axis=1)
    return float(np.median(lengths / camera.pixel_at(corners)))
