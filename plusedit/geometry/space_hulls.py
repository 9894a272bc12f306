"""The regions of `hulls` in space: convex bodies that a space curve cannot leave.

A plane curve lies in z = 0, and its bodies are flat.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.convex_hull import HullMesh, hull_mesh
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import elevated
from plusedit.geometry.hulls import line_ends, parents, span_points


def union_body(curve: PlusCurve) -> HullMesh:
    """The convex hull of all lines at both ends; the curve lies in it.

    Of a closed B-spline+ curve, whose lines come back shifted, it is that of all spans.
    ValueError for a closed curve of another family.
    """
    points = span_points(curve).reshape(-1, curve.dimension) if curve.closed else None
    return _body(np.concatenate(line_ends(curve)) if points is None else points)


def parent_bodies(curve: PlusCurve) -> tuple[HullMesh, HullMesh]:
    """The convex hulls of the control points of both parents; ValueError for a closed curve."""
    first, second = parents(curve)
    return _body(first.lines.points), _body(second.lines.points)


def elevated_body(curve: PlusCurve) -> HullMesh:
    """The convex hull of the control points in standard form, which is a tighter one.

    ValueError where the family has no standard form.
    """
    return _body(elevated(curve).points)


def span_bodies(curve: PlusCurve) -> list[HullMesh]:
    """For the piece between each two neighboring knots, a convex hull that holds it.

    A curve without knots is one piece. ValueError for a closed curve of another family than
    B-splines.
    """
    return [_body(points) for points in span_points(curve)]


def _body(points: Floats) -> HullMesh:
    if points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    return hull_mesh(points)
