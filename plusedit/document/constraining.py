"""Designs whose shapes keep their constraints, whatever an edit did to them."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design, changed
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.constraints import Constrained, Wish, constraints
from plusedit.geometry.keeping import Keeping, kept
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface_tangency import CORNERS

OldNumbers = Mapping[ShapeId, NDArray[np.intp]]
"""For shapes whose control lines or planes got other numbers, the old number of each that it has
now; -1 for new ones."""

_PROBLEMS: "WeakKeyDictionary[Shape, Mapping[Wish, str]]" = WeakKeyDictionary()
MIRRORED = {"tangent_start": "tangent_end", "tangent_end": "tangent_start"}


def enforced(old: Design, new: Design, old_numbers: Callable[[], OldNumbers]) -> Design:
    """The design after an edit, with every edited shape brought back to what it keeps.

    The very same design where nothing has to be brought back. `old_numbers` is asked only where
    some shape has constraints.
    """
    found: dict[ShapeId, Shape] = {}
    for shape_id in changed(old, new):
        shape = new.shapes.get(shape_id)
        if shape is None or shape.plus is None or not shape.constraints:
            continue
        before = old.shapes.get(shape_id)
        shape = _renumbered(shape, before, old_numbers().get(shape_id))
        keeping = _kept(shape, before)
        if keeping.geometry is not shape.geometry:
            shape = replace(shape, geometry=keeping.geometry)
        _PROBLEMS[shape] = keeping.problems
        if shape is not new[shape_id]:
            found[shape_id] = shape
    return replace(new, shapes={**new.shapes, **found}) if found else new


def problems_of(shape: Shape) -> Mapping[Wish, str]:
    """Why constraints of a shape are not kept, a sentence each; empty where all are."""
    if shape.plus is None or not shape.constraints:
        return {}
    known = _PROBLEMS.get(shape)
    if known is None:
        known = _PROBLEMS[shape] = _kept(shape, None).problems
    return known


def _kept(shape: Shape, before: Shape | None) -> Keeping:
    assert shape.plus is not None
    return kept(shape.plus, shape.constraints, None if before is None else before.plus)


def _renumbered(shape: Shape, before: Shape | None, numbers: NDArray[np.intp] | None) -> Shape:
    """The shape with its constraints at the same lines, planes and corners as before."""
    if before is None or before.plus is None or shape.plus is None:
        return shape
    if numbers is None:
        if len(before.plus.net) == len(shape.plus.net):
            return shape
        numbers = _found_again(before.plus, shape.plus)
    place = {int(number): row for row, number in enumerate(numbers) if number >= 0}
    wishes = []
    for wish in shape.constraints:
        counts = constraints[wish.kind].counts
        if counts == "elements":
            wish = Wish(wish.kind, tuple(place[i] for i in wish.numbers if i in place))
        elif counts == "corners":
            wish = Wish(wish.kind, _corners(before.plus, shape.plus, place, wish.numbers))
        elif wish.kind in MIRRORED and len(numbers) > 1 and numbers[0] > numbers[-1] >= 0:
            wish = Wish(MIRRORED[wish.kind])
        if wish.numbers or counts == "none":
            wishes.append(wish)
    return (
        shape if tuple(wishes) == shape.constraints else replace(shape, constraints=tuple(wishes))
    )


def _found_again(before: Constrained, after: Constrained) -> NDArray[np.intp]:
    """The old number of each line by its control point, where an edit doesn't tell; -1 if new."""
    known = {row.tobytes(): i for i, row in enumerate(before.net.control_points)}
    rows = after.net.control_points
    return np.array([known.get(row.tobytes(), -1) for row in rows], dtype=np.intp)


def _corners(
    before: Constrained, after: Constrained, place: Mapping[int, int], numbers: tuple[int, ...]
) -> tuple[int, ...]:
    """The corners of the net at which those corners lie now."""
    if not (isinstance(before.net, ControlPlanes) and isinstance(after.net, ControlPlanes)):
        return ()
    old, new = _corner_planes(before.net), _corner_planes(after.net)
    there = [place.get(old[number]) for number in numbers]
    # A row inserted beside a corner, or deleted at it, leaves a corner there all the same.
    return tuple(
        new.index(plane) if plane in new else number
        for plane, number in zip(there, numbers, strict=True)
    )


def _corner_planes(net: ControlPlanes) -> list[int]:
    rows, columns = net.shape
    return [u * (rows - 1) * columns + v * (columns - 1) for u, v in CORNERS]
