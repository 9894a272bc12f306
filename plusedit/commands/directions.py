"""Edits of directions, on any number of lines of any shapes.

What is turned, stretched or set becomes given: it follows its neighbours no longer until it is
reset. A direction is turned in one plane of coordinates; what it has across that plane stays.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import cos, pi, sin

import numpy as np

from plusedit.commands.base import Command, Landing, Targets, counted, edit_lines, fitted
from plusedit.document.design import Design
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

Plane = tuple[int, int]
"""Two axes: a positive angle turns from the first to the second."""

TOP: Plane = (0, 1)


def redirected(
    design: Design,
    targets: Targets,
    change: Callable[[PlusCurve, Floats], Floats],
    landing: Landing | None = None,
) -> Design:
    """The design with the named directions (k, dim) replaced by what `change` makes of them."""

    def edited(shape_id: ShapeId, curve: PlusCurve, rows: list[int]) -> ControlLines:
        lines = curve.lines
        given, automatic = lines.given.copy(), lines.automatic.copy()
        given[rows] = change(curve, curve.directions[rows])
        if landing is not None and landing.shape_id == shape_id:
            given[landing.number] = fitted(landing.vector, curve.dimension)
        automatic[rows] = False
        return replace(lines, given=given, automatic=automatic)

    return edit_lines(design, targets, edited)


def quarter_exact(angle: float) -> tuple[float, float]:
    """Cosine and sine, free of rounding at multiples of a quarter turn."""
    quarters = angle / (pi / 2.0)
    if quarters == round(quarters):
        return ((1.0, 0.0), (0.0, 1.0), (-1.0, 0.0), (0.0, -1.0))[round(quarters) % 4]
    return cos(angle), sin(angle)


def turned(vectors: Floats, angle: float, plane: Plane = TOP) -> Floats:
    """Vectors (k, dim) turned by `angle` in radians. ValueError if they don't have the plane."""
    first, second = plane
    if max(plane) >= vectors.shape[1]:
        raise ValueError("a plane curve can be turned in the top view only")
    c, s = quarter_exact(angle)
    result = vectors.copy()
    result[:, first] = c * vectors[:, first] - s * vectors[:, second]
    result[:, second] = s * vectors[:, first] + c * vectors[:, second]
    return result


@dataclass(frozen=True, eq=False)
class Turn(Command):
    """Turn directions by the same angle, and stretch them by the same factor if one is given."""

    targets: Targets
    angle: float
    """in radians, counter-clockwise as seen in the plane"""
    plane: Plane = TOP
    factor: float = 1.0
    landing: Landing | None = None
    """of one of the directions: where it is to point exactly"""

    @property
    def label(self) -> str:
        return counted(self.targets, "Rotate" if self.factor == 1.0 else "Stretch")

    def apply(self, design: Design) -> Design:
        if self.angle == 0.0 and self.factor == 1.0 and self.landing is None:
            return edit_lines(design, self.targets, lambda _, curve, rows: curve.lines)

        def changed(_: PlusCurve, directions: Floats) -> Floats:
            return turned(directions, self.angle, self.plane) * self.factor

        return redirected(design, self.targets, changed, self.landing)


@dataclass(frozen=True, eq=False)
class SetDirection(Command):
    """Give one line a direction, or None to let it follow its neighbours again."""

    shape_id: ShapeId
    number: int
    direction: Floats | None

    @property
    def label(self) -> str:
        return "Reset direction" if self.direction is None else "Set direction"

    def apply(self, design: Design) -> Design:
        targets = {self.shape_id: (self.number,)}
        if self.direction is None:
            return ResetDirections(targets).apply(design)
        direction = self.direction
        return redirected(
            design, targets, lambda curve, _: fitted(direction, curve.dimension)[None]
        )


@dataclass(frozen=True, eq=False)
class SetAngle(Command):
    """Point directions the same way in a plane; lengths stay, what has none gets length 1."""

    targets: Targets
    angle: float
    """in radians from the first axis of the plane towards the second"""
    plane: Plane = TOP

    @property
    def label(self) -> str:
        return counted(self.targets, "Set angle of")

    def apply(self, design: Design) -> Design:
        def pointed(_: PlusCurve, directions: Floats) -> Floats:
            if max(self.plane) >= directions.shape[1]:
                raise ValueError("the angle of a plane curve is that in the top view")
            columns = list(self.plane)
            length = np.linalg.norm(directions[:, columns], axis=1)
            length[~directions.any(axis=1)] = 1.0
            result = directions.copy()
            result[:, columns] = length[:, None] * np.array(quarter_exact(self.angle))
            return result

        return redirected(design, self.targets, pointed)


@dataclass(frozen=True, eq=False)
class SetLength(Command):
    """Give directions the same length; a direction of no length must point somewhere first."""

    targets: Targets
    length: float

    @property
    def label(self) -> str:
        return counted(self.targets, "Set length of")

    def apply(self, design: Design) -> Design:
        def stretched(_: PlusCurve, directions: Floats) -> Floats:
            if not self.length >= 0.0:
                raise ValueError("a length can't be negative; reverse the direction instead")
            now = np.linalg.norm(directions, axis=1, keepdims=True)
            if self.length > 0.0 and not now.all():
                raise ValueError("a control line without a direction can't be made longer")
            scale = np.divide(self.length, now, out=np.zeros_like(now), where=now > 0.0)
            longer: Floats = directions * scale
            return longer

        return redirected(design, self.targets, stretched)


@dataclass(frozen=True, eq=False)
class ScaleDirections(Command):
    """Multiply directions by a number; a negative one reverses them."""

    targets: Targets
    factor: float

    @property
    def label(self) -> str:
        return counted(self.targets, "Stretch")

    def apply(self, design: Design) -> Design:
        if self.factor == 1.0:
            return edit_lines(design, self.targets, lambda _, curve, rows: curve.lines)
        return redirected(design, self.targets, lambda _, d: d * self.factor)


@dataclass(frozen=True, eq=False)
class ReverseDirections(Command):
    """Point directions the other way."""

    targets: Targets

    @property
    def label(self) -> str:
        return counted(self.targets, "Reverse")

    def apply(self, design: Design) -> Design:
        # 0 - d and not -d: a zero direction would else become -0 and look changed in the file.
        return redirected(design, self.targets, lambda _, d: 0.0 - d)


@dataclass(frozen=True, eq=False)
class ResetDirections(Command):
    """Let directions follow the neighbouring control points again."""

    targets: Targets

    @property
    def label(self) -> str:
        return counted(self.targets, "Reset")

    def apply(self, design: Design) -> Design:
        def reset(_: ShapeId, curve: PlusCurve, rows: list[int]) -> ControlLines:
            if curve.lines.automatic[rows].all():
                return curve.lines
            automatic = curve.lines.automatic.copy()
            automatic[rows] = True
            return replace(curve.lines, automatic=automatic)

        return edit_lines(design, self.targets, reset)
