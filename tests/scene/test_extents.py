"""The size and the bending of a design, in numbers that seldom change."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.bases import families
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.extents import STEP, USUAL, extent_of
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill


def ring(radius, count=60):
    angle = 2.0 * np.pi * np.arange(count + 1) / count
    points = radius * np.column_stack([np.cos(angle), np.sin(angle)])
    return PlusCurve(families["bspline"].of_size(count + 1), ControlLines.of(points), 1.0)


def a_design(*geometries):
    return Design({str(place): Shape(g, "") for place, g in enumerate(geometries)})


@pytest.mark.parametrize("radius", [0.001, 1.0, 350.0])
def test_of_a_circle_both_are_known_but_for_a_step(radius):
    extent = extent_of(a_design(ring(radius)))
    assert 2.0 * radius * (1.0 - 1e-9) <= extent.size < 2.0 * radius * STEP
    assert 0.98 / radius <= extent.curvature < STEP / radius


def test_the_largest_shape_that_is_seen_counts():
    design = a_design(ring(1.0), ring(5.0))
    assert extent_of(design) == extent_of(a_design(ring(5.0)))
    hidden = replace(design["1"], visible=False)
    assert extent_of(design.with_shape("1", hidden)) == extent_of(a_design(ring(1.0)))


def test_a_small_change_leaves_it_as_it_is():
    assert extent_of(a_design(ring(1.1))) == extent_of(a_design(ring(1.1001)))


def test_nothing_and_a_point_are_taken_for_something_usual():
    point = PlusCurve(families["bezier"].of_size(3), ControlLines.of(np.ones((3, 2))), 1.0)
    for design in (Design(), a_design(point)):
        extent = extent_of(design)
        assert_allclose([extent.size, extent.curvature], [USUAL.size, USUAL.curvature])


def test_a_straight_line_bends_like_half_a_circle():
    line = ControlLines.of(np.array([[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]))
    extent = extent_of(a_design(PlusCurve(families["bezier"].of_size(3), line, 1.0)))
    assert 0.5 * np.pi / 2.0 <= extent.curvature < STEP * 0.5 * np.pi / 2.0


@pytest.mark.parametrize("geometry", [a_surface(), a_hill()], ids=["surface", "mesh"])
def test_every_kind_of_shape_has_them(geometry):
    extent = extent_of(a_design(geometry))
    assert extent.size > 0.0 and extent.curvature > 0.0
