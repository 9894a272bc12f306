"""The shelf of panels: each module here is one dock of the window."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from PySide6.QtWidgets import QWidget

from plusedit.registry import Registry
from plusedit.views.desk import Desk


@dataclass(frozen=True)
class Panel:
    """A dock: where it lies, and how to make what is in it."""

    title: str
    area: Literal["left", "right"]
    order: int
    """from top to bottom"""
    make: Callable[[Desk], QWidget]


panels: Registry[Panel] = Registry("plusedit.views.panels")


def panel(
    name: str, *, title: str, area: Literal["left", "right"], order: int
) -> Callable[[Callable[[Desk], QWidget]], Callable[[Desk], QWidget]]:
    """A decorator that puts a widget class, or a function that makes a widget, on the shelf."""

    def put(make: Callable[[Desk], QWidget]) -> Callable[[Desk], QWidget]:
        panels.register(name)(Panel(title, area, order, make))
        return make

    return put
