"""How smoothly curves go on at their knots and seams, and where two of them meet.

G2 is a ring: direction and curvature go on. G1 is a diamond: the curvature jumps, by the value
beside it. G0 is a square: there is a corner, of the angle beside it.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import degrees, isfinite
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.continuity import Joint, joints
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.meetings import meetings
from plusedit.scene.items import Caption, Item, Label, Mark, Markers, Row
from plusedit.scene.overlays import Seen, overlay

LOOKS: dict[int, tuple[Mark, float, str]] = {
    2: ("ring", 9.0, "accent"),
    1: ("diamond", 12.0, "hover"),
    0: ("square", 10.0, "classical"),
}
"""Mark, size in pixels and color, by order."""
NAMES = {2: "smooth (ring)", 1: "curvature jumps (diamond)", 0: "corner (square)"}
FEW = 40  # values of one curve, or where curves meet: where there are more the marks stand alone
WORDS = 10.0  # pixels, the height of letters
ASIDE = (8.0, 14.0)  # pixels from a mark to its words

continuity = overlay(
    "continuity",
    title="Continuity at knots and joins",
    order=113,
    shortcut="J",
    group="Curve analysis",
)


@dataclass(frozen=True, eq=False)
class Told:
    """Joints as they are shown."""

    counts: tuple[int, int, int]
    """of order 0, 1 and 2"""
    items: tuple[Item, ...]


_KEPT: "WeakKeyDictionary[PlusCurve, Told]" = WeakKeyDictionary()


@continuity.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterable[Item]:
    """A mark at each knot inside and at the seam; in words where it is not smooth."""
    return _of_curve(curve).items


@continuity.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """Marks and words where ends of curves meet, and how many there are of each kind."""
    curves = [curve for shape_id, curve in design.curves() if design[shape_id].visible]
    if not curves:
        return
    met = told(meetings(curves), orders=(2, 1, 0))
    yield from met.items
    counts = np.sum([met.counts, *(_of_curve(curve).counts for curve in curves)], axis=0)
    rows = (Row(f"G{order} {NAMES[order]}", str(counts[order]), LOOKS[order][2]) for order in LOOKS)
    yield Caption("Continuity", tuple(rows))


def _of_curve(curve: PlusCurve) -> Told:
    found = _KEPT.get(curve)
    if found is None:
        found = _KEPT[curve] = told(joints(curve), orders=(1, 0))
    return found


def told(found: Sequence[Joint], orders: Sequence[int]) -> Told:
    """Marks for joints, with words beside those of some orders."""
    ranked = [(joint.order, joint) for joint in found]
    items: list[Item] = []
    counts = [0, 0, 0]
    for order, (mark, size, color) in LOOKS.items():
        points = [joint.point for rank, joint in ranked if rank == order]
        counts[order] = len(points)
        if points:
            fill, outline = (None, color) if order == 2 else (color, "canvas")
            items.append(Markers(np.stack(points), mark, size, fill, outline, 1.5))
    words = [joint for order, joint in ranked if order in orders]
    if len(words) <= FEW:
        items += [Label(j.point, text_of(j), "text", ASIDE, "left", WORDS) for j in words]
    return Told((counts[0], counts[1], counts[2]), tuple(items))


def text_of(joint: Joint) -> str:
    """Such as "G0  37.2°", "G1  Δκ 0.42" or "G2"."""
    order = joint.order
    if order == 2:
        return "G2"
    if order == 1:
        return f"G1  Δκ {joint.jump:.3g}"
    return f"G0  {degrees(joint.angle):.3g}°" if isfinite(joint.angle) else "G0  cusp"
