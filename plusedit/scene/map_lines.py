"""Maps of surfaces in a plane view: level lines, where the 3D view has colors and stripes.

There a surface has no body, only lines. A map is drawn as the lines along which its value stays the
same, in the colors of its legend; stripes as the lines where dark and light ones meet.
"""

from collections import deque
from collections.abc import Hashable, Iterator, Mapping, Sequence
from itertools import pairwise

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_kernels import points_and_normals
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.color_scale import SCALES
from plusedit.scene.coloring import coloring_overlay, legend_of, span_of
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.drawn_surface import surface_grids
from plusedit.scene.items import Item, Segments
from plusedit.scene.level_lines import Triples, level_segments, triangles_of_grid
from plusedit.scene.map_values import values_of
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import CONTRAST, Overlay
from plusedit.scene.shapes import shown_meshes, shown_shapes
from plusedit.scene.stripes import Stripes, stripes_of

WIDTH = 1.25
STRIPE = "line"
RECENT = 12  # shapes whose lines are kept

_recent: deque[tuple[Floats, Hashable, list[Segments]]] = deque(maxlen=RECENT)
"""What was drawn by an array of values or points, and by what else; arrays never change."""


def map_items(
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    *,
    wait: bool = True,
    chosen: frozenset[ShapeId] = frozenset(),
) -> Iterator[Item]:
    """The lines of the map or of the stripes that are switched on, and the legend of the map.

    The `chosen` shapes are selected.
    """
    entry, stripes = coloring_overlay(options.overlays), stripes_of(options)
    if entry is not None:
        values = values_of(entry, design, camera, options, wait=wait, chosen=chosen)
        yield from _lines_of_map(entry, values, design, camera, options, wait)
    elif stripes is not None:
        yield from _lines_of_stripes(stripes, design, camera, wait)


def _lines_of_map(
    entry: Overlay,
    values: Mapping[ShapeId, Floats],
    design: Design,
    camera: PlaneCamera,
    options: ViewOptions,
    wait: bool,
) -> Iterator[Item]:
    contrast = entry.numbers(options.settings).get(CONTRAST.name, CONTRAST.usual)
    span = span_of(entry.coloring, values.values(), contrast)
    if span is None:
        return
    marks = [value for value, _ in span.ticks()]
    levels = tuple(sorted([*marks, *((a + b) / 2.0 for a, b in pairwise(marks))]))
    rows = SCALES[entry.coloring.kind].at(span.shares(np.array(levels)))
    colors = ["#" + "".join(f"{round(255.0 * part):02X}" for part in row) for row in rows]
    for shape_id, found in values.items():
        geometry = design[shape_id].geometry
        yield from _lines(geometry, found, levels, colors, camera, wait)
    yield legend_of(entry, span, values.values())


def _lines(
    geometry: Geometry,
    values: Floats,
    levels: Sequence[float],
    colors: list[str],
    camera: PlaneCamera,
    wait: bool,
) -> Iterator[Segments]:
    """One item for each level; the same as before for the same values."""
    key = (*levels, camera.projection)
    kept = _kept(values, key)
    if kept is None:
        points, triangles = _drawn(geometry, camera, wait)
        found = level_segments(points, triangles, values.ravel(), levels)
        kept = [
            Segments(starts, ends, color, WIDTH)
            for (starts, ends), color in zip(found, colors, strict=True)
            if len(starts)
        ]
        _recent.append((values, key, kept))
    yield from kept


def _kept(array: Floats, key: Hashable) -> list[Segments] | None:
    return next((lines for one, by, lines in _recent if one is array and by == key), None)


def _drawn(geometry: Geometry, camera: PlaneCamera, wait: bool) -> tuple[Floats, Triples]:
    """(n, 3) the points that are drawn of a surface, and the triangles that join them."""
    if isinstance(geometry, MeshSurface):
        drawing = drawing_of(geometry, wait=wait)
        return drawing.points, _seen(drawing, camera)
    assert isinstance(geometry, PlusSurface)
    grids = surface_grids(geometry, camera)
    return geometry.sample(*grids).reshape(-1, 3), triangles_of_grid(*map(len, grids))


def _lines_of_stripes(
    stripes: Stripes, design: Design, camera: PlaneCamera, wait: bool
) -> Iterator[Item]:
    pairs = np.arange(-stripes.count, stripes.count + 1)
    # Lamps are thin: a line each. Of bands both edges count.
    edges = (0.0,) if stripes.kind == "reflection" else (0.25, 0.75)
    levels = np.pi / stripes.count * np.concatenate([pairs + edge for edge in edges])
    key = stripes, camera.projection
    for points, triangles, across in _with_normals(design, camera, wait):
        kept = _kept(points, key)
        if kept is None:
            angles = _angles(stripes, across, camera)
            # Where the angle jumps by a whole turn there is no line.
            runs_on = np.ptp(angles[triangles], axis=1) < np.pi
            found = list(level_segments(points, triangles[runs_on], angles, levels.tolist()))
            starts, ends = (np.concatenate(each) for each in zip(*found, strict=True))
            kept = [Segments(starts, ends, STRIPE, 1.0)] if len(starts) else []
            _recent.append((points, key, kept))
        yield from kept


def _with_normals(
    design: Design, camera: PlaneCamera, wait: bool
) -> Iterator[tuple[Floats, Triples, Floats]]:
    for _, _, geometry in shown_shapes(design):
        if isinstance(geometry, PlusSurface):
            grids = surface_grids(geometry, camera)
            both = points_and_normals(geometry, *grids)
            points, across = (each.reshape(-1, 3).astype(np.float64) for each in both)
            yield points, triangles_of_grid(*map(len, grids)), across
    for _, _, surface in shown_meshes(design):
        drawing = drawing_of(surface, wait=wait)
        yield drawing.points, _seen(drawing, camera), drawing.normals


def _seen(drawing: MeshDrawing, camera: PlaneCamera) -> Triples:
    """The triangles; of a closed body, whose back nobody sees, those in front."""
    triangles = drawing.net.triangles
    if len(drawing.net.boundary):
        return triangles
    is_front = drawing.normals @ camera.axes_of_view[2] > 0.0
    seen: Triples = triangles[is_front[triangles].all(axis=1)]
    return seen


def _angles(stripes: Stripes, across: Floats, camera: PlaneCamera) -> Floats:
    """(n,) that the stripes are bands of, as `stripes` has them and the shader draws them."""
    if stripes.kind == "isophotes":
        angles: Floats = np.arccos(np.clip(across @ np.array(stripes.light), -1.0, 1.0))
        return angles
    toward = camera.axes_of_view[2]
    mirrored = 2.0 * (across @ toward)[:, None] * across - toward
    if stripes.kind == "zebra":
        angles = np.arccos(np.clip(mirrored @ camera.axes_of_view[1], -1.0, 1.0))
    else:
        angles = np.arctan2(mirrored[:, 2], mirrored[:, 1])
    return angles
