"""Parameters by corner of polygons from those of their triangles.

A cut may run along the diagonal of a polygon; then its triangles see their vertices at different
images. They are moved to where the first of them is.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.sheet import Sheet
from plusedit.geometry.mesh.polygons import PolygonMesh


def by_corner(mesh: PolygonMesh, sheet: Sheet, places: Floats) -> Floats:
    """(c, 2) parameters of the corners of a mesh from those of its triangles (t, 3, 2)."""
    parameters = np.zeros((len(mesh.corners), 2))
    cut = mesh.triangulation
    seen = _sewn(cut.owners, sheet, places)
    # Of several triangles at a corner the last stays; all have the same there.
    parameters[cut.corners.ravel()] = seen.reshape(-1, 2)
    return parameters


def _sewn(owners: "np.typing.NDArray[np.int32]", sheet: Sheet, places: Floats) -> Floats:
    """The places with the triangles of each polygon moved together."""
    count = len(owners)
    tails = places[:count].reshape(-1, 2)
    heads = np.roll(places[:count], -1, axis=1).reshape(-1, 2)
    half_edges = np.flatnonzero(sheet.opposite[: 3 * count] >= 0)
    across = sheet.opposite[half_edges]
    inside = across < 3 * count
    half_edges, across = half_edges[inside], across[inside]
    within = owners[half_edges // 3] == owners[across // 3]
    half_edges, across = half_edges[within], across[within]
    torn = (tails[half_edges] != heads[across]).any(axis=1)
    if not torn.any():
        return places[:count]
    moved = places[:count].copy()
    for owner in np.unique(owners[half_edges[torn] // 3]).tolist():
        triangles = np.flatnonzero(owners == owner).tolist()
        done, waiting = {triangles[0]}, triangles[1:]
        while waiting:
            for triangle in waiting:
                found = next(
                    (
                        corner
                        for corner in range(3 * triangle, 3 * triangle + 3)
                        if sheet.opposite[corner] // 3 in done
                    ),
                    None,
                )
                if found is not None:
                    break
            else:
                break
            _move_beside(moved, triangle, found, int(sheet.opposite[found]))
            done.add(triangle)
            waiting.remove(triangle)
    return moved


def _move_beside(places: Floats, triangle: int, half_edge: int, across: int) -> None:
    """Put a triangle where its half-edge meets the one across, by a shift or half a turn."""
    tail, head = places[triangle, half_edge % 3], places[triangle, (half_edge + 1) % 3]
    other_head = places[across // 3, across % 3]
    other_tail = places[across // 3, (across + 1) % 3]
    sign = 1.0 if (head - tail) @ (other_head - other_tail) >= 0.0 else -1.0
    places[triangle] = sign * (places[triangle] - tail) + other_tail
