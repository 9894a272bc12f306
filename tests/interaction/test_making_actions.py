"""Making surfaces by menu."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.making_actions import ACTIONS
from plusedit.interaction.tool import Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.space_camera import SpaceCamera
from tests.geometry.making.test_from_curves import edges
from tests.interaction.hand import BOW, WAVE, design

MAKE = {action.name: action.make for action in ACTIONS}
BODIES = [action.name for action in ACTIONS if action.menu == "Surface/New"]
FROM_CURVES = [action.name for action in ACTIONS if action.menu == "Surface/From curves"]
CAMERAS = {
    "top": PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0),
    "front": PlaneCamera((800.0, 600.0), (2.0, 1.0), 100.0, "front"),
    "space": SpaceCamera((800.0, 600.0), (2.0, 1.0, 5.0), 6.0, 0.5, 0.4, True),
}


def stage(*selected, on=None, camera="top"):
    start = design() if on is None else on
    return Stage(start, CAMERAS[camera], Selection.of_shapes(selected))


def made(name, given):
    """The surface that the action adds."""
    after = MAKE[name](given).apply(given.design)
    return list(after.shapes.values())[-1].surface


def with_edges():
    return Design({name: Shape(curve, name) for name, curve in zip("abcd", edges(), strict=True)})


@pytest.mark.parametrize("camera", CAMERAS)
@pytest.mark.parametrize("name", BODIES)
def test_a_new_surface_is_seen_in_the_middle_of_the_view(name, camera):
    given = stage(on=Design(), camera=camera)
    t = np.linspace(0.0, 1.0, 21)
    points = made(name, given).at(t, t).reshape(-1, 3)
    seen = given.camera.to_screen(points)
    low, high = seen.min(axis=0), seen.max(axis=0)
    assert (low > 0.0).all() and (high < given.camera.size).all()
    assert_allclose((low + high) / 2.0, np.array(given.camera.size) / 2.0, atol=30.0)
    if name == "new_sheet" and camera == "front":
        return  # seen edge-on
    assert (high - low).max() > 100.0


@pytest.mark.parametrize("name", FROM_CURVES)
def test_without_a_curve_an_action_says_what_to_select(name):
    with pytest.raises(EditError, match=r"^Select .*\.$"):
        MAKE[name](stage())


@pytest.mark.parametrize(
    ("name", "selected"),
    [("rule", (WAVE,)), ("loft", (WAVE,)), ("loft_round", (WAVE, BOW)), ("fill", (WAVE, BOW))],
)
def test_with_too_few_curves_an_action_says_how_many(name, selected):
    with pytest.raises(EditError, match=r"^Select .*\.$"):
        MAKE[name](stage(*selected))


def test_a_plane_curve_is_extruded_upwards_by_a_round_length():
    surface = made("extrude", stage(WAVE))
    assert_allclose(surface.at([0.3], [1.0])[..., 2], 2.0)


def test_a_straight_line_along_z_is_extruded_across():
    line = PlusCurve(BSpline(2, 2), ControlLines.of([[0.0, 0.0, 0.0], [0.0, 0.0, 4.0]]))
    surface = made("extrude", stage("line", on=Design({"line": Shape(line, "line")})))
    assert_allclose(surface.at([0.0], [1.0])[0, 0], [2.0, 0.0, 0.0])


@pytest.mark.parametrize(
    ("name", "camera", "across"),
    [
        ("revolve_x", "top", [1, 2]),
        ("revolve_y", "top", [0, 2]),
        ("revolve_z", "top", [0, 1]),
        ("revolve_upright", "top", [0, 2]),
        ("revolve_upright", "front", [0, 1]),
        ("revolve_upright", "space", [0, 1]),
    ],
)
def test_a_curve_is_revolved_about_the_axis_that_is_named(name, camera, across):
    surface = made(name, stage(BOW, camera=camera))
    distance = np.linalg.norm(surface.at(np.linspace(0.0, 1.0, 9), [0.4])[..., across], axis=-1)
    assert np.ptp(distance) < 1e-12


def test_a_curve_revolved_about_its_ends_has_two_poles():
    surface = made("revolve_ends", stage(WAVE))
    ends = surface.at(np.linspace(0.0, 1.0, 9), [0.0, 1.0])
    assert_allclose(
        ends, np.broadcast_to([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]], ends.shape), atol=1e-9
    )


def test_surfaces_between_curves_are_made_from_what_is_selected():
    assert made("rule", stage(WAVE, BOW)).planes.shape[1] == 2
    assert made("loft", stage(WAVE, BOW)).planes.shape[1] == 2
    assert made("loft_round", stage(*"abc", on=with_edges())).closed == (False, True)
    assert made("fill", stage(*"abcd", on=with_edges())).planes.shape == (8, 8)


def test_a_locked_curve_is_not_taken():
    locked = Design({WAVE: Shape(design()[WAVE].curve, "Wave", locked=True)})
    with pytest.raises(EditError, match="locked"):
        MAKE["extrude"](stage(WAVE, on=locked))
