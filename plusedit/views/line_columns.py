"""The columns of the table of control lines and planes: what stands there, and how it is set."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import radians

from plusedit.commands.base import Command, Side
from plusedit.commands.bearing import SetBearing
from plusedit.commands.directions import ResetDirections, SetAngle, SetDirection, SetLength
from plusedit.commands.lines import SetCoordinate, SetWeight
from plusedit.document.selection import LineId
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.views.direction_rows import azimuth_of, elevation_of, length_of

AXES = ("x", "y", "z")

HINTS = {
    "angle": ("Angle", "Direction in degrees, seen from the top"),
    "azimuth": ("Az", "Azimuth of the direction in degrees, from x towards y"),
    "elevation": ("El", "Elevation of the direction in degrees, above the plane of x and y"),
    "length": ("Length", "Length of the direction"),
    "auto": ("Auto", "Whether the direction follows the neighboring points, or is the face's own"),
}


@dataclass(frozen=True)
class Column:
    """One column: a coordinate, a number of a direction, the weight."""

    kind: str
    """such as "line", "x", "y", "z", "weight" or a key of HINTS"""
    side: Side = "both"
    """which of the directions of a plane; "both" for that of a line"""

    @property
    def way(self) -> int:
        """The place of the direction in a net."""
        return 1 if self.side == "v" else 0

    @property
    def head(self) -> str:
        """What stands above the column."""
        name = HINTS[self.kind][0] if self.kind in HINTS else self.kind.capitalize()
        if self.kind in AXES:
            return self.kind
        return name if self.side == "both" else f"{self.side} {name}"

    @property
    def hint(self) -> str:
        """What it means, in a sentence."""
        if self.kind in HINTS:
            text = HINTS[self.kind][1]
            return text if self.side == "both" else f"{text}: by {self.side}"
        if self.kind == "line":
            return "Shape and number of the control line or plane"
        return "Control point" if self.kind in AXES else "Its share in the shape"

    def belongs_to(self, geometry: Geometry) -> bool:
        """Whether such a number exists of the lines or planes of a shape."""
        if self.kind in AXES:
            return AXES.index(self.kind) < geometry.dimension
        if self.kind == "weight":
            return not isinstance(geometry, MeshSurface)
        if self.kind not in HINTS:
            return True
        if (len(geometry.vectors) == 2) != (self.side != "both"):
            return False
        in_space = geometry.dimension == 3
        return {"angle": not in_space, "azimuth": in_space, "elevation": in_space}.get(
            self.kind, True
        )

    def number_of(self, geometry: Geometry, row: int) -> float | None:
        """What stands there for a line or plane; None where there is nothing."""
        if not self.belongs_to(geometry):
            return None
        if self.kind in AXES:
            return float(geometry.net.control_points[row, AXES.index(self.kind)])
        if self.kind == "weight":
            weights = geometry.net.weight_row
            return 1.0 if weights is None else float(weights[row])
        direction = geometry.vectors[self.way, row]
        if self.kind == "elevation":
            return elevation_of(direction)
        return length_of(direction) if self.kind == "length" else azimuth_of(direction)

    def edit(self, line: LineId, value: float) -> Command:
        """The command that puts `value` there."""
        targets: dict[ShapeId, tuple[int, ...]] = {line.shape: (line.number,)}
        match self.kind:
            case "angle":
                return SetAngle(targets, radians(value))
            case "azimuth":
                return SetBearing(targets, azimuth=radians(value), side=self.side)
            case "elevation":
                return SetBearing(targets, elevation=radians(value), side=self.side)
            case "length":
                return SetLength(targets, value, side=self.side)
            case "weight":
                return SetWeight(targets, value)
        return SetCoordinate(targets, AXES.index(self.kind), value)

    def switched(self, line: LineId, geometry: Geometry) -> Command:
        """The command that makes the direction automatic, or keeps it as it is now."""
        if geometry.net.automatic_vectors[self.way, line.number]:
            direction = geometry.vectors[self.way, line.number]
            return SetDirection(line.shape, line.number, direction, side=self.side)
        return ResetDirections({line.shape: (line.number,)}, side=self.side)


SIDES: tuple[Side, ...] = ("both", "u", "v")

EVERY = (
    Column("line"),
    *(Column(axis) for axis in AXES),
    Column("angle"),
    *(
        Column(kind, side)
        for side in SIDES
        for kind in ("azimuth", "elevation", "length", "auto")
    ),
    Column("weight"),
)  # fmt: skip


def columns_for(shapes: Sequence[Geometry]) -> list[Column]:
    """The columns that say something of these shapes; those of a plane curve where none are."""
    if not shapes:
        return [column for column in EVERY if column.side == "both" and column.kind not in "z"]
    return [column for column in EVERY if any(column.belongs_to(shape) for shape in shapes)]
