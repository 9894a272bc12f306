"""Where ends of several curves meet."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.continuity import meeting
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.meetings import meetings


def straight(*points):
    return PlusCurve(Bernstein(len(points)), ControlLines.of(np.array(points)), 0.0)


def a_star(arms=5, dimension=2):
    """Segments from one point, outwards."""
    angles = 2.0 * np.pi * np.arange(arms) / arms
    tips = np.column_stack([np.cos(angles), np.sin(angles), np.zeros(arms)])[:, :dimension]
    return [straight(np.zeros(dimension), tip) for tip in tips]


@pytest.mark.parametrize("dimension", [2, 3])
def test_each_arm_of_a_star_meets_each_other_once(dimension):
    joints = meetings(a_star(5, dimension))
    assert len(joints) == 10
    assert all(joint.order == 0 for joint in joints)
    assert_allclose([joint.point for joint in joints], 0.0, atol=1e-15)


def test_it_finds_what_looking_at_all_pairs_does():
    rng = np.random.default_rng(3)
    corners = rng.random((6, 2))
    curves = [straight(corners[i], rng.random(2), corners[j]) for i in range(6) for j in range(i)]
    slow = [
        joint
        for k, one in enumerate(curves)
        for other in curves[:k]
        for joint in meeting(other, one)
    ]
    quick = meetings(curves)
    assert len(quick) == len(slow) > 20
    assert_allclose(sorted(j.angle for j in quick), sorted(j.angle for j in slow))


def test_curves_that_end_apart_do_not_meet():
    assert not meetings([straight((0.0, 0.0), (1.0, 0.0)), straight((1.001, 0.0), (2.0, 0.0))])
    assert not meetings([])


def test_a_straight_line_goes_on_smoothly_in_the_next():
    (joint,) = meetings([straight((0.0, 0.0), (1.0, 0.0)), straight((1.0, 0.0), (3.0, 0.0))])
    assert joint.order == 2


def test_plane_curves_and_curves_in_space_do_not_meet():
    assert not meetings(
        [straight((0.0, 0.0), (1.0, 0.0)), straight((1.0, 0.0, 0.0), (2.0, 0.0, 0.0))]
    )
