"""Plus curves and surfaces as a library: immutable values and pure functions on numpy arrays.

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

A surface is a `PlusSurface`: a basis by u and one by v, `ControlPlanes` and s. Its modules are

    surface_elevation, iso_curves  its standard form; curves on it, as plus curves
    corner_nets, convex_hull       what encloses it, and convex bodies in space
    surface_insertion, _sizes      rows and columns more or fewer, other bases
    surface_transforms             moved and turned; u and v swapped or run backwards
    surface_magnitude              the natural lengths, the best s, one s that suits both ways
    surface_tangency, _passing     tangent at the corners, through its control points
    surface_frames, surface_area   normals and curvatures, the area
    surface_nearest, _tessellate   the nearest point, where a ray meets it, grids fine enough
    surface_kernels, row_products  points, normals and buffers in single precision, to be drawn
"""

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.convex_hull import HullMesh, hull_mesh
from plusedit.geometry.corner_nets import corner_hull, corner_nets
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.elevation import StandardCurve, elevated
from plusedit.geometry.fitting import fit_bspline_plus
from plusedit.geometry.frames import curvature_at
from plusedit.geometry.hulls import elevated_hull, parents, span_hulls, union_hull
from plusedit.geometry.inflections import inflections
from plusedit.geometry.insertion import insert_line, with_basis
from plusedit.geometry.iso_curves import boundary_curves, iso_curve
from plusedit.geometry.length import arc_length
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import best_s, polygon_length
from plusedit.geometry.nearest import nearest_parameter, nearest_parameters, nearest_to_ray
from plusedit.geometry.passing import passing_through
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.row_products import load_kernels
from plusedit.geometry.standard import (
    elliptic_arc,
    from_bezier,
    from_bezier_path,
    from_rational_quadratic,
    from_rational_quadratic_path,
)
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_area import area
from plusedit.geometry.surface_elevation import StandardSurface, elevated_surface
from plusedit.geometry.surface_frames import (
    SurfaceFrame,
    frame_at,
    gaussian_curvature,
    mean_curvature,
    principal_curvatures,
)
from plusedit.geometry.surface_insertion import insert_column, insert_row
from plusedit.geometry.surface_kernels import points_and_normals, surface_points
from plusedit.geometry.surface_magnitude import (
    balanced,
    best_surface_s,
    natural_length,
    natural_lengths,
)
from plusedit.geometry.surface_nearest import RayHit, hit_by_ray, nearest_on_surface
from plusedit.geometry.surface_passing import passing_through_surface
from plusedit.geometry.surface_tangency import (
    tangent_at_corners,
    tangent_to_plane,
    tangent_to_planes,
)
from plusedit.geometry.surface_tessellate import surface_size, surface_tessellation
from plusedit.geometry.surface_transforms import (
    reversed_surface,
    transformed_surface,
    transposed,
)
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends
from plusedit.geometry.tessellate import tessellation
from plusedit.geometry.transforms import reversed_curve, transformed

__all__ = [
    "BSpline",
    "Bernstein",
    "ControlLines",
    "ControlPlanes",
    "Grid",
    "HullMesh",
    "PlusCurve",
    "PlusSurface",
    "RationalGaussian",
    "RayHit",
    "StandardCurve",
    "StandardSurface",
    "SurfaceFrame",
    "arc_length",
    "area",
    "balanced",
    "best_s",
    "best_surface_s",
    "boundary_curves",
    "closed_smoothly",
    "corner_hull",
    "corner_nets",
    "curvature_at",
    "elevated",
    "elevated_hull",
    "elevated_surface",
    "elliptic_arc",
    "fit_bspline_plus",
    "frame_at",
    "from_bezier",
    "from_bezier_path",
    "from_rational_quadratic",
    "from_rational_quadratic_path",
    "gaussian_curvature",
    "hit_by_ray",
    "hull_mesh",
    "inflections",
    "insert_column",
    "insert_line",
    "insert_row",
    "iso_curve",
    "load_kernels",
    "mean_curvature",
    "natural_length",
    "natural_lengths",
    "nearest_on_surface",
    "nearest_parameter",
    "nearest_parameters",
    "nearest_to_ray",
    "parents",
    "passing_through",
    "passing_through_surface",
    "points_and_normals",
    "polygon_length",
    "principal_curvatures",
    "reversed_curve",
    "reversed_surface",
    "span_hulls",
    "surface_points",
    "surface_size",
    "surface_tessellation",
    "tangent_at_corners",
    "tangent_at_ends",
    "tangent_to_plane",
    "tangent_to_planes",
    "tessellation",
    "transformed",
    "transformed_surface",
    "transposed",
    "union_hull",
    "with_basis",
]
