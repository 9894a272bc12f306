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
from plusedit.geometry.mesh.domains import (
    CylinderDomain,
    PillowDomain,
    PlaneDomain,
    TorusDomain,
)
from plusedit.geometry.mesh.mesh_surface import EditedPlane, MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface

WING, BOW, SAIL, KNEE = ShapeId("wing"), ShapeId("bow"), ShapeId("sail"), ShapeId("knee")

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


def a_mesh(smoothness=0.7):
    """A tent of a quad and a triangle over the plane, one of its planes edited."""
    vertices = [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 1], [2, 0.5, 0.5]]
    mesh = PolygonMesh.of(vertices, [[0, 1, 2, 3], [1, 4, 2]])
    parameters = mesh.vertices[mesh.corners, :2]
    edited = {1: EditedPlane(point=[1.5, 0.5, 1.0])}
    return MeshSurface(mesh, PlaneDomain(), parameters, smoothness, edited=edited)


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


domains = st.one_of(
    st.sampled_from([PlaneDomain(), CylinderDomain()]),
    st.builds(TorusDomain, positive),
    st.builds(PillowDomain, positive),
)


@st.composite
def meshes(draw):
    """Any surface of a mesh that a file can hold."""
    count = draw(st.integers(3, 6))
    vector = st.tuples(*[st.floats(-1e90, 1e90)] * 3)
    vertices = draw(st.lists(vector, min_size=count, max_size=count))
    corner = st.integers(0, count - 1)
    faces = draw(st.lists(st.lists(corner, min_size=3, max_size=5), min_size=1, max_size=4))
    mesh = PolygonMesh.of(np.array(vertices), faces)
    # Places that are closer together would make control planes too steep to be calculated with.
    place = st.tuples(*[st.integers(-9999, 9999).map(lambda number: number / 7)] * 2)
    corners = len(mesh.corners)
    parameters = draw(st.lists(place, min_size=corners, max_size=corners))
    parameters[0], parameters[1] = (0.0, 0.0), (1.0, 2.0)  # so that there is a surface
    plane = st.builds(EditedPlane, *[st.none() | vector] * 3)
    edited = draw(st.dictionaries(st.integers(0, len(faces) - 1), plane, max_size=2))
    factors = draw(st.none() | st.lists(positive, min_size=len(faces), max_size=len(faces)))
    numbers = draw(positive), draw(coordinates), draw(st.booleans())
    return MeshSurface(mesh, draw(domains), np.array(parameters), *numbers, edited, factors)


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
    st.booleans(),
)
shapes = st.builds(
    Shape,
    curves() | surfaces() | meshes(),
    words,
    visible=st.booleans(),
    locked=st.booleans(),
    style=styles,
)
designs = st.builds(Design, st.dictionaries(words.map(ShapeId), shapes, max_size=3))


def bits(geometry):
    """All that makes a geometry, for comparing to the last bit."""
    if isinstance(geometry, MeshSurface):
        return bits_of_mesh(geometry)
    net = geometry.net
    arrays = [net.control_points, net.given_vectors, net.automatic_vectors, net.weight_row]
    bases = [geometry.basis] if isinstance(geometry, PlusCurve) else geometry.bases
    numbers = [*arrays, np.float64(geometry.s)]
    return repr(bases), [None if a is None else (a.shape, a.tobytes()) for a in numbers]


def bits_of_mesh(surface):
    mesh, factors = surface.mesh, surface.factors
    arrays = [mesh.vertices, mesh.corners, mesh.starts, surface.parameters]
    parts = ("point", "gradient_u", "gradient_v")
    planes = {
        face: [None if (row := getattr(plane, part)) is None else row.tobytes() for part in parts]
        for face, plane in surface.edited.items()
    }
    numbers = (surface.domain, surface.smoothness, surface.s, surface.area_weights)
    is_even = factors is None or (factors == 1.0).all()
    return (
        repr(numbers),
        [(a.shape, a.tobytes()) for a in arrays],
        planes,
        None if is_even else factors.tobytes(),
    )


def contents(design):
    """All that makes a design, likewise."""
    return [
        (i, shape.name, shape.visible, shape.locked, shape.style, bits(shape.geometry))
        for i, shape in design.shapes.items()
    ]
