"""Labels that give way: none lies upon another, and those of low ranks have the first choice."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Label, Markers
from plusedit.scene.label_places import label_box, uncrowded
from plusedit.scene.options import ViewOptions
from plusedit.scene.scene import scene_items
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from tests.geometry.curves import random_curve

CAMERA = PlaneCamera((800.0, 600.0), scale=100.0)
NAMES = ViewOptions(overlays=frozenset({"names"}), handles="none")


def label(x, y, text="name", **more):
    return Label(np.array([x, y]), text, "text", **{"rank": 0} | more)


def box(item, camera=CAMERA):
    return camera.to_screen(item.at[None])[0] + label_box(item)


def overlap(one, other):
    return bool((one[0] < other[1]).all() and (other[0] < one[1]).all())


def scattered(count):
    random = np.random.default_rng(5)
    return [
        label(x, y, "n" * size, instead=((0.0, 40.0), (0.0, -40.0)))
        for (x, y), size in zip(
            random.uniform(-3.0, 3.0, (count, 2)), random.integers(1, 12, count), strict=True
        )
    ]


@pytest.mark.parametrize("count", [2, 30, 200])
def test_no_two_labels_that_give_way_overlap(count):
    boxes = [box(item) for item in uncrowded(scattered(count), CAMERA)]
    assert not any(overlap(a, b) for a, b in combinations(boxes, 2))


def test_a_label_is_left_out_only_where_all_its_places_are_taken():
    labels = scattered(60)
    placed = uncrowded(labels, CAMERA)
    taken = [box(item) for item in placed]
    kept = {(item.text, *item.at) for item in placed}
    for item in labels:
        if (item.text, *item.at) not in kept:
            for offset in (item.offset, *item.instead):
                here = box(replace(item, offset=offset)) + np.array([[-2.0], [2.0]])
                assert any(overlap(here, other) for other in taken)


def test_labels_with_room_stay_as_they_are():
    labels = (label(-2.0, 0.0), label(2.0, 0.0))
    assert uncrowded(labels, CAMERA) == labels


def test_a_lower_rank_has_the_first_choice():
    second, first = label(0.0, 0.0, "second", rank=1), label(0.0, 0.0, "first", rank=0)
    assert uncrowded([second, first], CAMERA) == (first,)
    assert uncrowded([first, second], CAMERA) == (first,)


def test_a_label_takes_another_of_its_places_rather_than_none():
    below = label(0.0, 0.0, "back", instead=((0.0, 30.0),))
    moved, front = uncrowded([below, label(0.0, 0.0, "front")], CAMERA)
    assert (moved.text, moved.offset) == ("back", (0.0, 30.0))
    assert front.offset == (0.0, 0.0)


def test_what_does_not_give_way_stays_in_its_order():
    fixed = [label(0.0, 0.0, "a", rank=None), label(0.0, 0.0, "b", rank=None)]
    mark = Markers(np.zeros((1, 2)), "disc", 4.0, None, "text")
    assert uncrowded([fixed[0], mark, fixed[1]], CAMERA) == (fixed[0], mark, fixed[1])


def crowd():
    """Six curves upon each other."""
    curve = random_curve("bspline")
    return Design({f"c{i}": Shape(curve, f"curve {i}") for i in range(6)})


def words(layers, camera):
    found = [item for item in layers if isinstance(item, Label)]
    boxes = [box(item, camera) for item in found]
    assert not any(overlap(a, b) for a, b in combinations(boxes, 2))
    return [item.text for item in found]


def test_names_of_shapes_upon_each_other_do_not_overlap_and_that_of_a_selected_one_is_there():
    selection = Selection(shapes=frozenset({"c0"}))
    space = SpaceCamera((800.0, 600.0))
    in_plane = words(scene_items(crowd(), CAMERA, NAMES, selection), CAMERA)
    in_space = words(space_items(crowd(), space, NAMES, selection), space)
    for names in (in_plane, in_space):
        assert 1 < len(names) < 6
        assert "curve 0" in names


def test_the_name_of_a_selected_shape_stands_below_it():
    selection = Selection(shapes=frozenset({"c0"}))
    found = [i for i in scene_items(crowd(), CAMERA, NAMES, selection) if isinstance(i, Label)]
    (alone,) = (
        item for item in scene_items(crowd(), CAMERA, NAMES, only={"c0"}) if isinstance(item, Label)
    )
    chosen = next(item for item in found if item.text == "curve 0")
    assert chosen.offset == alone.offset
    assert_array_equal(chosen.at, alone.at)
