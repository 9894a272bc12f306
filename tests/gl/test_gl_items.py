"""Lines, marks, areas and meshes: is each drawn where it belongs, and as wide as it says."""

import numpy as np
import pytest
from numpy.testing import assert_array_equal

from plusedit.scene.items import Markers, Mesh, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import DARK, LIGHT, THEMES
from plusedit.views.gl.artist import Look
from plusedit.views.space_picture import space_image_of
from tests.gl.easel import FRONT, ISO, TOP, at, color, is_like
from tests.scene.meshes import a_landscape

pytestmark = pytest.mark.gl

PIXEL = FRONT.pixel
LEVEL = np.array([[-2.0, 0.0, 0.0], [2.0, 0.0, 0.0]])
SQUARE = np.array([[-1.0, 0.0, -1.0], [1.0, 0.0, -1.0], [1.0, 0.0, 1.0], [-1.0, 0.0, 1.0]])
NEARER, FARTHER, BELOW = np.array([[0.0, -1.0, 0.0], [0.5, 1.0, 0.0], [0.0, 0.0, -2.0]])
CANVAS = color(LIGHT, "canvas")


def inked(pixels, canvas=CANVAS):
    """(height, width) whether anything was drawn there."""
    return (np.abs(pixels - canvas) > 2).any(axis=2)


def coverage(pixels):
    """(height, width) how much of each pixel is covered with the color of plus curves."""
    whole = np.abs(color(LIGHT, "plus") - CANVAS).sum()
    return np.abs(pixels - CANVAS).sum(axis=2) / whole


@pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))
def test_an_empty_frame_is_the_canvas(easel, theme):
    assert (easel.draw(theme=theme) == color(theme, "canvas")).all()


def test_an_empty_frame_without_a_ground_is_nothing(easel):
    assert not easel.draw(look=Look(transparent=True)).any()


@pytest.mark.parametrize("width", [1.0, 2.0, 5.0, 12.0])
def test_a_line_is_as_wide_as_it_says(easel, width):
    pixels = easel.draw(Polyline(LEVEL, "plus", width))
    assert is_like(at(pixels, FRONT, (0.01, 0.0, 0.01)), color(LIGHT, "plus")) or width < 2.0
    assert coverage(pixels)[:, 100].sum() == pytest.approx(width, abs=0.1)


def test_a_line_toward_the_eye_is_as_wide_near_as_far(easel):
    camera = SpaceCamera((200.0, 160.0), pitch=0.4, yaw=0.0)
    away = np.array([[0.0, -12.0, 0.0], [0.0, 12.0, 0.0]])
    pixels = easel.draw(Polyline(away, "plus", 4.0), camera=camera)
    rows = np.flatnonzero(inked(pixels).any(axis=1))
    assert coverage(pixels).sum(axis=1)[rows[3:-3]] == pytest.approx(4.0, abs=0.1)


def test_a_line_that_begins_behind_the_eye_is_seen_up_to_the_eye(easel):
    camera = SpaceCamera((200.0, 160.0), yaw=0.0, pitch=0.3)
    behind = camera.eye + 3.0 * camera.toward - np.array([0.0, 0.0, 1.0])
    pixels = easel.draw(Segments(behind[None], np.zeros((1, 3)), "plus", 3.0), camera=camera)
    assert inked(pixels)[-1].any()
    assert not inked(pixels)[:70].any()


def test_what_lets_through_is_laid_over_itself_only_once(easel):
    turns = np.linspace(0.0, 2.0 * np.pi, 60)
    ring = np.stack([2.0 * np.cos(turns), np.zeros(60), 2.0 * np.sin(turns)], axis=1)
    zigzag = np.array([[-2.0, 0, -2.0], [-1.0, 0, 2.0], [0, 0, -2.0], [1.0, 0, 2.0]])
    for line in (ring, zigzag):
        pixels = easel.draw(Polyline(line, "plus@50", 9.0))
        half = (CANVAS + color(LIGHT, "plus")) / 2.0
        assert is_like(pixels[..., :3].min(axis=(0, 1)), half[:3], within=3)


@pytest.mark.parametrize("dash", ["dash", "dot"])
def test_dashes_leave_gaps_all_along(easel, dash):
    pixels = easel.draw(Polyline(LEVEL, "plus", 2.0, dash))
    row = inked(pixels)[79:81, 68:132].any(axis=0)
    period = {"dash": 10, "dot": 5}[dash]
    changes = np.count_nonzero(np.diff(row.astype(int)))
    assert changes == pytest.approx(2 * len(row) / period, abs=2)


@pytest.mark.parametrize(
    ("mark", "middle", "corner"),
    [
        ("circle", "fill", None),
        ("square", "fill", "outline"),
        ("diamond", "fill", None),
        ("ring", None, None),
        ("cross", "outline", "outline"),
    ],
)
def test_marks_are_seen_in_their_form(easel, mark, middle, corner):
    pixels = easel.draw(Markers(np.zeros((1, 3)), mark, 24.0, "selected", "plus", 3.0))
    wanted = {"fill": "selected", "outline": "plus", None: "canvas"}
    assert is_like(pixels[80, 100], color(LIGHT, wanted[middle]))
    assert is_like(pixels[80 - 11, 100 + 11], color(LIGHT, wanted[corner]), within=40)
    rows, columns = np.nonzero(inked(pixels))
    assert rows.max() - rows.min() + 1 == pytest.approx(24, abs=3)
    assert columns.max() - columns.min() + 1 == pytest.approx(24, abs=3)


def test_a_hollow_mark_is_filled_with_the_canvas(easel):
    line = Polyline(LEVEL, "plus", 3.0)
    pixels = easel.draw(line, Markers(np.zeros((1, 3)), "circle", 20.0, None, "v"), theme=DARK)
    assert is_like(pixels[80, 100], color(DARK, "canvas"))


def test_an_area_is_filled_and_outlined(easel):
    pixels = easel.draw(Polygon(SQUARE, "selected", "plus", 4.0))
    assert is_like(at(pixels, FRONT, (0.3, 0.0, 0.3)), color(LIGHT, "selected"))
    assert is_like(at(pixels, FRONT, (1.0, 0.0, 0.3)), color(LIGHT, "plus"))
    assert is_like(at(pixels, FRONT, (1.3, 0.0, 0.3)), CANVAS)


def test_an_area_with_a_notch_keeps_it(easel):
    notched = np.array([[-2.0, 0, -2.0], [0, 0, 0.5], [2.0, 0, -2.0], [2.0, 0, 2.0], [-2, 0, 2.0]])
    pixels = easel.draw(Polygon(notched, "selected"))
    assert is_like(at(pixels, FRONT, (0.0, 0.0, -0.5)), CANVAS)
    assert is_like(at(pixels, FRONT, (0.0, 0.0, 1.0)), color(LIGHT, "selected"))


def test_what_is_nearer_hides_what_is_farther_whatever_comes_first(easel):
    near, far = Polygon(SQUARE + NEARER, "u"), Polygon(SQUARE + FARTHER, "v")
    line = Polyline(LEVEL, "plus", 3.0)
    pictures = [easel.draw(*items) for items in ((near, line, far), (far, line, near))]
    # Where smooth edges cross, the one drawn first has the rim.
    assert np.abs(pictures[0] - pictures[1]).mean() < 0.1
    assert is_like(at(pictures[0], FRONT, (0.0, 0.0, 0.0)), color(LIGHT, "u"))
    assert is_like(at(pictures[0], FRONT, (1.25, 0.0, 0.0)), color(LIGHT, "plus"))


def test_a_line_in_an_area_is_not_cut_up_by_it(easel):
    tilted = np.array([[-2.0, -2, -1], [2, -2, -1], [2, 2, 1], [-2, 2, 1.0]])
    across = Polyline(np.array([[-2.0, -1.0, -0.5], [2.0, 1.0, 0.5]]), "plus", 3.0)
    pixels = easel.draw(Polygon(tilted, "u"), across, camera=ISO)
    for share in np.linspace(-0.95, 0.95, 41):
        here = at(pixels, ISO, share * np.array([2.0, 1.0, 0.5]))
        assert is_like(here, color(LIGHT, "plus"), within=60)


def test_hidden_handles_are_faint_and_seen_ones_in_front_of_curves(easel):
    wall = Polygon(SQUARE + NEARER, "u")
    grip = Markers(np.array([[0.0, 0, 0], [1.5, 0, 0]]), "circle", 14.0, "selected", "selected")
    curve = Polyline(np.array([[1.0, -0.01, 0.0], [2.0, -0.01, 0.0]]), "plus", 3.0)
    pixels = easel.draw(wall, curve, handles=[grip])
    wanted = 0.7 * color(LIGHT, "u") + 0.3 * color(LIGHT, "selected")
    assert is_like(at(pixels, FRONT, (0.0, 0.0, 0.0)), wanted, within=3)
    assert is_like(at(pixels, FRONT, (1.5, 0.0, 0.0)), color(LIGHT, "selected"))


def test_handles_are_drawn_in_their_order(easel):
    def overlapping(first, second):
        marks = [Markers(np.zeros((1, 3)), "circle", 20.0, role, role) for role in (first, second)]
        square = Polygon(SQUARE / 2.0, first)
        return easel.draw(handles=[marks[0], square, marks[1]])[80, 100]

    assert is_like(overlapping("u", "v"), color(LIGHT, "v"))
    assert is_like(overlapping("v", "u"), color(LIGHT, "u"))


def test_a_mesh_is_warm_in_front_and_cool_behind(easel):
    mesh = Mesh(SQUARE, np.array([[0, 1, 2], [0, 2, 3]], np.int32))
    front = at(easel.draw(mesh), FRONT, (0.0, 0.0, 0.0))
    back_view = FRONT.looking("back")
    back = at(easel.draw(mesh, camera=back_view), back_view, (0.0, 0.0, 0.0))
    assert front[0] > front[2]
    assert back[0] < back[2]


def test_glass_does_not_care_which_comes_first(easel):
    corners = np.array([[0, 0, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2.0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.int32)
    glass = [
        Mesh(corners - 1.5 + k, faces, None, role, role)
        for k, role in ((0, "parent"), (2, "union"))
    ]
    pictures = [easel.draw(*items, camera=ISO) for items in (glass, glass[::-1])]
    assert_array_equal(*pictures)


def test_lines_within_glass_are_seen(easel):
    cube = Polyline(LEVEL, "plus", 3.0), Polygon(SQUARE + NEARER, "union")
    pixels = easel.draw(*cube)
    inside, beside = (at(pixels, FRONT, (x, 0.0, 0.0)) for x in (0.0, 1.5))
    assert is_like(beside, color(LIGHT, "plus"))
    assert not is_like(inside, beside, within=20)
    assert not is_like(inside, at(pixels, FRONT, (0.0, 0.0, 0.5)), within=20)


def test_coordinates_far_off_lose_nothing(easel):
    away = np.array([3e7, -2e7, 5e6])
    items = [Polyline(LEVEL, "plus", 3.0), Markers(LEVEL, "diamond", 12.0, None, "v")]
    moved = [
        Polyline(LEVEL + away, "plus", 3.0),
        Markers(LEVEL + away, "diamond", 12.0, None, "v"),
    ]
    there = ISO._aimed(away)
    difference = easel.draw(*items, camera=ISO) - easel.draw(*moved, camera=there)
    assert np.abs(difference).max() <= 4


def test_a_closer_look_at_one_end_of_a_long_line_is_sharp(easel):
    line = Polyline(np.array([[-1e7, 0, 0], [0.0, 0, 0], [0.0, 0, 1.0]]), "plus", 3.0)
    easel.draw(line, camera=FRONT.framing(line.points))
    assert is_like(at(easel.draw(line), FRONT, (0.0, 0.0, 0.5)), color(LIGHT, "plus"))


def test_more_pixels_to_a_logical_one_keep_the_picture(easel):
    from tests.gl.easel import SIZE, Easel

    fine = Easel(easel.gl, (2 * SIZE[0], 2 * SIZE[1]))
    items = Polyline(LEVEL, "plus", 4.0), Markers(SQUARE, "square", 14.0, "u", "v", 3.0)
    large = fine.draw(*items, ratio=2.0)
    fine.put_away()
    averaged = large.reshape(SIZE[1], 2, SIZE[0], 2, 4).mean(axis=(1, 3))
    assert np.abs(averaged - easel.draw(*items)).mean() < 0.5


def test_the_ground_fades_and_hides_nothing(easel):
    look = Look(ground=True)
    pixels = easel.draw(camera=ISO, look=look)
    assert inked(pixels)[80:, :].any()
    behind = easel.draw(Polyline(LEVEL + BELOW, "plus", 3.0), camera=ISO, look=look)
    assert is_like(at(behind, ISO, (0.0, 0.0, -2.0)), color(LIGHT, "plus"), within=60)


def test_seen_edge_on_there_is_no_ground(easel):
    edge_on = SpaceCamera((200.0, 160.0), yaw=0.3, pitch=0.0)
    assert not inked(easel.draw(camera=edge_on, look=Look(ground=True))).any()


@pytest.mark.parametrize("name", ["front", "right", "top", "left"])
def test_views_along_an_axis_have_a_grid(easel, name):
    camera = FRONT.looking(name)
    assert inked(easel.draw(camera=camera, look=Look(ground=True))).any()


def test_the_axes_stand_in_their_corner(easel):
    pixels = easel.draw(camera=TOP, look=Look(axes=True))
    rows, columns = np.nonzero(inked(pixels))
    assert columns.min() > 100
    assert rows.max() < 100
    wanted = color(LIGHT, "x")[:3]
    assert (np.abs(pixels[..., :3] - wanted) <= 2).all(axis=2).any()


def test_a_mesh_may_have_a_color_at_every_point(easel):
    colors = np.array([[1, 0, 0], [0, 0, 1], [0, 0, 1], [1, 0, 0]], np.float32)
    faces = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
    pixels = easel.draw(Mesh(SQUARE, faces, None, colors=colors))
    left = at(pixels, FRONT, (-0.95, 0.0, 0.0)).astype(int)
    right = at(pixels, FRONT, (0.95, 0.0, 0.0)).astype(int)
    assert left[0] > left[2] + 60
    assert right[2] > right[0] + 60


def test_the_surface_of_a_mesh_is_seen_in_space():
    image = space_image_of(a_landscape(), (120, 90))
    empty = space_image_of(a_landscape(visible=False), (120, 90))
    assert image.pixelColor(60, 45) != empty.pixelColor(60, 45)


def test_a_mesh_that_moves_takes_the_place_of_the_one_before(easel):
    faces = np.array([[0, 1, 2], [0, 2, 3]], np.int32)
    before, after = (Mesh(SQUARE + np.array([shift, 0.0, 0.0]), faces) for shift in (-0.5, 0.5))
    easel.draw(before)
    (buffers,) = easel.artist._meshes._held.values()
    moved = easel.draw(after)
    assert list(easel.artist._meshes._held.values()) == [buffers]
    np.testing.assert_array_equal(easel.draw(Mesh(after.points, faces.copy())), moved)
    assert list(easel.artist._meshes._held.values()) != [buffers]
