"""What surfaces hide of lines and marks, so that these can be drawn as vectors over a picture."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.scene.items import Item, Markers, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_framing import in_space
from plusedit.scene.space_scene import Solid, SpaceLayers
from plusedit.scene.theme import LIGHT
from plusedit.views.gl.artist import SpaceArtist
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.targets import Target

LARGEST = 2048  # pixels to a side
STEP = 1.5  # logical pixels between the places of a line that are looked at
MOST = 400  # such places of one chord
SLACK = 1.0  # logical pixels: what lies no deeper behind a surface is on it

Flags = NDArray[np.bool_]


@dataclass(frozen=True, eq=False)
class Depths:
    """How deep surfaces lie in a view."""

    camera: SpaceCamera
    matrix: Floats
    """(4, 4) from the world to clip space"""
    nearest: NDArray[np.float32]
    """(height, width) of the view, from 0 to 1; 1 where there is no surface"""

    def sees(self, points: Floats) -> Flags:
        """(m,) whether each point (m, dim) is not behind a surface; outside of the view, too."""
        clip = np.column_stack([in_space(points), np.ones(len(points))]) @ self.matrix.T
        with np.errstate(all="ignore"):
            places = clip[:, :3] / clip[:, 3:]
        height, width = self.nearest.shape
        x, y = (places[:, 0] + 1.0) / 2.0 * width, (1.0 - places[:, 1]) / 2.0 * height
        inside = (x >= 0.0) & (x < width) & (y >= 0.0) & (y < height) & (clip[:, 3] > 0.0)
        seen: Flags = np.ones(len(points), dtype=np.bool_)
        there = self.nearest[y[inside].astype(np.intp), x[inside].astype(np.intp)]
        deep, surface = self._away(places[inside, 2]), self._away(2.0 * there - 1.0)
        slack = SLACK * self.camera.pixel_at(in_space(points)[inside])
        # Where there is no surface, nothing is hidden, however far behind the farthest it lies.
        seen[inside] = (deep <= surface + slack) | (there >= 1.0)
        return seen

    def _away(self, depth: Floats) -> Floats:
        """How far along the view depths in clip space lie, in the world.

        In perspective those of clip space crowd together: a slack among them would be different
        for every range that is drawn.
        """
        forth, along = self.matrix[2], self.matrix[3, :3]
        if not along.any():
            return depth / np.linalg.norm(forth[:3])
        share = forth[:3] @ along / (along @ along)
        away: Floats = (forth[3] - share * self.matrix[3, 3]) / (depth - share)
        return away


def depths_of(gl: Functions, solids: Sequence[Solid], camera: SpaceCamera) -> Depths:
    """The depths of surfaces, drawn in the context that is current."""
    ratio = LARGEST / max(camera.size)
    width, height = (max(1, round(side * ratio)) for side in camera.size)
    target, artist = Target(gl, width, height), SpaceArtist(gl)
    try:
        target.bind()
        sight = artist.paint(SpaceLayers(solids=tuple(solids)), camera, LIGHT, ratio=ratio)
        found = _widened(target.depths())
    finally:
        artist.release()
        target.release()
    return Depths(camera, sight.matrix, found)


def _widened(depths: NDArray[np.float32]) -> NDArray[np.float32]:
    """The farthest of each pixel and its neighbors: what is drawn along an edge is seen there."""
    around = np.pad(depths, 1, mode="edge")
    rows, columns = depths.shape
    shifts = ((i, j) for i in range(3) for j in range(3))
    farthest: NDArray[np.float32] = np.max(
        [around[i : i + rows, j : j + columns] for i, j in shifts], axis=0
    )
    return farthest


def parted(items: Iterable[Item], depths: Depths) -> tuple[list[Item], list[Item]]:
    """What is seen of lines, marks and areas, and what surfaces hide of them."""
    seen: list[Item] = []
    hidden: list[Item] = []
    for item in items:
        match item:
            case Polyline():
                for run, is_seen in _runs(item.points, depths):
                    (seen if is_seen else hidden).append(replace(item, points=run))
            case Segments() if len(item.starts):
                behind, before = _split(item, depths)
                hidden.append(behind)
                seen.append(before)
            case Markers() if len(item.points):
                flags = depths.sees(item.points)
                hidden.append(replace(item, points=item.points[~flags]))
                seen.append(replace(item, points=item.points[flags]))
            case Polygon() if len(item.points):
                middle = item.points.mean(axis=0)[None]
                (seen if depths.sees(middle)[0] else hidden).append(item)
            case _:
                seen.append(item)
    return seen, hidden


def _runs(points: Floats, depths: Depths) -> Iterator[tuple[Floats, bool]]:
    """The stretches of a line, seen and hidden by turns."""
    if len(points) < 2:
        return
    fine = _refined(points, depths.camera)
    flags = depths.sees((fine[:-1] + fine[1:]) / 2.0)
    edges = [0, *(np.flatnonzero(np.diff(flags)) + 1).tolist(), len(flags)]
    for start, stop in pairwise(edges):
        yield fine[start : stop + 1], bool(flags[start])


def _refined(points: Floats, camera: SpaceCamera) -> Floats:
    """The line with so many points that every chord is short in the view."""
    screen = camera.to_screen(in_space(points))
    with np.errstate(all="ignore"):
        lengths = np.nan_to_num(np.linalg.norm(np.diff(screen, axis=0), axis=1), posinf=0.0)
    counts = np.clip(np.ceil(lengths / STEP), 1, MOST).astype(np.intp)
    starts = np.repeat(np.arange(len(counts)), counts)
    within = np.arange(counts.sum()) - np.repeat(np.cumsum(counts) - counts, counts)
    share = (within / counts[starts])[:, None]
    inner = points[starts] + share * (points[starts + 1] - points[starts])
    return np.concatenate([inner, points[-1:]])


def _split(item: Segments, depths: Depths) -> tuple[Segments, Segments]:
    """The hidden parts of segments, and those that are seen."""
    ends = np.stack([item.starts, item.ends])
    screen = depths.camera.to_screen(in_space(ends.reshape(-1, ends.shape[2]))).reshape(2, -1, 2)
    longest = float(np.nanmax(np.linalg.norm(screen[1] - screen[0], axis=1), initial=1.0))
    count = min(MOST, max(1, ceil(longest / STEP)))
    shares = np.linspace(0.0, 1.0, count + 1)
    ways = (item.ends - item.starts)[:, None]
    middles = item.starts[:, None] + (shares[:-1] + 0.5 / count)[:, None] * ways
    flags = depths.sees(middles.reshape(-1, ends.shape[2])).reshape(len(item.starts), count)

    def part(chosen: Flags) -> Segments:
        steps = np.diff(np.pad(chosen.astype(np.int8), ((0, 0), (1, 1))), axis=1)
        row, first = np.nonzero(steps == 1)
        _, last = np.nonzero(steps == -1)
        way = item.ends[row] - item.starts[row]
        starts = item.starts[row] + shares[first][:, None] * way
        return replace(item, starts=starts, ends=item.starts[row] + shares[last][:, None] * way)

    return part(~flags), part(flags)
