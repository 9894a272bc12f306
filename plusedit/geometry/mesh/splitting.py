"""A part of a mesh split where that helps, and given parameters.

Faces that stand out spoil a map, and faces that reach half around a domain have no place in it:
both are split before. But the map of a limb that is split finely, and many times as long as thick,
shrinks from face to face until they are lost in rounding. Such a part is mapped before it is
split, and its faces get their parameters from the faces in which they lie.
"""

from dataclasses import dataclass, replace

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mapping import Mapped, carried, mapped
from plusedit.geometry.mesh.maps import Progress, silent
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.refine import Refined, needs_refining, refined

TIMES = 2  # that faces are split if some reach around half of the domain
LOST = 1e-12  # of a parameter: a face of less extent has but four digits left


@dataclass(frozen=True, eq=False)
class Wishes:
    """What is known and wished of a part."""

    uv: Floats | None = None
    """(c, 2) texture coordinates by corner"""
    is_height_field: bool = False
    """whether it is known to be a terrain"""
    map_name: str | None = None
    """of the map to take if it suits; None takes the one that suits best"""
    refine: bool = True
    """whether faces are split"""
    wanted: int = 0
    """about how many faces there should be where some have to be split"""


@dataclass(frozen=True, eq=False)
class SplitAndMapped:
    """A part as it was split, and its parameters."""

    mesh: PolygonMesh
    mapped: Mapped
    notes: tuple[str, ...]
    """what to tell, those of the map included"""


def split_and_mapped(
    mesh: PolygonMesh, wishes: Wishes = Wishes(), progress: Progress = silent
) -> SplitAndMapped:
    """A connected part with parameters, its faces split if they have to be.

    ValueError, with a sentence, where it can't have any.
    """
    uneven = needs_refining(mesh)
    if not wishes.refine:
        told = (f"{uneven.why} would better be split",) if uneven else ()
        return _mapped(mesh, wishes, told, progress)
    if uneven:
        split = refined(mesh, wanted=max(mesh.face_count, wishes.wanted))
        found = _refined_and_mapped(mesh, split, wishes, progress)
        wishes = _along(wishes, split)
    else:
        found = _mapped(mesh, wishes, (), progress)
    if not _reaches_around(found):
        return found
    finer = found.mesh.subdivided(TIMES)
    uv = None if wishes.uv is None else finer.along(wishes.uv)
    told = (f"the faces were split into {finer.mesh.face_count}: some were half of the map",)
    return _mapped(finer.mesh, replace(wishes, uv=uv), told, progress)


def _refined_and_mapped(
    mesh: PolygonMesh, split: Refined, wishes: Wishes, progress: Progress
) -> SplitAndMapped:
    """A part mapped after it was split or, where that loses fewer faces, before."""
    found = _mapped(split.mesh, _along(wishes, split), split.notes, progress)
    lost = _lost(found)
    if not lost:
        return found
    whole = _mapped(mesh, wishes, (), progress)
    taken_along = carried(whole.mapped, split)
    told = whole.notes[: len(whole.notes) - len(whole.mapped.notes)]
    before = SplitAndMapped(split.mesh, taken_along, (*split.notes, *told, *taken_along.notes))
    return before if _lost(before) < lost else found


def _along(wishes: Wishes, split: Refined) -> Wishes:
    return replace(wishes, uv=None if wishes.uv is None else split.along(wishes.uv))


def _mapped(
    mesh: PolygonMesh, wishes: Wishes, notes: tuple[str, ...], progress: Progress
) -> SplitAndMapped:
    """By the map that is wished for if it suits, else by another one; after notes on the mesh."""
    uv, known = wishes.uv, wishes.is_height_field
    if (wish := wishes.map_name) is not None:
        try:
            found = mapped(mesh, uv=uv, is_height_field=known, wish=wish, progress=progress)
        except ValueError as error:
            notes = (*notes, str(error))
        else:
            return SplitAndMapped(mesh, found, (*notes, *found.notes))
    found = mapped(mesh, uv=uv, is_height_field=known, progress=progress)
    return SplitAndMapped(mesh, found, (*notes, *found.notes))


def _spans(found: SplitAndMapped) -> Floats:
    """(f, 2) the extents of the faces in the domain."""
    starts, parameters = found.mesh.starts[:-1], found.mapped.parameters
    spans: Floats = np.maximum.reduceat(parameters, starts) - np.minimum.reduceat(
        parameters, starts
    )
    return spans


def _reaches_around(found: SplitAndMapped) -> bool:
    """Whether some face reaches half around the domain, or farther."""
    return bool((_spans(found) >= 0.5 * np.array(found.mapped.domain.periods)).any())


def _lost(found: SplitAndMapped) -> int:
    """How many faces have but a few digits in the map, or are turned over."""
    places = np.abs(found.mapped.parameters[found.mesh.starts[:-1]]).max(axis=1)
    small = _spans(found).max(axis=1) <= LOST * places
    return int(np.count_nonzero(small)) + found.mapped.flips
