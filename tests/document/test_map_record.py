"""What a shape tells of the map of its mesh."""

import pytest

from plusedit.document.map_record import MapRecord, map_of, with_map
from plusedit.document.shape import NOTHING
from plusedit.io.formats.json_document import dumps, loads
from tests.scene.meshes import HILL, a_landscape


def telling(said):
    return a_landscape(extra={"map": said})[HILL]


def test_what_was_told_is_known_again():
    record = MapRecord("pillow", (1, 5, 2, 8))
    assert map_of(a_landscape(extra=with_map(NOTHING, record))[HILL]) == record


def test_a_file_keeps_it():
    record = MapRecord("filled_pillow", (1, 5, 2, 8))
    design = a_landscape(extra=with_map({"mine": "kept"}, record))
    again = loads(dumps(design), "hill.json").design[HILL]
    assert map_of(again) == record
    assert again.extra["mine"] == "kept"


def test_a_shape_may_tell_nothing():
    assert map_of(a_landscape()[HILL]) is None


@pytest.mark.parametrize(
    "said", ["pillow", 3, None, [], {}, {"name": 4}, {"name": "pillow", "cone_points": 4}]
)
def test_what_other_programs_write_there_is_not_taken_for_a_map(said):
    assert map_of(telling(said)) is None


@pytest.mark.parametrize("points", [[], [1, 2, 3], [1, 2, 3, "4"], [1, 2, 3, True], [1.0] * 4])
def test_cone_points_are_four_numbers_or_none(points):
    assert map_of(telling({"name": "pillow", "cone_points": points})) == MapRecord("pillow")
