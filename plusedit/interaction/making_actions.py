"""Actions that add surfaces: simple bodies in the middle of the view, and surfaces from curves."""

from collections.abc import Callable, Iterator

import numpy as np

from plusedit.commands.base import Command
from plusedit.commands.making import AddSurface, Extrude, Fill, Loft, Revolve, Rule
from plusedit.document.design import EditError
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.making.compatible import in_space
from plusedit.geometry.making.extrusion import normal_of
from plusedit.geometry.making.primitives import exact_sphere, sheet, sphere, torus, tube
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.actions import EditAction
from plusedit.interaction.selecting import shapes_of
from plusedit.interaction.tool import Outcome, Stage
from plusedit.interaction.world_axes import world_axes
from plusedit.scene.space_camera import SpaceCamera

NEW, FROM_CURVES = "Surface/New", "Surface/From curves"

SHARE = 0.5  # of the shorter side of the view that a new surface takes up
SAMPLES = 65  # of a curve, to see how large it is and how it lies

Ids = tuple[ShapeId, ...]
Body = Callable[[float, Floats], PlusSurface]
"""A surface of a size, about a center (3,)."""

AXES = (("x", (1.0, 0.0, 0.0)), ("y", (0.0, 1.0, 0.0)), ("z", (0.0, 0.0, 1.0)))


def place_in_view(stage: Stage) -> tuple[float, Floats]:
    """The size of a new surface, a round number, and its center (3,) in the middle of the view.

    In space the center is what the eye looks at; in a plane view, as near to the origin as can be.
    """
    camera = stage.camera
    size = round_number(SHARE * min(camera.size) * camera.pixel)
    if isinstance(camera, SpaceCamera):
        center = np.array(camera.target)
    else:
        origin, ahead = camera.ray(np.array(camera.size) / 2.0)
        center = origin - (origin @ ahead) * ahead
    step = size / 20.0
    return size, np.round(center / step) * step + 0.0


def round_number(length: float) -> float:
    """1, 2 or 5 times a power of ten, the largest that is not above the length."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(max(f * power for f in (1.0, 2.0, 5.0) if f * power <= length * (1.0 + 1e-9)))


def selected_curves(stage: Stage, wanted: str) -> Ids:
    """The selected curves that can be edited, back to front. EditError, the wanted, if none is."""
    if not stage.selection:
        raise EditError(wanted)
    found = tuple(i for i in shapes_of(stage) if stage.design[i].curve is not None)
    if not found:
        raise EditError(wanted)
    return found


def extrude(stage: Stage) -> Outcome:
    """Across the plane of the curves, by half their extent."""
    ids = selected_curves(stage, "Select a curve to extrude.")
    points = np.concatenate([_points(stage.design.curve(i)) for i in ids])
    extent = float(np.linalg.norm(np.ptp(points, axis=0)))
    if not extent > 0.0:
        raise EditError("A curve in one point can't be extruded.")
    return Extrude(ids, round_number(extent / 2.0) * normal_of(points))


def revolve(stage: Stage, axis: Floats) -> Outcome:
    """A whole turn about an axis through the origin."""
    ids = selected_curves(stage, "Select a curve to revolve.")
    return Revolve(ids, np.zeros(3), axis)


def revolve_upright(stage: Stage) -> Outcome:
    """A whole turn about the axis of the world that runs upwards in the view."""
    axis, _ = world_axes(stage.camera)[1]
    return revolve(stage, np.eye(3)[axis])


def revolve_about_ends(stage: Stage) -> Outcome:
    """A whole turn of one curve about the straight line through its ends."""
    (shape_id,) = _exactly(stage, 1, "Select one open curve to revolve about its ends.")
    first, *_, last = _points(stage.design.curve(shape_id))
    if np.allclose(first, last, rtol=0.0, atol=1e-12):
        raise EditError("A curve that ends where it begins has no line through its ends.")
    return Revolve((shape_id,), first, last - first)


def loft(stage: Stage, closed: bool) -> Outcome:
    """Through all selected curves, in their order from back to front."""
    least = 3 if closed else 2
    wanted = f"Select at least {'three' if closed else 'two'} curves, one behind the other."
    ids = selected_curves(stage, wanted)
    if len(ids) < least:
        raise EditError(wanted)
    return Loft(ids, closed)


def _exactly(stage: Stage, count: int, wanted: str) -> Ids:
    ids = selected_curves(stage, wanted)
    if len(ids) != count:
        raise EditError(wanted)
    return ids


def _points(curve: PlusCurve) -> Floats:
    return in_space(curve).at(np.linspace(0.0, 1.0, SAMPLES))


BODIES: tuple[tuple[str, str, Body], ...] = (
    ("sheet", "Sheet", lambda size, at: sheet(size=(size, size), center=at)),
    ("tube", "Tube", lambda size, at: tube(radius=0.3 * size, height=size, center=at)),
    (
        "torus",
        "Torus",
        lambda size, at: torus(radius=0.35 * size, thickness=0.15 * size, center=at),
    ),
    ("sphere", "Sphere", lambda size, at: sphere(radius=0.5 * size, center=at)),
    ("exact_sphere", "Exact sphere", lambda size, at: exact_sphere(0.5 * size, at)),
)


def _adding(title: str, body: Body) -> Callable[[Stage], Outcome]:
    return lambda stage: AddSurface(body(*place_in_view(stage)), title)


def _of(count: int, wanted: str, make: Callable[[Ids], Command]) -> Callable[[Stage], Outcome]:
    return lambda stage: make(_exactly(stage, count, wanted))


def _about(axis: tuple[float, ...]) -> Callable[[Stage], Outcome]:
    return lambda stage: revolve(stage, np.array(axis))


def _actions() -> Iterator[EditAction]:
    for name, title, body in BODIES:
        yield EditAction(f"new_{name}", title, (), NEW, _adding(title, body))
    rows: list[tuple[str, str, Callable[[Stage], Outcome]]] = [
        ("extrude", "Extrude", extrude),
        ("revolve_upright", "Revolve about the vertical axis", revolve_upright),
        *((f"revolve_{name}", f"Revolve about the {name}-axis", _about(to)) for name, to in AXES),
        ("revolve_ends", "Revolve about the line through its ends", revolve_about_ends),
        ("rule", "Ruled surface", _of(2, "Select two curves.", Rule)),
        ("loft", "Loft", lambda stage: loft(stage, False)),
        ("loft_round", "Closed loft", lambda stage: loft(stage, True)),
        (
            "fill",
            "Coons patch",
            _of(4, "Select four curves that meet at their ends.", Fill),
        ),
    ]
    for name, title, make in rows:
        yield EditAction(name, title, (), FROM_CURVES, make)


ACTIONS = tuple(_actions())
