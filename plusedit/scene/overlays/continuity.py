"""How smoothly curves go on at their knots and seams, and where two of them meet.

G2 is a ring: direction and curvature go on. G1 is a diamond: the curvature jumps, by the value
beside it. G0 is a square: there is a corner, of the angle beside it.
"""

from collections.abc import Iterator, Sequence
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
    2: ("ring", 7.0, "accent"),
    1: ("diamond", 10.0, "hover"),
    0: ("square", 9.0, "classical"),
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


@continuity.of_curves
def of_curve(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A mark at each knot inside and at the seam; in words where it is not smooth."""
    return joint_items(_joints(curve), told=(1, 0))


@continuity.of_designs
def of_design(design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterator[Item]:
    """Marks and words where ends of curves meet, and how many there are of each kind."""
    curves = [curve for shape_id, curve in design.curves() if design[shape_id].visible]
    if not curves:
        return
    met = meetings(curves)
    yield from joint_items(met, told=(2, 1, 0))
    counts = np.zeros(3, dtype=int)
    for found in (met, *map(_joints, curves)):
        counts += np.bincount([joint.order for joint in found], minlength=3)
    rows = (Row(f"G{order} {NAMES[order]}", str(counts[order]), LOOKS[order][2]) for order in LOOKS)
    yield Caption("Continuity", tuple(rows))


def joint_items(found: Sequence[Joint], told: Sequence[int]) -> Iterator[Item]:
    """Marks for joints, with words beside those of the orders that are to be told."""
    for order, (mark, size, color) in LOOKS.items():
        points = [joint.point for joint in found if joint.order == order]
        if points:
            fill = None if order == 2 else color
            outline = color if order == 2 else "canvas"
            yield Markers(np.stack(points), mark, size, fill, outline, 1.5)
    words = [joint for joint in found if joint.order in told]
    for joint in words if len(words) <= FEW else ():
        yield Label(joint.point, told_of(joint), LOOKS[joint.order][2], ASIDE, "left", WORDS)


def told_of(joint: Joint) -> str:
    """Such as "G0  37.2°", "G1  Δκ 0.42" or "G2"."""
    if joint.order == 2:
        return "G2"
    if joint.order == 1:
        return f"G1  Δκ {joint.jump:.3g}"
    return f"G0  {degrees(joint.angle):.3g}°" if isfinite(joint.angle) else "G0  cusp"


_KEPT: "WeakKeyDictionary[PlusCurve, tuple[Joint, ...]]" = WeakKeyDictionary()


def _joints(curve: PlusCurve) -> tuple[Joint, ...]:
    found = _KEPT.get(curve)
    if found is None:
        found = _KEPT[curve] = joints(curve)
    return found
