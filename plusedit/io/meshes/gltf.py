"""glTF 2.0 as .gltf with its buffers inside or beside it, and as .glb: triangles in a scene."""

from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import Object, object_of, of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.gltf_buffers import Buffers, SideFiles, no_side_files
from plusedit.io.gltf_scene import Placed, moved, placed_meshes
from plusedit.io.json_text import parse, shown
from plusedit.io.mesh_cleaning import ReadMesh, cleaned, were
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content, name_of
from plusedit.io.meshes import register

HEAD = 12
JSON, BINARY = b"JSON", b"BIN\0"
COMPRESSIONS = ("KHR_draco_mesh_compression", "EXT_meshopt_compression")
TRIANGLES, STRIP, FAN = 4, 5, 6
FREE = 100_000  # corners by which copies may exceed what the bytes explain


class Gltf:
    """The scene that the document shows, every mesh where its nodes put it."""

    title = "glTF 2.0"
    suffixes = (".glb", ".gltf")

    def read(self, data: bytes, name: str) -> MeshFile:
        """Its triangles. FormatError too if the document keeps its data in other files."""
        return self.read_beside(data, name, no_side_files)

    def read_beside(self, data: bytes, name: str, beside: SideFiles) -> MeshFile:
        """The same; `beside` gives what is in the files that the document names."""
        with within(name):
            if data.startswith(b"glTF"):
                text, chunk = _chunks(data)
            else:
                check_content(data, "a glTF document")
                text, chunk = data, None
            tree = object_of(parse(text), "the document")
            _check_version(tree)
            reading = _Reading(Buffers(tree, chunk, beside), len(data))
            for placed in placed_meshes(tree):
                reading.add(placed)
            return replace(cleaned(reading.mesh()), up="y")


register("gltf")(Gltf())


def _chunks(data: bytes) -> tuple[bytes, bytes | None]:
    """The document of a GLB file, and its binary part."""
    if len(data) < HEAD + 8:
        raise FormatError("is cut off within its first bytes")
    version, length = (int.from_bytes(data[i : i + 4], "little") for i in (4, 8))
    if version != 2:
        raise FormatError(f"is glTF of version {version}; version 2 is read")
    if length > len(data):
        raise FormatError(f"is cut off: promises {length} bytes, but {len(data)} are there")
    found: dict[bytes, bytes] = {}
    at = HEAD
    while at + 8 <= length and not {JSON, BINARY} <= found.keys():
        size, kind = int.from_bytes(data[at : at + 4], "little"), data[at + 4 : at + 8]
        if at + 8 + size > length:
            raise FormatError(f"promises a part of {size} bytes, but {length - at - 8} are there")
        if kind not in (JSON, BINARY):
            break  # what may follow the two is for others
        found[kind] = data[at + 8 : at + 8 + size]
        at += 8 + size
    if JSON not in found:
        raise FormatError("has no document within")
    return found[JSON], found.get(BINARY)


def _check_version(tree: Object) -> None:
    version = object_of(tree.get("asset"), "asset").get("version")
    if not isinstance(version, str) or version.partition(".")[0] != "2":
        raise FormatError(f"is glTF of version {shown(version)}; version 2 is read")


@dataclass(eq=False)
class _Reading:
    """Gathers the triangles of the primitives."""

    buffers: Buffers
    size: int
    points: list[Floats] = field(default_factory=list)
    uv: list[Floats | None] = field(default_factory=list)
    triangles: list[NDArray[np.int64]] = field(default_factory=list)
    labels: list[int] = field(default_factory=list)
    names: list[str] = field(default_factory=list)
    count: int = 0
    corners: int = 0
    others: int = 0

    def add(self, placed: Placed) -> None:
        """Take in a mesh."""
        primitives = placed.mesh.get("primitives")
        if not isinstance(primitives, list):
            raise FormatError(f"{placed.where}: has no primitives")
        if placed.name:
            self.names.append(name_of(placed.name.encode("utf-8", "replace")))
        label = len(self.names) - 1 if placed.name else -1
        for index, primitive in enumerate(primitives):
            where = f"{placed.where}: primitives {index}"
            self._add_primitive(object_of(primitive, where), where, placed.matrix, label)

    def mesh(self) -> ReadMesh:
        """All that was gathered."""
        triangles = np.concatenate([np.zeros((0, 3), np.int64), *self.triangles])
        counts = [len(part) for part in self.triangles]
        labels = np.repeat(np.array(self.labels, dtype=np.int64), counts)
        notes: list[str] = []
        if self.others:
            told = f"{of_number(self.others, 'part')} of points or lines"
            notes.append(f"{told} {were(self.others)} left out")
        uv = self._uv(notes)
        points = np.concatenate([np.zeros((0, 3)), *self.points])
        sizes = np.full(len(triangles), 3, dtype=np.int64)
        kinds = "points or lines" if self.others else ""
        return ReadMesh(
            points, triangles.ravel(), sizes, None, uv, labels, self.names, notes, kinds=kinds
        )

    def _add_primitive(self, primitive: Object, where: str, matrix: Floats, label: int) -> None:
        if used := [name for name in COMPRESSIONS if _is_used(primitive, name)]:
            raise FormatError(f"{where}: is compressed ({used[0]}), which is not read")
        mode = primitive.get("mode", TRIANGLES)
        if type(mode) is not int or mode not in (TRIANGLES, STRIP, FAN):
            self.others += 1
            return
        attributes = object_of(primitive.get("attributes"), f"{where}: attributes")
        if "POSITION" not in attributes:
            raise FormatError(f"{where}: has no positions")
        points = self._array(attributes["POSITION"], "VEC3").astype(np.float64)
        order = np.arange(len(points))
        if "indices" in primitive:
            order = self._array(primitive["indices"], "SCALAR")[:, 0].astype(np.int64)
        if len(order) and order.max() >= len(points):
            raise FormatError(
                f"{where}: names vertex {order.max()}, but there are {len(points)}, numbered from 0"
            )
        with np.errstate(over="ignore", invalid="ignore"):
            turned = np.linalg.det(matrix[:3, :3]) < 0.0
        triangles = _triangles(order, mode, where)
        self.triangles.append((triangles[:, ::-1] if turned else triangles) + self.count)
        self.points.append(moved(points, matrix))
        self.uv.append(self._texture(attributes, len(points)))
        self.labels.append(label)
        self.count += len(points)

    def _array(self, index: Any, kind: str) -> NDArray[Any]:
        found = self.buffers.array(index, kind)
        self.corners += len(found)
        if self.corners > FREE + self.buffers.size() + self.size:
            raise FormatError("repeats its meshes so often that they can't be read")
        return found

    def _texture(self, attributes: Object, count: int) -> Floats | None:
        if "TEXCOORD_0" not in attributes:
            return None
        uv = self._array(attributes["TEXCOORD_0"], "VEC2").astype(np.float64)
        uv[:, 1] = 1.0 - uv[:, 1]  # pictures hang from their upper edge here
        return uv if len(uv) == count else None

    def _uv(self, notes: list[str]) -> Floats | None:
        given = [uv for uv in self.uv if uv is not None]
        if not given:
            return None
        if missing := len(self.uv) - len(given):
            have = "has" if missing == 1 else "have"
            told = f"{of_number(missing, 'part')} {have} none"
            notes.append(f"all texture coordinates were ignored: {told}")
            return None
        return np.concatenate(given)


def _is_used(primitive: Object, name: str) -> bool:
    extensions = primitive.get("extensions")
    return isinstance(extensions, dict) and name in extensions


def _triangles(order: NDArray[np.int64], mode: int, where: str) -> NDArray[np.int64]:
    """(t, 3) corners of the triangles that a row of vertices makes."""
    if mode == TRIANGLES:
        if len(order) % 3:
            raise FormatError(f"{where}: {len(order)} corners make no whole triangles")
        return order.reshape(-1, 3)
    if len(order) < 3:
        return np.zeros((0, 3), dtype=np.int64)
    if mode == FAN:
        return np.stack([np.broadcast_to(order[0], len(order) - 2), order[1:-1], order[2:]], axis=1)
    strip = np.stack([order[:-2], order[1:-1], order[2:]], axis=1)
    strip[1::2] = strip[1::2, [0, 2, 1]]
    return strip
