"""Convex bodies that a space curve cannot leave."""

import numpy as np
import pytest

from plusedit.geometry.space_hulls import elevated_body, parent_bodies, span_bodies, union_body
from tests.geometry.bodies import outside, volume
from tests.geometry.curves import KINDS, random_curve

U = np.linspace(0.0, 1.0, 501)
SPLINES = tuple(k for k in KINDS if "rag" not in k and k != "staircase")
OPEN = tuple(k for k in KINDS if not k.startswith("closed"))


@pytest.mark.parametrize("kind", (*OPEN, "closed", "closed, odd order"))
def test_a_space_curve_lies_in_the_body_of_its_lines(kind):
    curve = random_curve(kind, dimension=3, contrast=4.0)
    assert outside(union_body(curve), curve.at(U)) < 1e-12


@pytest.mark.parametrize("kind", SPLINES)
def test_a_space_curve_lies_in_the_smaller_body_of_its_elevated_points(kind):
    curve = random_curve(kind, dimension=3, contrast=4.0)
    assert outside(elevated_body(curve), curve.at(U)) < 1e-12
    assert volume(elevated_body(curve)) <= volume(union_body(curve)) * (1.0 + 1e-12)


@pytest.mark.parametrize("kind", OPEN)
def test_the_body_of_the_lines_holds_those_of_both_parents(kind):
    curve = random_curve(kind, dimension=3)
    for body in parent_bodies(curve):
        assert outside(union_body(curve), body.points) < 1e-12


@pytest.mark.parametrize("kind", ["bspline", "kinks", "closed"])
def test_every_span_lies_in_its_own_body(kind):
    curve = random_curve(kind, dimension=3)
    breaks = curve.basis.breaks
    for low, high, body in zip(breaks[:-1], breaks[1:], span_bodies(curve), strict=True):
        u = np.linspace(low, high, 40, endpoint=high == 1.0 and not curve.closed)
        assert outside(body, curve.at(u)) < 1e-12


def test_the_body_of_a_plane_curve_is_flat():
    body = union_body(random_curve("bspline"))
    assert not body.points[:, 2].any()
    assert len(body.triangles)
