"""Exported files, read back by readers that know the formats and not this program."""

from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape, Style
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.surface_transforms import transposed
from plusedit.io.exporting import Tolerance, export_design
from plusedit.io.exports import exports
from tests.designs import a_curve
from tests.geometry.surfaces import a_surface, random_surface
from tests.io.mesh_files import READERS, a_ball, a_torus, a_tube

SURFACES = {
    "sheet": a_surface(),
    "tube": a_tube(),
    "torus": a_torus(),
    "ball": a_ball(),
    "ball by v": transposed(a_ball()),
    "weighted": random_surface("bspline", "rag", contrast=3.0, seed=3, s=0.4),
}
FINE = Tolerance(0.01)
DENSE = Grid.uniform(301)

every_export = pytest.mark.parametrize("suffix", READERS)
every_surface = pytest.mark.parametrize("name", SURFACES)
every_body = pytest.mark.parametrize("name", ["torus", "ball", "ball by v"])
with_parameters = pytest.mark.parametrize("suffix", ["obj", "ply", "glb"])


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    """The parts of a file to which shapes have been exported."""

    @cache
    def write(suffix, *geometries, tolerance=FINE):
        shapes = {str(i): Shape(geometry, f"shape {i}") for i, geometry in enumerate(geometries)}
        path = tmp_path_factory.mktemp("exports") / f"out.{suffix}"
        export_design(Design(shapes), path, tolerance=tolerance)
        return READERS[suffix](path.read_bytes())

    return write


def triangles(part):
    """(t, 3, 3) the corners of all faces, quads cut in two."""
    halves = [(f[0], f[i], f[i + 1]) for f in part.faces for i in range(1, len(f) - 1)]
    return part.points[halves]


def crossed(faces):
    """(t, 3) normals of triangles, twice as long as their area."""
    return np.cross(faces[:, 1] - faces[:, 0], faces[:, 2] - faces[:, 0])


def sides_run(faces):
    """How many times each side is run along, from one point to another."""
    return Counter((face[i - 1], face[i]) for face in faces for i in range(len(face)))


def by_place(part):
    """The faces, with one number for all points at the same place."""
    _, same = np.unique(part.points, axis=0, return_inverse=True)
    return [[int(same.ravel()[number]) for number in face] for face in part.faces]


def distance(surface, point):
    """From a point to a surface: the nearest of many places, then of many around that."""
    away = np.linalg.norm(surface.sample(DENSE, DENSE) - point, axis=2)
    i, j = np.unravel_index(away.argmin(), away.shape)
    u, v, reach = DENSE.parameters[i], DENSE.parameters[j], 4.0 / len(DENSE)
    for _ in range(2):
        around = np.linspace(-reach, reach, 41)
        away = np.linalg.norm(surface.at(u + around, v + around) - point, axis=2)
        i, j = np.unravel_index(away.argmin(), away.shape)
        u, v, reach = u + around[i], v + around[j], reach / 10.0
    return away.min()


def at_corners(part):
    """Points, normals and parameters at every corner of every face."""
    own = np.concatenate(part.corners)
    return part.points[np.concatenate(part.faces)], part.normals[own], part.parameters[own]


def test_there_is_a_reader_for_every_export():
    assert sorted(READERS) == list(exports)


@with_parameters
@every_surface
def test_points_are_where_the_surface_is_at_their_parameters(written, suffix, name):
    [part] = written(suffix, SURFACES[name])
    points, _, places = at_corners(part)
    [wanted] = SURFACES[name].derivatives_at(places, highest=0)
    assert_allclose(points, wanted, atol=2e-5)


@with_parameters
@every_surface
def test_normals_are_those_of_the_surface(written, suffix, name):
    [part] = written(suffix, SURFACES[name])
    _, normals, places = at_corners(part)
    _, by_u, by_v = SURFACES[name].derivatives_at(places, highest=1)
    across = np.cross(by_u, by_v)
    long = np.linalg.norm(across, axis=1) > 1e-3
    wanted = across[long] / np.linalg.norm(across[long], axis=1, keepdims=True)
    same = np.einsum("kd,kd->k", normals[long], wanted)
    assert long.mean() > 0.9
    assert_allclose(np.abs(same), 1.0, atol=1e-5)
    assert np.ptp(np.sign(same)) == 0.0


@every_export
@every_surface
def test_normals_have_length_one_everywhere(written, suffix, name):
    [part] = written(suffix, SURFACES[name])
    assert_allclose(np.linalg.norm(part.normals, axis=1), 1.0, atol=1e-5)


@every_export
@every_surface
def test_faces_stay_within_the_tolerance(written, suffix, name):
    surface = SURFACES[name]
    [part] = written(suffix, surface)
    middles = np.array([part.points[face].mean(axis=0) for face in part.faces])
    for middle in middles[:: max(1, len(middles) // 12)]:
        assert distance(surface, middle) <= 1.01 * FINE.amount


@every_export
@every_surface
def test_no_face_is_without_area(written, suffix, name):
    [part] = written(suffix, SURFACES[name])
    assert (np.linalg.norm(crossed(triangles(part)), axis=1) > 0.0).all()


@every_export
@every_body
def test_a_closed_surface_is_watertight(written, suffix, name):
    [part] = written(suffix, SURFACES[name])
    faces = part.faces if suffix == "obj" else by_place(part)
    runs = sides_run(faces)
    assert set(runs.values()) == {1}
    assert all((b, a) in runs for a, b in runs)


@pytest.mark.parametrize("suffix", READERS)
def test_only_the_rims_of_a_tube_are_open(written, suffix):
    [part] = written(suffix, SURFACES["tube"])
    runs = sides_run(by_place(part))
    rims = {a for a, b in runs if (b, a) not in runs}
    heights = np.unique(part.points, axis=0)[sorted(rims), 2]
    assert_allclose(np.minimum(heights, 3.0 - heights), 0.0, atol=1e-6)


@every_export
@pytest.mark.parametrize("inside_out", [False, True])
def test_a_body_has_its_outside_outside(written, suffix, inside_out):
    [part] = written(suffix, a_torus(inside_out=inside_out))
    faces = triangles(part)
    assert np.einsum("td,td->", faces[:, 0], crossed(faces)) > 0.0


@every_export
@every_surface
def test_faces_run_counterclockwise_around_their_normals(written, suffix, name):
    [part] = written(suffix, SURFACES[name], tolerance=Tolerance(0.003))
    means = np.array([part.normals[own].mean(axis=0) for own in part.corners])
    around = crossed(np.array([part.points[face[:3]] for face in part.faces]))
    agree = np.einsum("kd,kd->k", means, around) > 0.0
    assert agree.mean() > 0.98


def test_quads_stay_quads_in_an_obj(written):
    [part] = written("obj", SURFACES["torus"])
    assert {len(face) for face in part.faces} == {4}


@pytest.mark.parametrize("suffix", ["ply", "stl", "glb"])
def test_all_faces_of_the_others_are_triangles(written, suffix):
    [part] = written(suffix, SURFACES["ball"])
    assert {len(face) for face in part.faces} == {3}


def test_at_a_pole_there_are_triangles(written):
    for way, name in ((1, "ball"), (0, "ball by v")):
        [part] = written("obj", SURFACES[name])
        count = Counter(len(face) for face in part.faces)
        assert set(count) == {3, 4}
        assert count[3] == 2 * (len(np.unique(part.parameters[:, way])) - 1)


def test_a_pole_is_one_point_of_an_obj_and_so_is_each_point_of_a_seam(written):
    [part] = written("obj", SURFACES["ball"])
    assert len(np.unique(part.points, axis=0)) == len(part.points)
    rows, columns = (len(np.unique(part.parameters[:, way])) for way in (0, 1))
    assert len(part.points) == (rows - 2) * (columns - 1) + 2
    assert len(part.parameters) == len(part.normals) == rows * columns


def test_the_normal_at_a_pole_is_that_of_its_surroundings(written):
    [part] = written("glb", a_ball(s=0.0))
    south, north = part.points[:, 2].argmin(), part.points[:, 2].argmax()
    assert_allclose(part.normals[[south, north]], [[0, 0, -1], [0, 0, 1]], atol=1e-3)


def test_every_shape_is_a_part_with_its_name(written):
    for suffix in ("obj", "glb"):
        parts = written(suffix, SURFACES["torus"], SURFACES["sheet"])
        assert [part.name for part in parts] == ["shape 0", "shape 1"]
        for part, name in zip(parts, ("torus", "sheet"), strict=True):
            points, _, places = at_corners(part)
            [wanted] = SURFACES[name].derivatives_at(places, highest=0)
            assert_allclose(points, wanted, atol=1e-5)


@pytest.mark.parametrize("suffix", ["ply", "stl"])
def test_all_shapes_are_in_files_that_have_no_parts(written, suffix):
    single = [written(suffix, SURFACES[name])[0] for name in ("torus", "sheet")]
    [both] = written(suffix, SURFACES["torus"], SURFACES["sheet"])
    assert len(both.faces) == sum(len(part.faces) for part in single)
    assert_allclose(both.points.max(axis=0), np.max([p.points.max(axis=0) for p in single], axis=0))


def test_a_part_of_a_glb_has_the_color_of_its_shape(tmp_path):
    shape = Shape(a_surface(), "sail", style=Style("#ff8000"))
    export_design(Design({"a": shape, "b": replace(shape, style=Style())}), tmp_path / "out.glb")
    first, second = READERS["glb"]((tmp_path / "out.glb").read_bytes())
    assert_allclose(first.color, [1.0, 0.2158605, 0.0, 1.0], atol=1e-6)
    assert first.color != second.color


def test_curves_are_lines_of_an_obj(written):
    bow = PlusCurve(BSpline(4), ControlLines.of([[0, 0, 1], [1, 2, 0], [3, 2, 1], [4, 0, 2]]))
    parts = written("obj", a_curve(), a_surface(), bow, tolerance=Tolerance(0.001))
    plane, space = (part for part in parts if part.lines)
    for part, curve in ((plane, a_curve()), (space, bow)):
        joined = [*part.lines[0], *(n for line in part.lines[1:] for n in line[1:])]
        assert joined == list(range(joined[0], joined[-1] + 1))
        assert all(a[-1] == b[0] for a, b in zip(part.lines, part.lines[1:], strict=False))
        points = part.points[joined]
        ends = np.zeros((2, 3))
        ends[:, : curve.dimension] = curve.at([0.0, 1.0])
        assert_allclose(points[[0, -1]], ends, atol=1e-9)
        dense = np.zeros((5000, 3))
        dense[:, : curve.dimension] = curve.at(np.linspace(0, 1, 5000))
        middles = (points[1:] + points[:-1]) / 2
        away = np.linalg.norm(dense[:, None] - middles, axis=2).min(axis=0)
        assert away.max() <= 0.001 + np.linalg.norm(np.diff(dense, axis=0), axis=1).max()


def test_a_finer_tolerance_makes_more_faces(written):
    counts = [len(written("stl", a_torus(), tolerance=Tolerance(t))[0].faces) for t in (0.1, 0.01)]
    assert counts[1] > 3 * counts[0]


@pytest.mark.parametrize("name", ["", "a\nb\rc", "\ud800", "日本", "#", "f 1 2 3"])
def test_any_name_leaves_the_file_whole(tmp_path, name):
    for suffix in ("obj", "glb"):
        export_design(Design({"a": Shape(a_surface(), name)}), tmp_path / f"out.{suffix}")
        [part] = READERS[suffix]((tmp_path / f"out.{suffix}").read_bytes())
        assert part.faces
