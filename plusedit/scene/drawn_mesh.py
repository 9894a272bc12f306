"""Surfaces of meshes as they are drawn, and what is known of them by now.

A surface of a large mesh takes a while to evaluate. Windows never wait for that: they draw the best
there is, have the rest evaluated beside, and hand in what came of it. What was evaluated is kept
with its surface, for as long as that lives. After an edit of a few faces only what they reach is
evaluated anew.
"""

from typing import NamedTuple
from weakref import WeakKeyDictionary, WeakSet

import numpy as np
from numpy.typing import NDArray

from plusedit.document.design import Design, changed
from plusedit.document.shape import Shape
from plusedit.geometry.mesh.evaluation import Check, points_and_normals, unchecked
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.scene.mesh_nets import bare_net, known_net, net_of
from plusedit.scene.moved_meshes import moved_drawing

KEPT = 24  # drawings, and small ones beyond
KEPT_POINTS = 2_000_000  # of all that are kept
AT_ONCE = 2_000_000  # planes at places that are evaluated in the time of a frame
AWAITED = 100_000_000  # and in about a second
WIDE = 700.0  # planes that are within reach of a place, for S = 1
NEAR = 60.0  # and for a small S


class Known(NamedTuple):
    """A surface and what has been evaluated of it."""

    surface: MeshSurface
    drawing: MeshDrawing


_DRAWINGS: "WeakKeyDictionary[MeshSurface, MeshDrawing]" = WeakKeyDictionary()
"""The one asked for last comes last."""
_UNKNOWN: "WeakSet[MeshSurface]" = WeakSet()
"""Those that have been looked for among the drawings, as long as these stay the same."""
_BARE: "WeakKeyDictionary[MeshSurface, MeshDrawing]" = WeakKeyDictionary()


def drawing_of(surface: MeshSurface, *, wait: bool = True) -> MeshDrawing:
    """The surface as it is drawn.

    Without `wait` only what is known by now: the surface before the last change, or the mesh
    itself, where it has not been evaluated. With it evaluated to full accuracy, or where that would
    take more than about a second so nearly that no picture tells.
    """
    known = known_drawing(surface)
    if known is not None and (known.is_exact or not wait):
        return known
    if not wait:
        return _stand_in(surface)
    before = known_before(surface)
    if before is None and len(net_of(surface).places) * _planes_near(surface) > AWAITED:
        return known or keep(surface, previewed(surface))
    return keep(surface, evaluated(surface, before))


def known_drawing(surface: MeshSurface) -> MeshDrawing | None:
    """What has been evaluated of the surface, or of one that was moved to it as a whole."""
    found = _DRAWINGS.pop(surface, None)
    if found is not None:
        _DRAWINGS[surface] = found
        return found
    if surface in _UNKNOWN:
        return None
    for other, drawing in reversed(list(_DRAWINGS.items())):
        moved = moved_drawing(surface, other, drawing)
        if moved is not None:
            return keep(surface, moved)
    _UNKNOWN.add(surface)
    return None


def known_before(surface: MeshSurface) -> Known | None:
    """A surface that differs in planes and local factors only, evaluated to full accuracy."""
    for other, drawing in reversed(list(_DRAWINGS.items())):
        if drawing.is_exact and _differs_locally(surface, other):
            return Known(other, drawing)
    return None


def looks_alike(old: Design, new: Design) -> bool:
    """Whether designs differ in nothing but surfaces of meshes that are yet to be evaluated.

    For now both are drawn in the same way.
    """
    if list(old) != list(new):
        return False
    return all(_look_alike(old[i], new[i]) for i in changed(old, new))


def _look_alike(old: Shape, new: Shape) -> bool:
    before, after = old.mesh, new.mesh
    if before is None or after is None:
        return False
    if (old.style, old.visible, old.locked) != (new.style, new.visible, new.locked):
        return False
    is_same_net = before.mesh is after.mesh and before.net is after.net
    return is_same_net and drawing_of(before, wait=False) is drawing_of(after, wait=False)


def keep(surface: MeshSurface, drawing: MeshDrawing) -> MeshDrawing:
    """Draw a surface like that from now on; to be called from the thread that draws."""
    _DRAWINGS.pop(surface, None)
    _DRAWINGS[surface] = drawing
    _UNKNOWN.clear()
    drawing.net.latest[:] = [drawing]
    points = sum(len(kept.points) for kept in _DRAWINGS.values())
    while len(_DRAWINGS) > KEPT and points > KEPT_POINTS:
        points -= len(_DRAWINGS.pop(next(iter(_DRAWINGS))).points)
    return drawing


def evaluated(
    surface: MeshSurface, before: Known | None = None, check: Check = unchecked
) -> MeshDrawing:
    """The surface at its vertices and between them, to full accuracy; what `check` raises.

    Where it is known before an edit, only what that has changed is evaluated. Takes its time, in
    whatever thread.
    """
    rows = None if before is None else _changed(surface, before)
    if before is not None and rows is not None:
        return _patched(surface, before.drawing, rows, check)
    net = net_of(surface)
    return MeshDrawing.of(net, *points_and_normals(surface, net.places, check), exact=True)


def previewed(surface: MeshSurface, before: Known | None = None) -> MeshDrawing:
    """The same within the time of a frame or some, nearly right unless an edit is small."""
    from plusedit.geometry.mesh.preview import preview

    rows = None if before is None else _changed(surface, before)
    near = _planes_near(surface)
    if before is not None and rows is not None and near * len(rows) <= AT_ONCE:
        return _patched(surface, before.drawing, rows)
    net = net_of(surface)
    return MeshDrawing.of(net, *preview(surface, net.places), exact=False)


def _planes_near(surface: MeshSurface) -> float:
    """How many planes, and images of them, count at a place to full accuracy, about."""
    return NEAR + WIDE * surface.smoothness**2


def _changed(surface: MeshSurface, before: Known) -> NDArray[np.intp] | None:
    """The vertices of the drawing before that are elsewhere; None where that may be all."""
    from plusedit.geometry.mesh.neighborhood import changed_places

    return changed_places(before.surface, surface, before.drawing.net.places)


def _patched(
    surface: MeshSurface, drawing: MeshDrawing, rows: NDArray[np.intp], check: Check = unchecked
) -> MeshDrawing:
    """The drawing with some vertices evaluated anew."""
    net = drawing.net
    points, normals = drawing.points.copy(), drawing.normals.copy()
    points[rows], normals[rows] = points_and_normals(surface, net.places[rows], check)
    if net.sides is not None:
        normals[rows] *= net.sides[rows, None]
    return MeshDrawing(net, points, normals)


def _differs_locally(one: MeshSurface, other: MeshSurface) -> bool:
    return (
        one.mesh is other.mesh
        and one.parameters is other.parameters
        and one.domain == other.domain
        and (one.smoothness, one.s, one.area_weights)
        == (other.smoothness, other.s, other.area_weights)
    )


def _stand_in(surface: MeshSurface) -> MeshDrawing:
    net = known_net(surface)
    if net is not None and net.latest:
        return net.latest[0]
    bare = _BARE.get(surface)
    if bare is None:
        bare = MeshDrawing(bare_net(surface), surface.mesh.vertices, is_exact=False)
        _BARE[surface] = bare
    return bare
