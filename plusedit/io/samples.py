"""Points and derivatives of a design at given parameters, as a tree of numbers."""

from collections.abc import Mapping

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Json, NotDrawn, Shape, ShapeId, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.io.fields import numbers, object_of, required, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import parse, shown

KEYS = ("position", "d1", "d2")

Places = Mapping[ShapeId, Floats]
"""Parameters by shape."""


def everywhere(design: Design, count: int) -> Places:
    """`count` evenly spaced parameters for every curve."""
    return {shape_id: np.linspace(0.0, 1.0, count) for shape_id, _ in design.curves()}


def places_in(data: bytes, name: str, design: Design) -> Places:
    """The parameters that a file of that name says: {"wing": {"u": [0, 0.5]}}.

    FormatError if it names a shape that the design has not, or one that is no curve.
    """
    places: dict[ShapeId, Floats] = {}
    with within(name):
        for key, value in object_of(parse(data), "parameters").items():
            places[ShapeId(key)] = _parameters(key, value, design)
    return places


def samples(design: Design, name: str, places: Places, highest: int) -> Tree:
    """Of each shape the parameters, the points, and the derivatives up to the `highest`.

    FormatError, with the `name` of the design's file, if a result is beyond a double.
    """
    shapes: dict[str, Json] = {}
    with within(name):
        for shape_id, u in places.items():
            with within(f"shape {shown(shape_id)}"):
                shapes[shape_id] = _of_curve(design.curve(shape_id), u, highest)
    return {"shapes": shapes}


def left_out(design: Design, places: Places) -> list[ShapeId]:
    """The shapes that `places` does not name."""
    return [shape_id for shape_id in design if shape_id not in places]


def _parameters(key: str, value: Json, design: Design) -> Floats:
    with within(f"shape {shown(key)}"):
        if key not in design:
            raise FormatError("the design has no such shape")
        _check_curve(design[ShapeId(key)])
        tree = object_of(value, "parameters")
        if unknown := set(tree) - {"u"}:
            raise FormatError(f'{shown(min(unknown))}: a curve has the parameter "u" alone')
        row = numbers(required(tree, "u"), "u")
    return np.array(row)


def _check_curve(shape: Shape) -> None:
    if isinstance(shape.geometry, NotDrawn):
        raise FormatError(f"a {shape.geometry.kind} can't be sampled yet")


def _of_curve(curve: PlusCurve, u: Floats, highest: int) -> Tree:
    with np.errstate(all="ignore"):
        found = curve.derivatives(u, highest=highest)
    tree: dict[str, Json] = {"u": u.tolist()}
    for key, values in zip(KEYS, found, strict=False):
        finite = np.isfinite(values).all(axis=1)
        if not finite.all():
            at = float(u[int((~finite).argmax())])
            raise FormatError(f"{key}: is beyond a double at u = {at}")
        tree[key] = values.tolist()
    return tree
