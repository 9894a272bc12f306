"""Faces of a mesh as they lie on its surface: the outlines of those that are selected."""

from collections.abc import Iterator
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.scene.items import Item, Segments
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing, Pairs

WIDTH = 2.0  # pixels
KEPT = 4  # outlines of each net

_OUTLINES: "WeakKeyDictionary[DrawnNet, dict[tuple[int, ...], Pairs]]" = WeakKeyDictionary()


def face_items(
    drawing: MeshDrawing, faces: tuple[int, ...], color: str = "selected", width: float = WIDTH
) -> Iterator[Item]:
    """A line around the faces, as the surface is drawn; none between two of them."""
    yield Segments(*drawing.lines(outline_of(drawing.net, faces)), color, width)


def outline_of(net: DrawnNet, faces: tuple[int, ...]) -> Pairs:
    """(k, 2) vertices of the net joined by the edges around those faces of the mesh."""
    kept = _OUTLINES.setdefault(net, {})
    if faces not in kept:
        while len(kept) >= KEPT:
            del kept[next(iter(kept))]
        kept[faces] = _outline(net, faces)
    return kept[faces]


def _outline(net: DrawnNet, faces: tuple[int, ...]) -> Pairs:
    chosen = np.isin(net.parents, faces)
    places = np.flatnonzero(np.repeat(chosen, net.mesh.sizes))
    ends = net.mesh.corners.astype(np.intp)[np.stack([places, net.mesh.following[places]], axis=1)]
    count = max(net.mesh.vertex_count, 1)
    keys, counts = np.unique(ends.min(axis=1) * count + ends.max(axis=1), return_counts=True)
    return np.stack(np.divmod(keys[counts == 1], count), axis=1)
