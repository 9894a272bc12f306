import numpy as np
import pytest

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.scene.shape_account import HEADS, HINTS, account_of, family_title
from tests.geometry.curves import KINDS, random_curve
from tests.geometry.surfaces import random_surface
from tests.scene.meshes import a_hill

POINTS = np.array([[0.0, 0.0], [1.0, 2.0], [2.0, 2.0], [3.0, 0.0]])


def told(geometry):
    return dict(zip(HEADS, account_of(geometry), strict=True))


def test_every_head_has_a_hint():
    assert len(HEADS) == len(HINTS)


@pytest.mark.parametrize(
    ("basis", "weights", "s", "title"),
    [
        (Bernstein(4), None, 1.0, "Bézier+"),
        (Bernstein(4), None, 0.0, "Bézier"),
        (BSpline(4, 3), None, 1.0, "B-spline+"),
        (BSpline(4, 3, closed=True), None, 1.0, "closed B-spline+"),
        (BSpline(4, 3), np.array([1.0, 2.0, 1.0, 1.0]), 1.0, "NURBS+"),
        (RationalGaussian.of_size(4), None, 1.0, "RaG+"),
    ],
)
def test_families_have_the_names_of_the_books(basis, weights, s, title):
    assert family_title(PlusCurve(basis, ControlLines.of(POINTS, None, weights), s)) == title


def test_a_bezier_plus_curve_is_a_bezier_curve_of_one_point_more():
    found = told(PlusCurve(Bernstein(4), ControlLines.of(POINTS), 1.0))
    assert found["Degree, classical"] == "3"
    assert found["Control elements"] == "4"
    assert found["Exactly the same"] == "Bézier"
    assert found["its degree"] == "4"
    assert found["its points"] == "5"
    assert found["its numbers"] == "10"


def test_a_classical_curve_is_its_own_standard_form():
    found = told(PlusCurve(Bernstein(4), ControlLines.of(POINTS), 0.0))
    assert found["Exactly the same"] == "itself"
    assert found["its degree"] == "–"


def test_a_surface_has_degrees_both_ways():
    found = told(random_surface("bezier", "bspline", shape=(5, 6)))
    assert found["Family"] == "Bézier+ × B-spline+"
    assert found["Degree, classical"] == "4 × 3"
    assert found["its degree"] == "5 × 4"
    assert found["Inflections"] == "–"


def test_a_mesh_has_faces_and_no_standard_form():
    found = told(a_hill())
    assert found["Control elements"] == f"{a_hill().mesh.face_count:,}"
    assert found["Exactly the same"] == "–"


@pytest.mark.parametrize("kind", KINDS)
def test_every_kind_of_curve_is_told_of(kind):
    assert all(account_of(random_curve(kind, contrast=4.0)))
    assert all(account_of(random_curve(kind, dimension=3)))
