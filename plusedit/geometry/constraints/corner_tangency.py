"""Surfaces that leave chosen corners along the edges of the control net."""

import numpy as np

from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.constraints import Constrained, Element, Numbers, Settled, register
from plusedit.geometry.surface import WAYS, PlusSurface
from plusedit.geometry.surface_tangency import CORNERS, Corner, corner_objection, tangent_at_corners


class CornerTangency:
    """The planes beside a corner turn so that both edges of the surface touch the net's there."""

    title = "Tangent at corners"
    order = 25
    counts: Numbers = "corners"
    conflict = (
        "The planes beside these corners are held by other constraints; leave a corner out, or "
        "insert a row of planes."
    )

    def takes(self, geometry: Constrained) -> bool:
        return isinstance(geometry, PlusSurface)

    def objection(self, geometry: Constrained, numbers: tuple[int, ...]) -> str:
        if not numbers:
            return "No corner is chosen; select some planes at corners."
        return corner_objection(_surface(geometry))

    def miss(self, geometry: Constrained, numbers: tuple[int, ...]) -> float:
        surface = _surface(geometry)
        found = 0.0
        for corner in _corners(numbers):
            tangents = surface.derivatives_at([corner], highest=1)[1:]
            for way, tangent in zip(WAYS, tangents, strict=True):
                edge = _edge(surface, corner, WAYS.index(way))
                lengths = float(np.linalg.norm(tangent[0]) * np.linalg.norm(edge))
                if lengths == 0.0 or float(tangent[0] @ edge) <= 0.0:
                    return np.inf
                found = max(found, float(np.linalg.norm(np.cross(tangent[0], edge))) / lengths)
        return found

    def solved(
        self,
        geometry: Constrained,
        numbers: tuple[int, ...],
        settled: Settled,
        before: Constrained | None,
    ) -> Constrained:
        return tangent_at_corners(_surface(geometry), _corners(numbers))

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        surface = _surface(geometry)
        columns = surface.planes.shape[1]
        found: dict[Element, Floats] = {}
        for corner in _corners(numbers):
            for way in range(2):
                i, j = _beside(surface, corner, way)
                element = (way, i * columns + j)
                # Along the edge a change makes the surface run faster there, or slower.
                edge = unit(_edge(surface, corner, way)[None])
                found[element] = edge[:0] if element in found else edge
                i, j = _here(surface, corner)
                found[(way, i * columns + j)] = edge[:0]
        return found

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        at: Floats = _surface(geometry).derivatives_at(_corners(numbers), highest=0)[0]
        return at


def _corners(numbers: tuple[int, ...]) -> list[Corner]:
    return [CORNERS[number] for number in numbers]


def _here(surface: PlusSurface, corner: Corner) -> tuple[int, int]:
    rows, columns = surface.planes.shape
    return corner[0] * (rows - 1), corner[1] * (columns - 1)


def _beside(surface: PlusSurface, corner: Corner, way: int) -> tuple[int, int]:
    here = list(_here(surface, corner))
    here[way] += -1 if corner[way] else 1
    return here[0], here[1]


def _edge(surface: PlusSurface, corner: Corner, way: int) -> Floats:
    """(3,) of the net, in the sense in which the parameter runs."""
    points = surface.planes.points
    edge: Floats = points[_beside(surface, corner, way)] - points[_here(surface, corner)]
    return -edge if corner[way] else edge


def _surface(geometry: Constrained) -> PlusSurface:
    if not isinstance(geometry, PlusSurface):
        raise ValueError("Only surfaces have corners.")
    return geometry


register("corner_tangency")(CornerTangency())
