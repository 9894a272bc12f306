"""The program's own format: a design as one JSON document.

A file is taken whole or not at all. Keys that mean nothing to this program are kept and written
back, at the top, in shapes, in bases and in styles.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Json, NotDrawn, Shape, ShapeId, Style, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.io.basis_fields import basis_tree, read_basis
from plusedit.io.fields import (
    Object,
    check_kept,
    counted,
    expected,
    flag,
    kept,
    number,
    numbers,
    object_of,
    of_number,
    required,
    row,
    rows,
    text,
    within,
)
from plusedit.io.formats import FormatError, Loaded, register
from plusedit.io.json_text import document, parse, shown
from plusedit.io.not_drawn import MESH_KEYS, SURFACE_KEYS, check_mesh, check_surface

FORMAT = "plusedit-design"
VERSION = 1

TOP = frozenset({"format", "version", "shapes", "view"})
SHARED = frozenset({"id", "kind", "name", "visible", "locked", "style"})
CURVE = frozenset({"s", "basis", "points", "directions", "weights"})
STYLE = frozenset({"color", "width"})

CHECKS = {"surface": (check_surface, SURFACE_KEYS), "mesh": (check_mesh, MESH_KEYS)}

MIGRATIONS: dict[int, Callable[[Object], Object]] = {}
"""By version: what makes a tree of that version one of the next."""


class JsonDocument:
    """Designs as document files."""

    title = "PlusEdit design"
    suffixes = (".plus.json", ".json")
    keeps_all = True

    def read(self, data: bytes, name: str) -> Loaded:
        """The design in a file of that name. FormatError says what is wrong and where."""
        return loads(data, name)

    def write(self, design: Design) -> bytes:
        """The file of a design. FormatError if something in it is no JSON."""
        return dumps(design)


register("json")(JsonDocument())


def loads(data: bytes, name: str) -> Loaded:
    """The design that `data` says; `name` stands in front of what is wrong with it."""
    with within(name):
        tree = parse(data)
        if not isinstance(tree, dict):
            raise FormatError(f"expected an object, got {shown(tree)}")
        design = _design(up_to_date(tree))
    return Loaded(design, _notes(design))


def dumps(design: Design) -> bytes:
    """The document of a design, for `loads` to make the same design of it, bit for bit."""
    tree: dict[str, Json] = {"format": FORMAT, "version": VERSION}
    tree["shapes"] = [_shape_tree(shape_id, shape) for shape_id, shape in design.shapes.items()]
    if design.view:
        tree["view"] = design.view
    try:
        return document({**tree, **_without(design.extra, TOP)}, {"shapes": 2})
    except (ValueError, TypeError, RecursionError) as error:
        raise FormatError(f"the design can't be written as JSON: {error}") from error


def up_to_date(tree: Object) -> Object:
    """The tree as the current version would have written it."""
    if tree.get("format") != FORMAT:
        found = shown(tree["format"]) if "format" in tree else "none"
        raise FormatError(f"format: is no PlusEdit design: expected {shown(FORMAT)}, got {found}")
    version = required(tree, "version")
    if type(version) is not int or version < 1:
        raise expected("version", f"a whole number from 1 to {VERSION}", version)
    if version > VERSION:
        raise FormatError(f"version: is {shown(version)}; this program reads up to {VERSION}")
    for step in range(version, VERSION):
        tree = MIGRATIONS[step](tree)
    return tree


def _design(tree: Object) -> Design:
    entries = tree.get("shapes", [])
    if not isinstance(entries, list):
        raise expected("shapes", "a list", entries)
    shapes: dict[ShapeId, Shape] = {}
    for place, entry in enumerate(entries):
        shape_id = _id(entry, f"shapes: entry {place}")
        with within(f"shape {shown(shape_id)}"):
            if shape_id in shapes:
                raise FormatError("id: two shapes have it")
            shapes[shape_id] = _shape(shape_id, object_of(entry, "shape"))
    view = object_of(tree.get("view", {}), "view")
    check_kept(tree.get("view"), "view")
    return Design(shapes, MappingProxyType(dict(view)), MappingProxyType(dict(kept(tree, TOP))))


def _id(entry: Json, where: str) -> ShapeId:
    tree = object_of(entry, where)
    with within(where):
        shape_id = text(required(tree, "id"), "id")
    return ShapeId(shape_id)


def _shape(shape_id: ShapeId, tree: Object) -> Shape:
    kind = text(required(tree, "kind"), "kind")
    unknown: Object = {}
    of_basis: Object = {}
    if kind == "curve":
        geometry: Geometry
        geometry, of_basis = _curve(tree)
        unknown = kept(tree, SHARED | CURVE)
    elif kind in CHECKS:
        check, known = CHECKS[kind]
        check(tree)
        kept(tree, SHARED | known)
        rest = {key: value for key, value in tree.items() if key not in SHARED}
        geometry = NotDrawn(kind, MappingProxyType(rest))
    else:
        raise expected("kind", '"curve", "surface" or "mesh"', kind)
    style, of_style = _style(tree.get("style", {}))
    nested = {"basis": of_basis, "style": of_style}
    return Shape(
        geometry,
        name=text(tree.get("name", shape_id), "name"),
        visible=flag(tree.get("visible", True), "visible"),
        locked=flag(tree.get("locked", False), "locked"),
        style=style,
        extra=MappingProxyType({**unknown, **{key: tree for key, tree in nested.items() if tree}}),
    )


def _style(value: Json) -> tuple[Style, Object]:
    tree = object_of(value, "style")
    with within("style"):
        style = Style(
            text(tree["color"], "color") if "color" in tree else None,
            number(tree["width"], "width") if "width" in tree else None,
        )
        unknown = kept(tree, STYLE)
    return style, unknown


def _curve(tree: Object) -> tuple[PlusCurve, Object]:
    """The curve, and the unknown keys of its basis."""
    s = number(required(tree, "s"), "s")
    points = np.array(_at_least_two(rows(required(tree, "points"), "points", (2, 3))))
    basis, unknown = read_basis(required(tree, "basis"), "basis", len(points))
    given, automatic = np.zeros_like(points), np.ones(len(points), dtype=bool)
    if "directions" in tree:
        entries = counted(tree["directions"], "directions", len(points), "points")
        for i, entry in enumerate(entries):
            if entry is not None:
                given[i], automatic[i] = _direction(entry, i, points.shape[1]), False
    weights = None if "weights" not in tree else _weights(tree["weights"], len(points))
    return PlusCurve(basis, ControlLines(points, given, automatic, weights), s), unknown


def _at_least_two(entries: list[list[float]]) -> list[list[float]]:
    """The rows of points, if they are enough for a curve."""
    if len(entries) < 2:
        raise FormatError("points: has 1 row, a curve needs 2 or more")
    return entries


def _direction(value: Json, place: int, width: int) -> list[float]:
    direction = row(value, f"directions: row {place}")
    if len(direction) != width:
        count = of_number(len(direction), "number")
        raise FormatError(f"directions: row {place} has {count}, rows of points have {width}")
    return direction


def _weights(value: Json, count: int) -> Floats:
    weights = np.array(numbers(counted(value, "weights", count, "points"), "weights"))
    if (weights <= 0.0).any():
        place = int((weights <= 0.0).argmax())
        raise FormatError(f"weights: must be positive, number {place} is {weights[place]:g}")
    return weights


def _shape_tree(shape_id: ShapeId, shape: Shape) -> Tree:
    geometry = shape.geometry
    kind = geometry.kind if isinstance(geometry, NotDrawn) else "curve"
    tree: dict[str, Json] = {"id": shape_id, "kind": kind}
    if shape.name != shape_id:
        tree["name"] = shape.name
    if not shape.visible:
        tree["visible"] = False
    if shape.locked:
        tree["locked"] = True
    style = _style_tree(shape.style, _nested(shape.extra, "style"))
    if style:
        tree["style"] = style
    if isinstance(geometry, NotDrawn):
        return {**tree, **_without(geometry.tree, SHARED)}
    tree |= _curve_tree(geometry, _nested(shape.extra, "basis"))
    return {**tree, **_without(shape.extra, SHARED | CURVE)}


def _style_tree(style: Style, extra: Tree) -> Tree:
    said = {"color": style.color, "width": style.width}
    return {**{k: v for k, v in said.items() if v is not None}, **_without(extra, STYLE)}


def _curve_tree(curve: PlusCurve, extra: Tree) -> Tree:
    lines = curve.lines
    tree: dict[str, Json] = {"s": float(curve.s), "basis": basis_tree(curve.basis, extra)}
    tree["points"] = lines.points.tolist()
    if not lines.automatic.all():
        rows_of_lines = zip(lines.automatic.tolist(), lines.given.tolist(), strict=True)
        tree["directions"] = [None if automatic else row for automatic, row in rows_of_lines]
    if lines.weights is not None:
        tree["weights"] = lines.weights.tolist()
    return tree


def _nested(extra: Tree, key: str) -> Tree:
    value = extra.get(key)
    return value if isinstance(value, Mapping) else {}


def _without(tree: Tree, known: frozenset[str]) -> Tree:
    return {key: value for key, value in tree.items() if key not in known}


def _notes(design: Design) -> tuple[str, ...]:
    kinds = [s.geometry.kind for s in design.shapes.values() if isinstance(s.geometry, NotDrawn)]
    found = [of_number(kinds.count(kind), kind) for kind in CHECKS if kind in kinds]
    if not found:
        return ()
    return (f"{' and '.join(found)} kept as in the file, not yet drawn",)
