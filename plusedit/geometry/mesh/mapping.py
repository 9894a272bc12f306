"""A connected part of a mesh gets parameters: which map it gets, and what came of it."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from plusedit.geometry.arrays import Floats, frozen
from plusedit.geometry.mesh.domains import Domain
from plusedit.geometry.mesh.flattening.choice import Choice, choice
from plusedit.geometry.mesh.flattening.distortion import flips
from plusedit.geometry.mesh.flattening.unwrapping import by_corner
from plusedit.geometry.mesh.maps import Progress, Subject, maps, silent
from plusedit.geometry.mesh.polygons import PolygonMesh, fixed
from plusedit.geometry.mesh.refine import Refined
from plusedit.geometry.mesh.topology import Topology

OF_FILE = "file_uv"  # the map that takes texture coordinates, which a shape does not keep


SMALLEST = 1e-50  # of parameters: limbs of a part that come to less than that are lost


@dataclass(frozen=True, eq=False)
class Mapped:
    """The parameters of a connected part, and what there is to tell about them."""

    domain: Domain
    parameters: Floats
    """(c, 2) one (u, v) per corner, unwrapped within every face"""
    name: str
    """of the map, as on the shelf"""
    why: str
    """why this one, as a phrase for people"""
    flips: int
    """how many triangles are turned over"""
    notes: tuple[str, ...] = ()
    """what else to tell, a sentence each"""
    cone_points: tuple[int, ...] = ()
    """the four vertices at the corners of a pillow"""
    remarks: tuple[str, ...] = ()
    """those of the notes that hold however the faces are split"""

    @property
    def title(self) -> str:
        """What the map is called."""
        return maps[self.name].title


class MapOffer(NamedTuple):
    """A map on the shelf, and whether a mesh can have it."""

    name: str
    title: str
    objection: str
    """why not, as a phrase; empty where it can"""


def map_offers(mesh: PolygonMesh) -> tuple[MapOffer, ...]:
    """All maps but those that need more than the mesh, by their titles.

    Of a mesh that is no connected proper surface none can be had.
    """
    try:
        _check(mesh, mesh.topology, None, None)
    except ValueError as error:
        why = str(error)
        offers = [MapOffer(name, maps[name].title, why) for name in maps]
    else:
        subject = Subject(mesh, mesh.topology)
        offers = [MapOffer(name, maps[name].title, maps[name].objection(subject)) for name in maps]
    return tuple(sorted((o for o in offers if o.name != OF_FILE), key=lambda offer: offer.title))


def mapped(
    mesh: PolygonMesh,
    topology: Topology | None = None,
    *,
    uv: Floats | None = None,
    is_height_field: bool = False,
    wish: str | None = None,
    cone_points: tuple[int, ...] | None = None,
    progress: Progress | None = None,
) -> Mapped:
    """Parameters for a connected part of a mesh, a proper surface as `repaired` makes it.

    Parameters
    ----------
    uv
        (c, 2) texture coordinates by corner; used if they will do.
    is_height_field
        Whether the part is known to be a terrain.
    wish
        The name of the map to take instead of the one that suits best.
    cone_points
        Four vertices for the corners of a pillow.
    progress
        Is told what share is done and what comes next; what it raises ends the work.

    Raises
    ------
    ValueError
        With a sentence: the mesh is no connected proper surface, there is no such map, the wished
        one does not suit the part, or cone points are no four different vertices.
    KeyError
        If there is no map of the wished name.
    """
    known = topology if topology is not None else mesh.topology
    tell = progress or silent
    tell(0.0, "looking at the part")
    _check(mesh, known, uv, cone_points)
    subject = Subject(mesh, known, uv, is_height_field, tuple(cone_points or ()), tell)
    chosen = choice(subject) if wish is None else _wished(subject, wish)
    layout = maps[chosen.name].layout(subject)
    tell(0.95, "looking at the result")
    parameters = by_corner(mesh, subject.sheet, layout.places)
    # Gradients by less would be beyond all numbers.
    parameters[np.abs(parameters) < SMALLEST] = 0.0
    turned = flips(mesh, parameters)
    notes = (*layout.notes, *_findings(mesh, layout.domain, parameters, turned))
    tell(1.0, "done")
    return Mapped(
        layout.domain,
        fixed(parameters),
        chosen.name,
        chosen.why,
        turned,
        notes,
        layout.cone_points,
        layout.notes,
    )


def carried(found: Mapped, split: Refined) -> Mapped:
    """The parameters of a part, linear on each face, for the faces that it was split into."""
    parameters = split.along(found.parameters)
    turned = flips(split.mesh, parameters)
    findings = _findings(split.mesh, found.domain, parameters, turned)
    return replace(
        found, parameters=fixed(parameters), flips=turned, notes=(*found.remarks, *findings)
    )


def _check(
    mesh: PolygonMesh,
    topology: Topology,
    uv: Floats | None,
    cone_points: tuple[int, ...] | None,
) -> None:
    if not mesh.face_count:
        raise ValueError("a mesh without faces has no parameters")
    if len(topology.components) > 1:
        raise ValueError("only connected parts are mapped, one at a time")
    if topology.components[0].vertices != int(np.count_nonzero(mesh.used)):
        raise ValueError("a vertex where faces only touch must be split before")
    if uv is not None:
        frozen(uv, shape=(len(mesh.corners), 2), name="uv")
    if cone_points:
        used = mesh.used
        wrong = [p for p in cone_points if not (0 <= p < mesh.vertex_count and used[p])]
        if wrong:
            raise ValueError(f"cone points: no face has the vertex {wrong[0]}")


def _wished(subject: Subject, wish: str) -> Choice:
    if objection := maps[wish].objection(subject):
        raise ValueError(f"the map {maps[wish].title!r} does not suit this part: {objection}")
    return Choice(wish, "as wished")


def _findings(
    mesh: PolygonMesh, domain: Domain, parameters: Floats, turned: int
) -> tuple[str, ...]:
    """Sentences about faces that the map does not treat well."""
    found = []
    if turned:
        found.append(f"{_triangles(turned)} turned over by the map")
    spans = np.stack(
        [
            np.maximum.reduceat(axis, mesh.starts[:-1])
            - np.minimum.reduceat(axis, mesh.starts[:-1])
            for axis in parameters.T
        ],
        axis=1,
    )
    wide = int((spans >= 0.5 * np.array(domain.periods)).any(axis=1).sum())
    if wide:
        reach = "half around the domain or farther"
        found.append(
            f"1 face reaches {reach}: it should be split"
            if wide == 1
            else f"{wide} faces reach {reach}: they should be split"
        )
    collapsed = int(np.count_nonzero(spans.max(axis=1) == 0.0))
    if collapsed:
        one = "1 face has" if collapsed == 1 else f"{collapsed} faces have"
        found.append(f"{one} no extent in the map and no control plane")
    return tuple(found)


def _triangles(count: int) -> str:
    return "1 triangle is" if count == 1 else f"{count} triangles are"
