"""By which map a mesh got its parameters, as kept with its shape.

The parameters themselves are all that a surface needs; this is for people, who may want to know
the map and change it. It stands under the key "map" of the shape in files.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from plusedit.document.shape import Json, Shape, Tree

KEY = "map"


@dataclass(frozen=True)
class MapRecord:
    """A map of the shelf of maps."""

    name: str
    cone_points: tuple[int, ...] = ()
    """the vertices at the corners of a pillow, if a person chose them"""


def map_of(shape: Shape) -> MapRecord | None:
    """The map that a shape tells of; None where it tells of none, or in words unknown here."""
    said = shape.extra.get(KEY)
    if not isinstance(said, Mapping):
        return None
    name, points = said.get("name"), said.get("cone_points", [])
    if not isinstance(name, str) or not isinstance(points, list):
        return None
    numbers = tuple(point for point in points if type(point) is int)
    return MapRecord(name, numbers if len(numbers) == len(points) == 4 else ())


def with_map(extra: Tree, record: MapRecord) -> Tree:
    """What is kept with a shape, telling of another map."""
    said: dict[str, Json] = {"name": record.name}
    if record.cone_points:
        said["cone_points"] = list(record.cone_points)
    return MappingProxyType({**extra, KEY: MappingProxyType(said)})
