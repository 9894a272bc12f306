import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from plusedit.interaction.swing import Slowed, Swing

CENTER = np.array([100.0, 100.0])


def round_about(degrees, radius=50.0):
    angle = np.radians(degrees)
    return CENTER + radius * np.array([np.cos(angle), -np.sin(angle)])


@settings(max_examples=50)
@given(st.lists(st.floats(-80.0, 80.0), min_size=1, max_size=40))
def test_the_angle_adds_up_whatever_way_the_pointer_goes_round(steps):
    swing, degrees = Swing(CENTER, round_about(0.0)), 0.0
    for step in steps:
        degrees += step
        assert np.degrees(swing.to(round_about(degrees))) == pytest.approx(degrees, abs=1e-6)


def test_back_at_the_start_the_angle_is_zero_to_the_last_bit():
    swing = Swing(CENTER, round_about(17.0))
    for degrees in (40.0, 100.0, 60.0, -30.0):
        swing.to(round_about(degrees))
    assert swing.to(round_about(17.0)) == 0.0


@pytest.mark.parametrize("aside", [0.0, 0.5, -0.5, 3.0, 8.0])
def test_a_way_through_the_center_turns_by_little(aside):
    swing = Swing(CENTER, np.add(CENTER, (50.0, 0.0)))
    angles = [swing.to(np.add(CENTER, (x, aside))) for x in np.linspace(49.0, -50.0, 100)]
    assert abs(np.degrees(angles[-1])) < 10.0


def test_a_pointer_that_starts_on_the_center_has_an_angle_all_the_same():
    swing = Swing(CENTER, CENTER)
    assert swing.to(CENTER) == 0.0
    assert np.isfinite(swing.to(np.add(CENTER, (30.0, 30.0))))


def test_slowness_begins_and_ends_without_a_jump():
    slowed = Slowed()
    said = [slowed.of(value, slow=10 <= value < 20) for value in np.arange(0.0, 30.0)]
    assert np.abs(np.diff(said)).max() == pytest.approx(1.0)
    assert said[19] - said[9] == pytest.approx(1.0)
