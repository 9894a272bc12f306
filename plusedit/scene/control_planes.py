"""What control planes look like: a small square, an arm and a grip by u and one by v.

The edge and the grip by u are yellow and round, those by v magenta and lozenges: so they tell which
way a plane lies even where the colors don't. The back of a square is darker than its front. Grips
of automatic directions are hollow, the user's solid; so are squares, solid where the user has set
one of the two directions.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from plusedit.scene.camera import Camera
from plusedit.scene.control_lines import NORMAL, QUIET, SELECTED, Rows, Strokes
from plusedit.scene.items import Item, Mark, Markers, Polygon, Segments
from plusedit.scene.plane_handles import ROOM, SMALLEST, Planar, PlaneHandles, plane_handles

DOT = 4.5  # pixels, as all sizes here
GRIPS: Final[tuple[tuple[str, Mark, float], ...]] = (("u", "circle", 9.0), ("v", "diamond", 10.0))
"""Color, mark and size, by u and by v."""
RING = 34.0  # around the square of the active plane
FEWEST = 2.0 * SMALLEST / ROOM  # between control points, below which squares are mere dots
MOST = 1000  # squares of one surface; of more, unselected ones are dots
BACK = "@45"  # what the outline of a back has left of its opacity

EDGES = ((3, 0), (0, 1))
"""Corners of a square at the ends of the edge by u and of that by v."""
OTHERS = ((1, 2), (2, 3))


@dataclass(frozen=True, eq=False)
class Planes:
    """The control planes of one surface with what their looks depend on."""

    at: PlaneHandles
    gripped: NDArray[np.bool_]
    """(2, n)"""
    order: Rows
    """(n,) the rows of them from the farthest to the nearest"""

    def ordered(self, taken: NDArray[np.bool_]) -> Rows:
        """The rows of those planes, the farthest first."""
        return self.order[taken[self.order]]


def control_plane_items(
    geometry: Planar,
    camera: Camera,
    *,
    selected: tuple[int, ...] = (),
    active: int | None = None,
    quiet: bool = False,
    faces: tuple[int, ...] | None = None,
) -> Iterator[Item]:
    """The control planes of one surface, the selected ones in front; with `faces`, only those."""
    at = plane_handles(geometry, camera, faces)
    order = np.argsort(-camera.depths(at.world), kind="stable")
    planes, chosen = Planes(at, at.gripped(selected), order), at.among(selected)
    small = at.spacing < FEWEST or len(chosen) > MOST
    yield from _planes(planes, planes.ordered(~chosen), QUIET if quiet else NORMAL, small=small)
    if active is not None:
        point = geometry.net.control_points[[active]]
        yield Markers(point, "circle", RING, "selected@22", "selected@22")
    yield from _planes(planes, planes.ordered(chosen), SELECTED, small=False)


def _planes(planes: Planes, rows: Rows, strokes: Strokes, *, small: bool) -> Iterator[Item]:
    if not len(rows):
        return
    if not small:
        yield from _fills(planes, rows, strokes)
        yield from _outlines(planes, rows, strokes)
    yield from _arms(planes, rows, strokes)
    yield from _grips(planes, rows, strokes)
    points = planes.at.world[rows]
    yield Markers(points, "circle", DOT, strokes.color, strokes.color, 1.0)


def _fills(planes: Planes, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    at, automatic = planes.at, planes.at.automatic
    hollow = automatic.all(axis=0) & (strokes is not SELECTED)
    for row in rows[(at.flat & ~hollow)[rows]]:
        yield Polygon(at.corners[row], "front@85" if at.front[row] else "back")


def _outlines(planes: Planes, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    """The four edges of the squares; dotted where the directions span no plane."""
    at = planes.at
    backs, fronts = rows[~at.front[rows] & at.flat[rows]], rows[at.front[rows] & at.flat[rows]]
    yield from _edges(at, backs, OTHERS, _faded(strokes.color), strokes.width)
    yield from _edges(at, fronts, OTHERS, strokes.color, strokes.width)
    for (color, _, _), edge in zip(GRIPS, EDGES, strict=True):
        width = strokes.width + 0.75
        faint = f"{color}@70" if strokes is QUIET else color
        yield from _edges(at, rows[at.flat[rows]], (edge,), faint, width)
    for row in rows[~at.flat[rows]]:
        corners = at.corners[row]
        ends = np.roll(corners, -1, axis=0)
        yield Segments(corners, ends, strokes.color, strokes.width, "dot")


def _faded(color: str) -> str:
    return color if "@" in color else color + BACK


def _edges(
    at: PlaneHandles, rows: Rows, edges: tuple[tuple[int, int], ...], color: str, width: float
) -> Iterator[Item]:
    if len(rows):
        corners = at.corners[rows]
        starts = np.concatenate([corners[:, start] for start, _ in edges])
        ends = np.concatenate([corners[:, end] for _, end in edges])
        yield Segments(starts, ends, color, width)


def _arms(planes: Planes, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    points = planes.at.world
    for way, (color, _, _) in enumerate(GRIPS):
        gripped = rows[planes.gripped[way, rows]]
        if len(gripped):
            faint = f"{color}@60" if strokes is QUIET else color
            tips = planes.at.tips_world[way, gripped]
            yield Segments(points[gripped], tips, faint, strokes.width)


def _grips(planes: Planes, rows: Rows, strokes: Strokes) -> Iterator[Item]:
    automatic = planes.at.automatic
    for way, (color, mark, size) in enumerate(GRIPS):
        gripped = rows[planes.gripped[way, rows]]
        for hollow in (False, True):
            these = gripped[automatic[way, gripped] == hollow]
            if len(these):
                tips = planes.at.tips_world[way, these]
                larger = size + 1.5 if strokes is SELECTED else size
                yield Markers(tips, mark, larger, None if hollow else color, color)
