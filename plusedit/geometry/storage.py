"""What it takes to store a shape: its control elements, its numbers, and those of its exact
standard form, one degree higher.

Counted are coordinates of points, of directions that are not automatic, weights, knots, nodes and
widths where they are given, and s unless it is zero. Whole numbers, such as orders, are not.
"""

from dataclasses import dataclass, fields

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.net import ControlNet
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_elevation import elevated_surface


@dataclass(frozen=True)
class StandardForm:
    """The classical Bezier, B-spline or NURBS shape that is the same."""

    degrees: tuple[int, ...]
    points: int
    numbers: int


@dataclass(frozen=True)
class Storage:
    """What is stored of a shape."""

    degrees: tuple[int, ...] | None
    """of the classical shape of the same control points, by u or by u and v; None: no polynomial"""
    elements: int
    """control lines, planes or faces"""
    numbers: int
    form: StandardForm | None
    """None where there is none, and of what is classical itself, s = 0"""


def storage(geometry: PlusCurve | PlusSurface | MeshSurface) -> Storage:
    """What is stored of a curve, a surface, or the surface of a mesh."""
    if isinstance(geometry, MeshSurface):
        return Storage(None, geometry.mesh.face_count, _of_mesh(geometry), None)
    bases = (geometry.basis,) if isinstance(geometry, PlusCurve) else geometry.bases
    degrees = tuple(degree for basis in bases if (degree := _degree(basis)) is not None)
    numbers = stored_numbers(geometry)
    if len(degrees) < len(bases):
        return Storage(None, len(geometry.net), numbers, None)
    form = None if geometry.s == 0.0 else _standard(geometry)
    return Storage(degrees, len(geometry.net), numbers, form)


def stored_numbers(geometry: PlusCurve | PlusSurface) -> int:
    """How many numbers are stored of a curve or a surface."""
    bases = (geometry.basis,) if isinstance(geometry, PlusCurve) else geometry.bases
    return _of_net(geometry.net) + sum(map(_of_basis, bases)) + (geometry.s != 0.0)


def _degree(basis: Basis) -> int | None:
    if isinstance(basis, BSpline):
        return basis.order - 1
    return basis.size - 1 if isinstance(basis, Bernstein) else None


def _of_net(net: ControlNet) -> int:
    points, weights = net.control_points, net.weight_row
    given = int(np.count_nonzero(~net.automatic_vectors))
    return points.size + given * net.dimension + (0 if weights is None else weights.size)


def _of_basis(basis: Basis) -> int:
    """The numbers among its fields: rows of them, and those that are not whole."""
    values = (getattr(basis, field.name) for field in fields(basis))  # type: ignore[arg-type]
    return sum(len(v) if isinstance(v, tuple) else int(isinstance(v, float)) for v in values)


def _of_mesh(surface: MeshSurface) -> int:
    """Vertices, parameters of corners, S and s, local factors, and planes that were edited."""
    parts = [surface.mesh.vertices.size, surface.parameters.size, 2]
    parts += [] if surface.factors is None else [surface.factors.size]
    parts += [
        given.size
        for plane in surface.edited.values()
        for given in (plane.point, plane.gradient_u, plane.gradient_v)
        if given is not None
    ]
    return sum(parts)


def _standard(geometry: PlusCurve | PlusSurface) -> StandardForm:
    if isinstance(geometry, PlusCurve):
        curve = elevated(geometry)
        numbers = _of_form(curve.points, curve.weights) + _of_knots(curve.knots, curve.order)
        return StandardForm((curve.degree,), len(curve.points), numbers)
    surface = elevated_surface(geometry)
    numbers = _of_form(surface.points, surface.weights)
    numbers += _of_knots(surface.knots_u, surface.order_u)
    numbers += _of_knots(surface.knots_v, surface.order_v)
    return StandardForm(surface.degrees, int(np.prod(surface.points.shape[:-1])), numbers)


def _of_form(points: Floats, weights: Floats | None) -> int:
    return points.size + (0 if weights is None else weights.size)


def _of_knots(knots: Floats, order: int) -> int:
    """None where zeros and ones are all there is, as of a Bezier curve."""
    return 0 if len(knots) == 2 * order else len(knots)
