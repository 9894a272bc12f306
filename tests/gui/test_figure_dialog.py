"""Export figure: what is asked, what is previewed, what is remembered and written."""

import re
from dataclasses import replace

import pytest

from plusedit.app.figure_dialog import FigureDialog, FigureWish
from plusedit.scene.figure import FigureForm

pytestmark = pytest.mark.gui


@pytest.fixture
def dialog(qtbot, opened):
    made = FigureDialog(opened, FigureWish(), opened.figures.compose, has_space=False)
    qtbot.addWidget(made)
    return made


def test_the_usual_figure_is_a_pdf_of_a_column(dialog):
    wish = dialog.read()
    assert wish == FigureWish()
    assert (wish.suffix, wish.form.width, wish.form.text, wish.form.theme) == (
        ".pdf", 85.0, 8.0, "light"
    )  # fmt: skip


def test_the_preview_shows_the_figure_and_says_how_large_it_is(dialog):
    dialog.show_preview()
    assert not dialog.preview.pixmap().isNull()
    assert dialog.size_of_figure.text().startswith("85 × ")
    dialog.height_field.setText("40")
    dialog.show_preview()
    assert dialog.size_of_figure.text() == "85 × 40 mm"


def test_what_makes_no_sense_is_said_where_the_preview_would_be(dialog):
    dialog.width_field.setText("2")
    dialog.show_preview()
    assert dialog.size_of_figure.text() == "The width of a figure is 10 to 2000 mm, not 2."
    dialog._check()
    assert dialog.result() == 0
    assert dialog._reason.text()


def test_numbers_may_be_calculated(dialog):
    dialog.width_field.setText("170/2")
    dialog.line_field.setText("0.75")
    assert dialog.read().form == FigureForm(85.0, line=0.75)


def test_what_was_filled_in_comes_back(settings):
    wish = FigureWish("plane", ".svg", 600.0, FigureForm(120.0, 60.0, 9.0, 0.7, "dark", True))
    settings.figure = wish.tree()
    assert FigureWish.of(settings.figure) == wish


@pytest.mark.parametrize(
    "tree",
    [{}, {"width": -1.0, "suffix": ".gif", "part": []}, {"theme": 3, "resolution": "many"}],
)
def test_settings_that_make_no_sense_are_as_usual(tree):
    assert FigureWish.of(tree) == FigureWish()


@pytest.mark.parametrize("suffix", [".pdf", ".svg", ".png"])
def test_a_figure_of_what_is_seen_is_written_and_the_wish_remembered(
    opened, answers, tmp_path, suffix
):
    wish = replace(FigureWish(), suffix=suffix, form=FigureForm(70.0))
    answers.exported = tmp_path / f"figure{suffix}"
    opened.figures.ask = lambda _: wish
    opened.actions_table["export_figure"].trigger()
    assert answers.exported.stat().st_size > 500
    assert answers.suggested.suffix == suffix
    assert FigureWish.of(opened.settings.figure) == wish
    if suffix == ".svg":
        assert re.search(rb'width="70mm"', answers.exported.read_bytes())


def test_a_figure_with_too_many_pixels_is_told_and_not_written(opened, answers, tmp_path):
    wish = replace(FigureWish(), suffix=".png", resolution=2400.0, form=FigureForm(1500.0))
    opened.figures.ask = lambda _: wish
    answers.exported = tmp_path / "figure.png"
    opened.figures.export()
    assert answers.errors and answers.errors[0].endswith("million are the most.")
    assert not answers.exported.exists()


def test_nothing_happens_when_the_dialog_is_left(opened, answers, tmp_path):
    opened.figures.ask = lambda _: None
    answers.exported = tmp_path / "figure.pdf"
    opened.figures.export()
    assert not answers.exported.exists()
