"""What lies under the pointer, and inside a box.

Only what is seen and can be edited is found: dots and grips of the control lines that are shown,
then curves. All handles of a design stand in a few arrays, so that one look at ten thousand of
them is a handful of array operations.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import Camera, PlaneCamera
from plusedit.scene.drawn import Drawn, drawn
from plusedit.scene.handles import handle_shapes, handles

TIE = 0.25  # pixels: what is nearer by less counts as equally near

Kind = Literal["dot", "grip", "curve"]


@dataclass(frozen=True)
class Hit:
    """Something under the pointer."""

    kind: Kind
    shape: ShapeId
    number: int = -1
    """of the control line; -1 for a curve"""
    side: int = 0
    """of a grip: 1 where the direction points, -1 opposite"""
    u: float = 0.0
    """of a curve: the parameter nearest to the pointer"""
    distance: float = 0.0
    """in pixels"""

    @property
    def line(self) -> LineId | None:
        """The control line that was hit; None for a curve."""
        return None if self.kind == "curve" else LineId(self.shape, self.number)


@dataclass(frozen=True, eq=False)
class Field:
    """Dots, then grips, of many curves in pixels of the view."""

    at: Floats
    """(k, 2)"""
    sides: NDArray[np.int8]
    """(k,) 0 for a dot, 1 and -1 for grips"""
    owners: NDArray[np.intp]
    """(k,) which of `shapes`"""
    numbers: NDArray[np.intp]
    """(k,) of the control lines"""
    shapes: tuple[ShapeId, ...]

    @cached_property
    def x(self) -> Floats:
        """(k,) the first column of `at`, side by side in memory."""
        return np.ascontiguousarray(self.at[:, 0])


@dataclass(frozen=True, eq=False)
class Outlines:
    """Curves as segments in pixels of the view."""

    starts: Floats
    """(k, 2)"""
    ends: Floats
    parameters: Floats
    """(k, 2) at start and end"""
    owners: NDArray[np.intp]
    shapes: tuple[ShapeId, ...]

    @cached_property
    def sides(self) -> tuple[Floats, Floats]:
        """(k,) the smaller and the larger x of each segment."""
        x, y = self.starts[:, 0], self.ends[:, 0]
        return np.minimum(x, y), np.maximum(x, y)


def handles_under(
    at: Floats, stage: Stage, reach: float = REACH, *, selected_first: bool = True
) -> list[Hit]:
    """Dots and grips within `reach` pixels: nearest first, the selected first among equals."""
    shapes = handle_shapes(stage.design, stage.selection, stage.options)
    field = field_of(stage.design, shapes, stage.camera)
    # One comparison leaves few of many: the rest is worked out for those.
    rows = np.flatnonzero(np.abs(field.x - at[0]) <= reach)
    distances = np.hypot(*(field.at[rows] - at).T)
    found = [
        Hit(
            "grip" if field.sides[row] else "dot",
            field.shapes[field.owners[row]],
            int(field.numbers[row]),
            int(field.sides[row]),
            distance=float(distance),
        )
        for row, distance in zip(rows, distances, strict=True)
        if distance <= reach
    ]
    order = {shape_id: -place for place, shape_id in enumerate(field.shapes)}
    lines = stage.selection.lines if selected_first else frozenset()
    return sorted(
        found,
        key=lambda hit: (
            round(hit.distance / TIE),
            hit.line not in lines,
            hit.kind == "grip",
            order[hit.shape],
            -hit.side,
        ),
    )


def curves_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """Curves within `reach` pixels, each at its nearest parameter; nearest first, front first."""
    outlines = outlines_of(stage.design, stage.camera)
    if not len(outlines.starts):
        return []
    left, right = outlines.sides
    rows = np.flatnonzero((left <= at[0] + reach) & (right >= at[0] - reach))
    along, distances = nearest_on_segments(at, outlines.starts[rows], outlines.ends[rows])
    nearest: dict[int, Hit] = {}
    for place in np.argsort(distances, kind="stable"):
        if distances[place] > reach:
            break
        row = rows[place]
        first, last = outlines.parameters[row]
        u = float(first + along[place] * (last - first))
        owner = int(outlines.owners[row])
        hit = Hit("curve", outlines.shapes[owner], u=u, distance=float(distances[place]))
        nearest.setdefault(owner, hit)
    front = {shape_id: -place for place, shape_id in enumerate(outlines.shapes)}
    return sorted(nearest.values(), key=lambda hit: (round(hit.distance / TIE), front[hit.shape]))


def all_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """Everything within reach in an order that does not depend on what is selected."""
    dots = handles_under(at, stage, reach, selected_first=False)
    return dots + curves_under(at, stage, reach)


def under(at: Floats, stage: Stage, reach: float = REACH) -> Hit | None:
    """What a press would take."""
    found = handles_under(at, stage, reach) or curves_under(at, stage, reach)
    return found[0] if found else None


def inside(corner: Floats, other: Floats, stage: Stage) -> Selection:
    """The control lines shown whose dots lie in a box of pixels, and the curves wholly in it."""
    low, high = np.minimum(corner, other), np.maximum(corner, other)
    shapes = handle_shapes(stage.design, stage.selection, stage.options)
    field = field_of(stage.design, shapes, stage.camera)
    taken = ((field.at >= low) & (field.at <= high)).all(axis=1) & (field.sides == 0)
    lines = frozenset(
        LineId(field.shapes[field.owners[row]], int(field.numbers[row]))
        for row in np.flatnonzero(taken)
    )
    outlines = outlines_of(stage.design, stage.camera)
    ends = np.concatenate([outlines.starts, outlines.ends])
    out = ((ends < low) | (ends > high)).any(axis=1)
    reached = set(np.concatenate([outlines.owners, outlines.owners])[out].tolist())
    whole = [shape for place, shape in enumerate(outlines.shapes) if place not in reached]
    return Selection(lines, frozenset(whole))


@lru_cache(maxsize=4)
def field_of(design: Design, shapes: tuple[ShapeId, ...], camera: Camera) -> Field:
    """The dots and grips of those shapes."""
    at: list[Floats] = [np.zeros((0, 2))]
    sides, owners, numbers = ([np.zeros(0, np.intp)] for _ in range(3))
    for place, shape_id in enumerate(shapes):
        stand = handles(design.curve(shape_id), camera)
        rows, gripped = np.arange(len(stand.points)), np.flatnonzero(stand.drawn)
        at += [stand.points, stand.tips[0][gripped], stand.tips[1][gripped]]
        numbers += [rows, gripped, gripped]
        counts = (len(rows), len(gripped), len(gripped))
        sides.append(np.repeat([0, 1, -1], counts))
        owners.append(np.full(sum(counts), place))
    return Field(
        np.concatenate(at),
        np.concatenate(sides).astype(np.int8),
        np.concatenate(owners),
        np.concatenate(numbers),
        shapes,
    )


@lru_cache(maxsize=4)
def outlines_of(design: Design, camera: Camera) -> Outlines:
    """All curves that are seen and can be edited."""
    shapes: list[ShapeId] = []
    starts, ends, parameters = ([np.zeros((0, 2))] for _ in range(3))
    owners = [np.zeros(0, np.intp)]
    for shape_id, curve in design.curves():
        if design[shape_id].editable:
            shown = polyline(curve, camera)
            u, screen = shown.grid.parameters, shown.screen
            starts.append(screen[:-1])
            ends.append(screen[1:])
            parameters.append(np.stack([u[:-1], u[1:]], axis=1))
            owners.append(np.full(len(u) - 1, len(shapes)))
            shapes.append(shape_id)
    return Outlines(
        np.concatenate(starts),
        np.concatenate(ends),
        np.concatenate(parameters),
        np.concatenate(owners),
        tuple(shapes),
    )


def polyline(curve: PlusCurve, camera: Camera) -> Drawn:
    """The curve as it is drawn."""
    if isinstance(camera, PlaneCamera):
        return drawn(curve, camera)
    grid = Grid.uniform(257)
    points = curve.sample(grid)
    return Drawn(grid, points, camera.to_screen(points))


def nearest_on_segments(at: Floats, starts: Floats, ends: Floats) -> tuple[Floats, Floats]:
    """Where on each segment (0 to 1) it is nearest to a point (2,), and the distance there."""
    along = ends - starts
    square = (along**2).sum(axis=1)
    share = np.divide(
        ((at - starts) * along).sum(axis=1), square, out=np.zeros(len(starts)), where=square > 0.0
    ).clip(0.0, 1.0)
    distances: Floats = np.hypot(*(starts + share[:, None] * along - at).T)
    return share, distances


def seen_plane(camera: Camera) -> tuple[int, int]:
    """The two axes that run to the right and upwards."""
    return camera.axes if isinstance(camera, PlaneCamera) else (0, 1)


def in_world(pixels: Floats, camera: Camera) -> Floats:
    """(m, 3) points of the world, level with the origin, that are seen at pixels (m, 2)."""
    origin = np.zeros(3)
    return np.array([camera.to_world(pixel, origin) for pixel in np.asarray(pixels)])
