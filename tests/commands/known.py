"""Designs that the tests of commands edit."""

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

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


def sheet(**changes):
    """Four rows of five planes over [0, 3] x [0, 4], plane 7 with directions of its own."""
    x, y = np.meshgrid(np.arange(4.0), np.arange(5.0), indexing="ij")
    points = np.stack([x, y, np.sin(1.3 * x) * np.cos(y)], axis=-1)
    by_u, by_v = ([[None] * 5 for _ in range(4)] for _ in range(2))
    by_u[1][2], by_v[1][2] = [1.5, 0.25, 0.5], [0.0, 1.0, -0.5]
    planes = ControlPlanes.of(points, by_u, by_v)
    values = {"basis_u": BSpline(4, 3), "basis_v": BSpline(5, 4), "planes": planes, "s": 1.5}
    return PlusSurface(**{**values, **changes})


def known(geometry=None):
    """The curve or surface, the spline by default, as A behind the arch as B."""
    first = spline() if geometry is None else geometry
    return Design({A: Shape(first, "A"), B: Shape(arch(), "B")})


def geometries(design):
    return [geometry for _, geometry in design.drawn()]
