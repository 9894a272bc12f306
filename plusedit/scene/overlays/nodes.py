"""Where a shape is at its nodes: the points that the control lines and planes pull at most."""

from collections.abc import Iterator

from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.items import Item, Markers, Segments
from plusedit.scene.overlays import Seen, overlay

nodes = overlay("nodes", title="Nodes", order=50, shortcut="Shift+N")


@nodes.of_curves
def curve_nodes(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """A diamond at each C(x_i), tied to its control point by a hairline."""
    yield from _tied(curve.sample(Grid(curve.basis.nodes)), curve.lines.points)


@nodes.of_surfaces
def surface_nodes(shape: Shape, surface: PlusSurface, seen: Seen) -> Iterator[Item]:
    """A diamond at each S(x_i, y_j), tied to its control point by a hairline."""
    at = surface.sample(*(Grid(basis.nodes) for basis in surface.bases))
    yield from _tied(at.reshape(-1, 3), surface.planes.control_points)


def _tied(at: Floats, points: Floats) -> Iterator[Item]:
    yield Segments(at, points, "quiet@70", 1.0, "dot")
    yield Markers(at, "diamond", 7.0, "canvas", "quiet", 1.25)
