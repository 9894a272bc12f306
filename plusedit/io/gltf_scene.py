"""The meshes of a glTF document, each where the nodes of its scene put it."""

from collections.abc import Iterator
from math import hypot
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.document.shape import Json
from plusedit.geometry.arrays import Floats
from plusedit.io.fields import Object, vector
from plusedit.io.formats import FormatError
from plusedit.io.gltf_buffers import entry

MOST_NODES = 1_000_000
FRESH = np.eye(4)


class Placed(NamedTuple):
    """A mesh of the document, and where it stands."""

    mesh: Object
    where: str
    """such as meshes 3, for sentences"""
    name: str
    matrix: Floats
    """(4, 4), to be multiplied with columns x, y, z, 1"""


def placed_meshes(tree: Object) -> Iterator[Placed]:
    """The meshes of the scene that the document shows; all there are if it has no scene."""
    if not tree.get("nodes"):
        for number in range(len(_list(tree, "meshes"))):
            yield _placed(tree, number, {}, FRESH)
        return
    waiting: list[tuple[Json, Floats]] = [(index, FRESH) for index in reversed(_roots(tree))]
    seen: set[int] = set()
    while waiting:
        index, outer = waiting.pop()
        node = entry(tree, "nodes", index)
        assert isinstance(index, int)
        if index in seen or len(seen) > MOST_NODES:
            raise FormatError(f"nodes {index}: stands in more than one place")
        seen.add(index)
        matrix = _product(outer, _matrix(node, f"nodes {index}"))
        if "mesh" in node:
            yield _placed(tree, node["mesh"], node, matrix)
        waiting += [(child, matrix) for child in reversed(_list(node, "children"))]


def _placed(tree: Object, index: Json, node: Object, matrix: Floats) -> Placed:
    mesh = entry(tree, "meshes", index)
    name = mesh.get("name") or node.get("name") or ""
    return Placed(mesh, f"meshes {index}", name if isinstance(name, str) else "", matrix)


def _roots(tree: Object) -> list[Json]:
    scenes = _list(tree, "scenes")
    if scenes:
        return _list(entry(tree, "scenes", tree.get("scene", 0)), "nodes")
    nodes = _list(tree, "nodes")
    children = {
        child
        for node in nodes
        if isinstance(node, dict)
        for child in _list(node, "children")
        if isinstance(child, int)
    }
    return [index for index in range(len(nodes)) if index not in children]


def _list(tree: Object, key: str) -> list[Json]:
    value = tree.get(key, [])
    if not isinstance(value, list):
        raise FormatError(f"{key}: expected a list")
    return value


def _matrix(node: Object, where: str) -> Floats:
    """(4, 4) what a node does to what is in it."""
    if "matrix" in node:
        columns = vector(node["matrix"], f"{where}: matrix", 16)
        return np.array(columns).reshape(4, 4).T
    if not {"translation", "rotation", "scale"} & node.keys():
        return FRESH
    matrix = np.eye(4)
    scale = vector(node.get("scale", [1.0, 1.0, 1.0]), f"{where}: scale", 3)
    quaternion = vector(node.get("rotation", [0.0, 0.0, 0.0, 1.0]), f"{where}: rotation", 4)
    matrix[:3, :3] = _rotation(np.array(quaternion), where) * np.array(scale)
    matrix[:3, 3] = vector(node.get("translation", [0.0, 0.0, 0.0]), f"{where}: translation", 3)
    return matrix


def _rotation(quaternion: Floats, where: str) -> NDArray[np.float64]:
    length = hypot(*quaternion.tolist())
    if not 1e-3 < length < 1e3:
        raise FormatError(f"{where}: rotation has not length one")
    x, y, z, w = quaternion / length
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def _product(outer: Floats, inner: Floats) -> Floats:
    if inner is FRESH:
        return outer
    with np.errstate(over="ignore", invalid="ignore"):
        product: Floats = inner if outer is FRESH else outer @ inner
    return product


def moved(points: Floats, matrix: Floats) -> Floats:
    """Points (n, 3) where a matrix of `placed_meshes` puts them."""
    if matrix is FRESH:
        return points
    with np.errstate(over="ignore", invalid="ignore"):
        placed: Floats = points @ matrix[:3, :3].T + matrix[:3, 3]
    return placed
