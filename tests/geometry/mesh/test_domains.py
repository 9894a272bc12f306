import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.domains import (
    DOMAINS,
    CylinderDomain,
    PillowDomain,
    PlaneDomain,
    TorusDomain,
    domain_of,
)

EVERY_DOMAIN = (PlaneDomain(), CylinderDomain(), TorusDomain(0.3), PillowDomain(1.7))
every_domain = pytest.mark.parametrize("domain", EVERY_DOMAIN, ids=lambda each: each.kind)
PLACES = np.random.default_rng(2).uniform(-5.0, 5.0, (200, 2))


def images_of(domain, place, reach=12.0):
    shifts, signs = domain.images(reach)
    return signs[:, None] * place + shifts


def test_domains_of_equal_numbers_are_equal():
    assert PillowDomain(2.0) == PillowDomain(2.0) != PillowDomain(3.0)
    assert hash(TorusDomain(2.0)) == hash(TorusDomain(2.0))


@every_domain
def test_a_domain_comes_back_from_its_kind_and_sizes(domain):
    assert domain_of(domain.kind, domain.sizes) == domain


def test_an_unknown_kind_is_refused_by_name():
    with pytest.raises(ValueError, match=r"domain: 'ball' is none of 'plane', 'cylinder'"):
        domain_of("ball", {})


def test_sizes_that_do_not_belong_to_the_kind_are_refused():
    with pytest.raises(ValueError, match=r"a pillow has the keys \['width'\], got \['height'\]"):
        domain_of("pillow", {"height": 1.0})
    with pytest.raises(ValueError, match="a plane has no other keys"):
        domain_of("plane", {"height": 1.0})


@pytest.mark.parametrize("size", [0.0, -1.0, np.nan, np.inf])
def test_sizes_must_be_positive_and_finite(size):
    with pytest.raises(ValueError, match="width: must be positive"):
        PillowDomain(size)


def test_there_are_four_kinds():
    assert list(DOMAINS) == ["plane", "cylinder", "torus", "pillow"]


@every_domain
def test_the_first_image_is_the_place_itself(domain):
    shifts, signs = domain.images(3.0)
    assert_array_equal(shifts[0], [0.0, 0.0])
    assert signs[0] == 1.0


@every_domain
def test_a_reduced_place_is_an_image_of_the_place(domain):
    for place, reduced in zip(PLACES, domain.reduced(PLACES), strict=True):
        assert np.abs(images_of(domain, place) - reduced).sum(axis=1).min() < 1e-14


@every_domain
def test_reducing_twice_changes_nothing(domain):
    once = domain.reduced(PLACES)
    assert_array_equal(domain.reduced(once), once)


@every_domain
def test_all_images_have_the_same_reduced_place(domain):
    reduced = domain.reduced(images_of(domain, np.array([0.21, 0.13])))
    assert_allclose(reduced, np.broadcast_to(reduced[0], reduced.shape), atol=1e-13)


def test_the_cell_of_a_pillow_is_two_widths_by_one_half():
    reduced = PillowDomain(1.7).reduced(PLACES)
    assert reduced.min() >= 0.0
    assert (reduced < [3.4, 0.5 + 1e-15]).all()


def test_both_sides_of_a_pillows_rim_are_reduced_to_the_same():
    rim = np.array([[0.3, 0.0], [3.1, 0.0], [0.3, 0.5], [3.1, 0.5]])
    reduced = PillowDomain(1.7).reduced(rim)
    assert_allclose(reduced, [[0.3, 0.0], [0.3, 0.0], [0.3, 0.5], [0.3, 0.5]], atol=1e-15)


@every_domain
@pytest.mark.parametrize("reach", [0.05, 0.4, 1.0, 2.3])
def test_the_images_cover_whatever_is_within_reach(domain, reach):
    all_shifts, all_signs = domain.images(5.0)
    images = domain.images(reach)
    known = {(*shift, sign) for shift, sign in zip(*images, strict=True)}
    cell = np.where(np.isfinite(domain.periods), domain.periods, 1.0)
    generator = np.random.default_rng(7)
    places, centers = (generator.uniform(0, 1, (30, 2)) * cell for _ in range(2))
    places = domain.reduced(places)
    for shift, sign in zip(all_shifts, all_signs, strict=True):
        away = np.abs(places[:, None] - sign * centers - shift).max(axis=2)
        assert (away > reach).all() or (*shift, sign) in known


@every_domain
def test_the_nearest_image_is_nearer_than_all_others(domain):
    to = np.random.default_rng(3).uniform(-1.0, 1.0, PLACES.shape)
    for place, target, found in zip(PLACES, to, domain.nearest(PLACES, to), strict=True):
        distances = np.linalg.norm(images_of(domain, place, 20.0) - target, axis=1)
        assert_allclose(np.linalg.norm(found - target), distances.min(), atol=1e-13)
