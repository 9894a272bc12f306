"""The rows of a form that tell of the directions of control lines, or of planes by u or by v.

A direction in the plane has an angle and a length; one in space an azimuth (from the x axis
towards the y axis), an elevation above the plane of both, and a length.
"""

from collections.abc import Callable, Iterator
from math import asin, degrees, hypot, radians

import numpy as np
from PySide6.QtWidgets import QCheckBox, QFormLayout

from plusedit.commands.base import Command, Side, Targets, Together
from plusedit.commands.bearing import SetBearing
from plusedit.commands.directions import ResetDirections, SetAngle, SetDirection, SetLength
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import WAYS, Way
from plusedit.views.basis_form import check, row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import common, title

TITLES: dict[Way, str] = {"u": "Direction by u", "v": "Direction by v"}


class DirectionRows:
    """One direction of every selected control line or plane, in rows at the end of a form."""

    def __init__(self, desk: Desk, form: QFormLayout, side: Way | None) -> None:
        self._desk, self._form, self._side = desk, form, side
        self._targets: Targets = {}
        self._shapes: dict[ShapeId, Geometry] = {}
        self._title = None if side is None else title(TITLES[side])
        if self._title is not None:
            self._title.setContentsMargins(0, 6, 0, 0)
            form.addRow(self._title)
        self._angle = self._number("Angle °", "angle", self._set_angle)
        self._azimuth = self._number("Azimuth °", "azimuth", self._set_azimuth)
        self._elevation = self._number("Elevation °", "elevation", self._set_elevation)
        self._length = self._number("Length", "length", self._set_length, step=0.1)
        self._automatic = QCheckBox("follows its neighbors")
        self._automatic.setAccessibleName(self._called("automatic direction"))
        self._automatic.clicked.connect(self._switch_automatic)
        form.addRow(row_label("Automatic"), self._automatic)

    def show(self, targets: Targets, shapes: dict[ShapeId, Geometry]) -> None:
        """Show the directions of these; nothing where there are none of this kind."""
        self._shapes = shapes
        self._targets = {i: rows for i, rows in targets.items() if self._is_told_of(shapes[i])}
        is_seen = bool(self._targets)
        if self._title is not None:
            self._form.setRowVisible(self._title, is_seen)
        in_space = any(shapes[i].dimension == 3 for i in self._targets)
        self._form.setRowVisible(self._angle, is_seen and not in_space)
        for field in (self._azimuth, self._elevation):
            self._form.setRowVisible(field, is_seen and in_space)
        for widget in (self._length, self._automatic):
            self._form.setRowVisible(widget, is_seen)
        if is_seen:
            self._show_numbers()

    def _show_numbers(self) -> None:
        directions = list(self._different())
        mixed = "mixed" if any(d.any() for d in directions) else "none"
        self._angle.show_value(common(map(azimuth_of, directions)), mixed=mixed)
        self._azimuth.show_value(common(map(azimuth_of, directions)), mixed=mixed)
        self._elevation.show_value(common(map(elevation_of, directions)), mixed=mixed)
        self._length.show_value(common(map(length_of, directions)))
        flags = [self._flags(i)[list(rows)] for i, rows in self._targets.items()]
        check(self._automatic, np.unique(np.concatenate(flags)).tolist())
        # What is a face's own already can't be kept: it would be the same.
        are_faces = all(isinstance(self._shapes[i], MeshSurface) for i in self._targets)
        self._automatic.setText("the face's own" if are_faces else "follows its neighbors")
        self._automatic.setEnabled(not are_faces or not all(found.all() for found in flags))

    def _different(self) -> Iterator[Floats]:
        """The directions, (dim,) each; of a shape on which all are the same only one."""
        for shape_id, rows in self._targets.items():
            found = self._shapes[shape_id].vectors[self._way][list(rows)]
            yield from found[:1] if (found == found[0]).all() else found

    def _each(self) -> list[tuple[ShapeId, int]]:
        return [(i, row) for i, rows in self._targets.items() for row in rows]

    def _is_told_of(self, geometry: Geometry) -> bool:
        return (len(geometry.vectors) == 2) == (self._side is not None)

    @property
    def _way(self) -> int:
        """Which of the directions of a net it is."""
        return 0 if self._side is None else WAYS.index(self._side)

    def _direction(self, shape_id: ShapeId, row: int) -> Floats:
        direction: Floats = self._shapes[shape_id].vectors[self._way, row]
        return direction

    def _flags(self, shape_id: ShapeId) -> Flags:
        """(n,) which directions of a shape are automatic."""
        flags: Flags = self._shapes[shape_id].net.automatic_vectors[self._way]
        return flags

    def _called(self, name: str) -> str:
        return name if self._side is None else f"{name} by {self._side}"

    def _number(
        self, label: str, name: str, edit: Callable[[float], Command], *, step: float = 5.0
    ) -> NumberField:
        field = NumberField(
            self._called(name), lambda value: self._desk.commit(edit(value)), step=step
        )
        self._form.addRow(row_label(label), field)
        return field

    @property
    def _of(self) -> Side:
        return self._side or "both"

    def _set_angle(self, value: float) -> Command:
        return SetAngle(self._targets, radians(value), side=self._of)

    def _set_azimuth(self, value: float) -> Command:
        return SetBearing(self._targets, azimuth=radians(value), side=self._of)

    def _set_elevation(self, value: float) -> Command:
        return SetBearing(self._targets, elevation=radians(value), side=self._of)

    def _set_length(self, value: float) -> Command:
        return SetLength(self._targets, value, side=self._of)

    def _switch_automatic(self) -> None:
        if not all(self._flags(i)[list(rows)].all() for i, rows in self._targets.items()):
            self._desk.commit(ResetDirections(self._targets, side=self._of))
            return
        keep = tuple(
            SetDirection(i, row, self._direction(i, row), side=self._of) for i, row in self._each()
        )
        noun = "direction" if len(keep) == 1 else f"{len(keep)} directions"
        self._desk.commit(Together(f"Keep {noun}", keep))


def azimuth_of(direction: Floats) -> float | None:
    """In degrees from the x axis towards the y axis, seen from the top; None of no direction."""
    if not direction[:2].any():
        return None
    return round(degrees(float(np.arctan2(direction[1], direction[0]))), 10)


def elevation_of(direction: Floats) -> float | None:
    """In degrees above the plane of x and y; None of no direction."""
    length = float(np.linalg.norm(direction))
    if not length:
        return None
    return round(degrees(asin(max(-1.0, min(1.0, float(direction[-1]) / length)))), 10)


def length_of(direction: Floats) -> float:
    """The length, free of the last digits that rounding leaves."""
    return round(hypot(*direction), 12)
