"""A new smoothness S of mesh surfaces, against what no way could do without and against scipy.

    .venv/bin/python -m tests.benchmarks meshes

`ours` is the preview, points and normals at all vertices: the milliseconds that pass, on two
threads if there are two processors, and those of all processors together, which the ratios are of:

    copies   to a copy of what comes out
    exp      to float32 exponentials of numpy, one for every pair of a place and a plane, or an
             image of it, within 5 sigma
    scipy    of the straightforward way, by a k-d tree and a sparse matrix, to ours: points only,
             within 5 sigma; with ~ from the pairs, at the time that one takes in the row above

`error` is the largest distance from the surface at full accuracy, in diagonals of the mesh. The
last table moves one control plane: the time to find what can have changed, and to evaluate that
anew, as a preview and to full accuracy. The scan is read from the data beside the project, and
left out where that is missing.
"""

import platform
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import PlaneDomain
from plusedit.geometry.mesh.evaluation import points_and_normals
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.neighborhood import changed_places
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.preview import preview
from plusedit.geometry.mesh.subdivision import subdivided
from tests.benchmarks.curves import Work, installed, medians, seconds, there

SCAN = Path(__file__).parents[3] / "shared/data/mesh/bunny_scan_5holes.obj"
SMOOTHNESS = (0.25, 0.5, 1.0, 4.0, 8.0, 16.0)
REACH = 5.0  # sigma
SAMPLES = 2000  # planes and places that stand for all where pairs are counted and errors measured
EXPONENTIALS = 1 << 20
MOST_PAIRS = 3e7  # in one sparse matrix


@dataclass(frozen=True)
class Case:
    """A surface and where it is evaluated."""

    title: str
    surface: MeshSurface
    places: Floats


def cases() -> Iterator[Case]:
    if SCAN.exists():
        scan = scanned()
        yield Case("scan", scan, scan.vertex_places)
        finer = subdivided(scan.mesh, 1)
        split = MeshSurface(finer.mesh, scan.domain, finer.along(scan.parameters))
        yield Case("scan, split", split, split.vertex_places)
    large = hills(320)
    yield Case("hills", large, large.vertex_places)
    steps = np.linspace(0.0, 1.0, 256)
    grid = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    grid.flags.writeable = False
    yield Case("hills on 256 x 256", hills(187), grid)


def scanned() -> MeshSurface:
    from plusedit.io.mesh_import import import_mesh

    return import_mesh(SCAN).parts[0].surface


def hills(count: int) -> MeshSurface:
    """Two triangles for each cell of a square grid, u, v = x, y, the corners moved about."""
    steps = np.linspace(0.0, 1.0, count + 1)
    places = np.stack(np.meshgrid(steps, steps), axis=-1).reshape(-1, 2)
    places += np.random.default_rng(1).uniform(-0.3, 0.3, places.shape) / count
    heights = 0.1 * np.sin(9.0 * places[:, 0]) * np.cos(7.0 * places[:, 1])
    low = (np.arange(count)[:, None] * (count + 1) + np.arange(count)).ravel()
    right, up = low + 1, low + count + 1
    faces = np.concatenate(
        [np.stack([low, right, up + 1], axis=1), np.stack([low, up + 1, up], axis=1)]
    )
    mesh = PolygonMesh.of_rows(np.column_stack([places, heights]), faces)
    return MeshSurface(mesh, PlaneDomain(), places[faces].reshape(-1, 2))


def image_planes(surface: MeshSurface, places: Floats) -> tuple[Floats, Floats, Floats, Floats]:
    """All images of planes within reach of the places: centers, sigmas, and P, s A, s B (k, 3, 3)
    turned as the image is; with the places in the cell (m, 2)."""
    inside, planes, sigmas = surface.domain.reduced(places), surface.planes, surface.sigmas
    low, high = inside.min(axis=0), inside.max(axis=0)
    images = surface.domain.images(REACH * float(sigmas.max()))
    centers, widths, values = [], [], []
    for shift, sign in zip(images.shifts, images.signs, strict=True):
        moved = sign * surface.domain.shifted(planes.centers) + shift
        reach = REACH * sigmas[:, None]
        near = ((moved > low - reach) & (moved < high + reach)).all(axis=1) & (sigmas > 0.0)
        centers.append(moved[near])
        widths.append(sigmas[near])
        slopes = surface.s * sign * np.stack([planes.gradients_u, planes.gradients_v], axis=1)
        values.append(np.concatenate([planes.points[:, None], slopes], axis=1)[near])
    return np.concatenate(centers), np.concatenate(widths), np.concatenate(values), inside


def pairs_of(surface: MeshSurface, places: Floats) -> float:
    """How many pairs of a place and an image of a plane are within reach, from a sample."""
    from scipy.spatial import KDTree

    centers, widths, _, inside = image_planes(surface, places)
    some = np.random.default_rng(3).choice(len(centers), min(SAMPLES, len(centers)), replace=False)
    counts = KDTree(inside).query_ball_point(
        centers[some], REACH * widths[some], return_length=True
    )
    return float(counts.mean()) * len(centers)


def by_scipy(surface: MeshSurface, places: Floats) -> Floats:
    """(m, 3) points, by all pairs at once in one sparse matrix."""
    from scipy.sparse import csr_array
    from scipy.spatial import KDTree

    centers, widths, values, inside = image_planes(surface, places)
    lists = KDTree(inside).query_ball_point(centers, REACH * widths)
    counts = np.array([len(each) for each in lists])
    rows = np.concatenate([np.asarray(each, dtype=np.intp) for each in lists])
    planes = np.repeat(np.arange(len(centers)), counts)
    squares = ((inside[rows] - centers[planes]) ** 2).sum(axis=1)
    gaussians = np.exp(-0.5 * squares / widths[planes] ** 2)
    matrix = csr_array((gaussians, (rows, planes)), shape=(len(inside), len(centers)))
    bases = values[:, 0] - centers[:, :1] * values[:, 1] - centers[:, 1:] * values[:, 2]
    total = matrix @ bases
    total += inside[:, :1] * (matrix @ values[:, 1]) + inside[:, 1:] * (matrix @ values[:, 2])
    points: Floats = total / (matrix @ np.ones(len(centers)))[:, None]
    return points


def passing(work: Callable[[], object]) -> float:
    """Seconds that pass at a call, in the best of some."""
    best = np.inf
    for _ in range(5):
        start = time.perf_counter()
        work()
        best = min(best, time.perf_counter() - start)
    return best


def error_of(surface: MeshSurface, places: Floats) -> float:
    count = min(SAMPLES // 4, len(places))
    some = np.random.default_rng(4).choice(len(places), count, replace=False)
    exact, _ = points_and_normals(surface, places[some])
    away = np.linalg.norm(preview(surface, places).points[some] - exact, axis=1)
    return float(away.max()) / surface.mesh.diagonal


def row(case: Case, smoothness: float, per_pair: float) -> float:
    """Print one; seconds that a pair takes scipy."""
    places = case.places
    surface = case.surface.with_smoothness(smoothness)
    out = np.ones((len(places), 6), dtype=np.float32)
    copy, exponents = out.copy(), np.linspace(-12.0, 0.0, EXPONENTIALS, dtype=np.float32)
    works: dict[str, Work] = {
        "ours": lambda: preview(surface, places),
        "copy": lambda: np.copyto(copy, out),
        "exp": lambda: np.exp(exponents),
    }
    found = medians(works)
    pairs, ours = pairs_of(surface, places), found["ours"]
    mark = "~"
    if pairs < MOST_PAIRS:
        mark, per_pair = "", seconds(lambda: by_scipy(surface, places), 1) / pairs
    title = f"{case.title}: {surface.mesh.face_count} faces, {len(places)} places, S = {smoothness}"
    floor = pairs * found["exp"] / EXPONENTIALS
    print(
        f"{title:<58}{1e3 * passing(works['ours']):>8.1f}{1e3 * ours:>8.1f}"
        f"{ours / found['copy']:>9.3g}{ours / floor:>9.3g}"
        f"{mark + format(per_pair * pairs / ours, '.3g'):>9}{error_of(surface, places):>10.1e}",
        flush=True,
    )
    return per_pair


def edit(case: Case, smoothness: float) -> None:
    """Print what one moved plane takes."""
    places = case.places
    old = case.surface.with_smoothness(smoothness)
    face = old.mesh.face_count // 2
    point = old.planes.points[face] + 0.01 * old.mesh.diagonal

    def search() -> object:
        return changed_places(old, old.with_plane(face, point=point), places)

    new = old.with_plane(face, point=point)
    rows = changed_places(old, new, places)
    assert rows is not None
    found = medians(
        {
            "search": search,
            "preview": lambda: preview(new, places[rows]),
            "full": lambda: points_and_normals(new, places[rows]),
            "whole": lambda: preview(new, places),
        }
    )
    title = f"{case.title}: {old.mesh.face_count} faces, S = {smoothness}"
    times = "".join(f"{1e3 * found[name]:>10.1f}" for name in found)
    print(f"{title:<58}{len(rows):>10}{times}", flush=True)


def main() -> None:
    """Print the tables."""
    versions = {name: installed(name) for name in ("numpy", "numba", "scipy")}
    print(", ".join([f"Python {platform.python_version()}", *map(" ".join, there(versions))]))
    if versions["numba"] is None:
        print("numba is not installed: previews are to full accuracy, which would take hours")
        return
    if not SCAN.exists():
        print(f"without the scan: there is no {SCAN.name}")
    print(f"{'':<58}{'ms':>8}{'cpu ms':>8}{'copies':>9}{'exp':>9}{'scipy':>9}{'error':>10}")
    every = list(cases())
    for case in every:
        per_pair = 0.0
        for smoothness in SMOOTHNESS:
            per_pair = row(case, smoothness, per_pair)
    heads = ("places", "search", "preview", "full", "whole")
    print(f"{'one moved plane, cpu ms':<58}" + "".join(f"{head:>10}" for head in heads))
    for case in every[:2]:
        for smoothness in (0.7, 2.0, 4.0):
            edit(case, smoothness)


if __name__ == "__main__":
    main()
