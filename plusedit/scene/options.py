"""What a view shows: overlays switched on, whose control lines, and how a design keeps that."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from math import isfinite
from typing import Literal, TypeAlias, cast, get_args

from plusedit.document.shape import Json, Tree
from plusedit.scene.camera import LARGEST, SMALLEST, PlaneCamera, Projection

Handles: TypeAlias = Literal["auto", "selected", "all", "none"]

SWITCHES = ("grid", "rulers", "snap")
FAR = 1e100  # coordinates beyond that, no view is centred on


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

    def with_overlay(self, name: str, is_on: bool) -> "ViewOptions":
        """With that overlay switched on or off."""
        overlays = self.overlays | {name} if is_on else self.overlays - {name}
        return replace(self, overlays=overlays)


USUAL = ViewOptions()


def options_of(view: Tree) -> ViewOptions:
    """The options that a design keeps. What is missing or makes no sense is as usual."""
    overlays, handles = view.get("overlays"), view.get("handles")
    return ViewOptions(
        frozenset(_texts(overlays)) if isinstance(overlays, list) else USUAL.overlays,
        cast(Handles, handles) if handles in get_args(Handles) else USUAL.handles,
        **{name: _switch(view, name) for name in SWITCHES},
    )


def view_tree(options: ViewOptions, camera: PlaneCamera | None = None, *, old: Tree) -> Tree:
    """What a design keeps of options and camera, in place of what `old` says of them.

    Only what is not as usual is said; keys that this program does not know stay.
    """
    tree: dict[str, Json] = {
        key: value
        for key, value in old.items()
        if key not in ("overlays", "handles", "camera", *SWITCHES)
    }
    if options.overlays != USUAL.overlays:
        tree["overlays"] = [*sorted(options.overlays)]
    if options.handles != USUAL.handles:
        tree["handles"] = options.handles
    for name in SWITCHES:
        if getattr(options, name) != getattr(USUAL, name):
            tree[name] = getattr(options, name)
    if camera is not None:
        tree["camera"] = {
            "center": list(camera.center),
            "scale": camera.scale,
            "projection": camera.projection,
        }
    return tree


def camera_of(view: Tree, size: tuple[float, float]) -> PlaneCamera | None:
    """The camera that a design keeps, for a view of that size; None if it keeps none."""
    kept = view.get("camera")
    if not isinstance(kept, Mapping):
        return None
    center, scale = kept.get("center"), _number(kept.get("scale"))
    projection = kept.get("projection", "top")
    if not isinstance(center, list) or len(center) != 2 or scale is None:
        return None
    x, y = _number(center[0]), _number(center[1])
    if x is None or y is None or not SMALLEST <= scale <= LARGEST:
        return None
    if projection not in get_args(Projection):
        return None
    return PlaneCamera(size, (x, y), scale, cast(Projection, projection))


def _switch(view: Tree, name: str) -> bool:
    value = view.get(name)
    usual: bool = getattr(USUAL, name)
    return value if isinstance(value, bool) else usual


def _texts(values: Iterable[Json]) -> Iterable[str]:
    return (value for value in values if isinstance(value, str))


def _number(value: Json) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if isfinite(value) and abs(value) <= FAR else None
