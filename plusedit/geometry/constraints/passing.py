"""Curves and surfaces that pass through chosen control points, at the nodes of these."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.constraints import Constrained, Numbers, Settled, register
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.influence import Place, influence

RANK = 1e-10  # of the largest singular value: what is below is rounding
UNCHANGED = 1e-12  # of the largest change: such a direction stays as it is


class Passing:
    """Of all changes of the free gradients the least, by the pseudo-inverse."""

    title = "Through control points"
    order = 30
    counts: Numbers = "elements"
    conflict = (
        "Not all of these points can be passed through: the directions that are left free are too "
        "few, or have no hold there. Leave a point out, or insert control lines."
    )

    def takes(self, geometry: Constrained) -> bool:
        return True

    def objection(self, geometry: Constrained, numbers: tuple[int, ...]) -> str:
        if not numbers:
            return "No control points are chosen to pass through; select some."
        if numbers[-1] >= len(geometry.net) or numbers[0] < 0:
            return f"There is no control point {numbers[-1] + 1}; choose the points anew."
        return "With s = 0 directions have no effect; set s first." if geometry.s == 0.0 else ""

    def miss(self, geometry: Constrained, numbers: tuple[int, ...]) -> float:
        points = geometry.net.control_points
        size = float(np.ptp(points, axis=0).max()) or 1.0
        away = points[list(numbers)] - self.places(geometry, numbers)
        return float(np.abs(away).max()) / size

    def solved(
        self,
        geometry: Constrained,
        numbers: tuple[int, ...],
        settled: Settled,
        before: Constrained | None,
    ) -> Constrained:
        net, shape = geometry.net, geometry.net.automatic_vectors.shape
        free = np.ones(shape, dtype=np.bool_)
        for way, number in settled:
            free[way, number] = False
        shares = [influence(geometry, place) for place in nodes(geometry, numbers)]
        matrix = np.stack([share.reaches[free] for share in shares])
        missing = net.control_points[list(numbers)] - self.places(geometry, numbers)
        change = np.zeros((*shape, net.dimension))
        change[free] = np.linalg.lstsq(matrix, missing, rcond=RANK)[0] / geometry.s
        size = np.linalg.norm(change, axis=2)
        is_new = size > UNCHANGED * max(float(size.max()), float(np.abs(geometry.vectors).max()))
        given = np.where(is_new[..., None], geometry.vectors + change, net.given_vectors)
        return geometry.with_net(net.with_vectors(given, net.automatic_vectors & ~is_new))

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        ways, count = geometry.net.automatic_vectors.shape
        return frozenset((way, number) for way in range(ways) for number in range(count))

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        at = nodes(geometry, numbers)
        if isinstance(geometry, PlusCurve):
            return geometry.at([place[0] for place in at])
        found: Floats = geometry.derivatives_at(at, highest=0)[0]
        return found


def nodes(geometry: Constrained, numbers: tuple[int, ...]) -> list[Place]:
    """The parameters of those control lines or planes."""
    if isinstance(geometry, PlusCurve):
        return [(float(geometry.basis.nodes[number]),) for number in numbers]
    by_u, by_v = (basis.nodes for basis in geometry.bases)
    pairs = (divmod(number, len(by_v)) for number in numbers)
    return [(float(by_u[i]), float(by_v[j])) for i, j in pairs]


register("passing")(Passing())
