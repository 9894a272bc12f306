"""Pictures of designs in space: the same in the window, in tiles, and from a new context."""

from dataclasses import replace

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.blend import Grid
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Legend, Markers, Patch, Polygon, Polyline
from plusedit.scene.legends import placed
from plusedit.scene.options import ViewOptions, view_tree
from plusedit.scene.space_camera import STANDARD
from plusedit.scene.space_composition import composed_in_space
from plusedit.scene.theme import DARK, LIGHT
from plusedit.views import space_picture
from plusedit.views.gl.context import context_for_pictures
from plusedit.views.sketch import sketch_of
from plusedit.views.space_picture import space_image_of, space_png
from tests.geometry.surfaces import a_surface
from tests.gl.easel import ISO, Easel
from tests.scene.meshes import a_hill, a_landscape

pytestmark = pytest.mark.gl

SIZE = (360, 240)
SHEET = Design({ShapeId("sheet"): Shape(a_surface(s=1.0), "Sheet")})


def pixels_of(image):
    """(height, width, 4) red, green, blue and opacity."""
    image = image.convertToFormat(image.Format.Format_RGBA8888)
    rows = np.frombuffer(image.constBits(), np.uint8)
    return rows.reshape(image.height(), image.width(), 4).astype(int)


@pytest.fixture
def picture(qapp):
    """The pixels of a picture of the sheet."""

    def made(**options):
        return pixels_of(space_image_of(SHEET, SIZE, LIGHT, **options))

    return made


@pytest.mark.parametrize("view", STANDARD)
def test_every_view_shows_the_sheet(picture, view):
    pixels = picture(view=view)
    assert pixels.shape == (*SIZE[::-1], 4)
    off = (np.abs(pixels - pixels[0, 0]) > 3).any(axis=2)
    assert off.sum() > 0.02 * off.size
    rows, columns = np.nonzero(off)
    assert min(rows.min(), columns.min()) >= 4


def test_without_a_ground_the_rest_is_as_before(picture):
    on_canvas, alone = picture(), picture(transparent=True)
    assert alone[0, 0].tolist() == [0, 0, 0, 0]
    solid = alone[..., 3] == 255
    assert np.abs(on_canvas - alone)[solid].max() <= 1


def test_tiles_leave_no_seams(picture, monkeypatch):
    whole = picture()
    monkeypatch.setattr(space_picture, "TILE", 96)
    off = np.abs(picture() - whole)
    # Corners of triangles are rounded to parts of pixels, in each tile anew.
    assert off.max() <= 40
    assert off.mean() < 0.02


def test_a_picture_of_more_pixels_is_the_same_picture(picture):
    fine = picture(ratio=2.0)
    averaged = fine.reshape(SIZE[1], 2, SIZE[0], 2, 4).mean(axis=(1, 3))
    assert np.abs(averaged - picture()).mean() < 1.0


def test_the_window_shows_the_same_picture(qtbot):
    from plusedit.views.space_canvas import SpaceCanvas

    session = Session(SHEET)
    canvas = SpaceCanvas(session, Gestures(session, PlaneCamera((1.0, 1.0))))
    composition = composed_in_space(SHEET, (float(SIZE[0]), float(SIZE[1])))
    canvas.resize(*SIZE)
    qtbot.addWidget(canvas)
    with qtbot.waitExposed(canvas):
        canvas.show()
    canvas.set_theme(DARK)
    canvas.set_options(composition.options)
    canvas.set_camera(composition.camera)
    wanted = pixels_of(space_image_of(SHEET, SIZE, DARK))[..., :3]

    def is_the_same():
        seen = pixels_of(canvas.grabFramebuffer())[..., :3]
        off = np.abs(seen - wanted).max(axis=2)
        # The window has its axes in the corner, a picture has none.
        off[:110, -110:] = 0
        return (off > 8).mean() < 0.06 and off.mean() < 3.0

    # While a view is on its way it is drawn with fewer pixels.
    qtbot.waitUntil(is_the_same)


def test_a_png_file_says_what_was_drawn(qapp):
    from PySide6.QtGui import QImage

    read = pixels_of(QImage.fromData(space_png(SHEET, SIZE, DARK, True)))
    drawn = pixels_of(space_image_of(SHEET, SIZE, DARK, transparent=True))
    assert np.abs(read - drawn).max() <= 2


def test_a_new_context_draws_the_same_after_the_old_one_is_gone(qapp):
    items = Patch(a_surface(), Grid.uniform(9), Grid.uniform(9)), Polyline(np.eye(3), "plus")
    pictures = []
    for _ in range(3):
        with context_for_pictures() as gl:
            easel = Easel(gl)
            pictures.append(easel.draw(*items, camera=ISO))
            easel.put_away()
    assert all((picture == pictures[0]).all() for picture in pictures)


def test_drawing_a_picture_leaves_the_context_of_a_window_current(gl, easel, picture):
    before = easel.draw(Polyline(np.eye(3), "plus"), camera=ISO)
    picture()
    assert (easel.draw(Polyline(np.eye(3), "plus"), camera=ISO) == before).all()


def test_a_thousand_frames_leave_nothing_behind(alive, gl):
    easel = Easel(gl)
    random = np.random.default_rng(0)
    surface = a_surface()

    def frame(number):
        count = 5 + number % 7
        points = random.uniform(-1.0, 1.0, (count, 3))
        lifted = surface.planes.with_points(surface.planes.points + 0.01 * number)
        side = Grid.uniform(5 + number % 6)
        items = [Polyline(points, "plus", 2.0), Patch(surface.with_net(lifted), side, side)]
        items += [Polygon(points[:4], "union") for _ in range(number % 3)]
        handles = [Markers(points, "circle", 5.0, None, "v"), *items[2:]] * (number % 4)
        easel.draw(*items, handles=handles, camera=ISO.orbited(0.01 * number, 0.0))

    for number in range(84):
        frame(number)
    before = len(alive)
    for number in range(84, 84 + 1008):
        frame(number)
    frame(83)
    assert len(alive) == before
    easel.put_away()
    assert not alive


@pytest.mark.parametrize("theme", [LIGHT, DARK], ids=["light", "dark"])
@pytest.mark.parametrize("transparent", [False, True])
def test_a_colored_surface_has_its_legend_in_the_corner(qapp, theme, transparent):
    tree = view_tree(ViewOptions(overlays=frozenset({"deviation"})), old={})
    colored = replace(a_landscape(a_hill(smoothness=2.0)), view=tree)
    pixels = pixels_of(space_image_of(colored, SIZE, theme, transparent=transparent))
    layers = composed_in_space(colored, SIZE).layers
    legend = placed(next(item for item in layers.labels if isinstance(item, Legend)), SIZE)
    left, top, width, height = (round(side) for side in legend.bar)
    for color, y in ((legend.colors[-1], top + 1), (legend.colors[0], top + height - 2)):
        wanted = [int(color[i : i + 2], 16) for i in (1, 3, 5)]
        assert np.abs(pixels[y, left + width // 2, :3] - wanted).max() < 12
    ground = [int(theme.color("panel")[i : i + 2], 16) for i in (1, 3, 5)]
    corner = pixels[round(legend.box[1]) + 5, round(legend.box[0]) + 5]
    assert corner[3] > 200
    assert np.abs(corner[:3] - ground).max() < 32
    (mesh,) = layers.solids
    assert np.ptp(mesh.colors, axis=0).max() > 0.3


def test_colored_surfaces_are_colored_without_opengl_too(qapp):
    tree = view_tree(ViewOptions(overlays=frozenset({"deviation"})), old={})
    bare = a_landscape(a_hill(smoothness=2.0))
    plain, colored = (
        pixels_of(sketch_of(design, SIZE)) for design in (bare, replace(bare, view=tree))
    )
    gray = np.ptp(plain[..., :3], axis=-1).max()
    assert np.ptp(colored[..., :3], axis=-1).max() > gray + 40
