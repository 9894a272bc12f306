from dataclasses import replace

import numpy as np
import pytest

from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.options import ViewOptions
from plusedit.scene.shape_pairs import known_comparison
from plusedit.views.pair_measuring import PairMeasuring
from tests.geometry.surfaces import a_surface

pytestmark = pytest.mark.gui

SHOWN = ViewOptions(overlays=frozenset({"two_shapes"}))


@pytest.fixture
def session(qapp):
    shapes = {ShapeId(name): Shape(a_surface(n, n), name) for name, n in (("a", 4), ("b", 5))}
    return Session(Design(shapes))


def surfaces(session):
    return [surface for _, surface in session.design.surfaces()]


def done(qtbot, measuring):
    qtbot.waitUntil(lambda: not measuring.is_busy, timeout=30_000)


def test_the_pair_that_is_shown_is_compared_beside(qtbot, session):
    measuring = PairMeasuring(session)
    told = []
    measuring.ready.listen(lambda: told.append(True))
    measuring.set_options(SHOWN)
    done(qtbot, measuring)
    first, second = surfaces(session)
    assert known_comparison(second, first) is not None
    assert told == [True]


def test_nothing_is_compared_while_nothing_shows_it(session):
    measuring = PairMeasuring(session)
    measuring.set_options(ViewOptions())
    assert not measuring.is_busy


def test_after_an_edit_it_is_compared_again(qtbot, session):
    measuring = PairMeasuring(session)
    measuring.set_options(SHOWN)
    done(qtbot, measuring)
    old = session.design[ShapeId("a")]
    session.open(session.design.with_shape(ShapeId("a"), replace(old, geometry=a_surface(6, 6))))
    done(qtbot, measuring)
    first, second = surfaces(session)
    assert known_comparison(second, first) is not None


def test_shapes_that_can_t_be_calculated_with_are_given_up(qtbot, session):
    measuring = PairMeasuring(session)
    surface = surfaces(session)[0]
    huge = surface.net.with_control_points(np.full((16, 3), 1e90))
    shape = replace(session.design[ShapeId("a")], geometry=surface.with_net(huge))
    session.open(session.design.with_shape(ShapeId("a"), shape))
    measuring.set_options(SHOWN)
    done(qtbot, measuring)
