"""Curves fitted to points: new ones, and those that are fitted anew.

A fitted curve keeps what it was fitted to, under the key "fit" of its shape, so that it can be
fitted again more closely or with fewer lines.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from math import isfinite
from types import MappingProxyType

import numpy as np

from plusedit.commands.base import Command, unlocked, with_shapes
from plusedit.commands.naming import free_name
from plusedit.document.design import Design, EditError
from plusedit.document.selection import Selection
from plusedit.document.shape import Json, Shape, ShapeId, Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.fitting import Fitted, fit_bspline_plus

KEY = "fit"
MOST = 20_000  # points that a shape keeps


@dataclass(frozen=True, eq=False)
class FitSource:
    """What a curve is fitted to, and how closely."""

    points: Floats
    """(m, dim) in their order along the curve"""
    tolerance: float
    """the largest distance, in the unit of the points"""
    closed: bool = False
    order: int = 4
    corners: tuple[int, ...] = ()
    """numbers of the points at which the curve has a corner"""

    def within(self, tolerance: float) -> "FitSource":
        """The same points with another tolerance."""
        return replace(self, tolerance=tolerance)

    @cached_property
    def fitted(self) -> Fitted:
        """The curve. EditError, in a sentence, where there is none."""
        try:
            return fit_bspline_plus(
                self.points,
                tolerance=self.tolerance,
                order=self.order,
                closed=self.closed,
                corners=self.corners,
            )
        except ValueError as error:
            raise EditError(str(error)) from error

    @property
    def tree(self) -> Mapping[str, Json]:
        """As the shape keeps it."""
        return MappingProxyType(
            {
                "points": self.points.tolist(),
                "tolerance": self.tolerance,
                "closed": self.closed,
                "order": self.order,
                "corners": list(self.corners),
            }
        )


def fit_source(shape: Shape) -> FitSource | None:
    """What a shape was fitted to; None if it was not, or says so in a way that makes no sense."""
    kept = shape.extra.get(KEY)
    if shape.curve is None or not isinstance(kept, Mapping):
        return None
    tolerance, closed, order = (kept.get(key) for key in ("tolerance", "closed", "order"))
    if not (isinstance(tolerance, float | int) and isfinite(tolerance) and tolerance > 0.0):
        return None
    if not isinstance(closed, bool) or type(order) is not int or not 2 <= order <= 20:
        return None
    try:
        points = np.array(kept.get("points"), dtype=np.float64)
    except (TypeError, ValueError):
        return None
    if points.ndim != 2 or len(points) < 2 or points.shape[1] != shape.curve.dimension:
        return None
    corners = _corners(kept.get("corners", []), len(points))
    if corners is None or not np.isfinite(points).all():
        return None
    return FitSource(points, float(tolerance), closed, order, corners)


def _corners(value: Json, count: int) -> tuple[int, ...] | None:
    if not isinstance(value, list):
        return None
    found = tuple(number for number in value if type(number) is int and 0 <= number < count)
    return found if len(found) == len(value) else None


def fitted_shape(source: FitSource, name: str, style: Style | None = None) -> Shape:
    """A shape of the fitted curve, which remembers its source."""
    extra = {KEY: source.tree} if len(source.points) <= MOST else {}
    return Shape(source.fitted.curve, name, style=style or Style(), extra=MappingProxyType(extra))


@dataclass(frozen=True, eq=False)
class DrawFitted(Command):
    """Add a curve fitted to points; it is selected then."""

    source: FitSource
    name: str = "Curve"

    @property
    def label(self) -> str:
        return "Draw curve by hand"

    def apply(self, design: Design) -> Design:
        shape = fitted_shape(self.source, free_name(design, self.name))
        return design.with_shape(design.unused_id("curve"), shape)

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return Selection.of_shapes(shape_id for shape_id in new if shape_id not in old)


@dataclass(frozen=True, eq=False)
class Refit(Command):
    """Fit a curve anew, to what it was fitted to before or to other points."""

    shape_id: ShapeId
    source: FitSource

    @property
    def label(self) -> str:
        return "Fit curve"

    def apply(self, design: Design) -> Design:
        shape = unlocked(design, self.shape_id)
        if shape.curve is None:
            raise EditError(f"{shape.name} is not a curve")
        if self.source.points.shape[1] != shape.curve.dimension:
            raise EditError(f"{shape.name} has points of {shape.curve.dimension} numbers")
        made = fitted_shape(self.source, shape.name, shape.style)
        extra = MappingProxyType({**shape.extra, **made.extra})
        return with_shapes(
            design,
            {self.shape_id: replace(shape, geometry=made.geometry, extra=extra, constraints=())},
        )


@dataclass(frozen=True, eq=False)
class JoinFitted(Command):
    """Put one fitted curve in the place of curves that meet end to end; it is selected then."""

    ids: tuple[ShapeId, ...]
    source: FitSource

    @property
    def label(self) -> str:
        return f"Join {len(self.ids)} curves"

    def apply(self, design: Design) -> Design:
        shapes = [unlocked(design, shape_id) for shape_id in self.ids]
        made = fitted_shape(self.source, shapes[0].name, shapes[0].style)
        first, *others = self.ids
        return with_shapes(design, {first: made}).without(*others)

    def reselect(self, selection: Selection, old: Design, new: Design) -> Selection:
        return Selection.of_shapes(self.ids[:1])
