"""A design composed into a picture of space of a given size."""

from collections.abc import Iterator
from dataclasses import dataclass, replace

from plusedit.document.design import Design
from plusedit.scene.composition import LEAST_MARGIN, MARGIN
from plusedit.scene.items import Item
from plusedit.scene.options import ViewOptions, options_of, space_camera_of
from plusedit.scene.space_camera import STANDARD, SpaceCamera
from plusedit.scene.space_framing import framed_in_space
from plusedit.scene.space_scene import SpaceLayers, space_items


@dataclass(frozen=True, eq=False)
class SpaceComposition:
    """What a picture of space shows."""

    camera: SpaceCamera
    options: ViewOptions
    """`ground` only where the design asks for it"""
    layers: SpaceLayers

    def __iter__(self) -> Iterator[Item]:
        return iter(self.layers)


def composed_in_space(
    design: Design, size: tuple[float, float], view: str | None = None, *, wait: bool = True
) -> SpaceComposition:
    """All of the design, with the overlays and handles that it says itself.

    It is looked at from the named `view`, or else as the design's own 3D view looks, from wherever
    it is; "iso" where the design says nothing. Nothing is selected. Without `wait` surfaces of
    meshes are as they are known by now. KeyError for an unknown view.
    """
    options = replace(options_of(design.view), ground=design.view.get("ground") is True)
    camera = camera_of_view(design, size, view)
    margin = max(LEAST_MARGIN, MARGIN * min(size))
    camera = framed_in_space(design, camera, options, margin=min(margin, min(size) / 4.0))
    return SpaceComposition(camera, options, space_items(design, camera, options, wait=wait))


def camera_of_view(design: Design, size: tuple[float, float], view: str | None) -> SpaceCamera:
    """The camera of the named view, or else the design's own. KeyError for an unknown view."""
    if view is not None and view not in STANDARD:
        raise KeyError(f"no view {view!r}; there are: {', '.join(STANDARD)}")
    kept = space_camera_of(design.view, size) if view is None else None
    return kept or SpaceCamera.standard(view or "iso", size)
