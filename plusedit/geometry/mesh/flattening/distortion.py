"""What a map does to the triangles of a mesh: turns them over, or stretches them.

A map takes a triangle to the plane by a linear map with two singular values a >= b > 0: lengths
grow by a in one direction and by b across it. a / b is 1 where angles are kept; a b is what areas
grow by.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.polygons import PolygonMesh

FLAT = 1e-12  # of the area of a triangle to its squared size: less has no direction
ROUNDING = 1e-15  # of a parameter


class Stretch(NamedTuple):
    """How a map distorts each face."""

    angles: Floats
    """(f,) a / b >= 1: one where angles are kept, infinite where the face collapses"""
    areas: Floats
    """(f,) a b, divided by its mean over the mesh: one where the face has its share of the map"""


def signed_areas(mesh: PolygonMesh, parameters: Floats) -> Floats:
    """(t,) areas in the plane of the mesh's triangles, negative where they are turned over."""
    areas: Floats = 0.5 * doubled_areas(parameters[mesh.triangulation.corners])
    return areas


def flipped(mesh: PolygonMesh, parameters: Floats) -> NDArray[np.bool_]:
    """(f,) true for faces of which some triangle is turned over.

    A triangle that is flat up to the rounding of its parameters is not turned over.
    """
    marks = np.zeros(mesh.face_count, dtype=np.bool_)
    cut = mesh.triangulation
    marks[cut.owners[turned_over(parameters[cut.corners])]] = True
    return marks


def flips(mesh: PolygonMesh, parameters: Floats) -> int:
    """How many triangles of the mesh are turned over by parameters (c, 2), unwrapped by face."""
    return int(np.count_nonzero(turned_over(parameters[mesh.triangulation.corners])))


def turned_over(places: Floats) -> NDArray[np.bool_]:
    """(t,) true for triangles (t, 3, 2) in the plane that are turned over."""
    areas = doubled_areas(places)
    turned: NDArray[np.bool_] = areas < 0.0
    suspects = np.flatnonzero(turned)
    around = places[suspects]
    rounding = ROUNDING * np.abs(around).max(axis=(1, 2)) * np.ptp(around, axis=1).max(axis=1)
    turned[suspects] = areas[suspects] < -2.0 * rounding
    return turned


def stretch(mesh: PolygonMesh, parameters: Floats) -> Stretch:
    """How parameters (c, 2) distort every face; of polygons the mean over their area.

    Triangles without area in space count nothing.
    """
    cut = mesh.triangulation
    around, places = mesh.vertices[cut.triangles], parameters[cut.corners]
    ratios, doubled, usable = angle_ratios(around, places)
    ratios, weights = ratios[usable], doubled[usable]
    owners, count = cut.owners[usable], mesh.face_count
    areas = np.bincount(owners, weights, minlength=count)
    safe = np.where(areas > 0.0, areas, 1.0)
    angles = np.bincount(owners, weights * ratios, minlength=count) / safe
    grown = np.bincount(cut.owners, 2.0 * np.abs(signed_areas(mesh, parameters)), minlength=count)
    mean = grown.sum() / areas.sum() if areas.sum() > 0.0 and grown.sum() > 0.0 else 1.0
    has_area = areas > 0.0
    return Stretch(np.where(has_area, angles, 1.0), np.where(has_area, grown / (safe * mean), 1.0))


def angle_ratios(around: Floats, places: Floats) -> tuple[Floats, Floats, NDArray[np.bool_]]:
    """(t,) a / b of triangles with corners (t, 3, 3) in space and (t, 3, 2) in the map; (t,) twice
    their areas in space; (t,) true where there is enough of that for the ratio to mean anything."""
    first, second, third = around.transpose(1, 0, 2)
    doubled = np.linalg.norm(np.cross(second - first, third - first), axis=1)
    sides = np.stack([third - second, first - third, second - first], axis=1)
    squares = np.einsum("tcd,tcd->tc", sides, sides)
    usable: NDArray[np.bool_] = doubled > FLAT * squares.max(axis=1, initial=0.0)
    slopes = np.einsum("tck,tcd->tkd", places - places[:, :1], sides)
    form = np.einsum("tkd,tld->tkl", slopes, slopes)
    # a^2 + b^2 and a b, both times the squared doubled area.
    trace = form[:, 0, 0] + form[:, 1, 1]
    product = np.abs(doubled_areas(places)) * doubled
    root = np.sqrt(np.maximum(trace**2 - 4.0 * product**2, 0.0))
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        ratios = np.where(product > 0.0, (trace + root) / (2.0 * product), np.inf)
    return np.maximum(ratios, 1.0), doubled, usable


def doubled_areas(places: Floats) -> Floats:
    """(t,) twice the areas of triangles in the plane, negative where they are turned over."""
    first, second, third = places.transpose(1, 2, 0)
    (a, b), (c, d) = second - first, third - first
    areas: Floats = a * d - b * c
    return areas
