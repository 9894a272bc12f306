"""Where the curve is at the nodes: the points C(x_i) that the control lines pull at most."""

from collections.abc import Iterator

from plusedit.document.shape import Shape
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item, Markers, Segments
from plusedit.scene.overlays import overlay


@overlay("nodes", title="Nodes", order=50, shortcut="Shift+N")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """A diamond at each C(x_i), tied to its control point by a hairline."""
    at = curve.sample(Grid(curve.basis.nodes))
    yield Segments(at, curve.lines.points, "quiet@70", 1.0, "dot")
    yield Markers(at, "diamond", 7.0, "canvas", "quiet", 1.25)
