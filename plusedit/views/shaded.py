"""Surfaces drawn with a QPainter, for small pictures and where there is no OpenGL.

Every surface becomes a few thousand small quadrilaterals in one color each, drawn from the
farthest to the nearest: the light is that of the 3D view, what lies behind is covered.
"""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QPen

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.blend import Grid
from plusedit.scene.camera import Camera
from plusedit.scene.items import Mesh, Patch
from plusedit.scene.theme import Theme
from plusedit.views.arrays import polygon_of
from plusedit.views.painter import ItemPainter, color_of

FINEST = 49  # samples each way: enough for a picture of some hundred pixels
KEY = unit(np.array([-0.45, 0.65, 0.6]))  # the light: to the right, upwards, toward the eye
AMBIENT, DIFFUSE, SKY = 0.42, 0.5, 0.14  # shares of light; they add up to about one
SEAM = 1.8  # pixels of outline in the same color: closes the hairlines between neighbors


def draw_patches(items: Sequence[Patch | Mesh], to: ItemPainter) -> None:
    """Draw surfaces so that each covers what lies behind it."""
    faces = [_faces(item, to.camera, to.theme) for item in items]
    if not faces:
        return
    screen = [corners for group in faces for corners in group[0]]
    depths = np.concatenate([group[1] for group in faces])
    colors = np.concatenate([group[2] for group in faces])
    for place in np.argsort(-depths, kind="stable"):
        red, green, blue, alpha = (round(value) for value in colors[place])
        color = color_of(f"#{red:02X}{green:02X}{blue:02X}{alpha:02X}")
        pen = QPen(color, SEAM) if alpha == 255 else QPen(Qt.PenStyle.NoPen)
        to.painter.setPen(pen)
        to.painter.setBrush(color)
        to.painter.drawPolygon(polygon_of(screen[place]))
    to.painter.setBrush(Qt.BrushStyle.NoBrush)


def _faces(item: Patch | Mesh, camera: Camera, theme: Theme) -> tuple[list[Floats], Floats, Floats]:
    """Corners on the screen (k, 3 or 4, 2), depths (k,) and colors (k, 4) of the faces."""
    corners = _quadrilaterals(item) if isinstance(item, Patch) else item.points[item.triangles]
    flat = corners.reshape(-1, 3)
    screen = camera.to_screen(flat).reshape(*corners.shape[:2], 2)
    depths = camera.depths(flat).reshape(corners.shape[:2]).mean(axis=1)
    normals = _normals(corners)
    center = corners.mean(axis=1)
    origin, way = camera.ray(np.array(camera.size) / 2.0)
    looking = center - origin if getattr(camera, "perspective", False) else np.tile(way, (1, 1))
    is_front = np.einsum("kd,kd->k", normals, np.broadcast_to(looking, normals.shape)) < 0.0
    light = _light(np.where(is_front[:, None], normals, -normals) @ camera.axes_of_view.T)
    sides = np.array([_channels(theme.color(item.back)), _channels(theme.color(item.front))])
    colors = sides[is_front.astype(int)]
    if item.colors is not None:
        colors[:, :3] = 255.0 * _own_colors(item, item.colors.astype(np.float64))
    colors[:, :3] = np.clip(colors[:, :3] * light[:, None], 0.0, 255.0)
    is_seen = np.isfinite(screen).all(axis=(1, 2))
    return list(screen[is_seen]), depths[is_seen], colors[is_seen]


def _quadrilaterals(patch: Patch) -> Floats:
    """(k, 4, 3) the corners of the cells between samples."""
    return _cells(patch.surface.sample(*map(_coarse, (patch.grid_u, patch.grid_v))))


def _coarse(grid: Grid) -> Grid:
    return grid if len(grid) <= FINEST else Grid.uniform(FINEST)


def _cells(samples: Floats) -> Floats:
    """(k, 4, 3) what is at the corners of the cells between samples (m_u, m_v, 3)."""
    around = samples[:-1, :-1], samples[1:, :-1], samples[1:, 1:], samples[:-1, 1:]
    return np.stack(around, axis=2).reshape(-1, 4, 3)


def _own_colors(item: Patch | Mesh, colors: Floats) -> Floats:
    """(k, 3) the colors of the faces: the means of those of their corners."""
    if isinstance(item, Mesh):
        by_corner: Floats = colors[item.triangles]
    else:
        # Samples are many where only some are drawn: the nearest ones stand for those.
        rows, columns = (
            np.abs(_coarse(grid).parameters[:, None] - grid.parameters).argmin(axis=1)
            for grid in (item.grid_u, item.grid_v)
        )
        by_corner = _cells(colors[np.ix_(rows, columns)])
    means: Floats = by_corner.mean(axis=1)
    return means


def _normals(corners: Floats) -> Floats:
    """(k, 3) unit normals, by the diagonals of quadrilaterals; zero where a face has no area."""
    last = corners[:, 3] if corners.shape[1] == 4 else corners[:, 0]
    return unit(np.cross(corners[:, 2] - corners[:, 0], last - corners[:, 1]))


def _light(normals: Floats) -> Floats:
    """(k,) how bright faces are whose normals (k, 3) are given to the right, upwards, nearer."""
    key = np.clip(normals @ KEY, 0.0, 1.0)
    sky = (normals[:, 1] + 1.0) / 2.0
    light: Floats = AMBIENT + DIFFUSE * key + SKY * sky
    return light


def _channels(color: str) -> list[float]:
    return [float(int(color[i : i + 2] or "FF", 16)) for i in (1, 3, 5, 7)]
