"""The same control planes under other bases."""

import pytest

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.sizes import family_of
from plusedit.geometry.surface_sizes import (
    basis_along,
    with_closed,
    with_family,
    with_field,
    with_order,
)
from tests.geometry.surfaces import a_surface, random_surface

every_way = pytest.mark.parametrize(("way", "other"), [("u", "v"), ("v", "u")])


@every_way
@pytest.mark.parametrize("family", ["bezier", "bspline", "rag"])
def test_another_family_one_way_leaves_the_planes_and_the_other_way(way, other, family):
    surface = a_surface()
    changed = with_family(surface, way, family)
    assert family_of(basis_along(changed, way)) == family
    assert basis_along(changed, other) is basis_along(surface, other)
    assert changed.planes is surface.planes


@every_way
def test_what_would_change_nothing_gives_the_same_surface(way, other):
    surface = a_surface()
    assert with_family(surface, way, "bspline") is surface
    assert with_order(surface, way, 4) is surface
    assert with_closed(surface, way, False) is surface


@every_way
def test_order_and_closedness_belong_to_one_way(way, other):
    surface = with_closed(with_order(a_surface(), way, 3), way, True)
    count = basis_along(surface, way).size
    assert basis_along(surface, way) == BSpline(count, 3, closed=True)
    assert not basis_along(surface, other).closed


@every_way
def test_any_field_of_a_basis_can_be_set(way, other):
    surface = with_field(with_family(a_surface(), way, "rag"), way, "sigma", 0.125)
    assert basis_along(surface, way).sigma == 0.125
    knots = [0, 0, 0, 0.25, 1, 1, 1]
    surface = with_field(with_order(a_surface(4, 4), way, 3), way, "knots", knots)
    assert basis_along(surface, way).knots == tuple(knots)


def test_what_a_family_does_not_have_is_refused():
    surface = a_surface()
    with pytest.raises(ValueError, match="A bspline basis has no sigma"):
        with_field(surface, "u", "sigma", 0.5)
    with pytest.raises(ValueError, match="has no size"):
        with_field(surface, "u", "size", 5)
    with pytest.raises(ValueError, match="never closed"):
        with_closed(with_family(surface, "u", "bezier"), "u", True)
    with pytest.raises(ValueError, match="never closed"):
        with_family(random_surface("closed", "bezier"), "u", "bezier")
    with pytest.raises(ValueError, match="only B-splines"):
        with_order(random_surface("closed", "bezier"), "v", 3)
