"""Numbers of curves in the Inspector."""

import pytest

from plusedit.document.selection import Selection
from plusedit.geometry.curve_numbers import curve_numbers
from plusedit.scene.curve_words import energy_text, inflections_text, length_text
from plusedit.views.numbers_form import NumbersForm
from tests.designs import BOW, WING

pytestmark = pytest.mark.gui


@pytest.fixture
def form(qtbot, session):
    form = NumbersForm()
    qtbot.addWidget(form)
    form.show()
    return form


def told(form):
    return [form.length.text(), form.energy.text(), form.inflections.text()]


def test_numbers_of_the_selected_curve_are_found_beside_and_told(qtbot, form, session):
    curve = session.design.curve(BOW)
    form.show_curves({BOW: curve})
    known = curve_numbers(curve)
    wanted = [length_text(known), energy_text(known), inflections_text(known)]
    qtbot.waitUntil(lambda: told(form) == wanted)


def test_what_is_known_is_told_at_once(form, session):
    curve = session.design.curve(WING)
    known = curve_numbers(curve)
    form.show_curves({WING: curve})
    assert form.length.text() == length_text(known)


def test_lengths_of_several_are_summed(form, session):
    curves = {i: session.design.curve(i) for i in (BOW, WING)}
    total = sum(curve_numbers(curve).length for curve in curves.values())
    form.show_curves(curves)
    assert float(form.length.text().split()[0]) == pytest.approx(total, rel=1e-5)


def test_it_hides_where_no_curve_is_selected(form):
    form.show_curves({})
    assert form.isHidden()


def test_the_inspector_shows_them_of_curves_alone(qtbot, window, design):
    window.session.open(design)
    window.show_view()
    window.session.select(Selection(frozenset(), frozenset([BOW])))
    form = window.findChild(NumbersForm)
    qtbot.waitUntil(form.isVisible)
    window.session.select(Selection())
    qtbot.waitUntil(form.isHidden)
