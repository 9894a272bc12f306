"""Faces of a mesh as they lie on its surface: what those look like that are selected."""

from collections.abc import Iterator
from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.scene.items import Item, Mesh, Segments
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing, Pairs

WIDTH = 2.0  # pixels
FILL = "selected@30"
INNER = "@60"  # of the edges between selected faces
MOST = 5000  # faces between which edges are drawn
KEPT = 4  # outlines of each net


class Outline(NamedTuple):
    """Pairs of vertices of a net (k, 2) that edges of faces join."""

    around: Pairs
    """with one of the faces on one side only"""
    between: Pairs
    """with two of them"""


_FILLS: "WeakKeyDictionary[MeshDrawing, tuple[tuple[int, ...], Mesh]]" = WeakKeyDictionary()

NONE = np.zeros((0, 2), np.intp)

_OUTLINES: "WeakKeyDictionary[DrawnNet, dict[tuple[int, ...], Outline]]" = WeakKeyDictionary()


def face_items(
    drawing: MeshDrawing, faces: tuple[int, ...], color: str = "selected", width: float = WIDTH
) -> Iterator[Item]:
    """A line around the faces, as the surface is drawn, and thin ones between them."""
    outline = outline_of(drawing.net, faces)
    if len(outline.between) and len(faces) <= MOST:
        yield Segments(*drawing.lines(outline.between), color + INNER, 1.0)
    yield Segments(*drawing.lines(outline.around), color, width)


def face_fill(drawing: MeshDrawing, faces: tuple[int, ...]) -> Mesh:
    """The faces as glass on the surface; the same item as before while it is to look the same."""
    kept = _FILLS.get(drawing)
    if kept is None or kept[0] != faces:
        triangles = drawing.net.triangles[np.isin(drawing.net.faces, faces)]
        used, places = np.unique(triangles, return_inverse=True)
        at = drawing.points[used], places.reshape(-1, 3).astype(np.int32), drawing.normals[used]
        kept = _FILLS[drawing] = faces, Mesh(*at, FILL, FILL)
    return kept[1]


def outline_of(net: DrawnNet, faces: tuple[int, ...]) -> Outline:
    """The edges of those faces of the mesh in the net."""
    kept = _OUTLINES.setdefault(net, {})
    if faces not in kept:
        while len(kept) >= KEPT:
            del kept[next(iter(kept))]
        kept[faces] = _outline(net, faces)
    return kept[faces]


def _outline(net: DrawnNet, faces: tuple[int, ...]) -> Outline:
    owners = np.repeat(net.parents, net.mesh.sizes)
    places = np.flatnonzero(np.isin(owners, faces))
    if not len(places):
        return Outline(NONE, NONE)
    corners, count = net.mesh.corners.astype(np.intp), max(net.mesh.vertex_count, 1)
    ends = np.stack([corners[places], corners[net.mesh.following[places]]])
    keys = ends.min(axis=0) * count + ends.max(axis=0)
    order = np.argsort(keys, kind="stable")
    keys, owners = keys[order], owners[places[order]]
    firsts = np.flatnonzero(np.diff(keys, prepend=-1))
    pairs = np.stack(np.divmod(keys[firsts], count), axis=1)
    alone = np.diff(firsts, append=len(keys)) == 1
    # Parts of the same face have edges in common, too, which are not edges of the face.
    differ = np.minimum.reduceat(owners, firsts) != np.maximum.reduceat(owners, firsts)
    return Outline(pairs[alone], pairs[differ])
