"""Surfaces and meshes in a file: kept as they came, so only what must hold of them is looked at.

Their own layer will read them; until then a file with a broken one is refused all the same, and
a whole one is written back to the last digit.
"""

from plusedit.document.shape import Json
from plusedit.io.basis_fields import read_basis
from plusedit.io.fields import (
    Object,
    check_kept,
    counted,
    expected,
    filled,
    flag,
    number,
    object_of,
    of_number,
    positive,
    required,
    row,
    rows,
    text,
    whole,
)
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown

SURFACE_KEYS = frozenset(
    {"s", "basis_u", "basis_v", "points", "directions_u", "directions_v", "weights"}
)
MESH_KEYS = frozenset(
    {
        "vertices",
        "faces",
        "domain",
        "parameters",
        "smoothness",
        "s",
        "area_weights",
        "planes",
        "source",
    }
)
DOMAINS = {"plane": (), "cylinder": (), "torus": ("height",), "pillow": ("width",)}


def check_surface(tree: Object) -> None:
    """FormatError if the keys of a surface do not fit together."""
    number(required(tree, "s"), "s")
    points = filled(required(tree, "points"), "points")
    grid = [rows(entry, f"points: row {i}", (3,)) for i, entry in enumerate(points)]
    across = len(grid[0])
    for i, points_of_row in enumerate(grid):
        if len(points_of_row) != across:
            count = of_number(len(points_of_row), "point")
            raise FormatError(f"points: row {i} has {count}, row 0 has {across}")
    read_basis(required(tree, "basis_u"), "basis_u", len(grid))
    read_basis(required(tree, "basis_v"), "basis_v", across)
    for key in ("directions_u", "directions_v"):
        if key in tree:
            for i, entry in enumerate(counted(tree[key], key, len(grid), "rows of points")):
                _check_directions(entry, f"{key}: row {i}", across)
    if "weights" in tree:
        for i, entry in enumerate(counted(tree["weights"], "weights", len(grid), "rows of points")):
            for weight in counted(entry, f"weights: row {i}", across, "points"):
                positive(weight, f"weights: row {i}")


def _check_directions(value: Json, key: str, count: int) -> None:
    for j, entry in enumerate(counted(value, key, count, "points")):
        if entry is not None:
            _vector(entry, f"{key}: entry {j}", 3)


def check_mesh(tree: Object) -> None:
    """FormatError if the keys of a mesh do not fit together."""
    vertices = rows(required(tree, "vertices"), "vertices", (3,))
    faces = [
        _face(entry, f"faces: face {i}", len(vertices))
        for i, entry in enumerate(filled(required(tree, "faces"), "faces"))
    ]
    _check_domain(required(tree, "domain"))
    parameters = counted(required(tree, "parameters"), "parameters", len(faces), "faces")
    for i, (entry, face) in enumerate(zip(parameters, faces, strict=True)):
        for corner in counted(entry, f"parameters: row {i}", len(face), "corners"):
            _vector(corner, f"parameters: row {i}", 2)
    positive(required(tree, "smoothness"), "smoothness")
    number(tree.get("s", 1.0), "s")
    flag(tree.get("area_weights", False), "area_weights")
    for face_number, plane in object_of(tree.get("planes", {}), "planes").items():
        _check_plane(face_number, plane, len(faces))
    source = object_of(tree.get("source", {}), "source")
    check_kept(tree.get("source"), "source")
    for key in {"file", "sha256"} & source.keys():
        text(source[key], f"source: {key}")


def _face(value: Json, key: str, count: int) -> list[int]:
    corners = [whole(corner, key) for corner in filled(value, key)]
    if len(corners) < 3:
        raise FormatError(f"{key}: has {of_number(len(corners), 'corner')}, expected 3 or more")
    for corner in corners:
        if not 0 <= corner < count:
            raise FormatError(f"{key}: there is no vertex {corner}; there are {count}, from 0 on")
    return corners


def _check_domain(value: Json) -> None:
    domain = object_of(value, "domain")
    kind = text(required(domain, "kind"), "domain: kind")
    if kind not in DOMAINS:
        raise expected("domain: kind", "one of " + ", ".join(map(shown, DOMAINS)), kind)
    for key in DOMAINS[kind]:
        if key not in domain:
            raise FormatError(f"domain: {key}: is missing")
        positive(domain[key], f"domain: {key}")
    check_kept(value, "domain")


def _check_plane(face: str, value: Json, count: int) -> None:
    if not (face.isascii() and face.isdecimal()) or len(face) > 15 or int(face) >= count:
        raise FormatError(f"planes: there is no face {shown(face)}; there are {count}, from 0 on")
    key = f"planes: face {face}"
    plane = object_of(value, key)
    check_kept(value, key)
    for part in {"point", "gradient_u", "gradient_v"} & plane.keys():
        _vector(plane[part], f"{key}: {part}", 3)


def _vector(value: Json, key: str, width: int) -> None:
    found = len(row(value, key))
    if found != width:
        raise FormatError(f"{key}: has {of_number(found, 'number')}, expected {width}")
