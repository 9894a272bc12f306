"""The shelf of overlays: what can be drawn about a shape besides the shape itself.

An overlay is an entry and a function for each kind of shape that it can be drawn of, from the
shape's geometry and what is known of the view, a camera of the plane or of space first of all, to
items:

    nodes = overlay("nodes", title="Nodes", order=50, shortcut="Shift+N")

    @nodes.of_curves
    def curve_nodes(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]: ...

    @nodes.of_surfaces
    def surface_nodes(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]: ...

They are asked for every visible shape of a design while the overlay is switched on. What they
draw lies below the curves in the plane, but for marks and words; in space depth decides. One that
compares shapes is asked once, for all of a design (`of_designs`); what goes with the pointer is
asked for the point of a shape that is under it (`under_pointer`), and drawn in front. Numbers that
a person may change, such as the scale of a comb, are settings of the overlay. What it tells in
words and numbers stands in a corner, as a `Caption`.

An overlay can color surfaces in space instead, by values at the points that are drawn:

    twist = overlay("twist", title="Twist", order=80, coloring=Coloring(unit="1 / unit\u00b2"))

    @twist.coloring_of_surfaces
    def surface_twist(surface: PlusSurface, u: Floats, v: Floats) -> Floats: ...  # (m_u, m_v)

    @twist.coloring_of_meshes
    def mesh_twist(surface: MeshSurface, drawing: MeshDrawing) -> Floats: ...  # (n,)

The values depend on nothing else but the settings of the overlay: where it has more than the
contrast, both functions take them as a last argument, a mapping from names to numbers. Those of
meshes are found in a thread beside the window's, so they may take their time; values that are not
numbers are gray. All surfaces that are shown have one scale, with a legend in a corner. Where other
shapes decide, as in comparisons, the values are those of a design as a whole
(`coloring_of_designs`).

Or it changes how light falls on surfaces, pixel by pixel, into stripes that a shader knows:

    overlay("zebra", title="Zebra stripes", order=85, stripes="zebra", settings=(COUNT,))

Only one overlay colors or stripes surfaces at a time.
"""

from plusedit.registry import Registry
from plusedit.scene.overlay import (
    CONTRAST,
    GROUPS,
    USUAL_COLORING,
    Coloring,
    DrawnSurfaces,
    Group,
    Numbers,
    Overlay,
    Seen,
    Setting,
    StripeKind,
    Taken,
)

__all__ = [
    "CONTRAST",
    "GROUPS",
    "Coloring",
    "DrawnSurfaces",
    "Group",
    "Numbers",
    "Overlay",
    "Seen",
    "Setting",
    "StripeKind",
    "Taken",
    "in_order",
    "overlay",
    "overlays",
    "switched",
]

overlays: Registry[Overlay] = Registry("plusedit.scene.overlays")


def overlay(
    name: str,
    *,
    title: str,
    order: int,
    shortcut: str = "",
    coloring: Coloring = USUAL_COLORING,
    settings: tuple[Setting, ...] = (),
    group: Group = "",
    stripes: StripeKind = "",
) -> Overlay:
    """A new entry on the shelf, which draws nothing yet."""
    entry = Overlay(name, title, order, shortcut, coloring, settings, group, stripes)
    return overlays.register(name)(entry)


def in_order() -> list[Overlay]:
    """All overlays, in the order of the menu and of drawing."""
    return sorted(overlays.values(), key=lambda entry: (entry.order, entry.name))


def switched(names: frozenset[str], name: str, is_on: bool) -> frozenset[str]:
    """Those names with one more or less; what paints surfaces switches off what did before."""
    if not is_on:
        return names - {name}
    if name in overlays and overlays[name].paints:
        names = frozenset(i for i in names if i not in overlays or not overlays[i].paints)
    return names | {name}
