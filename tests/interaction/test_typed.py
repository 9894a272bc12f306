import pytest

from plusedit.interaction.typed import NOTHING_TYPED


def typed(keys):
    state = NOTHING_TYPED
    for key in keys:
        state = state.after(key)
    return state.values


@pytest.mark.parametrize(
    "keys, values",
    [
        ("", ()),
        ("-", ()),
        (".", ()),
        ("12", (12.0, None)),
        ("1.5", (1.5, None)),
        ("1,5", (1.5, None)),
        (".5", (0.5, None)),
        ("5-", (-5.0, None)),
        ("-5-", (5.0, None)),
        ("1.2.3", (1.23, None)),
        (["1", "Tab", "2"], (1.0, 2.0)),
        (["Tab", "2"], (None, 2.0)),
        (["1", "Tab", "2", "Tab", "3"], (13.0, 2.0)),
        (["1", "2", "Backspace"], (1.0, None)),
        (["1", "Backspace"], ()),
        (["Backspace"], ()),
    ],
)
def test_keys_make_numbers_field_by_field(keys, values):
    assert typed(keys) == values


def test_a_key_that_is_no_part_of_a_number_is_not_taken():
    assert all(NOTHING_TYPED.after(key) is None for key in ("A", "Enter", "Escape", "", "é"))


def test_no_number_of_digits_overflows():
    (value, _) = typed("9" * 400)
    assert value < 1e25
