"""What every overlay on the shelf has to keep, whoever wrote it."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.bases import families
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.camera import AXES, PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import (
    Caption,
    Label,
    Legend,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
)
from plusedit.scene.overlays import Coloring, Seen, in_order, overlays
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import THEMES
from tests.designs import bits
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import PAIRS, a_surface, random_surface
from tests.scene.meshes import a_hill

every_overlay = pytest.mark.parametrize("name", list(overlays))
of_surfaces = pytest.mark.parametrize(
    "name", [name for name, entry in overlays.items() if "surface" in entry.takes]
)
coloring_meshes = pytest.mark.parametrize(
    "name", [name for name, entry in overlays.items() if "mesh" in entry.colors]
)
coloring_surfaces = pytest.mark.parametrize(
    "name", [name for name, entry in overlays.items() if "surface" in entry.colors]
)
HILL = a_hill()
HILLS = [HILL, a_hill(smoothness=4.0), a_hill(s=0.0), a_hill(1)]
CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)
IN_SPACE = SpaceCamera((800.0, 600.0), height=3.0)


def drawn(name, geometry, camera=CAMERA):
    entry = overlays[name]
    seen = Seen(camera, (0, 1), entry.numbers({}))
    return list(entry.draw(Shape(geometry, "Bow & arrow"), geometry, seen))


def cameras():
    for perspective in (True, False):
        yield SpaceCamera((800.0, 600.0), height=3.0, perspective=perspective)
    for projection in AXES:
        yield PlaneCamera((800.0, 600.0), scale=200.0, projection=projection)


def places(item):
    """The positions of an item, (m, dim) each."""
    match item:
        case Segments(starts, ends):
            return [starts, ends]
        case Label(at):
            return [at[None]]
        case Polyline(points) | Polygon(points) | Markers(points) | Mesh(points):
            return [points]
        case Patch(surface, grid_u, grid_v):
            return [surface.sample(grid_u, grid_v).reshape(-1, 3)]
        case Caption() | Legend():
            return []


def colors(item):
    return [
        getattr(item, name)
        for name in ("color", "fill", "outline", "front", "back")
        if getattr(item, name, None) is not None
    ]


@every_overlay
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("dimension", [2, 3])
def test_it_draws_every_kind_of_curve_along_every_axis(name, kind, dimension):
    curve = random_curve(kind, dimension=dimension, contrast=4.0)
    for camera in cameras():
        for item in drawn(name, curve, camera):
            for points in places(item):
                assert np.isfinite(camera.to_screen(points)).all()


@of_surfaces
@pytest.mark.parametrize("kinds", PAIRS)
def test_it_draws_every_kind_of_surface_along_every_axis_and_in_space(name, kinds):
    surface = random_surface(*kinds, contrast=4.0)
    for camera in cameras():
        for item in drawn(name, surface, camera):
            for points in places(item):
                assert np.isfinite(camera.to_screen(points)).all()


@of_surfaces
@pytest.mark.parametrize("s", [0.0, 1.0, -3.0])
def test_it_draws_the_smallest_surface(name, s):
    for camera in cameras():
        for item in drawn(name, a_surface(2, 2, s), camera):
            assert all(np.isfinite(rows).all() for rows in places(item))


@of_surfaces
def test_in_the_plane_it_draws_nothing_that_only_space_can_show(name):
    assert not any(isinstance(i, Mesh | Patch) for i in drawn(name, a_surface()))


@every_overlay
@pytest.mark.parametrize("family", list(families))
@pytest.mark.parametrize("size", [2, 3, 500])
def test_it_draws_short_and_long_curves(name, family, size):
    if family != "bspline":
        size = min(size, 100)  # every function reaches everywhere: none has more in practice
    basis = families[family].of_size(size)
    points = np.random.default_rng(size).random((size, 2))
    for s in (0.0, 1.0, -3.0):
        for item in drawn(name, PlusCurve(basis, ControlLines.of(points), s)):
            assert all(np.isfinite(rows).all() for rows in places(item))


@every_overlay
def test_what_it_draws_about_a_design_or_at_a_place_is_somewhere(name):
    entry = overlays[name]
    shapes = [*(random_curve(kind) for kind in KINDS), a_surface(), a_hill()]
    shapes += [random_curve("bspline", dimension=3)]
    design = Design({str(place): Shape(g, f"shape {place}") for place, g in enumerate(shapes)})
    for camera in (CAMERA, IN_SPACE):
        for hurried in (True, False):
            seen = Seen(camera, (), entry.numbers({}), design, is_hurried=hurried)
            items = [*entry.draw_design(design, frozenset(["0"]), seen)]
            for shape_id, shape in design.shapes.items():
                place = (0.3,) if shape.curve is not None else (0.3, 0.4)
                items += entry.draw_place(design[shape_id], shape.geometry, place, seen)
            for item in items:
                assert all(np.isfinite(rows).all() for rows in places(item))


@every_overlay
def test_it_has_nothing_to_say_of_nothing(name):
    entry = overlays[name]
    for camera in (CAMERA, IN_SPACE):
        seen = Seen(camera, (), entry.numbers({}), Design())
        assert not list(entry.draw_design(Design(), frozenset(), seen))


@every_overlay
def test_it_draws_a_curve_whose_points_coincide(name):
    curve = PlusCurve(families["bezier"].of_size(3), ControlLines.of(np.ones((3, 2))), 1.0)
    for item in drawn(name, curve):
        assert all(np.isfinite(rows).all() for rows in places(item))


@every_overlay
def test_it_leaves_the_curve_as_it_is(name):
    curve = random_curve("bspline")
    before = bits(curve)
    drawn(name, curve)
    assert bits(curve) == before


@every_overlay
def test_it_draws_the_same_every_time(name):
    curve = random_curve("bspline")
    for first, second in zip(drawn(name, curve), drawn(name, curve), strict=True):
        for one, other in zip(places(first), places(second), strict=True):
            assert_array_equal(one, other)


@every_overlay
@pytest.mark.parametrize("camera", [CAMERA, IN_SPACE], ids=["plane", "space"])
def test_its_colors_are_in_every_theme(name, camera):
    items = drawn(name, random_curve("bspline"), camera) + drawn(name, a_surface(), camera)
    for item in items:
        for theme in THEMES.values():
            for color in colors(item):
                assert theme.color(color).startswith("#")


@every_overlay
def test_it_says_what_it_can_be_drawn_of(name):
    entry = overlays[name]
    assert entry.takes or entry.is_of_designs or entry.follows_pointer
    assert "surface" in overlays[name].takes or not drawn(name, a_surface())
    assert "mesh" in overlays[name].takes or not drawn(name, a_hill())


@coloring_meshes
@pytest.mark.parametrize("surface", HILLS, ids=["usual", "smooth", "without s", "one face"])
def test_it_has_a_value_at_every_point_of_a_mesh_that_is_drawn(name, surface):
    drawing = drawing_of(surface)
    values = overlays[name].mesh_values(surface, drawing)
    assert values.shape == (len(drawing.points),)
    assert values.dtype == np.float64
    assert not np.isinf(values).any()
    assert np.isfinite(values).mean() > 0.5
    assert_array_equal(values, overlays[name].mesh_values(surface, drawing))


@coloring_meshes
def test_values_on_meshes_take_any_precision(name):
    surface = a_hill(smoothness=2.0)
    exact = drawing_of(surface)
    single = replace(exact, points=exact.points.astype(np.float32), is_exact=False)
    values = [overlays[name].mesh_values(surface, drawing) for drawing in (exact, single)]
    assert_allclose(values[1], values[0], atol=1e-3 * np.nanmax(np.abs(values[0])))


@coloring_surfaces
@pytest.mark.parametrize("kinds", PAIRS)
def test_it_has_a_value_at_every_sample_of_a_surface(name, kinds):
    u, v = np.linspace(0.0, 1.0, 7), np.linspace(0.0, 1.0, 5)
    values = overlays[name].surface_values(random_surface(*kinds, contrast=4.0), u, v)
    assert values.shape == (7, 5)
    assert values.dtype == np.float64
    assert not np.isinf(values).any()


@every_overlay
def test_what_colors_surfaces_says_what_of_and_what_else_does_not(name):
    entry = overlays[name]
    assert entry.colors <= entry.takes
    assert entry.colors or entry.compares or entry.coloring == Coloring()
    assert ("mesh" in entry.colors) == (entry.mesh_values(HILL, drawing_of(HILL)) is not None)
    even = np.linspace(0.0, 1.0, 3)
    assert ("surface" in entry.colors) == (
        entry.surface_values(a_surface(), even, even) is not None
    )


@every_overlay
def test_the_menu_can_tell_it_from_the_others(name):
    entry = overlays[name]
    assert entry.name == name
    others = [other for other in overlays.values() if other is not entry]
    assert entry.title not in [other.title for other in others]
    assert entry.order not in [other.order for other in others]
    assert not entry.shortcut or entry.shortcut not in [other.shortcut for other in others]


def test_overlays_come_in_the_order_of_their_numbers():
    numbers = [entry.order for entry in in_order()]
    assert numbers == sorted(numbers)
