"""What is drawn, in single precision, against double precision; compiled and by numpy alone."""

import sys
from dataclasses import fields, replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry import row_products
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blend import Grid
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.row_products import Taps, load_kernels, load_kernels_in_background
from plusedit.geometry.surface import PlusSurface, tangent_terms
from plusedit.geometry.surface_frames import normals
from plusedit.geometry.surface_kernels import (
    SurfaceBuffers,
    changed_rows,
    points_and_normals,
    surface_buffers,
    surface_points,
)
from tests.geometry.surfaces import PAIRS, a_surface, random_surface, surfaces

GRIDS = Grid(np.linspace(0.0, 1.0, 37)), Grid(np.linspace(0.0, 1.0, 50) ** 2)
NAMES = tuple(field.name for field in fields(SurfaceBuffers))
every_pair = pytest.mark.parametrize("pair", PAIRS)
SINGLE = 2e-6  # what sums of some numbers in single precision may differ by


@pytest.fixture(params=["compiled", "numpy"], autouse=True)
def loops(request, monkeypatch):
    """Every test here is for the compiled loops and for numpy alone."""
    surface_buffers.cache_clear()
    if request.param == "numpy":
        monkeypatch.setattr(row_products, "_kernels", None)
    elif not load_kernels():
        pytest.skip("numba is not installed")


def buffers(surface, grids=GRIDS):
    return surface_buffers(*surface.bases, surface.planes, *grids)


def agree(found, expected):
    size = max(1.0, np.abs(expected).max())
    assert_allclose(found, expected, rtol=0, atol=SINGLE * size)


@every_pair
@pytest.mark.parametrize("contrast", [None, 10.0, 1e6])
def test_buffers_hold_the_terms_of_points_and_tangents(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    found = buffers(surface)
    exact = tangent_terms(*surface.bases, surface.planes, *GRIDS)
    for name in NAMES:
        agree(getattr(found, name), getattr(exact, name))


@given(surfaces(most=12), st.integers(2, 9), st.integers(2, 40))
@settings(max_examples=30, deadline=None)
def test_they_are_ready_to_be_uploaded_whatever_the_grid(surface, rows, columns):
    found = buffers(surface, (Grid.uniform(rows), Grid.uniform(columns)))
    for name in NAMES:
        each = getattr(found, name)
        assert each.shape == (rows, columns, 3)
        assert each.dtype == np.float32
        assert each.flags.c_contiguous
        assert np.isfinite(each).all()


@every_pair
@pytest.mark.parametrize("contrast", [None, 10.0, 1e6])
def test_points_and_normals_are_those_of_the_surface(pair, contrast):
    surface = random_surface(*pair, contrast=contrast)
    points, found = points_and_normals(surface, *GRIDS)
    at, by_u, by_v = surface.derivatives(*(grid.parameters for grid in GRIDS), highest=1)
    agree(points, at)
    assert_array_equal(surface_points(surface, *GRIDS), points)
    exact = normals(by_u, by_v)
    steep = np.linalg.norm(np.cross(by_u, by_v), axis=-1)
    plain = steep > 1e-3 * np.abs(by_u).max() * np.abs(by_v).max()
    assert_allclose(found[plain], exact[plain], atol=1e-3)


@pytest.mark.parametrize("offset", [1e5, -1e7])
def test_far_from_the_origin_a_surface_keeps_its_normals(offset):
    surface = a_surface()
    far = replace(surface, planes=surface.planes.with_points(surface.planes.points + offset))
    assert_allclose(
        points_and_normals(far, *GRIDS)[1], points_and_normals(surface, *GRIDS)[1], atol=1e-5
    )
    for name in NAMES[2:]:
        agree(getattr(buffers(far), name), getattr(buffers(surface), name))


@pytest.mark.parametrize("scale", [1e-100, 1e-12, 1e12, 1e100])
def test_normals_do_not_depend_on_the_size(scale):
    surface = a_surface()
    points = surface.planes.points / 4.0
    small = replace(surface, planes=surface.planes.with_points(points))
    large = replace(small, planes=small.planes.with_points(scale * points), s=scale * small.s)
    assert_allclose(
        points_and_normals(large, *GRIDS)[1], points_and_normals(small, *GRIDS)[1], atol=1e-5
    )
    assert np.isfinite(points_and_normals(large, *GRIDS)[0]).all()
    assert all(np.isfinite(getattr(buffers(large), name)).all() for name in NAMES)


def test_extreme_directions_and_s_leave_numbers():
    surface = a_surface()
    planes = surface.planes.with_directions(1e100 * surface.directions)
    wild = replace(surface, planes=planes, s=-1e100)
    assert all(np.isfinite(getattr(buffers(wild), name)).all() for name in NAMES)
    assert np.isfinite(surface_points(wild, *GRIDS)).all()
    assert np.isfinite(points_and_normals(wild, *GRIDS)[1]).all()


def test_another_s_leaves_the_buffers_as_they_are():
    surface = a_surface()
    assert buffers(replace(surface, s=7.0)) is buffers(surface)


def test_at_a_pole_the_tangents_just_beside_have_the_normal():
    x, y = np.meshgrid(np.linspace(0.0, 1.0, 5), np.linspace(-1.0, 1.0, 6), indexing="ij")
    points = np.stack([x, x * y, x**2], axis=-1)
    surface = PlusSurface(BSpline(5, 4), BSpline(6, 4), ControlPlanes.of(points), 0.0)
    found = buffers(surface)
    across = np.cross(found.base_u, found.base_v)
    unit = across / np.linalg.norm(across, axis=-1, keepdims=True)
    beside = unit[1]
    assert_allclose(unit[0], beside, atol=0.05)
    assert_allclose(found.base[0], 0.0, atol=1e-7)
    assert_allclose(points_and_normals(surface, *GRIDS)[1][0], beside, atol=0.05)


@every_pair
@pytest.mark.parametrize("contrast", [None, 10.0])
def test_changed_rows_complete_the_buffers_of_before(pair, contrast):
    surface = random_surface(*pair, shape=(9, 6), contrast=contrast)
    points = surface.planes.points.copy()
    points[4, 3] += 0.5
    moved = surface.planes.with_points(points)
    patched = {name: getattr(buffers(surface), name).copy() for name in NAMES}
    changed = changed_rows(*surface.bases, moved, surface.planes, *GRIDS)
    for name in NAMES:
        patched[name][changed.rows] = getattr(changed.buffers, name)
        agree(patched[name], getattr(buffers(replace(surface, planes=moved)), name))


def test_of_many_planes_one_that_is_moved_changes_few_rows():
    surface = a_surface(40, 5)
    points = surface.planes.points.copy()
    points[20, 2] += 1.0
    moved = surface.planes.with_points(points)
    changed = changed_rows(*surface.bases, moved, surface.planes, *GRIDS)
    assert changed.rows.stop - changed.rows.start <= 7


def test_a_turned_plane_and_another_weight_are_changes_too():
    surface = random_surface(shape=(9, 6), contrast=3.0)
    vectors = surface.directions.copy()
    vectors[1, 0, 2] += 1.0
    given_ones = surface.planes.with_directions(surface.directions)
    turned = given_ones.with_directions(vectors)
    weights = surface.planes.weights.copy()
    weights[0, 5] *= 0.99
    for after, before in (
        (turned, given_ones),
        (surface.planes.with_weights(weights), surface.planes),
    ):
        changed = changed_rows(*surface.bases, after, before, *GRIDS)
        assert changed.rows == slice(0, changed.rows.stop)
        assert 0 < changed.rows.stop < 37
    changed = changed_rows(
        *surface.bases, surface.planes.with_weights(None), surface.planes, *GRIDS
    )
    assert changed.rows == slice(0, 37)


def test_where_nothing_has_changed_nothing_is_uploaded():
    surface = random_surface()
    same = surface.planes.with_points(surface.planes.points.copy())
    assert changed_rows(*surface.bases, same, surface.planes, *GRIDS) is None


@pytest.mark.parametrize("width", [3, 30, 300, 3000])
@pytest.mark.parametrize("share", [0.02, 1.0])
def test_products_are_those_of_the_matrix(width, share):
    random = np.random.default_rng(width)
    matrix = random.normal(size=(53, 40)) * (random.random((53, 40)) < share)
    net = random.normal(size=(40, width)).astype(np.float32)
    taps, exact = Taps.of(matrix), matrix @ net
    agree(taps.along(net), exact)
    agree(taps.along(net, slice(5, 30)), exact[5:30])
    turned = exact.reshape(53, width // 3, 3).swapaxes(0, 1).reshape(width // 3, -1)
    agree(taps.across(net), turned)


def test_a_matrix_of_zeros_makes_zeros():
    assert_array_equal(Taps.of(np.zeros((4, 5))).along(np.ones((5, 6), dtype=np.float32)), 0.0)


def test_without_numba_there_are_no_loops_and_nothing_fails(monkeypatch):
    monkeypatch.setattr(row_products, "_kernels", None)
    monkeypatch.setitem(sys.modules, "plusedit.geometry.row_kernels", None)
    assert not load_kernels()
    load_kernels_in_background.cache_clear()
    load_kernels_in_background().join()
    load_kernels_in_background.cache_clear()
    assert np.isfinite(surface_points(a_surface(), *GRIDS)).all()


def test_they_are_loaded_once():
    load_kernels_in_background.cache_clear()
    thread = load_kernels_in_background()
    assert load_kernels_in_background() is thread
    thread.join()


def test_where_nothing_can_be_kept_loops_are_compiled_anew(monkeypatch):
    numba = pytest.importorskip("numba")
    from plusedit.geometry import row_kernels

    def njit(*, cache=False, **options):
        if cache:
            raise RuntimeError("cannot cache function: no locator available")
        return lambda function: (function, options)

    monkeypatch.setattr(numba, "njit", njit)
    function, options = row_kernels.compiled(len)
    assert function is len
    assert options["nogil"]
