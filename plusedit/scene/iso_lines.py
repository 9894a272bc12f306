"""Lines of constant u and of constant v of a surface as curves, for what analyzes curves."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.scene.camera import Camera
from plusedit.scene.drawn import drawn
from plusedit.scene.items import Polyline

EACH_WAY = 5


@dataclass(frozen=True, eq=False)
class IsoLine:
    """The curve of a surface along which one parameter is constant."""

    way: Way
    """the parameter that is constant"""
    value: float
    curve: PlusCurve

    def drawn(self, camera: Camera) -> Polyline:
        """In the color of the parameter that runs along it."""
        color = "v" if self.way == WAYS[0] else "u"
        return Polyline(drawn(self.curve, camera).points, color, 1.0)


_KEPT: "WeakKeyDictionary[PlusSurface, dict[tuple[Way, float], IsoLine]]" = WeakKeyDictionary()


def iso_lines(surface: PlusSurface, planes: Sequence[int] = ()) -> tuple[IsoLine, ...]:
    """Those at the nodes of some control planes, or else five each way, evenly.

    The same for the same surface.
    """
    kept = _KEPT.setdefault(surface, {})
    found = {
        place: kept.get(place) or _iso_line(surface, *place) for place in _places(surface, planes)
    }
    # No more than are shown: planes are selected and let go again.
    kept.clear()
    kept.update(found)
    return tuple(found.values())


def _iso_line(surface: PlusSurface, way: Way, value: float) -> IsoLine:
    return IsoLine(way, value, iso_curve(surface, way, value))


def _places(surface: PlusSurface, planes: Sequence[int]) -> Iterator[tuple[Way, float]]:
    numbers = np.unravel_index(
        np.array(planes, dtype=np.intp), [basis.size for basis in surface.bases]
    )
    for way, basis, rows in zip(WAYS, surface.bases, numbers, strict=True):
        if len(rows):
            values = basis.nodes[np.unique(rows)]
        else:
            values = np.linspace(0.0, 1.0, EACH_WAY, endpoint=not basis.closed)
        for value in values.tolist():
            yield way, value
