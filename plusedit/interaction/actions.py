"""Everything that a key or a menu can do to a design, as data.

Menus, the palette and the shortcut editor are made of `edit_actions`; what needs a window, such
as Open or Undo, is not among them. Shortcuts are in Qt's portable notation.
"""

from collections.abc import Callable
from dataclasses import dataclass

from plusedit.interaction.tool import Outcome, Stage


@dataclass(frozen=True)
class EditAction:
    """One entry of a menu."""

    name: str
    """for settings: never changed, never shown"""
    title: str
    shortcuts: tuple[str, ...]
    """by default; the first is shown"""
    menu: str
    """where it stands, such as "Curve" or "Curve/Order" """
    make: Callable[[Stage], Outcome]
    """what it does there. EditError says in a sentence why it can't be done"""

    @property
    def shortcut(self) -> str:
        """The first shortcut, or ""."""
        return self.shortcuts[0] if self.shortcuts else ""


def edit_actions() -> list[EditAction]:
    """All of them, in the order of the menus."""
    from plusedit.interaction import (
        arranging,
        constraint_actions,
        curve_actions,
        face_actions,
        fit_actions,
        line_actions,
        magnitude_actions,
        making_actions,
        net_selecting,
        selecting,
        surface_actions,
    )

    modules = (
        selecting,
        net_selecting,
        line_actions,
        magnitude_actions,
        curve_actions,
        fit_actions,
        making_actions,
        surface_actions,
        face_actions,
        constraint_actions,
        arranging,
    )
    return [action for module in modules for action in module.ACTIONS]
