"""Designs that the tests of commands edit."""

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

A, B = ShapeId("a"), ShapeId("b")

POINTS = [[0.0, 0.0], [1.0, 2.0], [2.0, 0.5], [3.0, 2.0], [4.0, 0.0], [5.0, 1.0]]


def spline(**changes):
    """Six lines, number 2 with a direction of its own."""
    directions = [None, None, [2.0, 0.5], None, None, None]
    values = {"basis": BSpline(6, 4), "lines": ControlLines.of(POINTS, directions), "s": 2.0}
    return PlusCurve(**{**values, **changes})


def arch():
    """A Bezier+ of four lines."""
    lines = ControlLines.of([[0.0, -1.0], [1.0, -3.0], [2.0, -3.0], [3.0, -1.0]])
    return PlusCurve(Bernstein(4), lines, 1.0)


def known(curve=None):
    """The curve, the spline by default, as A behind the arch as B."""
    return Design({A: Shape(spline() if curve is None else curve, "A"), B: Shape(arch(), "B")})


def curves(design):
    return [curve for _, curve in design.curves()]
