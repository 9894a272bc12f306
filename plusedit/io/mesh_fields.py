"""The surface of a mesh as a file says it: its keys besides those that every shape has.

Faces and parameters are rows of a row per face; as a mesh has many, they are taken at once where
all of them are what they should be, and one by one only to say which is not.
"""

from collections.abc import Mapping
from itertools import chain
from typing import Any

import numpy as np

from plusedit.document.shape import Json, Tree
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import (
    CylinderDomain,
    Domain,
    PillowDomain,
    PlaneDomain,
    TorusDomain,
)
from plusedit.geometry.mesh.mesh_surface import EditedPlane, MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh, starts_of
from plusedit.io.fields import (
    Object,
    check_kept,
    counted,
    expected,
    filled,
    flag,
    kept,
    nested,
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
from plusedit.io.json_text import Lines, shown

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
        "local_smoothness",
        "source",
    }
)
DOMAINS: dict[str, type[Domain]] = {
    domain.kind: domain for domain in (PlaneDomain, CylinderDomain, TorusDomain, PillowDomain)
}
SIZES = {"torus": ("height",), "pillow": ("width",)}
PARTS = ("point", "gradient_u", "gradient_v")
LONGEST = 10  # digits of the number of a face


def read_mesh_surface(tree: Object) -> tuple[MeshSurface, dict[str, Object]]:
    """The surface that `tree` says, and by key what else is kept: where the mesh came from, and
    unknown keys of the domain and of edited planes."""
    vertices = _vertices(required(tree, "vertices"))
    corners, sizes = _faces(required(tree, "faces"), len(vertices))
    domain, of_domain = _domain(required(tree, "domain"))
    parameters = _parameters(required(tree, "parameters"), sizes)
    smoothness = positive(required(tree, "smoothness"), "smoothness")
    s = number(tree.get("s", 1.0), "s")
    area_weights = flag(tree.get("area_weights", False), "area_weights")
    edited, of_planes = _planes(tree.get("planes", {}), len(sizes))
    factors = _factors(tree.get("local_smoothness", {}), len(sizes))
    source = _source(tree.get("source", {}))
    mesh = PolygonMesh(vertices, np.array(corners, np.int32), starts_of(np.array(sizes)))
    surface = MeshSurface(mesh, domain, parameters, smoothness, s, area_weights, edited, factors)
    _check_extent(surface)
    return surface, {"domain": of_domain, "planes": of_planes, "source": source}


def mesh_tree(surface: MeshSurface, extra: Tree) -> Mapping[str, object]:
    """What a file says of `surface`; `extra` holds what else was kept, by key."""
    mesh, domain = surface.mesh, surface.domain
    tree: dict[str, object] = {"vertices": _rows(mesh.vertices)}
    tree["faces"] = _of_faces("%d", mesh, mesh.corners.tolist())
    tree["domain"] = {"kind": domain.kind, **domain.sizes, **nested(extra, "domain")}
    tree["parameters"] = _of_faces("[%s, %s]", mesh, _words(surface.parameters))
    tree["smoothness"] = float(surface.smoothness)
    tree["s"] = float(surface.s)
    tree["area_weights"] = surface.area_weights
    if surface.edited:
        of_planes = nested(extra, "planes")
        tree["planes"] = {
            str(face): {**_plane_tree(plane), **nested(of_planes, str(face))}
            for face, plane in sorted(surface.edited.items())
        }
    if surface.factors is not None:
        faces = np.flatnonzero(surface.factors != 1.0)
        tree["local_smoothness"] = dict(
            zip(map(str, faces.tolist()), surface.factors[faces].tolist(), strict=True)
        )
    if source := nested(extra, "source"):
        tree["source"] = source
    return tree


def _rows(vectors: Floats) -> Lines:
    """(n, 3) vectors, a row each."""
    return _lines(["[%s, %s, %s]"] * len(vectors), _words(vectors))


def _of_faces(corner: str, mesh: PolygonMesh, values: list[Any]) -> Lines:
    """A row per face of an entry per corner, filled with the values."""
    sizes = mesh.sizes.tolist()
    patterns = {size: f"[{', '.join([corner] * size)}]" for size in set(sizes)}
    return _lines([patterns[size] for size in sizes], values)


def _lines(patterns: list[str], values: list[Any]) -> Lines:
    # All at once: to fill one after the other takes several times as long.
    return Lines(("\n".join(patterns) % tuple(values)).split("\n"))


def _words(values: Floats) -> list[str]:
    """Each of the numbers as the shortest word that gives it back.

    Most parameters stand in several faces; what is the same to the last bit is spelled once.
    """
    bits, places = np.unique(values.ravel().view(np.int64), return_inverse=True)
    words = np.array(list(map(float.__repr__, bits.view(np.float64).tolist())), dtype=object)
    found: list[str] = words[places].tolist()
    return found


def _plane_tree(plane: EditedPlane) -> dict[str, Json]:
    parts = ((key, getattr(plane, key)) for key in PARTS)
    return {key: part.tolist() for key, part in parts if part is not None}


def _vertices(value: Json) -> Floats:
    """(n, 3)"""
    entries: list[Any] = filled(value, "vertices")
    if _are_lists(entries) and set(map(len, entries)) == {3}:
        found = _numbers(list(chain.from_iterable(entries)))
        if found is not None:
            return found.reshape(-1, 3)
    return np.array(rows(value, "vertices", (3,)))


def _faces(value: Json, count: int) -> tuple[list[int], list[int]]:
    """The corners of all faces, and how many each has."""
    entries: list[Any] = filled(value, "faces")
    if _are_lists(entries):
        sizes = list(map(len, entries))
        corners = list(chain.from_iterable(entries))
        all_whole = set(map(type, corners)) == {int}
        if min(sizes) >= 3 and all_whole and min(corners) >= 0 and max(corners) < count:
            return corners, sizes
    faces = [_face(entry, f"faces: face {i}", count) for i, entry in enumerate(entries)]
    return list(chain.from_iterable(faces)), list(map(len, faces))


def _face(value: Json, key: str, count: int) -> list[int]:
    corners = [whole(corner, key) for corner in filled(value, key)]
    if len(corners) < 3:
        raise FormatError(f"{key}: has {of_number(len(corners), 'corner')}, expected 3 or more")
    for corner in corners:
        if not 0 <= corner < count:
            raise FormatError(f"{key}: there is no vertex {corner}; there are {count}, from 0 on")
    return corners


def _parameters(value: Json, sizes: list[int]) -> Floats:
    """(c, 2)"""
    entries: list[Any] = counted(value, "parameters", len(sizes), "faces")
    if _are_lists(entries) and list(map(len, entries)) == sizes:
        pairs = list(chain.from_iterable(entries))
        if _are_lists(pairs) and set(map(len, pairs)) == {2}:
            found = _numbers(list(chain.from_iterable(pairs)))
            if found is not None:
                return found.reshape(-1, 2)
    corners = [
        vector(corner, f"parameters: row {i}", 2)
        for i, (entry, size) in enumerate(zip(entries, sizes, strict=True))
        for corner in counted(entry, f"parameters: row {i}", size, "corners")
    ]
    return np.array(corners)


def _are_lists(entries: list[Any]) -> bool:
    return set(map(type, entries)) == {list}


def _numbers(values: list[Any]) -> Floats | None:
    """(n,) finite numbers; None where one of the values is none."""
    if not set(map(type, values)) <= {int, float}:
        return None
    found = np.array(values, dtype=np.float64)
    return found if np.isfinite(found).all() else None


def _domain(value: Json) -> tuple[Domain, Object]:
    tree = object_of(value, "domain")
    kind = text(required(tree, "kind"), "domain: kind")
    if kind not in DOMAINS:
        raise expected("domain: kind", "one of " + ", ".join(map(shown, DOMAINS)), kind)
    names = SIZES.get(kind, ())
    for key in names:
        if key not in tree:
            raise FormatError(f"domain: {key}: is missing")
    sizes = {key: positive(tree[key], f"domain: {key}") for key in names}
    check_kept(value, "domain")
    return DOMAINS[kind](**sizes), kept(tree, frozenset({"kind", *names}))


def _planes(value: Json, count: int) -> tuple[Mapping[int, EditedPlane], Object]:
    """The edited control planes by face, and by face what else stands there."""
    edited, unknown = {}, {}
    for face, entry in object_of(value, "planes").items():
        number_of_face = _face_number(face, "planes", count)
        key = f"planes: face {face}"
        plane = object_of(entry, key)
        check_kept(entry, key)
        given = {part: vector(plane[part], f"{key}: {part}", 3) for part in PARTS if part in plane}
        edited[number_of_face] = EditedPlane(**{k: np.array(row) for k, row in given.items()})
        if more := kept(plane, frozenset(PARTS)):
            unknown[face] = more
    return edited, unknown


def _factors(value: Json, count: int) -> Floats | None:
    """(f,) local factors of the smoothness, or None where none is said."""
    said = object_of(value, "local_smoothness")
    if not said:
        return None
    factors = np.ones(count)
    for face, factor in said.items():
        number_of_face = _face_number(face, "local_smoothness", count)
        factors[number_of_face] = positive(factor, f"local_smoothness: face {face}")
    return factors


def _face_number(face: str, key: str, count: int) -> int:
    if face.isascii() and face.isdecimal() and len(face) <= LONGEST:
        found = int(face)
        if found < count and str(found) == face:
            return found
    raise FormatError(f"{key}: there is no face {shown(face)}; there are {count}, from 0 on")


def _source(value: Json) -> Object:
    source = object_of(value, "source")
    check_kept(value, "source")
    for key in {"file", "sha256"} & source.keys():
        text(source[key], f"source: {key}")
    return source


def _check_extent(surface: MeshSurface) -> None:
    """FormatError where no face has a control plane, or one that can't be calculated with."""
    try:
        with np.errstate(all="ignore"):
            surface.foundation.planes  # noqa: B018
    except ValueError as error:
        if str(error).startswith("parameters"):
            raise
        raise FormatError(
            "parameters: are so close together, or vertices so far apart, that control planes are"
            " beyond what can be calculated with"
        ) from None
