"""The program's own format: a design as one JSON document.

A file is taken whole or not at all. Keys that mean nothing to this program are kept and written
back, at the top, in shapes, in bases and in styles.
"""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Json, Shape, ShapeId, Style, Tree
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.io.constraint_fields import KEY as CONSTRAINTS
from plusedit.io.constraint_fields import constraint_trees, read_constraints
from plusedit.io.curve_fields import CURVE_KEYS, curve_tree, read_curve
from plusedit.io.fields import (
    Object,
    check_kept,
    expected,
    flag,
    kept,
    nested,
    number,
    object_of,
    required,
    text,
    within,
)
from plusedit.io.formats import FormatError, Loaded, register
from plusedit.io.json_text import document, parse, shown
from plusedit.io.mesh_fields import MESH_KEYS, mesh_tree, read_mesh_surface
from plusedit.io.surface_fields import SURFACE_KEYS, read_surface, surface_tree

FORMAT = "plusedit-design"
VERSION = 1

TOP = frozenset({"format", "version", "shapes", "view"})
SHARED = frozenset({"id", "kind", "name", "visible", "locked", "style", CONSTRAINTS})
STYLE = frozenset({"color", "width", "facets"})

KEYS = {"curve": CURVE_KEYS, "surface": SURFACE_KEYS, "mesh": MESH_KEYS}
"""By kind: what a shape has besides what all have."""

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
    return Loaded(design)


def dumps(design: Design) -> bytes:
    """The document of a design, for `loads` to make the same design of it, bit for bit."""
    tree: dict[str, object] = {"format": FORMAT, "version": VERSION}
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
    if kind not in KEYS:
        raise expected("kind", '"curve", "surface" or "mesh"', kind)
    geometry, of_keys = _geometry(kind, tree)
    unknown = kept(tree, SHARED | KEYS[kind])
    style, of_style = _style(tree.get("style", {}))
    wishes, of_wishes = read_constraints(tree.get(CONSTRAINTS, []), geometry)
    nested_keys: dict[str, Json] = {**of_keys, "style": of_style, CONSTRAINTS: of_wishes}
    inside = {key: found for key, found in nested_keys.items() if found}
    return Shape(
        geometry,
        name=text(tree.get("name", shape_id), "name"),
        visible=flag(tree.get("visible", True), "visible"),
        locked=flag(tree.get("locked", False), "locked"),
        style=style,
        extra=MappingProxyType({**unknown, **inside}),
        constraints=wishes,
    )


def _geometry(kind: str, tree: Object) -> tuple[Geometry, dict[str, Object]]:
    """What `tree` says to draw, and what else stands under its keys, by those."""
    if kind == "curve":
        return read_curve(tree)
    if kind == "surface":
        return read_surface(tree)
    return read_mesh_surface(tree)


def _style(value: Json) -> tuple[Style, Object]:
    tree = object_of(value, "style")
    with within("style"):
        style = Style(
            text(tree["color"], "color") if "color" in tree else None,
            number(tree["width"], "width") if "width" in tree else None,
            flag(tree.get("facets", False), "facets"),
        )
        unknown = kept(tree, STYLE)
    return style, unknown


def _shape_tree(shape_id: ShapeId, shape: Shape) -> Mapping[str, object]:
    kind, own = _own_tree(shape)
    tree: dict[str, object] = {"id": shape_id, "kind": kind}
    if shape.name != shape_id:
        tree["name"] = shape.name
    if not shape.visible:
        tree["visible"] = False
    if shape.locked:
        tree["locked"] = True
    style = _style_tree(shape.style, nested(shape.extra, "style"))
    if style:
        tree["style"] = style
    if wishes := constraint_trees(shape.constraints, shape.extra.get(CONSTRAINTS)):
        tree[CONSTRAINTS] = wishes
    return {**tree, **own, **_without(shape.extra, SHARED | KEYS[kind])}


def _own_tree(shape: Shape) -> tuple[str, Mapping[str, object]]:
    """Its kind, and what only shapes of that kind have."""
    geometry = shape.geometry
    if isinstance(geometry, PlusCurve):
        return "curve", curve_tree(geometry, shape.extra)
    if isinstance(geometry, PlusSurface):
        return "surface", surface_tree(geometry, shape.extra)
    return "mesh", mesh_tree(geometry, shape.extra)


def _style_tree(style: Style, extra: Tree) -> Tree:
    said = {"color": style.color, "width": style.width, "facets": style.facets or None}
    return {**{k: v for k, v in said.items() if v is not None}, **_without(extra, STYLE)}


def _without(tree: Tree, known: frozenset[str]) -> Tree:
    return {key: value for key, value in tree.items() if key not in known}
