import pytest

from plusedit.scene.theme import DARK, LEAST, LIGHT, THEMES, Theme, contrast

TEXT, HANDLES = 4.5, 3.0


def seen(theme, role):
    """The color of a role on the canvas, its opacity taken into account."""
    color, ground = theme.color(role), theme.color("canvas")
    share = int(color[7:] or "FF", 16) / 255.0
    mixed = [
        round(share * int(color[i : i + 2], 16) + (1.0 - share) * int(ground[i : i + 2], 16))
        for i in (1, 3, 5)
    ]
    return "#" + "".join(f"{value:02X}" for value in mixed)


every_theme = pytest.mark.parametrize("theme", THEMES.values(), ids=list(THEMES))


@every_theme
@pytest.mark.parametrize("role", ["text", "quiet"])
@pytest.mark.parametrize("ground", ["canvas", "window", "panel"])
def test_text_can_be_read_on_every_ground(theme, role, ground):
    assert contrast(theme.color(role), theme.color(ground)) >= TEXT


@every_theme
@pytest.mark.parametrize("role", ["line", "line@60", "selected", "plus", "classical"])
def test_what_is_edited_stands_out_from_the_canvas(theme, role):
    assert contrast(seen(theme, role), theme.color("canvas")) >= HANDLES


def test_a_color_can_be_made_fainter():
    theme = Theme("test", {"line": "#102030", "veil": "#10203080"})
    assert theme.color("line") == "#102030"
    assert theme.color("line@50") == "#10203080"
    assert theme.color("veil@50") == "#10203040"
    assert theme.color("#AABBCC@0") == "#AABBCC00"


def test_an_unknown_role_is_an_error():
    with pytest.raises(KeyError):
        LIGHT.color("nothing")


def test_both_themes_have_the_same_roles():
    assert set(LIGHT.colors) == set(DARK.colors)


@pytest.mark.parametrize(("theme", "own"), [(DARK, "#000000"), (LIGHT, "#FFFFFF")])
def test_a_curve_in_the_color_of_the_canvas_is_seen_where_one_works(theme, own):
    assert theme.color(own) == own
    assert contrast(theme.legible().color(own), theme.color("canvas")) >= LEAST
    assert theme.legible().color(own + "80").endswith("80")


@every_theme
def test_colors_that_are_seen_stay_as_they_are(theme):
    assert theme.legible().color("#C8372D") == "#C8372D"


def test_black_on_white_has_the_greatest_contrast():
    assert contrast("#000000", "#FFFFFF") == pytest.approx(21.0)
    assert contrast("#123456", "#123456") == 1.0
