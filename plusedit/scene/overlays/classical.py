"""The classical curve of the same control points: what the control lines pull away from."""

from collections.abc import Iterator

from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Item, Polyline
from plusedit.scene.overlays import overlay


@overlay("classical", title="Classical curve", order=40, shortcut="Shift+C")
def draw(shape: Shape, curve: PlusCurve, camera: PlaneCamera) -> Iterator[Item]:
    """A thin line; nothing where s = 0, for there it is the curve itself."""
    if curve.s != 0.0:
        yield Polyline(drawn(curve.classical, camera).points, "classical", 1.0)
