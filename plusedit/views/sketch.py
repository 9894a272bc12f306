"""Designs in space as small pictures, drawn without OpenGL: quick, and to be had everywhere."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from PySide6.QtGui import QImage

from plusedit.document.design import Design
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.scene.composition import SIZE
from plusedit.scene.items import Item, Mesh, Patch, Polyline
from plusedit.scene.options import options_of, view_tree
from plusedit.scene.overlays import overlays
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_composition import composed_in_space
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.painter import ItemPainter, painting
from plusedit.views.picture import blank_image

WAITED_FOR = 5000  # faces, up to which meshes are smoothed for a small picture
SAMPLES = 129  # of a surface each way, to tell what it hides
CELL = 3.0  # pixels; what lies in one cell is hidden by the nearest surface there
SLACK = 0.03  # of the height that is seen: a curve on a surface is not hidden by it


def sketch_of(
    design: Design,
    size: tuple[int, int] = SIZE,
    theme: Theme = LIGHT,
    *,
    transparent: bool = False,
    ratio: float = 1.0,
) -> QImage:
    """The surfaces and curves of a design, framed in `size` logical pixels, without a legend.

    It is looked at as the design's own 3D view looks; `ratio` pixels of the image to each.
    """
    own = options_of(design.view)
    colored = frozenset(name for name in own.overlays if name in overlays and overlays[name].paints)
    bare = replace(own, overlays=colored, handles="none", isolines=False)
    plain = replace(design, view=view_tree(bare, old=design.view))
    image = blank_image(size, theme, transparent=transparent, ratio=ratio)
    faces = sum(surface.mesh.face_count for _, surface in design.meshes())
    extent = float(size[0]), float(size[1])
    picture = composed_in_space(plain, extent, wait=faces <= WAITED_FOR)
    layers, camera = picture.layers, picture.camera
    with painting(image) as painter:
        draw = ItemPainter(painter, camera, theme)
        draw.paint(layers.solids)
        draw.paint(layers.glass)
        draw.paint(_seen(layers.lines, _nearest(layers.solids, camera), camera))
    return image


Depths = NDArray[np.float64]
"""How deep the nearest surface lies in each cell of the view; infinite where there is none."""


def _nearest(solids: Sequence[Patch | Mesh], camera: SpaceCamera) -> Depths:
    width, height = (int(side // CELL) + 1 for side in camera.size)
    depths = np.full((height, width), np.inf)
    grid = Grid.uniform(SAMPLES)
    for item in solids:
        if isinstance(item, Patch):
            points = item.surface.sample(grid, grid).reshape(-1, 3)
        else:
            points = item.points
        points = points[np.isfinite(points).all(axis=1)]
        column, row = _cells(points, camera, depths)
        np.minimum.at(depths, (row, column), camera.depths(points))
    return depths


def _cells(
    points: Floats, camera: SpaceCamera, depths: Depths
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Column and row of each point; those outside of the view count to the cells at its rim."""
    column, row = np.floor(camera.to_screen(points) / CELL).T
    last_row, last_column = (side - 1 for side in depths.shape)
    return (
        np.clip(column, 0, last_column).astype(np.intp),
        np.clip(row, 0, last_row).astype(np.intp),
    )


def _seen(lines: Sequence[Item], depths: Depths, camera: SpaceCamera) -> Iterator[Item]:
    """The lines without what lies behind a surface."""
    for item in lines:
        if not isinstance(item, Polyline):
            yield item
            continue
        points = item.points
        if points.shape[1] == 2:
            points = np.column_stack([points, np.zeros(len(points))])
        column, row = _cells(points, camera, depths)
        is_seen = camera.depths(points) <= depths[row, column] + SLACK * camera.height
        for piece in _runs(is_seen):
            yield replace(item, points=points[piece])


def _runs(is_seen: NDArray[np.bool_]) -> Iterator[slice]:
    """The stretches of two points or more that are seen."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], is_seen.astype(np.int8), [0]])))
    for start, stop in edges.reshape(-1, 2):
        if stop - start > 1:
            yield slice(int(start), int(stop))
