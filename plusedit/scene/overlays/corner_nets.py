"""The four nets of points that an open plus surface is the mean of.

Every control plane at the four corners of the parameters, L_ij(0, 0), L_ij(1, 0), L_ij(0, 1) and
L_ij(1, 1): the surface is the bilinear mean of their classical surfaces, and lies in the hull of
all four. Two nets, as the paper has it, are not enough.
"""

from collections.abc import Iterator

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.corner_nets import corner_nets as nets_of
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.items import Caption, Dash, Item, Label, Mark, Markers, Row, Segments
from plusedit.scene.overlays import Seen, overlay
from plusedit.scene.shapes import shown_shapes

CORNERS = ((0, 0), (1, 0), (0, 1), (1, 1))
LOOKS: tuple[tuple[str, Dash, Mark], ...] = (
    ("#0A7FB8", "solid", "circle"),
    ("#D2691E", "dash", "square"),
    ("#0E9F77", "dot", "diamond"),
    ("#B565A7", "solid", "ring"),
)
"""Color, lines and marks of each: any one of the three tells them apart, or nearly so."""

corner_nets = overlay(
    "corner_nets", title="Corner nets", order=14, shortcut="Shift+Q", group="Constructions"
)


@corner_nets.of_surfaces
def of_surface(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """The lines and points of each net, with its corner beside the point that strays farthest.

    Nothing for a surface that closes.
    """
    if any(surface.closed):
        return
    for corner, net, (color, dash, mark) in zip(CORNERS, nets_of(surface), LOOKS, strict=True):
        starts, ends = _edges(net)
        yield Segments(starts, ends, color, 1.25, dash)
        yield Markers(net.reshape(-1, 3), mark, 5.0, color, color, 1.0)
        # Where the surface has that corner, the net and the surface meet; across they are apart.
        across = net[-1 - corner[0] * (len(net) - 1), -1 - corner[1] * (net.shape[1] - 1)]
        yield Label(across, _named(corner), color, (6.0, -5.0))


@corner_nets.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """What the colors stand for, where there is a surface that has such nets."""
    surfaces = (g for _, _, g in shown_shapes(design) if isinstance(g, PlusSurface))
    if any(not any(surface.closed) for surface in surfaces):
        rows = zip(CORNERS, LOOKS, strict=True)
        yield Caption(
            "All planes at (u, v) =", tuple(Row(_named(c), color=look[0]) for c, look in rows)
        )


def _named(corner: tuple[int, int]) -> str:
    return f"({corner[0]}, {corner[1]})"


def _edges(net: Floats) -> tuple[Floats, Floats]:
    """(k, 3) each: from where to where the lines of a net (n_u, n_v, 3) run."""
    pairs = ((net[:-1], net[1:]), (net[:, :-1], net[:, 1:]))
    starts, ends = (np.concatenate([p[side].reshape(-1, 3) for p in pairs]) for side in (0, 1))
    return starts, ends
