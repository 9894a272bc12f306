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
        if geometry.s != 0.0:
            return ""
        elements = "lines" if isinstance(geometry, PlusCurve) else "planes"
        return f"With s = 0 control {elements} have no effect; set s first."

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
        net = geometry.net
        shares = [influence(geometry, place) for place in nodes(geometry, numbers)]
        reaches = np.stack([share.reaches for share in shares])
        missing = net.control_points[list(numbers)] - self.places(geometry, numbers)
        change = _least_change(reaches, missing, settled) / geometry.s
        size = np.linalg.norm(change, axis=2)
        is_new = size > UNCHANGED * max(float(size.max()), float(np.abs(geometry.vectors).max()))
        given = np.where(is_new[..., None], geometry.vectors + change, net.given_vectors)
        return geometry.with_net(net.with_vectors(given, net.automatic_vectors & ~is_new))

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        ways, count = geometry.net.automatic_vectors.shape
        nowhere = np.zeros((0, geometry.dimension))
        return {(way, number): nowhere for way in range(ways) for number in range(count)}

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        at = nodes(geometry, numbers)
        if isinstance(geometry, PlusCurve):
            return geometry.at([place[0] for place in at])
        found: Floats = geometry.derivatives_at(at, highest=0)[0]
        return found


def _least_change(reaches: Floats, missing: Floats, settled: Settled) -> Floats:
    """(ways, n, dim) the least change of the gradients that adds what is missing (m, dim).

    `reaches` (m, ways, n) is what each adds. Where none does, the one that comes closest.
    """
    (count, ways, size), dimension = reaches.shape, missing.shape[1]
    change = np.zeros((ways, size, dimension))
    free = np.ones((ways, size), dtype=np.bool_)
    for way, number in settled:
        free[way, number] = False
    partly = [(element, axis) for element, axes in settled.items() for axis in axes]
    if not partly:
        change[free] = np.linalg.lstsq(reaches[:, free], missing, rcond=RANK)[0]
        return change
    # A gradient that may change along one vector only moves all coordinates at once.
    whole = np.kron(reaches[:, free], np.eye(dimension))
    along = np.stack(
        [np.outer(reaches[:, way, number], axis).ravel() for (way, number), axis in partly], axis=1
    )
    matrix = np.concatenate([whole, along], axis=1)
    found = np.linalg.lstsq(matrix, missing.reshape(count * dimension), rcond=RANK)[0]
    change[free] = found[: whole.shape[1]].reshape(-1, dimension)
    for share, ((way, number), axis) in zip(found[whole.shape[1] :], partly, strict=True):
        change[way, number] += share * axis
    return change


def nodes(geometry: Constrained, numbers: tuple[int, ...]) -> list[Place]:
    """The parameters of those control lines or planes."""
    if isinstance(geometry, PlusCurve):
        return [(float(geometry.basis.nodes[number]),) for number in numbers]
    by_u, by_v = (basis.nodes for basis in geometry.bases)
    pairs = (divmod(number, len(by_v)) for number in numbers)
    return [(float(by_u[i]), float(by_v[j])) for i, j in pairs]


register("passing")(Passing())
