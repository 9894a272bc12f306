"""Designs to test with: one that is known by heart, and any that can be."""

import numpy as np
from hypothesis import strategies as st

from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId, Style
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

WING, BOW, SAIL = ShapeId("wing"), ShapeId("bow"), ShapeId("sail")

DOCUMENT = b"""{
  "format": "plusedit-design", "version": 1, "author": {"name": "Ada"},
  "shapes": [
    {"id": "wing", "kind": "curve", "s": 2.5, "tag": ["a", null],
     "basis": {"family": "bspline", "order": 4, "hint": 3},
     "points": [[0, 0], [1, 2], [3, 2], [4, 0]],
     "directions": [null, [0.6, 0.8], null, null],
     "weights": [1, 1, 2, 1],
     "style": {"color": "#aabbcc", "width": 3, "dash": [1, 2]}},
    {"id": "bow", "kind": "curve", "name": "Bow", "s": -0.5, "visible": false, "locked": true,
     "basis": {"family": "rag", "sigma": [0.1, 0.2, 0.1], "nodes": [0, 0.25, 1]},
     "points": [[0, 0, 1], [1, 2, 1], [3, 2, 1e-320]]},
    {"id": "sail", "kind": "surface", "s": 1.2,
     "basis_u": {"family": "bezier"},
     "basis_v": {"family": "bspline", "order": 3, "closed": true, "ply": 2},
     "points": [[[0, 0, 1], [1, 0, 1], [1, 1, 1]], [[0, 0, 2], [1, 0, 2.5], [1, 1, 2]]],
     "directions_u": [[null, [1, 0, 0], null], [null, null, null]],
     "weights": [[1, 2, 3], [1, 1, 1]], "fabric": "dacron", "style": {"seam": "red"}},
    {"id": "knee", "kind": "mesh",
     "vertices": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 1], [2, 1, 1]],
     "faces": [[0, 1, 2, 3], [3, 2, 4]], "domain": {"kind": "torus", "height": 2},
     "parameters": [[[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1], [1, 1], [1, 2]]],
     "smoothness": 0.7, "s": 1, "area_weights": false,
     "planes": {"1": {"point": [0, 0, 0], "gradient_u": [1, 0, 0]}},
     "source": {"file": "knee.obj", "sha256": "00"}}
  ],
  "view": {"camera": {"center": [0, 1]}}
}
"""


def a_curve(s=2.0):
    """A cubic B-spline+ of four lines, the second of which is directed by hand."""
    points = [[0.0, 0.0], [1.0, 2.0], [3.0, 2.0], [4.0, 0.0]]
    return PlusCurve(BSpline(4), ControlLines.of(points, [None, [0.6, 0.8], None, None]), s)


def a_design():
    """A B-spline+ named wing behind a Bezier+ named bow."""
    lines = ControlLines.of([[0.0, 1.0], [2.0, 3.0], [4.0, 1.0]])
    bow = PlusCurve(Bernstein(3), lines, 1.0)
    return Design({WING: Shape(a_curve(), "wing"), BOW: Shape(bow, "Bow")})


coordinates = st.floats(-1e100, 1e100, allow_nan=False)
positive = st.floats(1e-100, 1e100, exclude_min=True)


@st.composite
def bases(draw, size):
    """Any basis of a shipped family for that many control lines."""
    family = draw(st.sampled_from(["bezier", "bspline", "rag"]))
    if family == "bezier":
        return Bernstein(size)
    closed = draw(st.booleans())
    if family == "rag":
        sigma = draw(positive | st.tuples(*[positive] * size))
        inside = st.floats(0.0, 1.0, exclude_max=closed)
        nodes = st.lists(inside, min_size=size, max_size=size, unique=True).map(sorted).map(tuple)
        return RationalGaussian(size, sigma, closed, draw(st.none() | nodes))
    order = draw(st.integers(2, 8 if closed else size))
    if closed or draw(st.booleans()):
        return BSpline(size, order, closed)
    inner = st.floats(0.0, 1.0, exclude_min=True, exclude_max=True)
    count = size - order
    between = draw(st.lists(inner, min_size=count, max_size=count, unique=True))
    return BSpline(size, order, knots=(0.0,) * order + tuple(sorted(between)) + (1.0,) * order)


@st.composite
def curves(draw):
    """Any curve that a file can hold."""
    size, dimension = draw(st.integers(2, 7)), draw(st.sampled_from([2, 3]))
    row = st.tuples(*[coordinates] * dimension)
    rows = st.lists(row, min_size=size, max_size=size)
    directions = st.lists(st.none() | row, min_size=size, max_size=size)
    weights = st.none() | st.lists(positive, min_size=size, max_size=size)
    lines = ControlLines.of(draw(rows), draw(st.none() | directions), draw(weights))
    return PlusCurve(draw(bases(size)), lines, draw(coordinates))


@st.composite
def surfaces(draw):
    """Any surface that a file can hold."""
    rows, columns = draw(st.integers(2, 4)), draw(st.integers(2, 4))

    def net(entry):
        row = st.lists(entry, min_size=columns, max_size=columns)
        return st.lists(row, min_size=rows, max_size=rows)

    vector = st.tuples(*[coordinates] * 3)
    directions = st.none() | net(st.none() | vector)
    planes = ControlPlanes.of(
        draw(net(vector)), draw(directions), draw(directions), draw(st.none() | net(positive))
    )
    return PlusSurface(draw(bases(rows)), draw(bases(columns)), planes, draw(coordinates))


words = st.text(max_size=8)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats(allow_nan=False, allow_infinity=False)
    | words,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(words, inner, max_size=3),
    max_leaves=6,
)  # fmt: skip
styles = st.builds(
    Style,
    st.none() | st.from_regex("#[0-9a-f]{6}", fullmatch=True),
    st.none() | st.floats(0.0, 1e6),
)
shapes = st.builds(
    Shape, curves() | surfaces(), words, visible=st.booleans(), locked=st.booleans(), style=styles
)
designs = st.builds(Design, st.dictionaries(words.map(ShapeId), shapes, max_size=3))


def bits(geometry):
    """All that makes a curve or a surface, for comparing to the last bit."""
    net = geometry.net
    arrays = [net.control_points, net.given_vectors, net.automatic_vectors, net.weight_row]
    bases = [geometry.basis] if isinstance(geometry, PlusCurve) else geometry.bases
    numbers = [*arrays, np.float64(geometry.s)]
    return repr(bases), [None if a is None else (a.shape, a.tobytes()) for a in numbers]


def contents(design):
    """All that makes a design of curves and surfaces, likewise."""
    return [
        (i, shape.name, shape.visible, shape.locked, shape.style, bits(shape.plus))
        for i, shape in design.shapes.items()
    ]
