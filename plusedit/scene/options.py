"""What a view shows: overlays switched on, whose control lines, and how a design keeps that."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from math import isfinite, pi
from types import MappingProxyType
from typing import Literal, TypeAlias, cast, get_args

from plusedit.document.shape import Json, Tree
from plusedit.scene.camera import LARGEST, SMALLEST, PlaneCamera, Projection
from plusedit.scene.overlays import overlays, switched
from plusedit.scene.space_camera import LARGEST as LARGEST_HEIGHT
from plusedit.scene.space_camera import SMALLEST as LEAST_HEIGHT
from plusedit.scene.space_camera import SpaceCamera

Handles: TypeAlias = Literal["auto", "selected", "all", "none"]
Shading: TypeAlias = Literal["studio", "matcap"]
ShownPanes: TypeAlias = Literal["2d", "3d", "both"]

SWITCHES = ("grid", "rulers", "snap", "ground", "isolines", "wire", "facets", "front_only")
NO_SETTINGS: Mapping[str, float] = MappingProxyType({})
FAR = 1e100  # coordinates beyond that, no view is centred on


@dataclass(frozen=True)
class ViewOptions:
    """Switches of a view; kept with the design."""

    overlays: frozenset[str] = frozenset({"classical", "polygon", "constraints"})
    """names on the shelf of overlays"""
    handles: Handles = "auto"
    """whose control lines are shown: of all shapes while they are few, else of the selected"""
    grid: bool = True
    rulers: bool = True
    snap: bool = False
    """whether points snap to the grid without Ctrl (Ctrl then frees them)"""
    ground: bool = True
    """whether the 3D view shows a grid on the ground, z = 0"""
    isolines: bool = True
    """whether surfaces show lines of constant u and of constant v"""
    wire: bool = False
    """whether the 3D view shows the mesh that surfaces are drawn as"""
    facets: bool = False
    """whether the 3D view shows meshes themselves, with flat faces, and not their surfaces"""
    front_only: bool = False
    """whether handles that a surface hides can't be picked"""
    shading: Shading = "studio"
    """how light falls on surfaces"""
    settings: Mapping[str, float] = field(default_factory=lambda: NO_SETTINGS)
    """numbers of overlays that are not as usual, by "overlay.setting" """

    def with_setting(self, name: str, value: float) -> "ViewOptions":
        """With another number of an overlay, by "overlay.setting"; the usual one is not kept."""
        settings = {**self.settings, name: value}
        if value == _usual(name):
            del settings[name]
        return replace(self, settings=MappingProxyType(settings))

    def with_overlay(self, name: str, is_on: bool) -> "ViewOptions":
        """With that overlay switched on or off; only one of those that color surfaces is on."""
        return replace(self, overlays=switched(self.overlays, name, is_on))


USUAL = ViewOptions()


def options_of(view: Tree) -> ViewOptions:
    """The options that a design keeps. What is missing or makes no sense is as usual."""
    overlays, handles, shading = view.get("overlays"), view.get("handles"), view.get("shading")
    return ViewOptions(
        frozenset(_texts(overlays)) if isinstance(overlays, list) else USUAL.overlays,
        cast(Handles, handles) if handles in get_args(Handles) else USUAL.handles,
        shading=cast(Shading, shading) if shading in get_args(Shading) else USUAL.shading,
        settings=_settings(view.get("overlay_settings")),
        **{name: _switch(view, name) for name in SWITCHES},
    )


def view_tree(
    options: ViewOptions,
    camera: PlaneCamera | None = None,
    *,
    old: Tree,
    camera_3d: SpaceCamera | None = None,
    panes: ShownPanes | None = None,
) -> Tree:
    """What a design keeps of options and cameras, in place of what `old` says of them.

    Only what is not as usual is said; keys that this program does not know stay, and so do the
    camera of the 3D view and the panes where none are given.
    """
    known = {"overlays", "overlay_settings", "handles", "shading", "camera", *SWITCHES}
    known |= {name for name, given in (("camera_3d", camera_3d), ("panes", panes)) if given}
    tree: dict[str, Json] = {key: value for key, value in old.items() if key not in known}
    if options.overlays != USUAL.overlays:
        tree["overlays"] = [*sorted(options.overlays)]
    for name in ("handles", "shading", *SWITCHES):
        if getattr(options, name) != getattr(USUAL, name):
            tree[name] = getattr(options, name)
    if options.settings:
        tree["overlay_settings"] = dict(options.settings)
    if camera is not None:
        tree["camera"] = {
            "center": list(camera.center),
            "scale": camera.scale,
            "projection": camera.projection,
        }
    if camera_3d is not None:
        tree["camera_3d"] = {
            "target": list(camera_3d.target),
            "height": camera_3d.height,
            "yaw": camera_3d.yaw,
            "pitch": camera_3d.pitch,
            "perspective": camera_3d.perspective,
        }
    if panes is not None:
        tree["panes"] = panes
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


def space_camera_of(view: Tree, size: tuple[float, float]) -> SpaceCamera | None:
    """The camera of the 3D view that a design keeps, for that size; None if it keeps none."""
    kept = view.get("camera_3d")
    if not isinstance(kept, Mapping):
        return None
    target = kept.get("target")
    if not isinstance(target, list) or len(target) != 3:
        return None
    numbers = [_number(value) for value in (*target, *map(kept.get, ("height", "yaw", "pitch")))]
    perspective = kept.get("perspective", True)
    if None in numbers or not isinstance(perspective, bool):
        return None
    x, y, z, height, yaw, pitch = cast(list[float], numbers)
    if not LEAST_HEIGHT <= height <= LARGEST_HEIGHT or abs(pitch) > pi / 2.0:
        return None
    return SpaceCamera(size, (x, y, z), height, yaw, pitch, perspective)


def panes_of(view: Tree) -> ShownPanes | None:
    """Which views a design asks for; None if it says nothing of them."""
    panes = view.get("panes")
    return cast(ShownPanes, panes) if panes in get_args(ShownPanes) else None


def _switch(view: Tree, name: str) -> bool:
    value = view.get(name)
    usual: bool = getattr(USUAL, name)
    return value if isinstance(value, bool) else usual


def _usual(name: str) -> float | None:
    """The usual number of an overlay, by "overlay.setting"; None if there is none such."""
    owner, _, own = name.partition(".")
    settings = overlays[owner].settings if owner in overlays else ()
    return next((setting.usual for setting in settings if setting.name == own), None)


def _settings(kept: Json) -> Mapping[str, float]:
    if not isinstance(kept, Mapping):
        return NO_SETTINGS
    numbers = {name: _number(value) for name, value in kept.items()}
    return MappingProxyType({name: n for name, n in numbers.items() if n is not None and n > 0.0})


def _texts(values: Iterable[Json]) -> Iterable[str]:
    return (value for value in values if isinstance(value, str))


def _number(value: Json) -> float | None:
    if isinstance(value, bool) or not isinstance(value, int | float):
        return None
    return float(value) if isfinite(value) and abs(value) <= FAR else None
