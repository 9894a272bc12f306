"""Plus curves as a library: immutable values and pure functions on numpy arrays.

    from plusedit.geometry import BSpline, ControlLines, PlusCurve, best_s, elevated

    lines = ControlLines.of([[0, 0], [1, 2], [3, 2], [4, 0]])  # directions are automatic
    curve = PlusCurve(BSpline(size=4, order=3), lines, s=2.0)
    points = curve.at([0.0, 0.5, 1.0])

A curve is a `PlusCurve`: a basis (`Bernstein`, `BSpline`, `RationalGaussian`), control lines and
the magnitude s. What can be asked of it and done to it lies in a module for each matter:

    elevation, standard, hulls     exact standard forms and back, and what encloses a curve
    insertion, sizes, transforms   lines more or fewer, another basis; moved, turned, reversed
    magnitude                      the length of the control polygon, the best s
    tangency, passing              tangent at the ends, closed smoothly, through its points
    frames, inflections, length    curvature, where it changes its sign, arc length
    nearest, tessellate            the nearest point, a grid fine enough to draw
    fitting                        a curve through dense points to a tolerance
"""

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import StandardCurve, elevated
from plusedit.geometry.fitting import fit_bspline_plus
from plusedit.geometry.frames import curvature_at
from plusedit.geometry.hulls import elevated_hull, parents, span_hulls, union_hull
from plusedit.geometry.inflections import inflections
from plusedit.geometry.insertion import insert_line, with_basis
from plusedit.geometry.length import arc_length
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import best_s, polygon_length
from plusedit.geometry.nearest import nearest_parameter, nearest_parameters
from plusedit.geometry.passing import passing_through
from plusedit.geometry.standard import (
    elliptic_arc,
    from_bezier,
    from_bezier_path,
    from_rational_quadratic,
    from_rational_quadratic_path,
)
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends
from plusedit.geometry.tessellate import tessellation
from plusedit.geometry.transforms import reversed_curve, transformed

__all__ = [
    "BSpline",
    "Bernstein",
    "ControlLines",
    "Grid",
    "PlusCurve",
    "RationalGaussian",
    "StandardCurve",
    "arc_length",
    "best_s",
    "closed_smoothly",
    "curvature_at",
    "elevated",
    "elevated_hull",
    "elliptic_arc",
    "fit_bspline_plus",
    "from_bezier",
    "from_bezier_path",
    "from_rational_quadratic",
    "from_rational_quadratic_path",
    "inflections",
    "insert_line",
    "nearest_parameter",
    "nearest_parameters",
    "parents",
    "passing_through",
    "polygon_length",
    "reversed_curve",
    "span_hulls",
    "tangent_at_ends",
    "tessellation",
    "transformed",
    "union_hull",
    "with_basis",
]
