"""How surfaces bend at the points that are drawn of them, from their second derivatives."""

from threading import Lock
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.evaluation import cone_points, jets
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_frames import PrincipalCurvatures, principal_curvatures
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing

ROUNDING = 1e-10  # of the largest curvature of a shape: smaller ones are taken to be zero

_OF_MESHES: "WeakKeyDictionary[MeshDrawing, PrincipalCurvatures]" = WeakKeyDictionary()
_FINDING = Lock()


def curvatures_on_grid(surface: PlusSurface, u: Floats, v: Floats) -> PrincipalCurvatures:
    """The principal curvatures (m_u, m_v) at every pair of parameters."""
    with np.errstate(all="ignore"):
        return _clean(principal_curvatures(surface.derivatives(u, v)))


def curvatures_of_drawing(surface: MeshSurface, drawing: MeshDrawing) -> PrincipalCurvatures:
    """Those (n,) at the points that are drawn, against the normals that are drawn.

    Found if need be, in whatever thread, and kept with the drawing. Where the domain of a closed
    surface has a cone point the surface need not be smooth: there they are nan.
    """
    with _FINDING:
        found = _OF_MESHES.get(drawing)
        if found is None:
            found = _OF_MESHES[drawing] = at_net(surface, drawing.net)[1]
    return found


def gaussian(found: PrincipalCurvatures) -> Floats:
    """The product of both."""
    product: Floats = found.largest * found.smallest
    return product


def mean(found: PrincipalCurvatures) -> Floats:
    """Half their sum."""
    half: Floats = (found.largest + found.smallest) / 2.0
    return half


def at_net(surface: MeshSurface, net: DrawnNet) -> tuple[Floats, PrincipalCurvatures]:
    """(n, 3) the points of a surface at the places of a net, and the curvatures there."""
    places = net.places
    with np.errstate(all="ignore"):
        derivatives = jets(surface, places, highest=2)
        found = principal_curvatures(derivatives)
        is_cone = np.zeros(len(places), dtype=np.bool_)
        is_cone[cone_points(surface.domain, places)] = True
        sides = np.ones(len(places)) if net.sides is None else net.sides
        # Seen from the other side, what was the largest curvature is the smallest.
        is_turned = sides < 0.0
        largest = np.where(is_turned, -found.smallest, found.largest)
        smallest = np.where(is_turned, -found.largest, found.smallest)
        first, second = found.along_largest, found.along_smallest
        seen = PrincipalCurvatures(
            np.where(is_cone, np.nan, largest),
            np.where(is_cone, np.nan, smallest),
            np.where(is_turned[:, None], second, first),
            np.where(is_turned[:, None], first, second),
        )
        return derivatives[0], _clean(seen)


def _clean(found: PrincipalCurvatures) -> PrincipalCurvatures:
    """Without rounding errors where there is no curvature, and without infinities."""
    both = [found.largest, found.smallest]
    for place, values in enumerate(both):
        both[place] = np.where(np.isfinite(values), values, np.nan)
    top = max((float(np.nanmax(np.abs(each), initial=0.0)) for each in both), default=0.0)
    for place, values in enumerate(both):
        both[place] = np.where(np.abs(values) <= ROUNDING * top, 0.0, values)
    return PrincipalCurvatures(both[0], both[1], found.along_largest, found.along_smallest)
