"""From edited control points to points and normals of the surface, against other libraries.

    .venv/bin/python -m tests.benchmarks surfaces

The peers work out the classical bicubic B-spline surface of the same control points on the same
knots; we the plus surface, automatic directions included: `points` and `normals` in single
precision, as they are drawn (normals: with the points), `double` the points in double precision,
as they are exported and as the peers have them. The scipy peer multiplies by u and by v one after
the other. Needs scipy, splipy and geomdl; a peer that is not installed is left out, and so are
Python loops over a quarter of a million samples.

The second table is a drag of one control plane: what has to be computed anew for the card, the
whole and the changed rows, and what the slider of s takes, in copies of points and normals. All
take turns, each twice, and the second time counts; the numbers are medians of processor time.
"""

import importlib
import platform
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from plusedit.geometry import BSpline, ControlPlanes, Grid, PlusSurface
from plusedit.geometry.arrays import Floats
from plusedit.geometry.row_products import load_kernels
from plusedit.geometry.surface_kernels import (
    changed_rows,
    points_and_normals,
    surface_buffers,
    surface_points,
)
from tests.benchmarks.curves import PEERS, Work, installed, medians, there

COUNTS = (4, 20, 100)
SAMPLES = (101, 501)
DRAGGED = 256
LOOPS_UP_TO = 101  # samples each way


@dataclass(frozen=True)
class Case:
    """A square net of control points and how finely its surface is sampled."""

    points: Floats
    basis: BSpline
    grid: Grid

    @classmethod
    def of(cls, count: int, samples: int) -> "Case":
        points = np.random.default_rng(count).random((count, count, 3))
        return cls(points, BSpline(count, 4), Grid.uniform(samples))

    @property
    def surface(self) -> PlusSurface:
        return PlusSurface(self.basis, self.basis, ControlPlanes.of(self.points), 0.5)


def edited(case: Case, evaluate: Callable[[PlusSurface, Grid, Grid], object]) -> Work:
    """What a drag does: other points in the same planes; the matrices are there already."""
    surface = case.surface

    def work() -> object:
        moved = replace(surface, planes=surface.planes.with_points(case.points))
        return evaluate(moved, case.grid, case.grid)

    return work


def scipy_points(case: Case) -> Work:
    spline = importlib.import_module("scipy.interpolate").BSpline
    knots, u = case.basis.knot_vector, case.grid.parameters

    def work() -> object:
        rows = spline(knots, case.points, 3)(u)
        return spline(knots, rows, 3, axis=1)(u)

    return work


def scipy_normals(case: Case) -> Work:
    spline = importlib.import_module("scipy.interpolate").BSpline
    knots, u = case.basis.knot_vector, case.grid.parameters

    def work() -> object:
        by_u = spline(knots, case.points, 3)
        rows = spline(knots, by_u(u), 3, axis=1)
        return rows(u), units(np.cross(spline(knots, by_u(u, 1), 3, axis=1)(u), rows(u, 1)))

    return work


def units(vectors: Floats) -> Floats:
    vectors /= np.linalg.norm(vectors, axis=-1, keepdims=True)
    return vectors


def splipy_surface(case: Case) -> Callable[[], tuple[Any, Floats]]:
    splipy = importlib.import_module("splipy")
    basis = splipy.BSplineBasis(4, case.basis.knot_vector)
    u = case.grid.parameters.copy()  # it writes to them
    return lambda: (splipy.Surface(basis, basis, case.points, raw=True), u)


def splipy_points(case: Case) -> Work:
    make = splipy_surface(case)

    def work() -> object:
        surface, u = make()
        return surface(u, u)

    return work


def splipy_normals(case: Case) -> Work:
    make = splipy_surface(case)

    def work() -> object:
        surface, u = make()
        return surface(u, u), surface.normal(u, u)

    return work


def geomdl_points(case: Case) -> Work:
    library = importlib.import_module("geomdl.BSpline")
    knots = case.basis.knot_vector.tolist()

    def work() -> object:
        surface = library.Surface()
        surface.degree_u = surface.degree_v = 3
        surface.ctrlpts2d = case.points.tolist()
        surface.knotvector_u = surface.knotvector_v = knots
        surface.sample_size = len(case.grid)
        return surface.evalpts

    return work


def geomdl_normals(case: Case) -> Work:
    library = importlib.import_module("geomdl.BSpline")
    normal = importlib.import_module("geomdl.operations").normal
    knots, u = case.basis.knot_vector.tolist(), case.grid.parameters.tolist()
    places = [(a, b) for a in u for b in u]

    def work() -> object:
        surface = library.Surface()
        surface.degree_u = surface.degree_v = 3
        surface.ctrlpts2d = case.points.tolist()
        surface.knotvector_u = surface.knotvector_v = knots
        return normal(surface, places)  # and the points

    return work


POINTS = {"scipy": scipy_points, "splipy": splipy_points, "geomdl": geomdl_points}
NORMALS = {"scipy": scipy_normals, "splipy": splipy_normals, "geomdl": geomdl_normals}


def rows(case: Case, peers: list[str]) -> None:
    """Points in single and in double precision, and normals."""
    count, samples = len(case.points), len(case.grid)
    title = f"{count} x {count} planes, {samples} x {samples} samples"
    ours = {
        "points": edited(case, surface_points),
        "double": edited(case, PlusSurface.sample),
    }
    found = medians(ours | {peer: POINTS[peer](case) for peer in peers}, warm=True)
    for name in ours:
        report(f"{name}, {title}", found, name, peers)
    with_normals = {"normals": edited(case, points_and_normals)}
    found = medians(with_normals | {peer: NORMALS[peer](case) for peer in peers}, warm=True)
    report(f"normals, {title}", found, "normals", peers)


def report(title: str, found: dict[str, float], ours: str, peers: list[str]) -> None:
    ratios = "".join(f"{found[peer] / found[ours]:>10.3g}" for peer in peers)
    print(f"{title:<48}{1e6 * found[ours]:>10.1f}{ratios}", flush=True)


def drag(count: int) -> None:
    """One control plane in the middle, at DRAGGED x DRAGGED samples."""
    surface, grid = Case.of(count, DRAGGED).surface, Grid.uniform(DRAGGED)
    points = surface.planes.points.copy()
    points[count // 2, count // 2] += 0.1
    buffer = np.ones((DRAGGED, DRAGGED, 6), dtype=np.float32)
    uploaded = buffer.copy()

    def whole() -> object:
        moved = surface.planes.with_points(points)
        return surface_buffers(surface.basis_u, surface.basis_v, moved, grid, grid)

    def changed() -> object:
        moved, (by_u, by_v) = surface.planes.with_points(points), surface.bases
        return changed_rows(by_u, by_v, moved, surface.planes, grid, grid)

    def slid() -> object:
        other = replace(surface, s=0.7)
        return surface_buffers(other.basis_u, other.basis_v, other.planes, grid, grid)

    works: dict[str, Work] = {"whole": whole, "changed": changed, "s": slid}
    found = medians(works | {"copy": lambda: np.copyto(uploaded, buffer)}, warm=True)
    for name in works:
        title = f"{name}, {count} x {count} planes, {DRAGGED} x {DRAGGED} samples"
        print(f"{title:<48}{1e6 * found[name]:>10.1f}{found[name] / found['copy']:>10.3g}")


def main() -> None:
    """Print tables: microseconds of ours, and how many times as long each peer takes."""
    versions = {name: installed(name) for name in ("numpy", "numba", *PEERS)}
    print(", ".join([f"Python {platform.python_version()}", *map(" ".join, there(versions))]))
    if not load_kernels():
        print("without the compiled loops: numba is not installed")
    peers = [peer for peer in PEERS if versions[peer]]
    print(f"{'':<48}{'ours (us)':>10}" + "".join(f"{peer:>10}" for peer in peers) + "   (ratios)")
    for samples in SAMPLES:
        some = [peer for peer in peers if peer != "geomdl" or samples <= LOOPS_UP_TO]
        for count in COUNTS:
            rows(Case.of(count, samples), some)
    print(f"{'':<48}{'ours (us)':>10}{'copies':>10}")
    for count in COUNTS:
        drag(count)


if __name__ == "__main__":
    main()
