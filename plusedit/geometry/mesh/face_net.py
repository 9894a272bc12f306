"""Faces of a mesh as control planes that can be edited.

The control plane of a face is its own as long as nobody has changed it. What has been changed is
kept by face, and only that: a point P, a gradient A by u or B by v.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.mesh.planes import FacePlanes
from plusedit.geometry.net import Flags

PARTS = ("point", "gradient_u", "gradient_v")


@dataclass(frozen=True, eq=False)
class EditedPlane:
    """What of a face's control plane has been changed; None where it is still the face's."""

    point: Floats | None = None
    """(3,) P"""
    gradient_u: Floats | None = None
    """(3,) A"""
    gradient_v: Floats | None = None
    """(3,) B"""

    def __post_init__(self) -> None:
        for name in PARTS:
            value = getattr(self, name)
            if value is not None:
                object.__setattr__(self, name, frozen(value, shape=(3,), name=name))


@dataclass(frozen=True, eq=False)
class EditedPlanes(Mapping[int, EditedPlane]):
    """The edited planes of a mesh by face, in arrays: there may be as many as faces."""

    faces: NDArray[np.intp]
    """(k,) ascending"""
    parts: Floats
    """(3, k, 3) P, A and B; zero where not given"""
    given: Flags
    """(3, k) which of them have been changed"""
    _made: "dict[FacePlanes, FaceNet]" = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        for array in (self.faces, self.parts, self.given):
            array.flags.writeable = False

    @classmethod
    def of(cls, edited: Mapping[int, EditedPlane]) -> "EditedPlanes":
        """The same planes; `edited` itself if it is in arrays already."""
        if isinstance(edited, EditedPlanes):
            return edited
        faces = sorted(edited)
        parts, given = np.zeros((3, len(faces), 3)), np.zeros((3, len(faces)), dtype=np.bool_)
        for place, face in enumerate(faces):
            for row, name in enumerate(PARTS):
                value = getattr(edited[face], name)
                if value is not None:
                    parts[row, place], given[row, place] = value, True
        return cls(np.array(faces, dtype=np.intp), parts, given)

    def __len__(self) -> int:
        return len(self.faces)

    def __iter__(self) -> Iterator[int]:
        return iter(self.faces.tolist())

    def __getitem__(self, face: int) -> EditedPlane:
        return self._by_face[face]

    @cached_property
    def _by_face(self) -> dict[int, EditedPlane]:
        return {
            face: EditedPlane(
                *(self.parts[k, place] if self.given[k, place] else None for k in range(3))
            )
            for place, face in enumerate(self.faces.tolist())
        }

    def on(self, own: "FaceNet") -> "FaceNet":
        """The faces' own planes with these edits; the same object when asked again."""
        found = self._made.get(own.own)
        if found is None:
            found = own.with_edited(self) if len(self) else own
            self._made[own.own] = found
        return found

    def transformed(self, turn: Floats, shift: Floats) -> "EditedPlanes":
        """The planes after x -> turn x + shift."""
        parts = self.parts @ turn.T
        parts[0] += shift
        parts[~self.given] = 0.0
        return EditedPlanes(self.faces, parts, self.given)


@dataclass(frozen=True, eq=False)
class FaceNet:
    """The control planes of all faces as edits see them; never changed in place.

    A gradient that is *automatic* is the face's own. Faces have no weights that can be set.
    """

    own: FacePlanes
    """the planes of the faces without any edit"""
    own_vectors: Floats
    """(2, f, 3) A and B of those"""
    control_points: Floats
    """(f, 3) P"""
    vectors: Floats
    """(2, f, 3) A and B"""
    automatic_vectors: Flags
    """(2, f) true where a gradient is the face's own"""

    @classmethod
    def of(cls, own: FacePlanes) -> "FaceNet":
        """The faces' own planes."""
        vectors = np.stack([own.gradients_u, own.gradients_v])
        automatic = np.ones(vectors.shape[:2], dtype=np.bool_)
        for array in (vectors, automatic):
            array.flags.writeable = False
        return cls(own, vectors, own.points, vectors, automatic)

    def _with(self, **known: Any) -> "FaceNet":
        """The net with other fields, which are read-only; made for every frame of a drag."""
        for array in known.values():
            array.flags.writeable = False
        return replace(self, **known)

    def __len__(self) -> int:
        return len(self.control_points)

    @property
    def dimension(self) -> int:
        """3, as the points of every mesh have."""
        return 3

    @cached_property
    def planes(self) -> FacePlanes:
        """The control planes with the edits; centers, radii and weights stay the faces'."""
        if self.control_points is self.own.points and self.vectors is self.own_vectors:
            return self.own
        by_u, by_v = self.vectors
        return replace(self.own, points=self.control_points, gradients_u=by_u, gradients_v=by_v)

    @cached_property
    def given_vectors(self) -> Floats:
        """(2, f, 3) the gradients that were changed; zero where automatic."""
        given, changed = np.zeros_like(self.vectors), np.nonzero(~self.automatic_vectors)
        given[changed] = self.vectors[changed]
        given.flags.writeable = False
        return given

    @property
    def weight_row(self) -> None:
        """None: all faces have the same weight, or that of their area."""
        return None

    def with_control_points(self, points: Floats) -> "FaceNet":
        """The same gradients at other points (f, 3); itself if they are what they were."""
        at = frozen(points, shape=(len(self), 3), name="points")
        return self if np.array_equal(at, self.control_points) else self._with(control_points=at)

    def with_vectors(self, given: Floats, automatic: Flags) -> "FaceNet":
        """The same points with other gradients (2, f, 3); where `automatic` (2, f) the face's own.

        A gradient that is given as it is by itself is automatic.
        """
        vectors, changed = self.own_vectors.copy(), np.nonzero(~np.asarray(automatic))
        vectors[changed] = frozen(given[changed], shape=(None, 3), name="gradients")
        if np.array_equal(vectors, self.vectors):
            return self
        return self._with(vectors=vectors, automatic_vectors=~_differ(vectors, self.own_vectors))

    def with_weight_row(self, weights: Floats | None) -> "FaceNet":
        """The net itself for None. ValueError otherwise."""
        if weights is not None:
            raise ValueError("faces of a mesh have no weights; S can be changed there instead")
        return self

    def with_edited(self, edited: EditedPlanes) -> "FaceNet":
        """The net with these edits made as well."""
        points, vectors = self.control_points.copy(), self.vectors.copy()
        automatic = self.automatic_vectors.copy()
        for target, part, given in zip((points, *vectors), edited.parts, edited.given, strict=True):
            target[edited.faces[given]] = part[given]
        automatic[:, edited.faces] &= ~edited.given[1:]
        return self._with(control_points=points, vectors=vectors, automatic_vectors=automatic)

    def without_edits(self, faces: list[int]) -> "FaceNet":
        """The net with the own planes of those faces; itself if they have them already."""
        points, automatic = self.control_points.copy(), self.automatic_vectors.copy()
        points[faces] = self.own.points[faces]
        automatic[:, faces] = True
        return self.with_control_points(points).with_vectors(self.vectors, automatic)

    @cached_property
    def edited(self) -> EditedPlanes:
        """What differs from the faces' own planes."""
        moved = _differ(self.control_points, self.own.points)
        given = np.stack([moved, *~self.automatic_vectors])
        faces = np.flatnonzero(given.any(axis=0))
        parts = np.stack([self.control_points[faces], *self.vectors[:, faces]])
        parts[~given[:, faces]] = 0.0
        return EditedPlanes(faces, parts, given[:, faces], {self.own: self})


def _differ(one: Floats, other: Floats) -> Flags:
    """(...,) where vectors (..., 3) are not equal."""
    # Column by column: `any` along so short an axis takes five times as long.
    x, y, z = np.moveaxis(one != other, -1, 0)
    differ: Flags = x | y | z
    return differ
