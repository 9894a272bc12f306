"""Points and derivatives of a design at given parameters, as a tree of numbers."""

from collections.abc import Mapping, Sequence

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Json, ShapeId, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.fields import numbers, object_of, required, rows, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import parse, shown

OF_CURVES = ("position", "d1", "d2")
OF_SURFACES = ("position", "du", "dv", "duu", "duv", "dvv")
OF_MESHES = ("position", "du", "dv")

MOST_PAIRS = 1_000_000  # of one surface: a few hundred megabytes of text with all derivatives

WHOSE = {
    ("u",): 'curve has the parameter "u"',
    ("u", "v"): 'surface has "u" and "v"',
    ("uv",): 'mesh has "uv"',
}

Places = Mapping[ShapeId, tuple[Floats, ...]]
"""Parameters by shape: u (m,) of a curve; u (m_u,) and v (m_v,) of a surface, for every pair; uv
(m, 2) of a mesh."""


def everywhere(design: Design, count: int) -> Places:
    """`count` evenly spaced parameters for every curve, and as many each way for every surface.

    For a mesh, the parameters of its vertices.
    """
    even = np.linspace(0.0, 1.0, count)
    return {
        shape_id: (even,) * len(_names(shape.geometry))
        if shape.mesh is None
        else (shape.mesh.vertex_places,)
        for shape_id, shape in design.shapes.items()
    }


def places_in(data: bytes, name: str, design: Design) -> Places:
    """The parameters that a file of that name says: {"wing": {"u": [0, 0.5]}}.

    FormatError if it names a shape that the design has not.
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
                shapes[shape_id] = _of(design[shape_id].geometry, parameters, highest)
    return {"shapes": shapes}


def _names(geometry: Geometry) -> tuple[str, ...]:
    """Of its parameters."""
    if isinstance(geometry, MeshSurface):
        return ("uv",)
    return ("u",) if isinstance(geometry, PlusCurve) else ("u", "v")


def _parameters(key: str, value: Json, design: Design) -> tuple[Floats, ...]:
    if key not in design:
        raise FormatError("the design has no such shape")
    tree, names = object_of(value, "parameters"), _names(design[ShapeId(key)].geometry)
    if unknown := set(tree) - set(names):
        raise FormatError(f"{shown(min(unknown))}: a {WHOSE[names]} alone")
    if names == ("uv",):
        return (np.array(rows(required(tree, "uv"), "uv", (2,))),)
    return tuple(np.array(numbers(required(tree, name), name)) for name in names)


def _of(geometry: Geometry, parameters: tuple[Floats, ...], highest: int) -> Tree:
    if len(parameters) == 2:
        _check_pairs(*map(len, parameters))
    with np.errstate(all="ignore"):
        keys, found = _derivatives(geometry, parameters, highest)
    names = _names(geometry)
    tree: dict[str, Json] = {n: u.tolist() for n, u in zip(names, parameters, strict=True)}
    for key, values in zip(keys, found, strict=False):
        finite = np.isfinite(values).all(axis=-1)
        if not finite.all():
            place = np.unravel_index(int((~finite).argmax()), finite.shape)
            at = [
                f"{n} = {u[i].tolist()}" for n, u, i in zip(names, parameters, place, strict=True)
            ]
            raise FormatError(f"{key}: is beyond a double at {', '.join(at)}")
        tree[key] = values.tolist()
    return tree


def _derivatives(
    geometry: Geometry, parameters: tuple[Floats, ...], highest: int
) -> tuple[Sequence[str], Sequence[Floats]]:
    """What there is up to that order, and how it is called; no second derivatives of meshes."""
    if isinstance(geometry, MeshSurface):
        found = geometry.derivatives(*parameters) if highest else (geometry.at(*parameters),)
        return OF_MESHES, found
    keys = OF_CURVES if isinstance(geometry, PlusCurve) else OF_SURFACES
    return keys, geometry.derivatives(*parameters, highest=highest)


def _check_pairs(of_u: int, of_v: int) -> None:
    if of_u * of_v > MOST_PAIRS:
        raise FormatError(f"{of_u} x {of_v} parameters are too many: more than {MOST_PAIRS} pairs")
