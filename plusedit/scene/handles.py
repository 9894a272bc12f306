"""Control lines as they stand on the screen: where the dots and grips are.

Control line i is drawn as the segment P_i -+ h g_i, h the spacing of the nodes, with a grip at
each end. Seen from the side it is never shorter than 24 nor longer than 160 pixels, so that it can
always be gripped; the direction is what counts, which both ends show. At a slant it is seen
shorter, but never than 24 pixels; only as it turns end on its grips go into the dot, and come out
again on the other side. Drawing and picking read the same handles.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.curve import PlusCurve
from plusedit.scene.camera import Camera
from plusedit.scene.options import ViewOptions

SHORTEST, LONGEST = 24.0, 160.0  # pixels from grip to grip
END_ON = 1e-3  # foreshortening beyond which a direction is seen as a point
STEEP = 0.05  # foreshortening down to which the shortest length is kept to, against all depth
ALL_UP_TO = 200  # control lines and planes of a design, or of a mesh, whose handles are all shown
SEVERAL = 12  # selected faces of a large mesh that all have handles: more would cover each other
PROBE = 100.0  # pixels over which foreshortening is measured: many, so that rounding is lost


@dataclass(frozen=True, eq=False)
class Handles:
    """The control lines of one curve in pixels of the view, to the right and downwards."""

    points: Floats
    """(n, 2) the dots, at the P_i"""
    tips: Floats
    """(2, n, 2) the grips: tips[0] on the side of +d_i, tips[1] on that of -d_i"""
    drawn: NDArray[np.bool_]
    """(n,) false where the direction is zero or seen end on: no segment and no grips there"""
    limited: NDArray[np.bool_]
    """(n,) true where the segment is not as long as it would be by itself"""
    arms: Floats
    """(n, dim) from P_i to tips[0], in the world"""
    full: Floats
    """(n, dim) h |s| d_i: the arms as they would be by themselves, in the world"""


@lru_cache(maxsize=256)
def handles(curve: PlusCurve, camera: Camera) -> Handles:
    """Where the dots and grips of a curve stand in that view."""
    points, directions = curve.lines.points, curve.directions
    full = curve.spacing * abs(curve.s) * directions
    ways, pixel = unit(directions), camera.pixel_at(points)
    at = camera.to_screen(points)
    seen = foreshortening(points, ways, pixel, camera)
    is_drawn = seen > END_ON
    whole = np.linalg.norm(full, axis=1) / pixel
    length = np.clip(whole, SHORTEST / 2.0, LONGEST / 2.0)
    length = np.maximum(length, SHORTEST / 2.0 / np.maximum(seen, STEEP))
    arms = ways * np.where(is_drawn, length * pixel, 0.0)[:, None]
    tips = np.stack([camera.to_screen(points + arms), camera.to_screen(points - arms)])
    tips[:, ~is_drawn] = at[~is_drawn]
    return Handles(at, tips, is_drawn, is_drawn & (length != whole), arms, full)


def foreshortening(points: Floats, ways: Floats, pixel: Floats, camera: Camera) -> Floats:
    """(n,) by how much unit vectors (n, dim) at points (n, dim) are seen shorter than they are.

    0 for one that is seen end on, 1 for one across the view; `pixel` (n,) is its length there.
    """
    half = ways * (PROBE / 2.0 * pixel)[:, None]
    seen = camera.to_screen(points + half) - camera.to_screen(points - half)
    lengths: Floats = np.hypot(seen[:, 0], seen[:, 1]) / PROBE
    return lengths


def handle_shapes(
    design: Design, selection: Selection, options: ViewOptions
) -> tuple[ShapeId, ...]:
    """The shapes whose control lines or planes are shown, back to front: only editable ones.

    Of a mesh of many faces planes are shown only where some are selected.
    """
    if options.handles == "none":
        return ()
    free = {i: shape for i, shape in design.shapes.items() if shape.editable}
    counts = {i: shape.element_count for i, shape in free.items() if not has_many_faces(shape)}
    everyone = options.handles == "all" or (
        options.handles == "auto" and sum(counts.values()) <= ALL_UP_TO
    )
    chosen = selection.by_shape()
    return tuple(
        i for i in free if i in chosen or (i in counts and (everyone or i in selection.shapes))
    )


def has_many_faces(shape: Shape) -> bool:
    """Whether it is a mesh of so many that not all of their planes are ever shown."""
    return shape.mesh is not None and shape.element_count > ALL_UP_TO


Handled: TypeAlias = tuple[ShapeId, tuple[int, ...] | None]
"""A shape, and the numbers of the lines or planes of it that are shown; None: all of them."""


def handled(design: Design, selection: Selection, options: ViewOptions) -> tuple[Handled, ...]:
    """The control lines and planes that are shown, by shape, back to front."""
    shapes = handle_shapes(design, selection, options)
    return tuple((i, faces_handled(design, i, selection)) for i in shapes)


def faces_handled(
    design: Design, shape_id: ShapeId, selection: Selection
) -> tuple[int, ...] | None:
    """Of a mesh of many faces the selected ones, or of many of those the leading one; else None."""
    if not has_many_faces(design[shape_id]):
        return None
    chosen = selection.by_shape().get(shape_id, ())
    if len(chosen) <= SEVERAL:
        return chosen
    leading = selection.leading
    return (leading.number,) if leading is not None and leading.shape == shape_id else ()
