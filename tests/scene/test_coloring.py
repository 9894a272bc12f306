"""Surfaces colored by values on them, with one scale for all and a legend that is true."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.mesh.deviation import deviation_of
from plusedit.scene.color_scale import SCALES, Span
from plusedit.scene.coloring import (
    NO_TINTS,
    coloring_overlay,
    has_values,
    known_values,
    mesh_values,
    rounded,
    span_of,
    tinted,
)
from plusedit.scene.drawn_deviation import drawn_deviation, known_deviation
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Label, Legend, Mesh, Patch
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Coloring, Overlay, overlays
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import HILL, a_hill, a_landscape

CAMERA = SpaceCamera((800.0, 600.0), (0.5, 0.5, 0.0), 2.0)
DEVIATION = ViewOptions(overlays=frozenset({"deviation"}))
A, B = ShapeId("a"), ShapeId("b")


@pytest.fixture
def height(monkeypatch):
    """An overlay that colors everything by how high it lies."""
    made = Overlay("height", "Height", 99, "", Coloring(unit="m"))
    made.coloring_of_surfaces(lambda surface, u, v: surface.at(u, v)[..., 2])
    made.coloring_of_meshes(lambda surface, drawing: drawing.points[:, 2])
    monkeypatch.setitem(overlays._filled(), "height", made)
    return made


HEIGHT = ViewOptions(overlays=frozenset({"height"}))


def solids(design, options, **more):
    return space_items(design, CAMERA, options, **more).solids


def legend_in(design, options, **more):
    labels = space_items(design, CAMERA, options, **more).labels
    return next((item for item in labels if isinstance(item, Legend)), None)


def a_range():
    """Two hills, one of them twice as high."""
    low, high = a_hill(), a_hill().transformed(np.diag([1.0, 1.0, 2.0]), [2.0, 0.0, 0.0])
    return Design({A: Shape(low, "Low"), B: Shape(high, "High")})


def test_without_a_coloring_overlay_nothing_is_colored():
    options = ViewOptions(overlays=frozenset({"mesh", "names"}))
    assert coloring_overlay(options.overlays) is None
    assert all(item.colors is None for item in solids(a_landscape(), options))
    assert legend_in(a_landscape(), options) is None


def test_a_mesh_is_colored_by_its_values_and_the_legend_says_what_they_are(height):
    design = a_landscape()
    (mesh,) = solids(design, HEIGHT)
    legend = legend_in(design, HEIGHT)
    assert (legend.title, legend.unit) == ("Height", "m")
    shown = mesh.points[:, 2]
    span = span_of(height.coloring, [shown])
    assert_array_equal(mesh.colors, SCALES["sequential"].at(span.shares(shown)))
    for share, text in legend.ticks:
        assert span.low + share * (span.high - span.low) == pytest.approx(float(text), abs=1e-9)


def test_a_plus_surface_is_colored_at_its_samples(height):
    design = Design({A: Shape(a_surface(), "Sail")})
    (patch,) = solids(design, HEIGHT)
    assert isinstance(patch, Patch)
    values = patch.surface.at(patch.grid_u.parameters, patch.grid_v.parameters)[..., 2]
    assert patch.colors.shape == (*values.shape, 3)
    lowest, highest = values.ravel()[[values.argmin(), values.argmax()]]
    assert lowest < highest
    assert legend_in(design, HEIGHT) is not None


def test_all_shapes_have_one_scale(height):
    low, high = solids(a_range(), HEIGHT)
    span = span_of(height.coloring, [low.points[:, 2], high.points[:, 2]])
    for item in (low, high):
        expected = SCALES["sequential"].at(span.shares(item.points[:, 2]))
        assert_array_equal(item.colors, expected)


def test_shapes_that_are_hidden_do_not_count_for_the_scale(height):
    design = a_range()
    alone = Design({A: design[A]})
    hidden = design.with_shape(B, replace(design[B], visible=False))
    assert legend_in(hidden, HEIGHT).ticks == legend_in(alone, HEIGHT).ticks


def test_what_looks_the_same_is_the_same_item(height):
    for design in (a_landscape(), Design({A: Shape(a_surface(), "Sail")})):
        before = space_items(design, CAMERA, HEIGHT)
        after = space_items(design, CAMERA, HEIGHT)
        assert before.solids == after.solids
        assert before.labels[-1] is after.labels[-1]


def test_an_overlay_that_is_switched_off_leaves_no_colors_behind(height):
    design = a_landscape()
    assert solids(design, HEIGHT)[0].colors is not None
    assert solids(design, ViewOptions(overlays=frozenset()))[0].colors is None


def test_without_waiting_a_mesh_is_bare_until_its_values_are_known():
    design = a_landscape(a_hill())
    surface, entry = design.mesh(HILL), overlays["deviation"]
    drawing = drawing_of(surface)
    assert solids(design, DEVIATION, wait=False)[0].colors is None
    assert legend_in(design, DEVIATION, wait=False) is None
    assert not has_values(entry, drawing)
    mesh_values(entry, surface, drawing)
    assert has_values(entry, drawing)
    assert solids(design, DEVIATION, wait=False)[0].colors is not None
    assert legend_in(design, DEVIATION, wait=False) is not None


def test_after_a_change_the_colors_before_it_stay_until_the_new_ones_are_known():
    entry, before = overlays["deviation"], a_hill()
    old = mesh_values(entry, before, drawing_of(before))
    after = before.with_smoothness(3.0)
    drawing = drawing_of(after)
    assert known_values(entry, after, drawing) is old
    assert not has_values(entry, drawing)
    new = mesh_values(entry, after, drawing)
    assert known_values(entry, after, drawing) is new


def test_waiting_finds_the_deviation_of_what_is_drawn():
    (mesh,) = solids(a_landscape(a_hill(smoothness=2.0)), DEVIATION)
    assert isinstance(mesh, Mesh)
    assert mesh.colors.shape == mesh.points.shape


def test_the_deviation_is_in_percent_of_the_size_of_the_mesh():
    surface = a_hill(smoothness=2.0)
    drawing = drawing_of(surface)
    values = mesh_values(overlays["deviation"], surface, drawing)
    found = deviation_of(drawing.net.mesh, drawing.points, surface.mesh)
    assert_allclose(values, 100.0 * found.from_mesh / surface.mesh.diagonal)


def test_a_deviation_is_found_once():
    surface = a_hill()
    drawing = drawing_of(surface)
    assert known_deviation(drawing) is None
    found = drawn_deviation(surface, drawing)
    assert known_deviation(drawing) is drawn_deviation(surface, drawing) is found


def test_meshes_that_are_shown_as_they_are_have_no_colors():
    options = replace(DEVIATION, facets=True)
    assert solids(a_landscape(), options)[0].colors is None
    assert legend_in(a_landscape(), options) is None


def test_words_and_legends_are_drawn_over_everything():
    labels = space_items(a_landscape(), CAMERA, DEVIATION).labels
    assert all(isinstance(item, Label | Legend) for item in labels)


def test_a_scale_ends_at_a_round_number_that_few_values_are_beyond():
    values = np.append(np.linspace(0.0, 1.3, 1000), 40.0)
    assert span_of(Coloring(), [values]) == Span(0.0, 1.5)


def test_a_diverging_scale_has_zero_in_the_middle():
    values = np.linspace(-0.2, 0.7, 1000)
    assert span_of(Coloring(kind="diverging"), [values]) == Span(-0.8, 0.8)


def test_a_scale_can_be_fixed():
    values = np.linspace(-0.2, 0.7, 100)
    assert span_of(Coloring(fixed=(0.0, 1.0)), [values]) == Span(0.0, 1.0)
    assert span_of(Coloring(fixed=(None, 1.0)), [np.abs(values)]) == Span(0.0, 1.0)


def test_rounding_errors_have_the_color_of_zero():
    coloring = Coloring(least=1e-6)
    assert span_of(coloring, [np.full(9, 1e-15)]) == Span(0.0, 1e-6)
    assert span_of(coloring, [np.zeros(9)]) == Span(0.0, 1e-6)


def test_where_nothing_is_a_number_nothing_is_colored(height):
    assert span_of(Coloring(), [np.full(4, np.nan)]) is None
    assert tinted(height, {A: np.full(4, np.nan)}) is NO_TINTS
    assert tinted(height, {}) is NO_TINTS


def test_a_legend_tells_whether_values_are_beyond_its_ends(height):
    inside = tinted(height, {A: np.linspace(0.0, 1.0, 500)}).legend
    beyond = tinted(height, {A: np.append(np.linspace(0.0, 1.0, 500), 9.0)}).legend
    assert inside.is_open == (False, False)
    assert beyond.is_open == (False, True)


@pytest.mark.parametrize(
    ("value", "up"), [(1.0, 1.0), (1.01, 1.5), (0.07, 0.08), (9.0, 10.0), (3e-9, 3e-9), (0.0, 1.0)]
)
def test_numbers_are_rounded_upwards(value, up):
    assert rounded(value) == pytest.approx(up)
