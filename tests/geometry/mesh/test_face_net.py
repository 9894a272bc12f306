"""Faces of a mesh as control planes that can be edited."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from plusedit.geometry.mesh.mesh_surface import EditedPlane
from tests.geometry.mesh.mesh_surfaces import EVERY_KIND, pillow
from tests.interaction.space_hand import sail

every_kind = pytest.mark.parametrize("kind", EVERY_KIND, ids=lambda each: each.__name__)


def moved(surface, *faces):
    points = surface.net.control_points.copy()
    points[list(faces)] += [0.5, -0.25, 1.0]
    return surface.with_net(surface.net.with_control_points(points))


def turned(surface, way, *faces):
    given, automatic = surface.net.given_vectors.copy(), surface.net.automatic_vectors.copy()
    given[way, list(faces)] = [1.0, 2.0, 3.0]
    automatic[way, list(faces)] = False
    return surface.with_net(surface.net.with_vectors(given, automatic))


@every_kind
def test_the_net_of_a_mesh_is_the_planes_of_its_faces(kind):
    surface = kind()
    net, planes = surface.net, surface.planes
    assert len(net) == surface.mesh.face_count
    assert_array_equal(net.control_points, planes.points)
    assert_array_equal(surface.vectors, [planes.gradients_u, planes.gradients_v])
    assert net.automatic_vectors.all() and not net.given_vectors.any()


@every_kind
def test_a_surface_with_its_own_net_is_not_edited(kind):
    surface = kind()
    assert not surface.with_net(surface.net).edited
    assert surface.net.with_control_points(surface.net.control_points.copy()) is surface.net
    automatic = np.zeros_like(surface.net.automatic_vectors)
    assert surface.net.with_vectors(surface.vectors, automatic) is surface.net


@every_kind
def test_only_what_differs_from_the_faces_is_kept(kind):
    surface = turned(moved(kind(), 2, 7), 1, 7)
    assert list(surface.edited) == [2, 7]
    assert surface.edited[2].gradient_u is None and surface.edited[2].gradient_v is None
    assert_array_equal(surface.edited[7].gradient_v, [1.0, 2.0, 3.0])
    assert_array_equal(surface.edited[7].point, kind().planes.points[7] + [0.5, -0.25, 1.0])
    assert surface.edited[7].gradient_u is None


@every_kind
def test_an_edited_net_says_what_the_planes_are(kind):
    surface = turned(moved(kind(), 2), 0, 3)
    assert_array_equal(surface.planes.points, surface.net.control_points)
    assert_array_equal(surface.planes.gradients_u, surface.vectors[0])
    assert_array_equal(np.flatnonzero(~surface.net.automatic_vectors[0]), [3])
    assert surface.net.automatic_vectors[1].all()
    assert surface.planes.centers is surface.foundation.planes.centers


@every_kind
def test_the_edits_of_a_file_and_those_of_a_net_are_the_same(kind):
    surface = turned(moved(kind(), 2, 7), 0, 7)
    read = kind().with_edited(dict(surface.edited.items()))
    assert_array_equal(read.planes.points, surface.planes.points)
    assert_array_equal(read.vectors, surface.vectors)
    assert_array_equal(read.net.automatic_vectors, surface.net.automatic_vectors)


def test_what_is_automatic_again_is_the_faces_own():
    surface = pillow()
    edited = moved(turned(surface, 0, 3), 3)
    free = np.ones_like(edited.net.automatic_vectors)
    back = edited.with_net(edited.net.with_vectors(edited.net.given_vectors, free))
    assert_array_equal(back.vectors, surface.vectors)
    assert list(back.edited) == [3]
    assert not back.with_net(back.net.without_edits([3])).edited


def test_planes_and_net_stay_the_same_objects_whatever_s_and_smoothness_are():
    edited = moved(pillow(), 3)
    for other in (edited.with_smoothness(3.0), edited.with_s(0.5)):
        assert other.net is edited.net
        assert other.planes is edited.planes


def test_points_that_stay_are_shared_by_what_is_turned():
    edited = moved(pillow(), 3)
    assert turned(edited, 0, 4).net.control_points is edited.net.control_points
    assert moved(edited, 4).vectors is edited.vectors


def test_moved_with_the_mesh_edits_stay_edits():
    turn, shift = np.diag([1.0, -2.0, 0.5]), np.array([1.0, 2.0, 3.0])
    edited = turned(moved(pillow(), 3), 1, 5)
    image = edited.transformed(turn, shift)
    assert list(image.edited) == [3, 5]
    np.testing.assert_allclose(image.edited[3].point, turn @ edited.edited[3].point + shift)
    np.testing.assert_allclose(image.edited[5].gradient_v, turn @ [1.0, 2.0, 3.0])
    assert image.edited[5].point is None


def test_nothing_of_a_net_can_be_written_to():
    edited = turned(moved(pillow(), 3), 0, 4)
    for array in (edited.net.control_points, edited.vectors, edited.net.given_vectors):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


def test_what_is_no_net_of_faces_is_refused():
    with pytest.raises(TypeError, match="faces"):
        pillow().with_net(sail().net)
    with pytest.raises(ValueError, match="no weights"):
        pillow().net.with_weight_row(np.ones(3))
    with pytest.raises(ValueError, match="not finite"):
        pillow().net.with_control_points(np.full_like(pillow().net.control_points, np.nan))


def test_edited_planes_are_found_by_face():
    surface = pillow().with_edited({5: EditedPlane(point=np.zeros(3)), 2: EditedPlane()})
    assert (list(surface.edited), len(surface.edited), 3 in surface.edited) == ([2, 5], 2, False)
    assert surface.edited[2].point is None
    with pytest.raises(KeyError):
        surface.edited[3]
