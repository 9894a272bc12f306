"""A design composed into a picture of a given size: what every kind of picture draws."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from plusedit.document.design import Design
from plusedit.scene.camera import AXES, PlaneCamera, Projection
from plusedit.scene.framing import framed
from plusedit.scene.graduation import graduation
from plusedit.scene.items import Item, Segments
from plusedit.scene.options import ViewOptions, options_of
from plusedit.scene.scene import Layers, scene_items

SIZE = (1200, 800)  # pixels, where nobody asks for another
MARGIN = 0.04  # of the shorter side
LEAST_MARGIN = 8.0  # pixels


@dataclass(frozen=True, eq=False)
class Composition:
    """What a picture shows."""

    camera: PlaneCamera
    options: ViewOptions
    grid: tuple[Item, ...]
    """where the design asks for one; below all layers"""
    layers: Layers

    def __iter__(self) -> Iterator[Item]:
        return chain(self.grid, self.layers)


def composed(
    design: Design, size: tuple[float, float], projection: Projection | None = None
) -> Composition:
    """All of the design, with the overlays and control lines that it says itself.

    It is seen in that projection, or else as its own plane view sees it. The grid is shown only
    where the design asks for it; nothing is selected.
    """
    options = replace(options_of(design.view), grid=design.view.get("grid") is True, rulers=False)
    view = design.view.get("camera")
    kept = view.get("projection") if isinstance(view, dict) else None
    camera = PlaneCamera(size)
    for wanted in (kept, projection):
        if wanted in AXES:
            camera = replace(camera, projection=wanted)
    margin = max(LEAST_MARGIN, MARGIN * min(size))
    camera = framed(design, camera, options, margin=min(margin, min(size) / 4.0))
    grid = tuple(_grid(camera)) if options.grid else ()
    return Composition(camera, options, grid, scene_items(design, camera, options))


def _grid(camera: PlaneCamera) -> Iterator[Item]:
    """Minor and major lines, in the middle of pixels so that they are crisp."""
    marks = graduation(camera.pixel)
    low, high = camera.window
    lines = [marks.between(float(low[side]), float(high[side])) for side in (0, 1)]
    for kind, color in ((1, "minor"), (0, "major")):
        for side in (0, 1):
            at = np.zeros((len(lines[side][kind]), 2))
            at[:, side] = lines[side][kind]
            screen = np.floor(camera.to_screen(camera.placed(at))) + 0.5
            starts, ends = screen.copy(), screen
            starts[:, 1 - side], ends[:, 1 - side] = 0.0, camera.size[1 - side]
            yield Segments(
                camera.placed(camera.in_plane(starts)), camera.placed(camera.in_plane(ends)), color
            )
