"""The shelf of panels: each module here is one dock of the window."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal, TypeAlias

from PySide6.QtWidgets import QWidget

from plusedit.registry import Registry
from plusedit.views.desk import Desk

Area: TypeAlias = Literal["left", "right", "beside", "below"]
"""Left, right of or below the views, or between the views and what is on the right."""


@dataclass(frozen=True)
class Panel:
    """A dock: where it lies, and how to make what is in it."""

    title: str
    area: Area
    order: int
    """from top to bottom"""
    make: Callable[[Desk], QWidget]
    menu: str = "Window"
    """where the switch stands that shows and hides it"""
    shortcut: str = ""
    is_shown: bool = True
    """whether it is there at the first start"""
    least_width: int = 360
    """logical pixels; where one below the views would be narrower, it becomes a tab"""


panels: Registry[Panel] = Registry("plusedit.views.panels")


def panel(
    name: str,
    *,
    title: str,
    area: Area,
    order: int,
    menu: str = "Window",
    shortcut: str = "",
    is_shown: bool = True,
    least_width: int = 360,
) -> Callable[[Callable[[Desk], QWidget]], Callable[[Desk], QWidget]]:
    """A decorator that puts a widget class, or a function that makes a widget, on the shelf."""

    def put(make: Callable[[Desk], QWidget]) -> Callable[[Desk], QWidget]:
        entry = Panel(title, area, order, make, menu, shortcut, is_shown, least_width)
        panels.register(name)(entry)
        return make

    return put
