import pytest

from plusedit.scene.theme import DARK, LIGHT, THEMES, Theme

TEXT, HANDLES = 4.5, 3.0


def luminance(color):
    """Of "#rrggbb", as the accessibility guidelines (WCAG 2) define it."""
    channels = [int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]
    linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in channels]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(one, other):
    low, high = sorted([luminance(one), luminance(other)])
    return (high + 0.05) / (low + 0.05)


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
