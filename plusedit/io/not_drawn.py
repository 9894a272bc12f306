"""Meshes in a file: kept as they came, so only what must hold of them is looked at.

Their own layer will read them; until then a file with a broken one is refused all the same, and
a whole one is written back to the last digit.
"""

from plusedit.document.shape import Json
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
    rows,
    text,
    vector,
    whole,
)
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown

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
            vector(corner, f"parameters: row {i}", 2)
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
        vector(plane[part], f"{key}: {part}", 3)
