"""Shipped examples are seen whole in whatever room the 3D view has, and from all sides."""

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from plusedit.io.files import load
from plusedit.resources import example_files
from plusedit.scene.options import space_camera_of
from plusedit.scene.space_camera import STANDARD
from tests.gl.test_first_session import make_window

pytestmark = pytest.mark.gl

__all__ = ["make_window"]

FIGURE_7 = next(path for path in example_files() if path.stem == "figure_7")


def test_an_example_is_seen_whole_from_its_own_side_in_a_narrow_view(make_window):
    window = make_window()
    window.view.set_animated(False)
    window.files.open(FIGURE_7)
    window.panes.space.setFixedWidth(360)
    window.files.open(FIGURE_7)
    QApplication.processEvents()
    window.panes.space.grabFramebuffer()
    camera = window.panes.space.camera
    own = space_camera_of(load(FIGURE_7).design.view, camera.size)
    assert (camera.yaw, camera.pitch, camera.perspective) == (own.yaw, own.pitch, own.perspective)
    for _, surface in window.session.design.surfaces():
        pixels = camera.to_screen(surface.net.control_points)
        assert (pixels > 0.0).all() and (pixels < np.array(camera.size)).all()


@pytest.mark.parametrize("name", STANDARD)
def test_the_menu_tells_from_where_the_3d_view_looks(make_window, name):
    window = make_window()
    window.view.set_animated(False)
    window.files.open(FIGURE_7)
    assert window.view.looks_from == ""
    window.view.look_from(name)
    assert window.view.looks_from == name
