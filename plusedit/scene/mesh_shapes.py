"""What surfaces of meshes look like, in the plane and in space."""

from collections.abc import Hashable, Iterator
from weakref import WeakKeyDictionary, WeakValueDictionary

import numpy as np

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.color_scale import Colors
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.faceted_mesh import faceted
from plusedit.scene.items import Item, Mesh, Polyline, Segments
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.options import ViewOptions
from plusedit.scene.silhouettes import lifted, zero_lines
from plusedit.scene.space_camera import SpaceCamera

FEW = 4000  # edges, up to which they are drawn without being asked for
EDGE = 1.5  # pixels
SHORTEST = 14.0  # pixels that a line of a silhouette extends, to be drawn
EDGES = "line@22"
WIRE = "line@30"
DIM, FAINT = "@45", "line@10"  # of locked shapes
BACK = 0.72  # of the brightness of a surface's own color

_ITEMS: "WeakValueDictionary[tuple[object, ...], Mesh]" = WeakValueDictionary()
"""Those that someone still draws."""
_SEEN: "WeakKeyDictionary[MeshDrawing, dict[type, tuple[Hashable, tuple[Floats, ...]]]]" = (
    WeakKeyDictionary()
)
_SEGMENTS: "WeakKeyDictionary[MeshDrawing, dict[tuple[str, str], Segments]]" = WeakKeyDictionary()


def mesh_item(shape: Shape, drawing: MeshDrawing, colors: Colors | None = None) -> Mesh:
    """The surface shaded, the same item as before while it is to look the same.

    With `colors` (n, 3) of its points instead of the colors of its sides.
    """
    own, dim = shape.style.color, DIM if shape.locked else ""
    front, back = (own, darker(own)) if own else ("front", "back")
    sides = front + dim, back + dim
    key = (drawing, *sides, id(colors))
    kept = _ITEMS.get(key)
    if kept is None:
        # It holds its colors: as long as it is kept, no others get their number.
        item = Mesh(drawing.points, drawing.net.triangles, drawing.normals, *sides, colors)
        kept = _ITEMS[key] = item
    return kept


def mesh_items_in_space(
    shape: Shape,
    surface: MeshSurface,
    camera: SpaceCamera,
    options: ViewOptions,
    *,
    selected: bool,
    draft: bool,
    wait: bool,
    colors: Colors | None = None,
) -> Iterator[Item]:
    """The surface shaded, its edges and, unless it is a draft, its silhouette."""
    is_itself = options.facets or shape.style.facets
    drawing = faceted(surface.mesh) if is_itself else drawing_of(surface, wait=wait)
    yield mesh_item(shape, drawing, colors)
    if options.wire:
        yield edge_item(drawing, "edges", WIRE)
    elif options.isolines and len(drawing.net.edges) <= FEW:
        yield edge_item(drawing, "edges", FAINT if shape.locked else EDGES)
    color = ("selected" if selected else "line") + (DIM if shape.locked else "")
    width = shape.style.width or EDGE
    yield edge_item(drawing, "boundary", color, width)
    if not draft:
        yield from (Polyline(line, color, width) for line in mesh_silhouette(drawing, camera))


def mesh_items_in_plane(
    shape: Shape,
    surface: MeshSurface,
    camera: PlaneCamera,
    options: ViewOptions,
    *,
    selected: bool,
    wait: bool,
) -> Iterator[Item]:
    """The outline of the surface, and its edges where they are few."""
    drawing = drawing_of(surface, wait=wait)
    if options.isolines and len(drawing.net.edges) <= FEW:
        yield edge_item(drawing, "edges", FAINT if shape.locked else EDGES)
    color = "selected" if selected else shape.style.color or "plus"
    color += DIM if shape.locked else ""
    width = shape.style.width or EDGE
    yield edge_item(drawing, "boundary", color, width)
    yield from (Polyline(line, color, width) for line in mesh_silhouette(drawing, camera))


def edge_item(drawing: MeshDrawing, which: str, color: str, width: float = 1.0) -> Segments:
    """The "edges" of the polygons or only those at the "boundary"; the same item as before."""
    kept = _SEGMENTS.setdefault(drawing, {})
    key = (which, f"{color} {width}")
    if key not in kept:
        kept[key] = Segments(*drawing.lines(getattr(drawing.net, which)), color, width)
    return kept[key]


def mesh_silhouette(drawing: MeshDrawing, camera: Camera) -> tuple[Floats, ...]:
    """Lines (m, 3) where the surface turns away from the eye.

    In space they lie before it, and those of bumps that are seen as small are left out.
    """
    key: Hashable = camera.projection if isinstance(camera, PlaneCamera) else camera
    # One for each view: both are drawn again whenever something changes.
    by_kind = _SEEN.setdefault(drawing, {})
    seen = by_kind.get(type(camera))
    if seen is None or seen[0] != key:
        lines = zero_lines(drawing.points, drawing.net.triangles, _facing(drawing, camera))
        if isinstance(camera, SpaceCamera):
            found = tuple(lifted(line, camera) for line in _long(list(lines), camera))
        else:
            found = tuple(lines)
        seen = by_kind[type(camera)] = key, found
    return seen[1]


def _long(lines: list[Floats], camera: SpaceCamera) -> Iterator[Floats]:
    """The lines that are seen as long enough; all others together would look like dirt."""
    if lines:
        starts = np.cumsum([0, *map(len, lines[:-1])])
        screen = camera.to_screen(np.concatenate(lines))
        spans = np.maximum.reduceat(screen, starts) - np.minimum.reduceat(screen, starts)
        yield from (line for line, span in zip(lines, spans, strict=True) if span.max() >= SHORTEST)


def darker(color: str) -> str:
    """The back of a surface that has a color of its own."""
    parts = (int(color[i : i + 2], 16) for i in (1, 3, 5))
    return "#" + "".join(f"{round(BACK * part):02X}" for part in parts)


def _facing(drawing: MeshDrawing, camera: Camera) -> Floats:
    """(n,) positive where the surface is seen from its front."""
    if isinstance(camera, SpaceCamera) and camera.perspective:
        facing: Floats = np.einsum("nd,nd->n", drawing.normals, camera.eye - drawing.points)
    else:
        facing = drawing.normals @ camera.axes_of_view[2]
    return facing
