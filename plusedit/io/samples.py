"""Points and derivatives of a design at given parameters, as a tree of numbers."""

from collections.abc import Mapping

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Json, PlusGeometry, ShapeId, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.io.fields import numbers, object_of, required, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import parse, shown

OF_CURVES = ("position", "d1", "d2")
OF_SURFACES = ("position", "du", "dv", "duu", "duv", "dvv")

MOST_PAIRS = 1_000_000  # of one surface: a few hundred megabytes of text with all derivatives

Places = Mapping[ShapeId, tuple[Floats, ...]]
"""Parameters by shape: u (m,) of a curve; u (m_u,) and v (m_v,) of a surface, for every pair."""


def everywhere(design: Design, count: int) -> Places:
    """`count` evenly spaced parameters for every curve, and as many each way for every surface."""
    even = np.linspace(0.0, 1.0, count)
    return {shape_id: (even,) * len(_names(geometry)) for shape_id, geometry in design.drawn()}


def places_in(data: bytes, name: str, design: Design) -> Places:
    """The parameters that a file of that name says: {"wing": {"u": [0, 0.5]}}.

    FormatError if it names a shape that the design has not, or one that is not drawn.
    """
    places: dict[ShapeId, tuple[Floats, ...]] = {}
    with within(name):
        for key, value in object_of(parse(data), "parameters").items():
            with within(f"shape {shown(key)}"):
                places[ShapeId(key)] = _parameters(key, value, design)
    return places


def samples(design: Design, name: str, places: Places, highest: int) -> Tree:
    """Of each shape the parameters, the points, and the derivatives up to order `highest`.

    FormatError, with the `name` of the design's file, if a result is beyond a double, or if there
    are too many.
    """
    shapes: dict[str, Json] = {}
    with within(name):
        for shape_id, parameters in places.items():
            with within(f"shape {shown(shape_id)}"):
                shapes[shape_id] = _of(design.plus(shape_id), parameters, highest)
    return {"shapes": shapes}


def left_out(design: Design, places: Places) -> list[ShapeId]:
    """The shapes that `places` does not name."""
    return [shape_id for shape_id in design if shape_id not in places]


def _names(geometry: PlusGeometry) -> tuple[str, ...]:
    """Of its parameters."""
    return ("u",) if isinstance(geometry, PlusCurve) else ("u", "v")


def _parameters(key: str, value: Json, design: Design) -> tuple[Floats, ...]:
    if key not in design:
        raise FormatError("the design has no such shape")
    geometry = design[ShapeId(key)].plus
    if geometry is None:
        raise FormatError("a mesh can't be sampled yet")
    tree, names = object_of(value, "parameters"), _names(geometry)
    if unknown := set(tree) - set(names):
        whose = 'curve has the parameter "u"' if names == ("u",) else 'surface has "u" and "v"'
        raise FormatError(f"{shown(min(unknown))}: a {whose} alone")
    return tuple(np.array(numbers(required(tree, name), name)) for name in names)


def _of(geometry: PlusGeometry, parameters: tuple[Floats, ...], highest: int) -> Tree:
    if len(parameters) == 2:
        _check_pairs(*map(len, parameters))
    with np.errstate(all="ignore"):
        found = geometry.derivatives(*parameters, highest=highest)
    names = _names(geometry)
    keys = OF_CURVES if isinstance(geometry, PlusCurve) else OF_SURFACES
    tree: dict[str, Json] = {n: u.tolist() for n, u in zip(names, parameters, strict=True)}
    for key, values in zip(keys, found, strict=False):
        finite = np.isfinite(values).all(axis=-1)
        if not finite.all():
            place = np.unravel_index(int((~finite).argmax()), finite.shape)
            at = [f"{n} = {float(u[i])}" for n, u, i in zip(names, parameters, place, strict=True)]
            raise FormatError(f"{key}: is beyond a double at {', '.join(at)}")
        tree[key] = values.tolist()
    return tree


def _check_pairs(of_u: int, of_v: int) -> None:
    if of_u * of_v > MOST_PAIRS:
        raise FormatError(f"{of_u} x {of_v} parameters are too many: more than {MOST_PAIRS} pairs")
