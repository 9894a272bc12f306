"""Badges say what shapes keep, and what they can't keep now."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.document.shape import Shape
from plusedit.geometry.constraints import Wish
from plusedit.geometry.keeping import kept
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers
from plusedit.scene.overlays import Seen, overlays
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.surfaces import a_surface
from tests.interaction.hand import wave

CAMERA = PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0)


def badges(geometry, *wishes, camera=CAMERA):
    keeping = kept(geometry, wishes)
    shape = Shape(keeping.geometry, "A", constraints=wishes)
    return list(overlays["constraints"].draw(shape, keeping.geometry, Seen(camera)))


def letters(items):
    return [item.text for item in items if isinstance(item, Label)]


def test_a_shape_without_constraints_has_no_badges():
    assert not badges(wave())


def test_every_constraint_has_a_letter_at_every_place():
    items = badges(wave(), Wish("tangent_start"), Wish("passing", (1, 2)))
    assert sorted(letters(items)) == ["P", "P", "T"]


def test_badges_in_one_place_stand_side_by_side():
    items = badges(wave(), Wish("tangent_start"), Wish("passing", (0,)))
    places = [CAMERA.to_screen(item.points)[0] for item in items if isinstance(item, Markers)]
    assert np.hypot(*(places[0] - places[1])) >= 15.0


def test_what_cannot_be_kept_has_an_exclamation_mark():
    still = replace(wave(), s=0.0)
    assert letters(badges(still, Wish("tangent_start"))) == ["!"]


@pytest.mark.parametrize("camera", [CAMERA, SpaceCamera((800.0, 600.0), height=8.0)])
def test_corners_of_a_surface_have_badges_in_both_views(camera):
    items = badges(a_surface(), Wish("corner_tangency", (0, 1, 2, 3)), camera=camera)
    assert letters(items) == ["T"] * 4
