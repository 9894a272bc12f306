"""What every reader of meshes ends with: faces that can be relied on, and notes on the others."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.io.fields import of_number
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile, Numbers

Indices = NDArray[np.int64]
Marks = NDArray[np.bool_]

LARGEST = 1e15  # coordinates; beyond, neighboring doubles are some tenths apart
MOST = 2**31 - 1  # corners and vertices are counted with 31 bits
SOME = 1000  # corners that mostly show that not all lie on one line
FLAT = 1e-12  # of the square of the size: an area that is none


@dataclass(eq=False)
class ReadMesh:
    """A mesh as a file has it, with numbers that may be wrong."""

    points: Floats
    """(n, 3); entries may be nan or infinite"""
    corners: Indices
    """(c,) vertices from 0"""
    sizes: Indices
    """(f,) corners of every face; may be less than three"""
    uv: Floats | None = None
    """(c, 2) by corner"""
    vertex_uv: Floats | None = None
    """(n, 2) by vertex, where there is none by corner"""
    labels: Indices | None = None
    """(f,) the group of every face, -1 for none"""
    names: Sequence[str] = ()
    """of the groups; the same name makes one group"""
    notes: list[str] = field(default_factory=list)
    first: int = 0
    """the number of the first vertex in the file"""
    kinds: str = ""
    """what else than faces the file holds, such as "lines", for the sentence on missing faces"""


def cleaned(read: ReadMesh) -> MeshFile:
    """The mesh without faces that can't be used, which notes tell. FormatError if none is left."""
    _check_counts(read)
    _check_indices(read)
    _check_size(read.points)
    _take_uv(read)
    broken = _leave_out_infinite(read)
    _leave_out_short(read)
    if not len(read.sizes):
        raise FormatError(f"has no face that can be used: {'; '.join(read.notes)}")
    _drop_infinite(read, broken)
    _tell_unused(read)
    if not _is_wide(read.points[read.corners[:SOME]]):
        _check_extent(read.points[read.corners])
    starts = _starts(read.sizes)
    mesh = PolygonMesh(read.points, read.corners.astype(np.int32), starts.astype(np.int32))
    return MeshFile(mesh, read.uv, _groups(read), notes=tuple(read.notes))


def doubles(values: NDArray[Any]) -> Floats:
    """The same numbers as doubles."""
    # Bytes can be a "signaling" NaN, which warns wherever it is touched.
    with np.errstate(invalid="ignore", over="ignore"):
        return values.astype(np.float64)


def vertices(count: int) -> str:
    """Such as "1 vertex" or "12 vertices"."""
    return "1 vertex" if count == 1 else f"{count} vertices"


def were(count: int) -> str:
    """The verb for so many."""
    return "was" if count == 1 else "were"


def _check_counts(read: ReadMesh) -> None:
    if not len(read.points) and not len(read.sizes):
        raise FormatError("has neither points nor faces")
    if not len(read.sizes):
        besides = f", only {read.kinds}" if read.kinds else ""
        raise FormatError(f"has {of_number(len(read.points), 'point')} but no faces{besides}")
    if max(len(read.corners), len(read.points)) > MOST:
        raise FormatError(f"has more than {MOST} corners or vertices")


def _check_indices(read: ReadMesh) -> None:
    wrong: Marks = (read.corners < 0) | (read.corners >= len(read.points))
    if not wrong.any():
        return
    corner = int(wrong.argmax())
    face = int(np.searchsorted(np.cumsum(read.sizes), corner, side="right")) + 1
    raise FormatError(
        f"face {face} names vertex {read.corners[corner] + read.first}, but there are"
        f" {vertices(len(read.points))}, numbered from {read.first}"
    )


def _check_size(points: Floats) -> None:
    largest = np.abs(np.where(np.isfinite(points), points, 0.0)).max(initial=0.0)
    if largest > LARGEST:
        raise FormatError(
            f"has a coordinate of size {largest:.3g}; more than {LARGEST:g} can't be worked with"
        )


def _take_uv(read: ReadMesh) -> None:
    if read.uv is None and read.vertex_uv is not None:
        read.uv = read.vertex_uv[read.corners]
    if read.uv is None:
        return
    wrong = int((~(np.abs(read.uv) <= LARGEST)).any(axis=1).sum())
    if wrong:
        read.uv = None
        read.notes.append(
            "all texture coordinates were ignored:"
            f" those of {of_number(wrong, 'corner')} are no finite numbers"
        )


def _leave_out_infinite(read: ReadMesh) -> Marks:
    """Leave out the faces with vertices that are not finite; which vertices that are (n,)."""
    broken: Marks = np.logical_not(np.isfinite(read.points).all(axis=1))
    if broken.any():
        hit = np.bincount(_owners(read)[broken[read.corners]], minlength=len(read.sizes)) > 0
        if count := _leave_out(read, ~hit):
            told = f"{of_number(count, 'face')} with a vertex that is no finite number"
            read.notes.append(f"{told} {were(count)} left out")
    return broken


def _leave_out_short(read: ReadMesh) -> None:
    """Leave out corners that repeat the next one, then faces without three different ones."""
    repeated = _repeats(read)
    left_out = 0
    if repeated.any() or read.sizes.min(initial=3) < 3:
        owners = _owners(read)
        sizes = np.bincount(owners[~repeated], minlength=len(read.sizes))
        mended = int((repeated & (sizes >= 3)[owners]).sum())
        if mended:
            told = of_number(mended, "corner")
            read.notes.append(f"{told} beside the same vertex in the face {were(mended)} left out")
        _keep_corners(read, ~repeated)
        read.sizes = sizes
        left_out = _leave_out(read, sizes >= 3)
    if read.sizes.max(initial=3) > 3:
        left_out += _leave_out(read, ~_alternates(read))
    if left_out:
        told = f"{of_number(left_out, 'face')} with fewer than three different corners"
        read.notes.append(f"{told} {were(left_out)} left out")


def _alternates(read: ReadMesh) -> Marks:
    """(f,) whether a face runs to and fro between two vertices."""
    after = _after(read.sizes)
    differs = read.corners != read.corners[after[after]]
    stays: Marks = np.bincount(_owners(read)[differs], minlength=len(read.sizes)) == 0
    return stays


def _drop_infinite(read: ReadMesh, broken: Marks) -> None:
    """Drop the vertices that are not finite, which no face has any more."""
    if broken.any():
        read.corners = (np.cumsum(~broken) - 1)[read.corners]
        read.points = read.points[~broken]


def _tell_unused(read: ReadMesh) -> None:
    used = np.zeros(len(read.points), dtype=np.bool_)
    used[read.corners] = True
    if unused := int((~used).sum()):
        belong = "belongs" if unused == 1 else "belong"
        read.notes.append(f"{vertices(unused)} {belong} to no face")


def _check_extent(at: Floats) -> None:
    """FormatError if all of the points (c, 3) lie on one line."""
    if (at == at[0]).all():
        raise FormatError("has faces without area: all their points lie at one place")
    if not _is_wide(at):
        raise FormatError("has faces without area: all their points lie on one line")


def _is_wide(at: Floats) -> bool:
    """Whether points (c, 3) do not all lie on one line."""
    away = at - at[0]
    distances = np.linalg.norm(away, axis=1)
    farthest = int(distances.argmax())
    areas = np.linalg.norm(np.cross(away, away[farthest]), axis=1)
    return bool(areas.max() > FLAT * distances[farthest] ** 2)


def _groups(read: ReadMesh) -> dict[str, Numbers]:
    if read.labels is None or not len(read.names):
        return {}
    distinct = list(dict.fromkeys(read.names))
    places = {name: i for i, name in enumerate(distinct)}
    merged = np.array([places[name] for name in read.names] + [-1])[read.labels]
    order = np.argsort(merged, kind="stable").astype(np.int32)
    bounds = np.searchsorted(merged[order], np.arange(len(distinct) + 1))
    parts = {name: order[bounds[i] : bounds[i + 1]] for i, name in enumerate(distinct)}
    return {name: faces for name, faces in parts.items() if len(faces)}


def _owners(read: ReadMesh) -> Indices:
    return np.repeat(np.arange(len(read.sizes)), read.sizes)


def _starts(sizes: Indices) -> Indices:
    return np.concatenate([np.zeros(1, dtype=np.int64), np.cumsum(sizes)])


def _after(sizes: Indices) -> Indices:
    """(c,) the next corner around the face of every corner."""
    starts = _starts(sizes)
    after = np.arange(1, starts[-1] + 1)
    some = sizes > 0
    after[starts[1:][some] - 1] = starts[:-1][some]
    return after


def _repeats(read: ReadMesh) -> Marks:
    """(c,) whether the next corner of the face is the same vertex."""
    repeats: Marks = read.corners == read.corners[_after(read.sizes)]
    return repeats


def _leave_out(read: ReadMesh, kept: Marks) -> int:
    """Leave out the faces that are not kept (f,); how many there are."""
    count = int((~kept).sum())
    if count:
        _keep_corners(read, kept[_owners(read)])
        read.sizes = read.sizes[kept]
        if read.labels is not None:
            read.labels = read.labels[kept]
    return count


def _keep_corners(read: ReadMesh, kept: Marks) -> None:
    read.corners = read.corners[kept]
    if read.uv is not None:
        read.uv = read.uv[kept]
