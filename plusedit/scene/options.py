"""What a view shows: overlays switched on, and whose control lines."""

from dataclasses import dataclass
from typing import Literal, TypeAlias

Handles: TypeAlias = Literal["auto", "selected", "all", "none"]


@dataclass(frozen=True)
class ViewOptions:
    """Switches of a view; kept with the design."""

    overlays: frozenset[str] = frozenset({"classical", "polygon"})
    """names on the shelf of overlays"""
    handles: Handles = "auto"
    """whose control lines are shown: of all shapes while they are few, else of the selected"""
    grid: bool = True
    rulers: bool = True
    snap: bool = False
    """whether points snap to the grid without Ctrl (Ctrl then frees them)"""
