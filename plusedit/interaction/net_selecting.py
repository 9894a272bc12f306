"""Actions that select along control nets: rows, columns, neighbors."""

from collections.abc import Callable

import numpy as np

from plusedit.commands.planes import row_numbers
from plusedit.document.design import EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.shape import Geometry, PlusGeometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface, Way
from plusedit.interaction.actions import EditAction
from plusedit.interaction.tool import Outcome, Stage


def chosen_planes(stage: Stage) -> dict[ShapeId, tuple[int, ...]]:
    """The active control plane, or where none is active every selected one, by shape.

    EditError if there is none that can be edited.
    """
    active = stage.selection.active
    by_shape = {active.shape: (active.number,)} if active else stage.selection.by_shape()
    found = {
        shape_id: rows
        for shape_id, rows in by_shape.items()
        if stage.design[shape_id].surface is not None and stage.design[shape_id].editable
    }
    if not found:
        raise EditError("Select a control plane of a surface first.")
    return found


def select_rows(stage: Stage, way: Way) -> Outcome:
    """The row of the active plane, or its column where the way is "v"; else those of all selected.

    A row is the planes of one node by u, a column those of one node by v.
    """
    lines: set[LineId] = set()
    for shape_id, numbers in chosen_planes(stage).items():
        shape = stage.design.surface(shape_id).planes.shape
        for place in {place_of(shape, number, way) for number in numbers}:
            found = row_numbers(shape, way, place).tolist()
            lines |= {LineId(shape_id, number) for number in found}
    return Selection.of_lines(lines, stage.selection.active)


def place_of(shape: tuple[int, int], number: int, way: Way) -> int:
    """Which row a plane is in, or which column where the way is "v"."""
    return number // shape[1] if way == "u" else number % shape[1]


def grow(stage: Stage) -> Outcome:
    """What is selected and its neighbors: along a curve, all round in a net or on a mesh."""
    return _resized(stage, lambda geometry, chosen: chosen | beside(geometry, chosen))


def shrink(stage: Stage) -> Outcome:
    """What is selected, but for those beside one that is not."""
    return _resized(stage, lambda geometry, chosen: chosen & ~beside(geometry, ~chosen))


def _resized(stage: Stage, change: Callable[[Geometry, Flags], Flags]) -> Outcome:
    lines: set[LineId] = set()
    chosen_lines = stage.selection.by_shape()
    for shape_id, numbers in chosen_lines.items():
        geometry = stage.design[shape_id].geometry
        chosen = np.zeros(stage.design[shape_id].element_count, dtype=np.bool_)
        chosen[list(numbers)] = True
        after = np.flatnonzero(change(geometry, chosen)).tolist()
        lines |= {LineId(shape_id, number) for number in after}
    if not chosen_lines:
        raise EditError("Select control lines or control planes first.")
    if not lines:
        raise EditError("The selection can't get any smaller.")
    return Selection.of_lines(lines, stage.selection.active)


def beside(geometry: Geometry, chosen: Flags) -> Flags:
    """(n,) which lines or planes are next to one of the chosen (n,), round the seam too.

    Faces are next to each other where they have a vertex in common.
    """
    if isinstance(geometry, MeshSurface):
        return _touching(geometry.mesh, chosen)
    grid = chosen.reshape(_shape(geometry))
    found = np.zeros_like(grid)
    closed = (geometry.closed,) if isinstance(geometry, PlusCurve) else geometry.closed
    for axis, wraps in enumerate(closed):
        for by, seam in ((1, 0), (-1, -1)):
            moved = np.roll(grid, by, axis)
            if not wraps:
                np.moveaxis(moved, axis, 0)[seam] = False
            found |= moved
    return found.ravel()


def _touching(mesh: PolygonMesh, chosen: Flags) -> Flags:
    touched = np.zeros(mesh.vertex_count, dtype=np.bool_)
    touched[mesh.corners[np.repeat(chosen, mesh.sizes)]] = True
    return np.logical_or.reduceat(touched[mesh.corners], mesh.starts[:-1])


def _shape(geometry: PlusGeometry) -> tuple[int, ...]:
    return geometry.planes.shape if isinstance(geometry, PlusSurface) else (len(geometry.net),)


ACTIONS = (
    EditAction(
        "select_row",
        "Select row of control planes",
        ("Alt+R",),
        "Select",
        lambda stage: select_rows(stage, "u"),
    ),
    EditAction(
        "select_column",
        "Select column of control planes",
        ("Alt+Shift+R",),
        "Select",
        lambda stage: select_rows(stage, "v"),
    ),
    EditAction("grow_selection", "Grow selection", ("Alt+Up",), "Select", grow),
    EditAction("shrink_selection", "Shrink selection", ("Alt+Down",), "Select", shrink),
)
