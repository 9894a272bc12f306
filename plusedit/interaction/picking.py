"""What lies under the pointer, and inside a box.

Only what is seen and can be edited is found: dots and grips of the control lines and planes that
are shown, the gizmo, then curves and surfaces. All handles of a design stand in a few arrays, so
that one look at ten thousand of them is a handful of array operations.
"""

import numpy as np
from numpy.typing import NDArray

from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.face_picking import faces_inside, faces_under
from plusedit.interaction.facets import hidden, surfaces_under
from plusedit.interaction.gizmo_picking import gizmo_under
from plusedit.interaction.handle_field import Field, field_of
from plusedit.interaction.hits import TIE, Hit, Kind, nearest_on_segments
from plusedit.interaction.outlines import outlines_of
from plusedit.interaction.places import in_space
from plusedit.interaction.tool import REACH, Stage
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.handles import Handled, faces_handled, handled
from plusedit.scene.plane_handles import plane_handles

AHEAD = 3.0  # pixels by which dots and grips count as nearer than the gizmo around them


def handles_under(
    at: Floats, stage: Stage, reach: float = REACH, *, selected_first: bool = True
) -> list[Hit]:
    """Dots and grips within `reach` pixels: nearest first, the selected first among equals.

    Of others as near, what is nearer to the eye comes first, then what lies in front.
    """
    field = field_of(stage.design, _handled(stage), stage.camera)
    # One comparison leaves few of many: the rest is worked out for those.
    rows = np.flatnonzero(np.abs(field.x - at[0]) <= reach)
    distances = np.hypot(*(field.at[rows] - at).T)
    near = distances <= reach
    rows, distances = rows[near], distances[near]
    if len(rows):
        taken = _can_be_taken(field, rows, stage)
        rows, distances = rows[taken], distances[taken]
    found = [
        Hit(
            "grip" if field.sides[row] else "dot",
            field.shapes[field.owners[row]],
            int(field.numbers[row]),
            int(field.sides[row]),
            distance=float(distance),
            depth=float(field.depths[row]),
        )
        for row, distance in zip(rows, distances, strict=True)
    ]
    order = {shape_id: -place for place, shape_id in enumerate(field.shapes)}
    lines = stage.selection.lines if selected_first else frozenset()
    return sorted(
        found,
        key=lambda hit: (
            round(hit.distance / TIE),
            hit.line not in lines,
            hit.kind == "grip",
            hit.depth,
            order[hit.shape],
            -hit.side,
        ),
    )


def _handled(stage: Stage) -> tuple[Handled, ...]:
    return handled(stage.design, stage.selection, stage.options)


def _can_be_taken(field: Field, rows: NDArray[np.intp], stage: Stage) -> NDArray[np.bool_]:
    """Which of those rows are shown, and not hidden where the view asks for that."""
    taken = np.ones(len(rows), dtype=np.bool_)
    chosen = stage.selection.by_shape()
    for owner in np.unique(field.owners[rows]):
        shape_id = field.shapes[owner]
        geometry = stage.design[shape_id].geometry
        grips = np.flatnonzero((field.owners[rows] == owner) & (field.sides[rows] > 0))
        if not isinstance(geometry, PlusCurve) and len(grips):
            faces = faces_handled(stage.design, shape_id, stage.selection)
            at = plane_handles(geometry, stage.camera, faces)
            places = at.rows_of(field.numbers[rows[grips]])
            shown = at.gripped(chosen.get(shape_id, ()))
            taken[grips] = shown[field.sides[rows[grips]] - 1, places]
    if stage.options.front_only and not isinstance(stage.camera, PlaneCamera):
        taken &= ~np.array(hidden(field.world[rows], stage.design, stage.camera), dtype=np.bool_)
    return taken


def curves_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """Curves within `reach` pixels, each at its nearest parameter; nearest first, front first."""
    return [hit for hit in lines_under(at, stage, reach) if hit.kind == "curve"]


def lines_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """The same, and surfaces by the lines that are drawn on them."""
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
        owner = int(outlines.owners[row])
        if owner not in nearest:
            first, last = outlines.parameters[row]
            u = float(first + along[place] * (last - first))
            shape_id = outlines.shapes[owner]
            nearest[owner] = Hit(
                _kind_of(stage.design[shape_id]), shape_id, u=u, distance=float(distances[place])
            )
    front = {shape_id: -place for place, shape_id in enumerate(outlines.shapes)}
    return sorted(nearest.values(), key=lambda hit: (round(hit.distance / TIE), front[hit.shape]))


def shapes_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """Curves and surfaces: curves first, but for those that a surface hides.

    In a view of a plane surfaces are found by the lines on them only: they are seen through. But
    of a mesh that is selected the faces are found everywhere.
    """
    lines = lines_under(at, stage, reach)
    if isinstance(stage.camera, PlaneCamera):
        faces = faces_under(at, stage)
        owners = {hit.shape for hit in faces}
        return [hit for hit in lines if hit.shape not in owners] + faces
    inside = surfaces_under(at, stage)
    if not inside:
        return lines
    curves = [hit for hit in lines if hit.kind == "curve"]
    covered = [_is_hidden(hit, stage) for hit in curves]
    seen = [hit for hit, is_covered in zip(curves, covered, strict=True) if not is_covered]
    unseen = [hit for hit, is_covered in zip(curves, covered, strict=True) if is_covered]
    return seen + inside + unseen + [hit for hit in lines if hit.kind != "curve"]


def _kind_of(shape: Shape) -> Kind:
    return "curve" if shape.curve is not None else "mesh" if shape.mesh is not None else "surface"


def _is_hidden(hit: Hit, stage: Stage) -> bool:
    point = in_space(stage.design.curve(hit.shape).at([hit.u]))
    return hidden(point, stage.design, stage.camera)[0]


def all_under(at: Floats, stage: Stage, reach: float = REACH) -> list[Hit]:
    """Everything within reach in an order that does not depend on what is selected."""
    dots = handles_under(at, stage, reach, selected_first=False)
    return dots + shapes_under(at, stage, reach)


def under(at: Floats, stage: Stage, reach: float = REACH) -> Hit | None:
    """What a press would take."""
    held = handles_under(at, stage, reach)
    part = gizmo_under(at, stage, reach)
    if part is not None and not (held and held[0].distance <= part.distance + AHEAD):
        return part
    found = held or shapes_under(at, stage, reach)
    return found[0] if found else None


def inside(corner: Floats, other: Floats, stage: Stage) -> Selection:
    """The dots shown that lie in a box of pixels, and the curves and surfaces wholly in it.

    Of meshes that are selected also the faces in it, unless all of them are.
    """
    low, high = np.minimum(corner, other), np.maximum(corner, other)
    field = field_of(stage.design, _handled(stage), stage.camera)
    held = ((field.at >= low) & (field.at <= high)).all(axis=1) & (field.sides == 0)
    rows = np.flatnonzero(held)
    lines = frozenset(
        LineId(field.shapes[field.owners[row]], int(field.numbers[row]))
        for row in rows[_can_be_taken(field, rows, stage)]
    )
    outlines = outlines_of(stage.design, stage.camera)
    ends = np.concatenate([outlines.starts, outlines.ends])
    out = ((ends < low) | (ends > high)).any(axis=1)
    reached = set(np.concatenate([outlines.owners, outlines.owners])[out].tolist())
    whole = [shape for place, shape in enumerate(outlines.shapes) if place not in reached]
    return Selection(lines | faces_inside(low, high, stage), frozenset(whole))
