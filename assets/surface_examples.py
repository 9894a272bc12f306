"""The designs in space among the examples; `make_examples.py` writes them.

Figure 7 of A. A. Goshtasby, Plus Curves and Surfaces, reconstructed from its text, and designs that
show what control planes are good for and what surfaces can be made from.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Json, Shape, Style
from plusedit.geometry.arrays import Floats, unit
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.iso_curves import iso_curve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import polygon_length
from plusedit.geometry.making import primitives
from plusedit.geometry.making.lofting import lofted
from plusedit.geometry.making.revolution import revolved
from plusedit.geometry.making.ruled import ruled
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import balanced, natural_length

UP = np.array([0.0, 0.0, 1.0])
THIN, BROAD, THICK = Style(None, 1.0), Style(None, 2.5), Style(None, 3.0)

NET = (
    (0.0, 0.5, 0.3, 0.0),
    (0.4, 1.9, 1.5, 0.3),
    (0.2, 1.3, 2.1, 0.6),
    (0.0, 0.4, 0.7, 0.2),
)
"""Heights of the 4 x 4 control points of Figure 7."""

FRAMES = (
    (4.2, 0.75, 0.55, -0.05), (2.6, 1.05, 0.45, -0.35), (0.6, 1.15, 0.45, -0.45),
    (-1.4, 0.75, 0.52, -0.3), (-3.1, 0.06, 0.72, 0.25),
)  # fmt: skip
"""Of the boat: where along it, half its beam there, and the heights of its edge and its keel."""

GLASS = (
    (1.15, 0.0), (1.15, 0.12), (0.2, 0.25), (0.14, 1.1), (0.14, 1.7),
    (0.5, 2.1), (1.25, 2.5), (1.2, 3.6), (0.95, 4.4),
)  # fmt: skip

Layer = tuple[str, Geometry, Style]


@dataclass(frozen=True)
class Eye:
    """Where the 3D view looks from; the radians of a camera."""

    target: tuple[float, float, float]
    height: float
    yaw: float
    pitch: float
    perspective: bool = True

    @property
    def ground(self) -> tuple[Floats, Floats]:
        """What runs to the right, and away from the eye, along the ground."""
        cos, sin = np.cos(self.yaw), np.sin(self.yaw)
        return np.array([cos, sin, 0.0]), np.array([-sin, cos, 0.0])


def scene(
    layers: Iterable[Layer], about: str, eye: Eye, overlays: str = "", handles: str = "selected"
) -> Design:
    """A design of named curves and surfaces, seen in space."""
    camera: dict[str, Json] = {
        "target": [*eye.target],
        "height": eye.height,
        "yaw": eye.yaw,
        "pitch": eye.pitch,
        "perspective": eye.perspective,
    }
    view: dict[str, Json] = {"overlays": [*overlays.split()], "grid": False, "ground": False}
    view |= {"handles": handles, "camera_3d": camera, "panes": "3d"}
    made = Design(view=view, extra={"about": about})
    for name, geometry, style in layers:
        shape_id = made.unused_id(name.strip("()").replace(" ", "-"))
        made = made.with_shape(shape_id, Shape(geometry, name, style=style))
    return made


# --- geometry -------------------------------------------------------------------------------


def rounded(values: ArrayLike) -> Floats:
    """Rounded, so that the files show numbers that people can read."""
    short: Floats = np.round(np.asarray(values, dtype=np.float64), 6) + 0.0
    return short


def legible(surface: PlusSurface) -> PlusSurface:
    """The surface with rounded numbers."""
    planes = surface.planes
    weights = None if planes.weights is None else rounded(planes.weights)
    kept = ControlPlanes(rounded(planes.points), rounded(planes.given), planes.automatic, weights)
    return replace(surface, planes=kept, s=float(rounded(surface.s)))


def curve(points: ArrayLike, s: float = 0.5, *, closed: bool = False) -> PlusCurve:
    """A cubic B-spline+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(rounded(points))
    made = PlusCurve(BSpline(len(lines), min(4, len(lines)), closed), lines)
    return replace(made, s=float(rounded(s * polygon_length(made))))


def bezier_surface(points: Floats, s: float) -> PlusSurface:
    """A Bezier+ surface with automatic directions; s in natural lengths."""
    rows, columns, _ = points.shape
    made = PlusSurface(Bernstein(rows), Bernstein(columns), ControlPlanes.of(rounded(points)))
    return replace(made, s=float(rounded(s * natural_length(made))))


def moved(surface: PlusSurface, by: Floats) -> PlusSurface:
    """The surface somewhere else."""
    return replace(surface, planes=surface.planes.with_points(rounded(surface.planes.points + by)))


def rotation(axis: ArrayLike, degrees: float) -> Floats:
    """(3, 3) counterclockwise about the axis, as seen from where it points to."""
    x, y, z = unit(np.asarray(axis, dtype=np.float64))
    cross = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    angle = np.radians(degrees)
    turned: Floats = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * cross @ cross
    return turned


def folded(surface: PlusSurface, places: Iterable[tuple[int, int]], degrees: float) -> PlusSurface:
    """The surface with some planes turned, outwards from its middle and down."""
    planes = surface.planes
    given, automatic, directions = planes.given.copy(), planes.automatic.copy(), surface.directions
    middle = planes.points.mean(axis=(0, 1))
    for i, j in places:
        outwards = (planes.points[i, j] - middle) * [1.0, 1.0, 0.0]
        turn = rotation(np.cross(UP, outwards), degrees)
        given[:, i, j], automatic[:, i, j] = rounded(directions[:, i, j] @ turn.T), False
    return replace(surface, planes=replace(planes, given=given, automatic=automatic))


def bulging(surface: PlusSurface, way: int, outwards: Floats, by: float) -> PlusSurface:
    """The surface with the directions one way leaning out and in by turns.

    `outwards` (n_u, n_v, 3) are unit vectors; `by` is the slope.
    """
    directions = surface.directions.copy()
    length = np.linalg.norm(directions[way], axis=-1).mean()
    signs = np.where(np.indices(outwards.shape[:2])[way] % 2, -1.0, 1.0)
    directions[way] += by * length * signs[..., None] * outwards
    return legible(replace(surface, planes=surface.planes.with_directions(directions)))


def sailcloth(
    tack: ArrayLike, clew: ArrayLike, head: ArrayLike, *, camber: float, roach: float, twist: float
) -> PlusSurface:
    """A sail of 4 x 5 planes, u from luff to leech and v upwards, filled by the wind."""
    low, aft, top = (np.asarray(corner, dtype=np.float64) for corner in (tack, clew, head))
    away = unit(np.cross(aft - low, top - low))
    u, v = np.arange(4)[:, None, None] / 3.0, np.arange(5)[None, :, None] / 4.0
    fullness = np.sin(np.pi * v)
    leech = aft + (top - aft) * v + roach * fullness * unit(aft - low)
    leech = leech + away * twist * np.sin(np.pi * v / 1.2)
    chord = leech - (low + (top - low) * v)
    depth = 4.0 * camber * (u * (1.0 - u)) ** 0.8 * (1.25 - 0.6 * u)
    depth = depth * (0.35 + 0.65 * np.sin(np.pi * np.minimum(v + 0.15, 1.0)))
    points = low + (top - low) * v + u * chord
    points = points + away * depth * np.linalg.norm(chord, axis=-1, keepdims=True)
    made = PlusSurface(Bernstein(4), BSpline(5, 4), ControlPlanes.of(rounded(points)))
    return replace(made, s=float(rounded(natural_length(made) / 2.0)))


def frame(x: float, beam: float, edge: float, keel: float) -> PlusCurve:
    """One section of a boat, from edge to edge by way of the keel."""
    side = edge - 0.35 * (edge - keel)
    half = [(beam, edge), (0.98 * beam, side), (0.55 * beam, keel + 0.05)]
    port = [(x, -y, z) for y, z in half]
    return curve([*port, (x, 0.0, keel), *((x, -y, z) for _, y, z in reversed(port))])


def star(radii: tuple[float, float], height: float, turn: float) -> PlusCurve:
    """A closed level curve with five bays."""
    angles = 2.0 * np.pi * np.arange(10) / 10.0 + turn
    r = np.resize(radii, 10)
    points = np.stack([r * np.cos(angles), r * np.sin(angles), np.full(10, height)], axis=1)
    return curve(points, closed=True)


# --- designs --------------------------------------------------------------------------------


def figure_7() -> Design:
    """The same 16 control points four times."""
    eye = Eye((0.0, 0.0, 0.85), 8.0, 0.55, 0.5, perspective=False)
    x, y = np.meshgrid(np.arange(4.0) - 1.5, np.arange(4.0) - 1.5, indexing="ij")
    points = np.stack([x, y, np.array(NET)], axis=2)
    plus = bezier_surface(points, 0.65)
    corners = [(i, j) for i in (0, 3) for j in (0, 3)]
    inner = [(i, j) for i in (1, 2) for j in (1, 2)]
    panels = (
        bezier_surface(points, 0.0),
        plus,
        folded(plus, corners, 62.0),
        folded(plus, inner, -90.0),
    )
    right, back = eye.ground
    places = [a * 2.7 * right + b * 4.1 * back for b in (1.0, -1.0) for a in (-1.0, 1.0)]
    about = (
        "(a) A Bezier surface of 4 x 4 control points. (b) The Bezier+ surface of the same points,"
        " its directions automatic: it rises towards them. (c) Other directions at the four corner"
        " planes. (d) Other directions at the four inner planes. Points and directions are"
        " reconstructed: the paper shows them but gives no numbers."
    )
    layers = [
        (f"({letter})", moved(panel, place), Style())
        for letter, panel, place in zip("abcd", panels, places, strict=True)
    ]
    return scene(layers, about, eye, "names polygon", "all")


def sail() -> Design:
    """A boat before the wind."""
    main = sailcloth(
        (0.12, 0.0, 1.1), (3.5, 0.35, 1.15), (0.1, 0.0, 8.6), camber=0.11, roach=0.55, twist=0.55
    )
    jib = sailcloth(
        (-2.6, 0.0, 0.55), (0.35, 0.5, 0.85), (-0.15, 0.0, 7.2), camber=0.12, roach=0.12, twist=0.5
    )
    spars = {
        "mast": ((0.0, 0.0, 0.45), (0.0, 0.0, 8.75)),
        "boom": ((0.0, 0.0, 1.0), (3.6, 0.36, 1.05)),
    }
    stays = {
        "forestay": ((-2.95, 0.0, 0.7), (-0.02, 0.0, 7.4)),
        "backstay": ((4.15, 0.0, 0.55), (0.0, 0.0, 8.75)),
    }
    hull = lofted([frame(*of) for of in FRAMES])
    port, starboard = (iso_curve(hull, "u", side) for side in (0.0, 1.0))
    stern = frame(*FRAMES[0])
    across = curve(stern.lines.points[[0, -1]])
    bodies = {"hull": hull, "deck": ruled(starboard, port), "transom": ruled(stern, across)}
    layers: list[Layer] = [(name, legible(body), Style()) for name, body in bodies.items()]
    layers += [(name, curve(ends), THICK) for name, ends in spars.items()]
    layers += [(name, curve(ends), THIN) for name, ends in stays.items()]
    layers += [("mainsail", main, Style()), ("jib", jib, Style())]
    about = (
        "Two sails of 4 x 5 control planes each, Bezier+ across and B-spline+ upwards. Select one"
        " and change s: the wind freshens. The hull is a loft through five frames; deck and transom"
        " are ruled surfaces between its edges."
    )
    return scene(layers, about, Eye((0.5, 0.0, 4.2), 9.8, -0.7, 0.16))


def tube() -> Design:
    """A tube whose control points stand on a straight cylinder."""
    plain = primitives.tube(10, 8, radius=1.0, height=5.0)
    outwards = unit(plain.planes.points * [1.0, 1.0, 0.0])
    about = (
        "The control points of this tube stand on a straight cylinder. All of its form comes from"
        " the directions by v, which lean out and in by turns; with s = 0 the cylinder is back."
    )
    made = bulging(plain, 1, outwards, 1.6)
    return scene([("tube", made, Style())], about, Eye((0.0, 0.0, 0.0), 5.9, 0.6, 0.35))


def torus() -> Design:
    """A torus whose control points lie on a round one."""
    plain = primitives.torus(16, 8, radius=2.0, thickness=0.75)
    points = plain.planes.points
    ring = 2.0 * unit(points * [1.0, 1.0, 0.0])
    about = (
        "The control points of this torus lie on a round one. Its eight cushions come from the"
        " directions by u alone, which lean out and in by turns."
    )
    made = bulging(plain, 0, unit(points - ring), 1.0)
    return scene([("torus", made, Style())], about, Eye((0.0, 0.0, -0.1), 6.1, 0.4, 0.75))


def horn() -> Design:
    """A tube along a spiral, of 8 x 9 planes with automatic directions."""
    t = np.linspace(0.0, 1.0, 9)
    angle, radius = 2.6 * np.pi * t, 1.9 * (1.0 - 0.45 * t)
    path = np.stack([radius * np.cos(angle), radius * np.sin(angle), 2.6 * t], axis=1)
    ahead = unit(np.gradient(path, axis=0))
    side = unit(np.cross(ahead, UP))
    over = np.cross(side, ahead)
    width = 0.75 * (1.0 - t) ** 1.2 + 0.12
    around = 2.0 * np.pi * np.arange(8)[:, None, None] / 8.0
    points = path + width[:, None] * (np.cos(around) * side - np.sin(around) * over)
    made = PlusSurface(BSpline(8, 4, closed=True), BSpline(9, 4), ControlPlanes.of(points))
    made = legible(balanced(replace(made, s=natural_length(made) / 2.0)))
    about = "A tube that winds up a spiral and narrows: 8 x 9 control planes, balanced by u and v."
    return scene([("horn", made, Style())], about, Eye((0.0, 0.0, 1.1), 5.4, 0.6, 0.5))


def loft() -> Design:
    """A vase through six closed curves."""
    sections = [
        star((0.75, 0.75), 0.0, 0.0),
        star((1.65, 1.15), 0.9, 0.25),
        star((1.9, 1.1), 2.0, 0.6),
        star((0.78, 0.6), 3.4, 0.95),
        star((0.6, 0.6), 4.2, 1.1),
        star((1.2, 0.95), 5.0, 1.2),
    ]
    layers: list[Layer] = [("vase", legible(lofted(sections)), Style())]
    layers += [(f"section {i}", section, BROAD) for i, section in enumerate(sections, 1)]
    about = "A loft: one surface through six closed curves, each of which it meets exactly."
    return scene(layers, about, Eye((0.0, 0.0, 2.4), 6.2, 0.6, 0.3))


def goblet() -> Design:
    """A profile and the surface that it sweeps."""
    profile = curve([(r, 0.0, z) for r, z in GLASS])
    layers: list[Layer] = [
        ("goblet", revolved(profile, np.zeros(3), UP), Style()),
        ("profile", profile, BROAD),
    ]
    about = (
        "A curve turned about the z-axis: rational, so that every section across is a circle to"
        " the last bit, with the profile's own directions and s."
    )
    return scene(layers, about, Eye((0.0, 0.0, 2.2), 5.1, 0.6, 0.35))


SURFACES: tuple[Callable[[], Design], ...] = (figure_7, sail, tube, torus, horn, loft, goblet)
