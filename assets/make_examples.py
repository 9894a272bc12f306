"""Makes the designs in the folder `examples`: run `python assets/make_examples.py`.

Figures 1 to 6 of A. A. Goshtasby, Plus Curves and Surfaces, with control points of our own, and
five drawings that show what control lines are good for. Those in space are in `surface_examples`
and `mesh_examples`, those that set the paper right in `facts`, what it claims in `claims`.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
from claims import claims
from curve_examples import (
    Layer,
    alternating,
    around,
    bezier,
    bspline,
    design,
    ellipse,
    gaussian,
    lower_half,
    mirrored,
    mixed,
    panels,
    parent_points,
    turned,
)
from facts import FACTS
from mesh_examples import MESHES
from surface_examples import SURFACES

from plusedit.document.design import Design
from plusedit.document.shape import Style
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tangency import closed_smoothly, tangent_at_ends
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

BLUE, SKY, TEAL = "#3B82F6", "#0EA5E9", "#0D9488"
VIOLET, PINK, AMBER, CLAY, GRAY = "#7C3AED", "#DB2777", "#F59E0B", "#B45309", "#8A94A6"


# --- designs --------------------------------------------------------------------------------


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
    return design(panels(growing(), 2, 2.0, 3.4), about, "names polygon")


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
    curves = panels(growing()[1:] + turning(), 3, 1.2, 2.4, parent_points)
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
    curves = [bspline(QUAD, s, closed=True) for s in (0.45, 0.2, 0.45)]
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
    clef, braid, windflower, rose, vase, claims, *SURFACES, *MESHES, *FACTS,
)  # fmt: skip


def files() -> Iterator[tuple[str, bytes]]:
    """Name and content of every example."""
    for example in EXAMPLES:
        yield f"{example.__name__}.json", dumps(example())


if __name__ == "__main__":
    for name, content in files():
        (FOLDER / name).write_bytes(content)
