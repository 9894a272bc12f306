"""Which faces to turn over so that all of a part face the same way.

That is a coloring of the faces with two colors, turned or not: an edge of two faces that run
along it in opposite directions asks for the same color, one along which they run in the same
direction for different ones. Seen otherwise, every face has two sides, and each such edge joins
the sides that face the same way; a part has then two halves, its two sides. Only a one-sided part,
like a Moebius strip, is in one piece.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.cleaning import Kept
from plusedit.geometry.mesh.polygons import Numbers, PolygonMesh
from plusedit.geometry.mesh.topology import connected

Flags = NDArray[np.bool_]
Indices = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Orientation:
    """Faces to be turned over, part by part."""

    component_of: Numbers
    """(f,) the connected part of every face, numbered by their lowest faces"""
    turned: Flags
    """(f,) faces to turn so that their part faces one way"""
    one_sided: Flags
    """(parts,) those of which nothing can be made so"""

    def counts(self) -> dict[str, int]:
        """Faces turned over in parts where others are not, and parts turned as a whole."""
        faces = np.bincount(self.component_of)
        turned = np.bincount(self.component_of[self.turned], minlength=len(faces))
        whole = turned == faces
        return {"turned": int(turned[~whole].sum()), "inside_out": int(np.count_nonzero(whole))}


def oriented(mesh: PolygonMesh, first: Indices, second: Indices) -> Orientation:
    """The turning of faces for which all pairs of half-edges, `first` and `second`, are opposed.

    The front of a closed part becomes its outer side, that of an open part the side which is the
    front of most of its faces already.
    """
    count = mesh.face_count
    a, b = mesh.owners[first], mesh.owners[second]
    crossed = np.where(mesh.corners[first] == mesh.corners[second], count, 0)
    if not crossed.any():
        component_of = connected(count, a, b)
        turned = np.zeros(count, dtype=np.bool_)
        one_sided = np.zeros(component_of.max(initial=-1) + 1, dtype=np.bool_)
    else:
        links = np.concatenate([a, a + count]), np.concatenate([b + crossed, b + count - crossed])
        front, back = connected(2 * count, *links).reshape(2, -1)
        # Sides are numbered by their lowest faces: the lowest face of a part stays as it is.
        component_of = np.unique(np.minimum(front, back), return_inverse=True)[1].astype(np.int32)
        turned = front > back
        one_sided = np.bincount(component_of[front == back], minlength=component_of.max() + 1) > 0
    paired = np.zeros(len(mesh.corners), dtype=np.bool_)
    paired[first] = paired[second] = True
    turned ^= _wrong_side(mesh, component_of, turned, paired)[component_of]
    return Orientation(component_of, turned, one_sided)


def _wrong_side(mesh: PolygonMesh, part: Numbers, turned: Flags, paired: Flags) -> Flags:
    """(parts,) true where the other side is the outer one, or that of most faces."""
    sizes = np.bincount(part)
    wrong: Flags = 2 * np.bincount(part[turned], minlength=len(sizes)) > sizes
    closed = np.bincount(part[mesh.owners[~paired]], minlength=len(sizes)) == 0
    if closed.any():
        volumes = np.bincount(part, _cones(mesh, part) * np.where(turned, -1.0, 1.0))
        wrong[closed] = np.where(volumes == 0.0, wrong, volumes < 0.0)[closed]
    return wrong


def _cones(mesh: PolygonMesh, part: Numbers) -> Floats:
    """(f,) volumes of the cones from the middle of the part to every face, signed by its front."""
    sizes = np.bincount(part)
    middle = [np.bincount(part, column) / sizes for column in mesh.centers.T]
    outward = mesh.centers - np.stack(middle, axis=1)[part]
    volumes: Floats = np.einsum("fd,fd->f", outward, mesh.area_vectors) / 3.0
    return volumes


def turned_over(kept: Kept, chosen: Flags) -> Kept:
    """The faces that are marked (f,) run the other way around, from the same first corner."""
    first, last = _ends(kept.mesh)
    place = np.arange(len(kept.corners))
    back = np.repeat(chosen, kept.mesh.sizes) & (place != first)
    order = np.where(back, first + last + 1 - place, place)
    mesh = PolygonMesh(kept.mesh.vertices, kept.mesh.corners[order], kept.mesh.starts)
    return Kept(mesh, kept.faces, kept.corners[order])


def half_edges_over(mesh: PolygonMesh, chosen: Flags, half_edges: Indices) -> Indices:
    """The numbers of half-edges once the faces that are marked (f,) are turned over."""
    first, last = _ends(mesh)
    over = first[half_edges] + last[half_edges] - half_edges
    return np.where(chosen[mesh.owners[half_edges]], over, half_edges)


def _ends(mesh: PolygonMesh) -> tuple[Indices, Indices]:
    """(c,) the first and the last corner of the face of every corner."""
    first = np.repeat(mesh.starts[:-1].astype(np.intp), mesh.sizes)
    return first, np.repeat(mesh.starts[1:].astype(np.intp) - 1, mesh.sizes)
