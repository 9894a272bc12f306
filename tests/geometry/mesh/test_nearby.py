import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.mesh import evaluation
from plusedit.geometry.mesh.domains import CylinderDomain, PillowDomain, PlaneDomain, TorusDomain
from plusedit.geometry.mesh.evaluation import points_and_normals
from tests.geometry.mesh.mesh_surfaces import grid_corners, spanned, uneven

CELLS = {
    PlaneDomain(): (1.0, 1.0),
    CylinderDomain(): (1.0, 0.7),
    TorusDomain(0.7): (1.0, 0.7),
    PillowDomain(0.5): (1.0, 0.5),
}


def bumpy(domain, **options):
    """A surface of 9800 uneven triangles all over the cell."""
    width, height = CELLS[domain]
    corners = grid_corners(uneven(0.0, width, 70), uneven(0.0, height, 70, 4))

    def shape(u, v):
        return u, v, np.sin(40.0 * u) * np.cos(50.0 * v)

    return spanned(domain, corners, shape, **options)


def some_places(domain):
    """Places here and there, many of them at the edges of the cell."""
    size = np.array(CELLS[domain])
    inner = np.random.default_rng(1).uniform(-0.1, 1.1, (7, 2))
    edges = np.stack(np.meshgrid([0.0, 0.5, 1.0], [0.0, 0.5, 1.0]), axis=-1).reshape(-1, 2)
    return size * np.concatenate([inner, edges])


@pytest.mark.parametrize("domain", list(CELLS), ids=lambda domain: domain.kind)
@pytest.mark.parametrize("smoothness", [0.3, 1.0, 3.0])
def test_a_few_places_need_only_the_planes_nearby(domain, smoothness, monkeypatch):
    surface, places = bumpy(domain, smoothness=smoothness), some_places(domain)
    points, normals = points_and_normals(surface, places)
    monkeypatch.setattr(evaluation, "nearby", lambda tree, *rest: tree)
    all_points, all_normals = points_and_normals(surface, places)
    assert_allclose(points, all_points, atol=1e-13)
    assert_allclose(normals, all_normals, atol=1e-9)


@pytest.mark.parametrize("domain", list(CELLS), ids=lambda domain: domain.kind)
def test_most_planes_are_left_out_where_sigmas_are_small(domain, monkeypatch):
    surface, real, counts = bumpy(domain, smoothness=0.3), evaluation.nearby, []

    def counted(tree, *rest):
        counts.append(len(found := real(tree, *rest)) / len(tree))
        return found

    monkeypatch.setattr(evaluation, "nearby", counted)
    surface.at(some_places(domain)[-2:])
    assert counts[0] < 0.2


def test_many_places_close_together_need_few_planes_as_well(monkeypatch):
    surface = bumpy(PlaneDomain(), smoothness=0.7)
    places = np.random.default_rng(2).uniform(0.4, 0.5, (500, 2))
    few = surface.at(places)
    monkeypatch.setattr(evaluation, "nearby", lambda tree, *rest: tree)
    assert_allclose(few, surface.at(places), atol=1e-13)


def test_far_from_all_planes_the_nearest_one_counts(monkeypatch):
    surface = bumpy(PlaneDomain(), smoothness=0.7)
    places = np.array([[50.0, -30.0], [-1e4, 0.5], [0.5, 0.5]])
    few = surface.at(places)
    monkeypatch.setattr(evaluation, "nearby", lambda tree, *rest: tree)
    assert_allclose(few, surface.at(places), rtol=1e-12)
