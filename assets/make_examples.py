"""Makes the designs in the folder `examples`: run `python assets/make_examples.py`.

Figures 1 to 6 of A. A. Goshtasby, Plus Curves and Surfaces, with control points of our own, and
five drawings that show what control lines are good for. Those in space are in `surface_examples`
and `mesh_examples`.
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from mesh_examples import MESHES
from numpy.typing import ArrayLike
from surface_examples import SURFACES

from plusedit.document.design import Design
from plusedit.document.shape import Json, Shape, Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.hulls import line_ends
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import polygon_length
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends
from plusedit.geometry.transforms import transformed
from plusedit.io.formats.json_document import dumps

FOLDER = Path(__file__).parent / "examples"

ARCH = ((0.0, 0.0), (0.4, 2.7), (3.3, 3.0), (4.0, 0.3))
QUAD = ((0.0, 0.0), (3.0, 0.2), (3.3, 3.2), (0.3, 2.8))
RISE = ((0.0, 0.6), (0.9, 3.0), (2.6, 3.4), (3.2, 0.9), (5.2, 0.0), (6.2, 2.4))
CLEF = (
    (0.05, 0.55), (-0.55, 1.05), (0.1, 1.75), (0.95, 1.0), (0.1, -0.15), (-1.3, 0.9),
    (-0.55, 2.6), (0.65, 4.1), (0.62, 5.75), (0.02, 5.3), (0.0, 3.6), (0.4, 0.4),
    (0.62, -1.5), (-0.1, -2.1), (-0.6, -1.45), (-0.2, -1.2),
)  # fmt: skip
VASE = ((0.75, 0.0), (0.55, 0.35), (1.95, 1.9), (1.75, 3.7), (0.55, 4.3), (0.6, 5.1), (1.15, 5.6))
VASE_WEIGHTS = (1.0, 2.2, 1.0, 1.4, 2.5, 1.0, 1.0)

QUARTERS = (0.0, 0.0, 0.0, 0.25, 0.25, 0.5, 0.5, 0.75, 0.75, 1.0, 1.0, 1.0)
HALVES = (0.0, 0.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0)

BLUE, SKY, TEAL = "#3B82F6", "#0EA5E9", "#0D9488"
VIOLET, PINK, AMBER, CLAY, GRAY = "#7C3AED", "#DB2777", "#F59E0B", "#B45309", "#8A94A6"


# --- curves ---------------------------------------------------------------------------------


def bezier(points: ArrayLike, s: float) -> PlusCurve:
    """A Bezier+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(Bernstein(len(lines)), lines), s)


def bspline(points: ArrayLike, s: float, *, closed: bool = False) -> PlusCurve:
    """A cubic B-spline+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(BSpline(len(lines), 4, closed), lines), s)


def gaussian(points: ArrayLike, s: float) -> PlusCurve:
    """A RaG+ curve with automatic directions; s in lengths of the control polygon."""
    lines = ControlLines.of(points)
    return scaled(PlusCurve(RationalGaussian.of_size(len(lines)), lines), s)


def ellipse(center: tuple[float, float], radii: tuple[float, float]) -> PlusCurve:
    """A whole ellipse, exactly: four rational quarters."""
    around = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    return conic(np.array(around) * radii + center, QUARTERS)


def lower_half(center: tuple[float, float], radii: tuple[float, float]) -> PlusCurve:
    """The lower half of an ellipse, exactly: two rational quarters."""
    below = [(-1, 0), (-1, -1), (0, -1), (1, -1), (1, 0)]
    return conic(np.array(below) * radii + center, HALVES)


def conic(points: Floats, knots: tuple[float, ...]) -> PlusCurve:
    """Quadratic NURBS whose weights alternate between those of a corner and of a quarter."""
    weights = np.where(np.arange(len(points)) % 2, np.sqrt(0.5), 1.0)
    lines = ControlLines.of(points, weights=weights)
    return PlusCurve(BSpline(len(points), 3, knots=knots), lines, 0.0)


def scaled(curve: PlusCurve, s: float) -> PlusCurve:
    """The curve with s given in lengths of its control polygon."""
    return replace(curve, s=round(s * polygon_length(curve), 6))


def turned(curve: PlusCurve, degrees: dict[int, float]) -> PlusCurve:
    """The curve with control lines turned counterclockwise, by number."""
    lines, directions = curve.lines, curve.directions
    for number, angle in degrees.items():
        a = np.radians(angle)
        rotation = np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
        # Rounded, here and below, so that the files show numbers that people can read.
        lines = lines.with_direction(number, np.round(rotation @ directions[number], 9) + 0.0)
    return replace(curve, lines=lines)


def alternating(curve: PlusCurve, *degrees: float) -> PlusCurve:
    """The curve with its control lines turned by those angles in turn."""
    angles = {i: degrees[i % len(degrees)] for i in range(len(curve.lines))}
    return turned(curve, {i: angle for i, angle in angles.items() if angle})


def moved(curve: PlusCurve, by: ArrayLike) -> PlusCurve:
    """The curve somewhere else."""
    points = np.round(curve.lines.points + np.asarray(by), 9) + 0.0
    return replace(curve, lines=curve.lines.with_points(points))


def mirrored(curve: PlusCurve) -> PlusCurve:
    """The curve with left and right changed."""
    return transformed(curve, np.diag([-1.0, 1.0]), np.zeros(2))


def around(count: int, radii: Sequence[float], start: float = 0.0) -> Floats:
    """Points (count, 2) at even angles, their distances from the center taken in turn."""
    angles = start + 2.0 * np.pi * np.arange(count) / count
    distances = np.resize(radii, count)
    ring: Floats = np.round(distances * [np.cos(angles), np.sin(angles)], 9).T + 0.0
    return ring


def mixed(first: str, last: str, share: float) -> str:
    """A color between two."""
    ends = [[int(color[i : i + 2], 16) for i in (1, 3, 5)] for color in (first, last)]
    parts = (round(a + share * (b - a)) for a, b in zip(*ends, strict=True))
    return "#" + "".join(f"{part:02X}" for part in parts)


# --- designs --------------------------------------------------------------------------------

Layer = tuple[str, PlusCurve, Style]


def design(layers: Iterable[Layer], about: str, overlays: str = "", handles: str = "") -> Design:
    """A design of named curves, back to front, with the named overlays switched on."""
    view: dict[str, Json] = {"overlays": [*overlays.split()], "grid": False}
    made = Design(view=view | ({"handles": handles} if handles else {}), extra={"about": about})
    for name, curve, style in layers:
        shape_id = made.unused_id(name.strip("()").replace(" ", "-"))
        made = made.with_shape(shape_id, Shape(curve, name, style=style))
    return made


def panels(
    curves: Sequence[PlusCurve],
    columns: int,
    gap: float = 2.0,
    extent: Callable[[PlusCurve], Floats] = lambda curve: curve.lines.points,
) -> Iterator[Layer]:
    """Curves named (a), (b), ... in rows of so many, in cells that the extents of all fit in.

    Control points stand in the middle of a cell, so that panels can be compared.
    """
    middles = [(c.lines.points.min(axis=0) + c.lines.points.max(axis=0)) / 2.0 for c in curves]
    reach = [extent(c) - middle for c, middle in zip(curves, middles, strict=True)]
    low = np.min([r.min(axis=0) for r in reach], axis=0)
    high = np.max([r.max(axis=0) for r in reach], axis=0)
    width, height = high - low + gap
    for number, (curve, middle) in enumerate(zip(curves, middles, strict=True)):
        place = np.array([number % columns * width, -(number // columns) * height])
        yield f"({'abcdef'[number]})", moved(curve, place - middle), Style()


def parent_points(curve: PlusCurve) -> Floats:
    """(2n, 2) the control points of both parents: their hull holds the curve."""
    return np.concatenate(line_ends(curve))


def growing() -> list[PlusCurve]:
    """The curves of Figure 1."""
    return [bezier(ARCH, s) for s in (0.0, 0.25, 0.5, 0.75)]


def turning() -> list[PlusCurve]:
    """The curves of Figure 2."""
    start = bezier(ARCH, 0.65)
    return [turned(start, {1: a, 2: b}) for a, b in ((-50, 50), (85, -85), (180, 0))]


def figure_1() -> Design:
    about = (
        "(a) A Bezier curve. (b) to (d) Bezier+ curves of the same control points with growing"
        " gradient magnitude s: 0.25, 0.5 and 0.75 times the length of the control polygon."
    )
    return design(panels(growing(), 2), about, "names polygon")


def figure_2() -> Design:
    about = (
        "Bezier+ curves of the same control points, the same gradient magnitude and the same"
        " directions at the ends, but other directions at the two inner control points."
    )
    return design(panels(turning(), 3), about, "names polygon", "all")


def figure_3() -> Design:
    open_ends = turned(bezier(ARCH, 0.75), {0: 38.0, 3: 32.0})
    loop = ((1.4, 0.0), (4.4, 0.9), (3.7, 3.5), (0.6, 3.0), (-0.6, 0.9), (1.4, 0.0))
    about = (
        "Bezier (red) and Bezier+ (green, on dark ground white). (a) The inner"
        " directions are such that the curve is tangent to the end control lines. (b)"
        " The end control lines coincide as well: a smooth closed curve. (c) From the same"
        " points a Bezier+ curve may have an inflection more."
    )
    curves = [
        tangent_at_ends(open_ends, how="unit"),
        closed_smoothly(bezier(loop, 0.5)),
        turned(bezier(((0.0, 0.0), (2.0, 3.0), (4.0, 0.4)), 0.7), {0: -40.0, 1: 100.0}),
    ]
    return design(panels(curves, 3), about, "classical names polygon", "all")


def figure_4() -> Design:
    about = (
        "The Bezier+ curves of Figures 1 and 2, each a blend of two Bezier curves (red). It lies"
        " in the convex hull (blue) of the union of their convex hulls (pink)."
    )
    curves = panels(growing()[1:] + turning(), 3, 1.2, parent_points)
    return design(curves, about, "hulls names", "none")


def figure_5() -> Design:
    about = (
        "(a) A B-spline curve of order 4 with six control points. (b) The B-spline+ curve of order"
        " 4 with the same control points; the segments are its control lines."
    )
    curves = panels([bspline(RISE, 0.0), bspline(RISE, 0.6)], 2)
    return design(curves, about, "names polygon", "all")


def figure_6() -> Design:
    about = (
        "(a) A closed B-spline (red) and B-spline+ (green, on dark ground white) curve."
        " (b) The same with a smaller gradient magnitude s. (c) The same as (a) with the"
        " direction at the upper right control point reversed."
    )
    curves = [bspline(QUAD, s, closed=True) for s in (0.5, 0.25, 0.5)]
    curves[2] = turned(curves[2], {2: 180.0})
    return design(panels(curves, 3), about, "classical names polygon", "all")


def clef() -> Design:
    """One open curve of 16 control lines on five straight ones."""
    staff = [bezier(((-2.2, y), (2.2, y)), 0.0) for y in range(5)]
    layers: list[Layer] = [("staff line", line, Style(GRAY, 1.0)) for line in staff]
    layers.append(("clef", bspline(CLEF, 0.6), Style(BLUE, 6.0)))
    about = "A treble clef: one B-spline+ curve of 16 control lines. It passes near its points."
    return design(layers, about, handles="selected")


def braid() -> Design:
    """Strands whose control points all lie on one straight line."""
    points = np.column_stack([np.linspace(0.0, 9.0, 8), np.zeros(8)])
    about = (
        "RaG+ curves: the control points of every strand lie on the same straight line. The waves"
        " come from the directions alone, 70 degrees up and down, and s sets how high they go."
    )
    layers: list[Layer] = []
    for number in range(21):
        strand = alternating(gaussian(points, 0.22 * (number - 10)), 70.0, -70.0)
        layers.append((f"strand {number + 1}", strand, Style(mixed(SKY, VIOLET, number / 20), 2.0)))
    return design(layers, about, handles="selected")


def windflower() -> Design:
    """Eight control lines, and nothing changes but s."""
    points = around(8, [1.0])
    about = (
        "Closed B-spline+ curves of the same eight control lines, which point in and out by turns."
        " Only s differs: 0 in the circle, growing towards the star."
    )
    layers: list[Layer] = []
    for number in range(13):
        curve = alternating(bspline(points, 0.12 * number, closed=True), 90.0, -90.0)
        color = mixed(SKY, PINK, number / 12)
        layers.append((f"s {0.12 * number:.2f} L", curve, Style(color, 2.0)))
    return design(layers, about, handles="selected")


def rose() -> Design:
    """Rings of petals: every second control line runs backwards."""
    layers: list[Layer] = []
    for number in range(8):
        size = 0.22 + 0.13 * number
        points = around(16, [size, 0.55 * size], np.pi / 8.0 * (number % 2))
        ring = alternating(bspline(points, 0.55, closed=True), 0.0, 180.0)
        color = mixed(AMBER, PINK, number / 7)
        layers.append((f"ring {number + 1}", ring, Style(color, 2.5)))
    about = "Closed B-spline+ curves of 16 control lines, every second one of them reversed."
    return design(layers, about, handles="selected")


def vase() -> Design:
    """A profile of NURBS+ and its mirror image; rim, foot and bands are exact ellipses."""
    profile = turned(bspline(VASE, 0.55), {6: 40.0})
    profile = replace(profile, lines=profile.lines.with_weights(np.array(VASE_WEIGHTS)))
    outline = Style(CLAY, 3.0)
    layers: list[Layer] = [
        ("rim", ellipse((0.0, 5.6), (1.15, 0.2)), outline),
        ("foot", lower_half((0.0, 0.0), (0.75, 0.14)), outline),
    ]
    points = profile.at(np.linspace(0.0, 1.0, 4001))
    for height in (1.6, 1.8, 3.0, 3.2, 4.55):
        radius = round(float(points[np.abs(points[:, 1] - height).argmin(), 0]), 3)
        band = lower_half((0.0, height), (radius, round(0.18 * radius, 3)))
        layers.append(("band", band, Style(TEAL, 2.0)))
    layers += [("profile", profile, outline), ("mirror image", mirrored(profile), outline)]
    about = (
        "A vase: its profile is one NURBS+ curve of seven control lines, some of them weighted;"
        " rim, foot and bands are exact ellipses, rational and with s = 0."
    )
    return design(layers, about, handles="selected")


EXAMPLES: tuple[Callable[[], Design], ...] = (
    figure_1, figure_2, figure_3, figure_4, figure_5, figure_6,
    clef, braid, windflower, rose, vase, *SURFACES, *MESHES,
)  # fmt: skip


def files() -> Iterator[tuple[str, bytes]]:
    """Name and content of every example."""
    for example in EXAMPLES:
        yield f"{example.__name__}.json", dumps(example())


if __name__ == "__main__":
    for name, content in files():
        (FOLDER / name).write_bytes(content)
