"""Fairness of surfaces: how much they bend, and how much their mean curvature changes.

Lower is fairer: of two surfaces through the same points the one with less bending is flatter, and
the one with less variation is rounder. While an edit is going on it is told again once that rests.
"""

from collections.abc import Iterator, Mapping

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.fairness import Fairness, fairness_of_triangles, known_fairness
from plusedit.geometry.fairness import fairness as fairness_of
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.drawn_curvature import at_net
from plusedit.scene.items import Caption, Item, Row
from plusedit.scene.mesh_nets import net_of
from plusedit.scene.overlays import Seen, overlay

FEW = 4  # surfaces that are told of
LATER = "…"

fairness = overlay(
    "fairness",
    title="Fairness numbers",
    order=82,
    shortcut="Shift+F8",
    group="Surface analysis",
)


@fairness.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """A caption for each surface that is selected, or for all while none is; for few at most."""
    shown = [(i, surface) for i, surface in design.surfaces() if design[i].visible]
    told = [pair for pair in shown if pair[0] in chosen] or shown
    for shape_id, surface in told[:FEW]:
        known = known_fairness(surface) if seen.is_hurried else fairness_of(surface)
        yield _caption(design[shape_id].name or shape_id, known)


@fairness.finding_of_meshes()
def find_of_mesh(surface: MeshSurface, numbers: Mapping[str, float]) -> Fairness:
    """That of the triangles that are drawn, with the curvatures of the surface itself."""
    net = net_of(surface)
    points, bends = at_net(surface, net)
    return fairness_of_triangles(points, net.triangles, bends.largest, bends.smallest)


@fairness.of_meshes
def of_mesh(shape: Shape, surface: MeshSurface, seen: Seen) -> Iterator[Item]:
    """A caption, once it is known."""
    known = seen.findings if isinstance(seen.findings, Fairness) else None
    yield _caption(shape.name, known)


def _caption(name: str, known: Fairness | None) -> Caption:
    if known is None:
        return Caption(name, tuple(Row(what, LATER) for what in NAMES))
    texts = (
        f"{known.area:.5g} unit²",
        f"{known.bending:.5g}",
        f"{known.variation:.5g} / unit²",
    )
    return Caption(name, tuple(map(Row, NAMES, texts)))


NAMES = ("area", "bending ∫ κ₁² + κ₂²", "variation ∫ |∇H|²")
