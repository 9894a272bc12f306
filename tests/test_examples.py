"""The designs that ship with the program: each opens, and shows what its caption says."""

import json
import runpy
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.comparison import even_points, fit_curve
from plusedit.geometry.frames import curvature
from plusedit.geometry.making.lofting import section_parameters
from plusedit.geometry.mesh.deviation import deviation
from plusedit.geometry.mesh.flattening.distortion import flips
from plusedit.geometry.mesh.mesh_surface import USUAL_SMOOTHNESS, MeshSurface
from plusedit.geometry.residual import residual
from plusedit.geometry.storage import stored_numbers
from plusedit.geometry.surface import PlusSurface
from plusedit.io.files import load
from plusedit.resources import example_files, picture_of_example
from plusedit.scene.options import options_of, panes_of, space_camera_of
from plusedit.scene.overlays import overlays
from plusedit.scene.theme import THEMES

ASSETS = Path(__file__).parents[1] / "assets"
sys.path.append(str(ASSETS))
MAKER = runpy.run_path(str(ASSETS / "make_examples.py"))


def panels(name):
    """The curves of an example by the names of its shapes."""
    [path] = [path for path in example_files() if path.stem == name]
    return {shape.name: shape.curve for shape in load(path).design.shapes.values()}


def cross(a, b):
    return a[0] * b[1] - a[1] * b[0]


def inflections(curve):
    """How often the curvature changes its sign."""
    _, velocity, acceleration = curve.derivatives(np.linspace(0.0, 1.0, 2001))
    return int((np.diff(np.sign(curvature(velocity, acceleration))) != 0).sum())


def alike(old, new):
    """Whether two JSON trees agree but for the rounding of numbers.

    Many are kept with few digits: where machines differ in the last bit, rounding may change the
    last digit that is kept.
    """
    if isinstance(old, dict):
        return old.keys() == new.keys() and all(alike(old[key], new[key]) for key in old)
    if isinstance(old, list):
        return len(old) == len(new) and all(map(alike, old, new))
    if isinstance(old, float):
        last = 10.0 ** -len(repr(old).partition(".")[2])
        return abs(new - old) <= max(1e-9, 1e-9 * abs(old), 1.01 * min(last, 1e-3))
    return old == new


@pytest.mark.parametrize("path", example_files(), ids=lambda path: path.stem)
def test_an_example_opens_without_a_remark(path):
    loaded = load(path)
    assert len(loaded.design) > 0
    assert not loaded.notes


@pytest.mark.parametrize("path", example_files(), ids=lambda path: path.stem)
def test_an_example_switches_on_overlays_that_there_are(path):
    assert options_of(load(path).design.view).overlays <= set(overlays)


def test_the_examples_are_those_that_are_made():
    made = dict(MAKER["files"]())
    assert sorted(made) == [path.name for path in example_files()]
    for path in example_files():
        assert alike(json.loads(path.read_bytes()), json.loads(made[path.name])), path.name


def test_figure_1_grows_s_from_zero_and_changes_nothing_else():
    curves = list(panels("figure_1").values())
    strengths = [curve.s for curve in curves]
    assert strengths[0] == 0.0
    assert strengths == sorted(set(strengths))
    for curve in curves:
        assert_allclose(curve.lines.points - curve.lines.points[0], MAKER["ARCH"], atol=1e-8)


def test_figure_2_differs_in_the_inner_directions_only():
    a, b, c = panels("figure_2").values()
    assert a.s == b.s == c.s
    for other in (b, c):
        ahead = other.lines.points - other.lines.points[0]
        assert_allclose(ahead, a.lines.points - a.lines.points[0], atol=1e-8)
        assert_allclose(other.directions[[0, -1]], a.directions[[0, -1]], atol=1e-8)
        assert (np.abs(other.directions[1:-1] - a.directions[1:-1]) > 0.1).any(axis=1).all()


def test_figure_3a_is_tangent_to_its_end_control_lines():
    curve = panels("figure_3")["(a)"]
    velocity = curve.derivatives([0.0, 1.0])[1]
    for at, direction in zip(velocity, curve.directions[[0, -1]], strict=True):
        assert at @ direction > 0.0
        assert cross(at, direction) == pytest.approx(0.0, abs=1e-9)


def test_figure_3b_closes_smoothly():
    curve = panels("figure_3")["(b)"]
    position, velocity, _ = curve.derivatives([0.0, 1.0])
    assert_allclose(position[0], position[1], atol=1e-12)
    assert_allclose(velocity[0], velocity[1], atol=1e-9)
    assert cross(velocity[0], curve.directions[0]) == pytest.approx(0.0, abs=1e-9)


def test_figure_3c_has_one_inflection_more_than_its_classical_curve():
    curve = panels("figure_3")["(c)"]
    assert len(curve.lines) == 3
    assert inflections(curve) == inflections(curve.classical) + 1


def test_figure_4_has_the_curves_of_figures_1_and_2():
    of_figures = [*list(panels("figure_1").values())[1:], *panels("figure_2").values()]
    for curve, same in zip(panels("figure_4").values(), of_figures, strict=True):
        assert curve.s == same.s
        assert_allclose(curve.directions, same.directions, atol=1e-8)


def test_figure_5_is_of_order_4_with_six_points():
    classical, plus = panels("figure_5").values()
    assert classical.s == 0.0 < plus.s
    assert classical.basis == plus.basis
    assert (plus.basis.order, plus.basis.size, plus.closed) == (4, 6, False)


def test_figure_6_lowers_s_and_then_reverses_the_upper_right_line():
    a, b, c = panels("figure_6").values()
    assert a.closed and b.closed and c.closed
    assert 0.0 < b.s < a.s == c.s
    upper_right = c.lines.points.sum(axis=1).argmax()
    signs = np.where(np.arange(len(c.lines)) == upper_right, -1.0, 1.0)
    assert_allclose(c.directions, signs[:, None] * a.directions, atol=1e-8)


def test_the_strands_of_the_braid_share_one_straight_line():
    for curve in panels("braid").values():
        assert_array_equal(curve.lines.points[:, 1], 0.0)


# In space


def surfaces(name):
    """The surfaces of an example by the names of its shapes."""
    return {key: shape.surface for key, shape in spatial(name).items() if shape.surface}


def spatial(name):
    """The shapes of an example by their names."""
    [path] = [path for path in example_files() if path.stem == name]
    return {shape.name: shape for shape in load(path).design.shapes.values()}


SPATIAL = [path for path in example_files() if load(path).design.is_spatial]


def test_there_are_a_sail_a_tube_a_torus_and_a_loft():
    assert {"figure_7", "sail", "tube", "torus", "loft"} <= {path.stem for path in SPATIAL}


@pytest.mark.parametrize("path", SPATIAL, ids=lambda path: path.stem)
def test_an_example_in_space_is_in_full_view(path):
    design, size = load(path).design, (1200.0, 800.0)
    camera = space_camera_of(design.view, size)
    assert panes_of(design.view) == "3d"
    for geometry in (shape.geometry for shape in design.shapes.values()):
        seen = camera.to_screen(points_of(geometry))
        assert (seen > 0.0).all() and (seen < size).all()


def points_of(geometry):
    """Points of a curve or surface."""
    if isinstance(geometry, MeshSurface):
        return geometry.at(geometry.vertex_places)
    t = np.linspace(0.0, 1.0, 21)
    points = geometry.at(t, t) if isinstance(geometry, PlusSurface) else geometry.at(t)
    return points.reshape(-1, geometry.dimension)


def test_figure_7_has_the_same_16_points_four_times():
    panels = list(surfaces("figure_7").values())
    assert len(panels) == 4
    for panel in panels:
        assert panel.planes.shape == (4, 4)
        ahead = panel.planes.points - panel.planes.points[0, 0]
        assert_allclose(ahead, panels[0].planes.points - panels[0].planes.points[0, 0], atol=1e-6)


def test_figure_7_goes_from_bezier_to_bezier_plus():
    a, b, c, d = surfaces("figure_7").values()
    assert a.s == 0.0 < b.s == c.s == d.s
    assert b.planes.automatic.all()
    t = np.linspace(0.0, 1.0, 41)
    # It expands towards its control points.
    middle = slice(1, 3)
    gaps = [
        np.linalg.norm(p.at(t, t)[:, :, None, None] - p.planes.points[middle, middle], axis=-1)
        for p in (a, b)
    ]
    assert (gaps[1].min(axis=(0, 1)) < gaps[0].min(axis=(0, 1))).all()


@pytest.mark.parametrize(("panel", "turned"), [("(c)", (0, 3)), ("(d)", (1, 2))])
def test_figure_7_turns_four_planes_and_keeps_the_lengths_of_their_directions(panel, turned):
    start, other = surfaces("figure_7")["(b)"], surfaces("figure_7")[panel]
    changed = (np.abs(other.directions - start.directions) > 0.1).any(axis=(0, 3))
    wanted = np.zeros((4, 4), dtype=bool)
    wanted[np.ix_(turned, turned)] = True
    assert_array_equal(changed, wanted)
    assert_allclose(np.linalg.norm(other.directions, axis=-1), 1.0, atol=1e-5)


def test_the_points_of_tube_and_torus_lie_on_round_ones():
    tube, torus = surfaces("tube")["tube"], surfaces("torus")["torus"]
    assert (tube.closed, torus.closed) == ((True, False), (True, True))
    assert_allclose(np.hypot(*tube.planes.points[..., :2].T), 1.0, atol=1e-5)
    x, y, z = torus.planes.points.reshape(-1, 3).T
    assert_allclose(np.hypot(np.hypot(x, y) - 2.0, z), 0.75, atol=1e-5)


def test_the_loft_meets_its_sections():
    shapes = spatial("loft")
    vase = shapes["vase"].surface
    curves = [shape.curve for shape in shapes.values() if shape.curve]
    t = np.linspace(0.0, 1.0, 21)
    for v, curve in zip(section_parameters(curves), curves, strict=True):
        assert_allclose(vase.at(t, [v])[:, 0], curve.at(t), atol=1e-5)


def test_the_goblet_is_round():
    t = np.linspace(0.0, 1.0, 21)
    radius = np.hypot(*surfaces("goblet")["goblet"].at(t, t)[..., :2].T)
    assert_allclose(radius, np.broadcast_to(radius[:, :1], radius.shape), rtol=1e-12)


# Of meshes


def meshes(name):
    """The surfaces of meshes of an example by the names of its shapes."""
    return {key: shape.mesh for key, shape in spatial(name).items() if shape.mesh}


MESHES = ("canyon", "rabbit", "knee", "figure_8")


@pytest.mark.parametrize("name", MESHES)
def test_the_meshes_are_whole_and_of_quads(name):
    found = meshes(name)
    assert found
    for surface in found.values():
        (component,) = surface.mesh.topology.components
        is_land = surface.domain.kind == "plane"
        assert (component.boundaries, component.handles) == ((1, 0) if is_land else (0, 0))
        assert set(surface.mesh.sizes.tolist()) == {4}
        assert flips(surface.mesh, surface.parameters) == 0


@pytest.mark.parametrize("name", MESHES)
def test_the_meshes_load_quickly(name):
    assert sum(surface.mesh.face_count for surface in meshes(name).values()) < 12_000


@pytest.mark.parametrize("name", ["rabbit", "knee"])
def test_the_surface_of_a_body_keeps_close_to_its_mesh(name):
    for surface in meshes(name).values():
        assert surface.smoothness == USUAL_SMOOTHNESS
        assert deviation(surface).to_surface.rms < 0.003 * surface.mesh.diagonal


def test_the_canyon_is_cut_deep_and_drains():
    mesh = meshes("canyon")["canyon"].mesh
    x, y, z = mesh.vertices.T
    lowest = z.argmin()
    assert x[lowest] == x.max()
    plateau = np.quantile(z, 0.9)
    assert plateau - z.min() > 0.7 * np.ptp(z)
    rows = z.reshape(len(np.unique(x)), len(np.unique(y)))
    assert (rows.min(axis=1) < plateau - 0.1 * np.ptp(z)).all()


def test_figure_8_shows_every_mesh_and_its_surface_at_two_levels():
    shapes = spatial("figure_8")
    assert list(shapes) == [f"({letter})" for letter in "abcdefghi"]
    for row in ("abc", "def", "ghi"):
        panels = [shapes[f"({letter})"] for letter in row]
        assert [shape.style.facets for shape in panels] == [True, False, False]
        itself, detailed, smooth = (shape.mesh for shape in panels)
        assert detailed.smoothness < smooth.smoothness
        for other in (detailed, smooth):
            assert_array_equal(itself.mesh.corners, other.mesh.corners)
            ahead = [each.mesh.vertices - each.mesh.vertices[0] for each in (itself, other)]
            assert_allclose(*ahead, atol=3e-4)


def test_every_example_has_a_picture_in_each_theme():
    for path in example_files():
        for theme in THEMES:
            header = picture_of_example(path, theme).read_bytes()[:24]
            assert header[:8] == b"\x89PNG\r\n\x1a\n"
            assert (int.from_bytes(header[16:20]), int.from_bytes(header[20:])) == (416, 264)


def test_no_picture_is_left_of_an_example_that_is_gone():
    folder = picture_of_example(example_files()[0], "light").parent
    named = {picture_of_example(path, theme) for path in example_files() for theme in THEMES}
    assert set(folder.iterdir()) == named


@pytest.mark.parametrize(
    ("letter", "away", "numbers"), [("a", 0.26, 12), ("b", 0.0032, 25), ("c", 0.0015, 24)]
)
def test_the_curves_of_the_claims_are_as_near_to_the_spiral_as_they_say(letter, away, numbers):
    found = panels("claims")
    spiral, curve = found[f"spiral {letter}"], found[f"({letter})"]
    points = even_points(spiral, 201)
    assert stored_numbers(curve) == numbers
    # Of the wild one, nearest points of other turns come out nearer than those that are meant.
    assert residual(curve, points).rms <= 1.05 * away
    assert fit_curve(points, "bspline", 6).rms > 0.2
