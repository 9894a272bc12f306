"""From edited control points to points on the curve, against other libraries.

    .venv/bin/python -m tests.benchmarks curves

The peers draw the classical cubic B-spline of the same control points on the same knots; we draw
the plus curve, automatic directions included. Needs scipy, splipy and geomdl; a peer that is not
installed is left out. All take turns; the numbers are medians of processor time.
"""

import importlib
import platform
import time
from collections.abc import Callable
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version

import numpy as np

from plusedit.geometry import BSpline, ControlLines, Grid, PlusCurve
from plusedit.geometry.arrays import Floats

PEERS = ("scipy", "splipy", "geomdl")
EDITED = ((4, 256), (10, 256), (40, 256), (200, 256), (1000, 256))
MANY = ((10, 1000), (10, 100_000), (1000, 100_000))
ROUNDS = 60
PATIENCE = 1.0  # seconds for one column of a row; slow ones take part in fewer rounds
BATCH = 2e-3  # seconds that one timing lasts at least

Work = Callable[[], object]


@dataclass(frozen=True)
class Case:
    """One control polygon and how often its curve is sampled."""

    points: Floats
    basis: BSpline
    grid: Grid

    @classmethod
    def of(cls, lines: int, samples: int) -> "Case":
        points = np.random.default_rng(lines).random((lines, 2))
        return cls(points, BSpline(lines, 4), Grid.uniform(samples))


def edited(case: Case) -> Work:
    """What a drag does: other points in the same lines; the matrices are there already."""
    lines = ControlLines.of(case.points)

    def work() -> object:
        moved = lines.with_points(case.points)
        return PlusCurve(case.basis, moved, 0.5).sample(Grid.uniform(len(case.grid)))

    return work


def new_lines(case: Case) -> Work:
    """The same from points alone."""

    def work() -> object:
        lines = ControlLines.of(case.points)
        return PlusCurve(case.basis, lines, 0.5).sample(Grid.uniform(len(case.grid)))

    return work


def slid(case: Case) -> Work:
    """What the slider of s does: other s, the same lines."""
    lines = ControlLines.of(case.points)
    return lambda: PlusCurve(case.basis, lines, 0.5).sample(case.grid)


def anew(case: Case) -> Work:
    """New parameters: nothing is there already."""
    curve = PlusCurve(case.basis, ControlLines.of(case.points), 0.5)
    return lambda: curve.at(case.grid.parameters)


def by_scipy(case: Case) -> Work:
    interpolate = importlib.import_module("scipy.interpolate")
    knots, u = case.basis.knot_vector, case.grid.parameters
    return lambda: interpolate.BSpline(knots, case.points, 3)(u)


def by_splipy(case: Case) -> Work:
    splipy = importlib.import_module("splipy")
    basis = splipy.BSplineBasis(4, case.basis.knot_vector)
    u = case.grid.parameters.copy()  # it writes to them
    return lambda: splipy.Curve(basis, case.points)(u)


def by_geomdl(case: Case) -> Work:
    library = importlib.import_module("geomdl.BSpline")
    knots = case.basis.knot_vector.tolist()

    def work() -> object:
        curve = library.Curve()
        curve.degree = 3
        curve.ctrlpts = case.points.tolist()
        curve.knotvector = knots
        curve.sample_size = len(case.grid)
        return curve.evalpts

    return work


BY_PEER = {"scipy": by_scipy, "splipy": by_splipy, "geomdl": by_geomdl}


def medians(works: dict[str, Work], *, warm: bool = False) -> dict[str, float]:
    """Seconds one call takes; the works take turns, the slow ones not in every round.

    With `warm` each is done once more before it is timed, as from one frame to the next: what it
    needs lies in the cache, and its memory need not be fetched from the system again.
    """
    batches: dict[str, int] = {}
    once: dict[str, float] = {}
    for name, work in works.items():
        once[name] = min(seconds(work, 1) for _ in range(3)) or BATCH
        batches[name] = max(1, int(BATCH / once[name]))
    runs: dict[str, list[float]] = {name: [] for name in works}
    for turn in range(ROUNDS):
        for name, work in works.items():
            share = max(1, int(ROUNDS * once[name] * batches[name] / PATIENCE))
            if turn % share == 0:
                if warm:
                    work()
                runs[name].append(seconds(work, batches[name]))
    return {name: float(np.median(row)) for name, row in runs.items()}


def seconds(work: Work, batch: int) -> float:
    """How long one call takes, of so many in a row; what else the machine does is not counted."""
    start = time.process_time()
    for _ in range(batch):
        work()
    return (time.process_time() - start) / batch


def installed(name: str) -> str | None:
    """The version, or None if it is not installed."""
    try:
        return version(name)
    except PackageNotFoundError:
        return None


def row(title: str, case: Case, ours: Work, peers: list[str]) -> None:
    works = {"ours": ours} | {peer: BY_PEER[peer](case) for peer in peers}
    found = medians(works)
    ratios = "".join(f"{found[peer] / found['ours']:>10.3g}" for peer in peers)
    print(f"{title:<42}{1e6 * found['ours']:>10.1f}{ratios}", flush=True)


def main() -> None:
    """Print a table: microseconds of ours, and how many times as long each peer takes."""
    versions = {name: installed(name) for name in ("numpy", *PEERS)}
    print(", ".join([f"Python {platform.python_version()}", *map(" ".join, there(versions))]))
    peers = [peer for peer in PEERS if versions[peer]]
    print(f"{'':<42}{'ours (us)':>10}" + "".join(f"{peer:>10}" for peer in peers) + "   (ratios)")
    for lines, samples in EDITED:
        case = Case.of(lines, samples)
        for title, make in (("moved points", edited), ("s", slid), ("new lines", new_lines)):
            row(f"{title}, {lines} lines, {samples} samples", case, make(case), peers)
    for lines, samples in MANY:
        case = Case.of(lines, samples)
        # Python loops over so many samples would take minutes.
        fast = [peer for peer in peers if peer != "geomdl" or samples < 10_000]
        row(f"moved points, {lines} lines, {samples} samples", case, edited(case), fast)
        row(f"new u, {lines} lines, {samples} samples", case, anew(case), fast)


def there(versions: dict[str, str | None]) -> list[tuple[str, str]]:
    """The names and versions of what is installed."""
    return [(name, found) for name, found in versions.items() if found is not None]


if __name__ == "__main__":
    main()
