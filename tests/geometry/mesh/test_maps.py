"""Parts of meshes get parameters: which map, one to one, and consistent where domains close."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.geometry.mesh.flattening.distortion import flipped, flips, stretch
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.maps import Subject, maps
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh
from plusedit.geometry.mesh.repair import repaired
from plusedit.io.mesh_reading import read_mesh
from tests.geometry.mesh.bodies import (
    FOLDER,
    NAMES,
    cube,
    cylinder,
    every_real_mesh,
    sheet,
    together,
    torus,
)
from tests.geometry.mesh.mapped_bodies import (
    areas_of,
    assert_seams_fit,
    assert_similar,
    ball,
    blocks,
    ramp,
    rings,
    tube,
    turned_in_space,
    without,
)

TETRAHEDRON = PolygonMesh.of(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
)
BODIES = {
    "ball": (ball(), "pillow"),
    "egg": (ball(3, (3.0, 1.0, 0.7)), "pillow"),
    "tetrahedron": (TETRAHEDRON, "pillow"),
    "cube": (cube(), "pillow"),
    "closed cylinder": (cylinder(24, 3.0), "pillow"),
    "bar of blocks": (blocks((x, 0, 0) for x in range(9)), "pillow"),
    "cross of blocks": (blocks([(1, 0, 0), (0, 1, 0), (1, 1, 0), (2, 1, 0), (1, 2, 0)]), "pillow"),
    "open ball": (without(ball(), [7]), "filled_pillow"),
    "ball with holes": (without(ball(), [0, 100, 200, 300]), "filled_pillow"),
    "torus": (torus(24, 15), "torus"),
    "ring of blocks": (rings(1), "torus"),
    "torus with a hole": (without(torus(24, 15), [5]), "torus"),
    "two handles": (rings(2), "rough_cut"),
    "three handles and a hole": (without(rings(3), [8]), "rough_cut"),
    "tube": (tube(12, 9), "cylinder"),
    "long tube": (tube(9, 80, height=60.0), "cylinder"),
    "tube with a hole": (without(tube(12, 9), [50]), "cylinder"),
    "sheet": (sheet(6, 9), "height_field"),
    "sheet somewhere": (turned_in_space(sheet(6, 9)), "flat"),
    "sheet with a hole": (without(turned_in_space(sheet(6, 9)), [20]), "flat"),
    "bent sheet": (without(tube(12, 9), np.arange(0, 108, 12)), "square"),
    "half a ball": (turned_in_space(ball().taken(np.arange(256)).mesh), "circle"),
    "one turn": (ramp(0.9), "height_field"),
    "two turns": (ramp(1.9), "square"),
    "triangle": (PolygonMesh.of(np.eye(3), [(0, 1, 2)]), "flat"),
}
every_body = pytest.mark.parametrize(("mesh", "name"), BODIES.values(), ids=BODIES)

KINDS = {
    "beetle_nonmanifold.obj": "circle",
    "blub_quads_uv.obj": "pillow",
    "bunny_closed_3k.obj": "pillow",
    "bunny_scan_5holes.obj": "filled_pillow",
    "demosthenes_open.obj": "filled_pillow",
    "femur.stl": "pillow",
    "goathead_closed.obj": "pillow",
    "halftunnel_quads.off": "cylinder",
    "hand_closed.obj": "pillow",
    "mountain_irregular_sheet.obj": "square",
    "plane_27loops.obj": "filled_pillow",
    "planexy.off": "height_field",
    "skull_genus2.obj": "rough_cut",
    "spot_quads_uv.obj": "pillow",
    "spot_tri_uv.obj": "pillow",
    "teapot_3parts.obj": "filled_pillow",
    "tm_BoxTextured.glb": "pillow",
    "tm_box.obj": "pillow",
    "tm_cube_blender_uv.ply": "pillow",
    "tm_cylinder.stl": "pillow",
    "tm_fuze.obj": "pillow",
    "tm_negative_indices.obj": "pillow",
    "tm_polygonfaces.obj": "circle",
    "tm_quadknot.obj": "torus",
    "tm_suzanne.ply": "filled_pillow",
    "torus.obj": "torus",
}


@every_body
def test_every_kind_of_body_has_its_map_and_no_triangle_is_turned_over(mesh, name):
    found = mapped(mesh)
    assert found.name == name
    assert found.flips == 0
    assert areas_of(mesh, found.parameters).min() > 0.0
    assert found.parameters.shape == (len(mesh.corners), 2)
    assert found.why
    assert found.title == maps[name].title


@every_body
def test_the_two_sides_of_every_edge_fit(mesh, name):
    found = mapped(mesh)
    if name != "rough_cut":
        assert_seams_fit(mesh, found)


@pytest.mark.parametrize("name", ["ball", "cross of blocks", "torus", "ring of blocks", "tube"])
def test_domains_are_covered_once(name):
    found = mapped(BODIES[name][0])
    height = np.ptp(found.parameters[:, 1])
    cell = {"pillow": 0.5, "torus": 1.0, "cylinder": 1.0}[found.name]
    periods = [p if np.isfinite(p) else height for p in found.domain.periods]
    total = areas_of(BODIES[name][0], found.parameters).sum()
    assert total == pytest.approx(cell * np.prod(periods))


@every_real_mesh
def test_every_part_of_real_meshes_has_parameters_without_flips(name):
    parts = real_parts(name)
    for place, (mesh, uv) in enumerate(parts[:6]):
        found = mapped(mesh, uv=uv)
        assert found.flips == 0
        assert np.isfinite(found.parameters).all()
        if found.name != "rough_cut":
            assert_seams_fit(mesh, found)
        if place == 0 and name in KINDS:
            assert found.name == KINDS[name]


def real_parts(name):
    """The proper parts of a mesh file and their texture coordinates."""
    path = FOLDER / "mesh" / name
    if not path.is_file():
        pytest.skip("no real meshes here")
    file = read_mesh(path)
    return [
        (part.mesh, None if file.uv is None else file.uv[part.corners])
        for part in repaired(file.mesh).parts
    ]


def test_every_real_mesh_has_an_expected_map():
    assert set(NAMES) - set(KINDS) <= {"tm_no_indices_3storybuilding.glb"}


# Angles ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("mesh", [ball(4), turned_in_space(ball(4))], ids=["", "turned"])
def test_a_ball_keeps_its_angles(mesh):
    angles = stretch(mesh, mapped(mesh).parameters).angles
    assert np.median(angles) < 1.05
    assert angles.mean() < 1.1


def test_a_torus_keeps_its_angles_and_the_ratio_of_its_periods():
    mesh = torus(48, 32)
    found = mapped(mesh)
    ratio = found.domain.height
    # Radii 2 and 1: going around along the axis is sqrt(2^2 - 1^2) as far as across, on the
    # conformal torus.
    assert max(ratio, 1.0 / ratio) == pytest.approx(np.sqrt(3.0), rel=0.01)
    assert stretch(mesh, found.parameters).angles.max() < 1.1


def test_a_twisted_torus_is_laid_out_along_its_shortest_periods():
    mesh = torus(40, 20)
    grid = np.arange(800).reshape(40, 20)
    # Quads joined with a shift of seven along each ring: the same torus by other generators.
    sheared = np.stack([np.roll(row, 7 * i) for i, row in enumerate(grid)])
    order = np.empty(800, dtype=np.intp)
    order[sheared.ravel()] = np.arange(800)
    moved = PolygonMesh(mesh.vertices[np.argsort(order)], order[mesh.corners], mesh.starts)
    assert_allclose(mapped(moved).domain.height, mapped(mesh).domain.height, rtol=1e-6)


def test_a_tube_is_unrolled():
    mesh = tube(16, 10, radius=1.0, height=3.0)
    found = mapped(mesh)
    side = 16 * 2.0 * np.sin(np.pi / 16)
    u, v = found.parameters.T
    x, y, z = mesh.vertices[mesh.corners].T
    # Either rim may have v = 0; u then goes around as seen from the other one.
    up = 1.0 if v[z == 0.0].max() == 0.0 else -1.0
    assert_allclose(up * v - (up * v)[z == 0.0].max(), z / side, atol=1e-3)
    turned = (u - up * np.arctan2(y, x) / (2.0 * np.pi) + 0.5) % 1.0
    assert_allclose(np.abs(turned - turned[0] + 0.5) % 1.0, 0.5, atol=1e-3)


def test_the_surface_of_a_ball_is_round_across_the_cuts():
    mesh = ball(4)
    found = mapped(mesh)
    surface = MeshSurface(mesh, found.domain, found.parameters, smoothness=0.5)
    places = np.random.default_rng(0).uniform(-2.0, 2.0, (2000, 2))
    radii = np.linalg.norm(surface.at(places), axis=1)
    assert_allclose(radii, 1.0, atol=0.02)


# Sheets ---------------------------------------------------------------------------------------


def test_a_flat_sheet_keeps_its_shape_wherever_it_lies():
    mesh = without(turned_in_space(sheet(5, 8)), [11, 12])
    found = mapped(mesh)
    assert found.name == "flat"
    assert_similar(mesh, found.parameters)
    assert found.parameters.min() == 0.0
    assert found.parameters.max() == 1.0


@pytest.mark.parametrize("triangles", [False, True])
def test_a_flat_rectangle_slides_to_its_own_shape(triangles):
    mesh = turned_in_space(uneven_sheet(7, 5), 3)
    if triangles:
        mesh = PolygonMesh.of(mesh.vertices, mesh.triangles()[0])
    found = mapped(mesh, wish="square")
    assert_similar(mesh, found.parameters)
    assert found.why == "as wished"


def uneven_sheet(rows, columns, seed=2):
    """A flat rectangle of uneven quads."""
    mesh = sheet(rows, columns)
    random = np.random.default_rng(seed)
    points = mesh.vertices.copy()
    inner = (points[:, :2] > 0).all(axis=1) & (points[:, :2] < (columns, rows)).all(axis=1)
    points[inner, :2] += random.uniform(-0.3, 0.3, (int(inner.sum()), 2))
    return mesh.with_vertices(points)


def test_a_flat_disk_on_the_circle_keeps_its_shape():
    angle = 2.0 * np.pi * np.arange(12) / 12
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.concatenate([[(0.0, 0.0)], 0.4 * ring, ring])
    after = np.roll(np.arange(12), -1)
    inner = [(0, 1 + i, 1 + after[i]) for i in range(12)]
    outer = [(1 + i, 13 + i, 13 + after[i], 1 + after[i]) for i in range(12)]
    mesh = PolygonMesh.of(np.pad(points, ((0, 0), (0, 1))), [*inner, *outer])
    assert_similar(mesh, mapped(mesh, wish="circle").parameters)


def test_a_terrain_has_x_and_y_for_parameters():
    mesh = sheet(4, 6)
    points = mesh.vertices * (30.0, 30.0, 1.0) + (5e5, 4e6, 0.0)
    points[:, 2] = 400.0 * np.sin(points[:, 0])
    mesh = mesh.with_vertices(points)
    found = mapped(mesh, is_height_field=True)
    assert found.name == "height_field"
    assert_allclose(found.parameters * 180.0, points[mesh.corners, :2] - (5e5, 4e6), atol=1e-9)


def test_a_terrain_with_walls_is_no_height_field_unless_it_is_known_to_be_one():
    mesh = sheet(2, 4)
    points = mesh.vertices.copy()
    points[points[:, 0] >= 2, 2] = 5.0
    points[points[:, 0] == 2, 0] = 1.0
    wall = mesh.with_vertices(points)
    assert mapped(wall).name != "height_field"
    assert mapped(wall, is_height_field=True).name == "height_field"


def test_what_lies_above_itself_is_not_seen_from_above():
    assert mapped(ramp(0.9)).name == "height_field"
    assert mapped(ramp(1.1)).name != "height_field"
    assert maps["height_field"].title not in mapped(ramp(1.1)).title


def test_ears_at_the_sides_of_a_rectangle_do_not_collapse():
    rim = [(0, 0), (1, 0), (2, 0), (3, 0), (3, 2), (0, 2)]
    points = np.pad([*rim, (1.5, 1), (1.5, -0.01)], ((0, 0), (0, 1)))
    spokes = [(i, (i + 1) % 6, 6) for i in range(6)]
    mesh = bent(PolygonMesh.of(points, [*spokes, (2, 1, 7)]))
    found = mapped(mesh, wish="square")
    assert areas_of(mesh, found.parameters).min() > 1e-4


def bent(mesh):
    points = mesh.vertices.copy()
    points[:, 2] = 0.1 * points[:, 0] ** 2
    return mesh.with_vertices(points)


# Texture coordinates --------------------------------------------------------------------------


def curved_sheet():
    """A part of a tube and its unrolled texture coordinates."""
    mesh = without(tube(12, 6), np.arange(0, 72, 12))
    points = mesh.vertices[mesh.corners]
    angle = np.arctan2(points[:, 1], points[:, 0]) % (2.0 * np.pi)
    angle[angle < 0.1] += 2.0 * np.pi
    return mesh, np.stack([angle, points[:, 2]], axis=1) / 7.0


def test_good_texture_coordinates_are_taken_as_they_are():
    mesh, uv = curved_sheet()
    found = mapped(mesh, uv=uv)
    assert found.name == "file_uv"
    assert_array_equal(found.parameters, uv)


@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        (lambda uv: uv * (-1.0, 1.0), "turned over"),
        (lambda uv: uv * (0.0, 1.0), "one line"),
        (lambda uv: uv * (9.0, 1.0), "one way"),
        (lambda uv: uv + np.repeat([[0.0, 0.0], [3.0, 0.0]], [80, len(uv) - 80], axis=0), "seams"),
        (
            lambda uv: (
                np.exp(-uv[:, 1:]) * np.stack([np.cos(9 * uv[:, 0]), np.sin(9 * uv[:, 0])], 1)
            ),
            "overlap",
        ),
    ],
)
def test_texture_coordinates_that_will_not_do_are_left(spoil, reason):
    mesh, uv = curved_sheet()
    bad = spoil(uv)
    found = mapped(mesh, uv=bad)
    assert found.name == "square"
    subject = Subject(mesh, mesh.topology, bad)
    told = maps["file_uv"].objection(subject) or maps["file_uv"].drawback(subject)
    assert reason in told


def test_texture_coordinates_with_seams_are_taken_if_wished():
    mesh = cube()
    uv = np.tile([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)], (6, 1))
    assert mapped(mesh, uv=uv).name == "pillow"
    assert_array_equal(mapped(mesh, uv=uv, wish="file_uv").parameters, uv)


# Wishes, cone points, progress ----------------------------------------------------------------


def test_cone_points_are_where_they_are_wished():
    mesh = ball()
    wished = (0, 17, 101, 200)
    found = mapped(mesh, wish="pillow", cone_points=wished)
    assert set(found.cone_points) == set(wished)
    assert found.flips == 0
    width = found.domain.width
    corners = np.array([(0, 0), (0, 0.5), (width, 0.5), (width, 0)])
    for vertex, corner in zip(found.cone_points, corners, strict=True):
        here = found.parameters[mesh.corners == vertex]
        assert_allclose(
            found.domain.nearest(here, np.tile(corner, (len(here), 1))) - corner, 0.0, atol=1e-12
        )


@pytest.mark.parametrize(
    ("wish", "mesh", "reason"),
    [
        ("pillow", torus(8, 6), "it has handles"),
        ("pillow", sheet(2, 2), "it isn't closed"),
        ("torus", ball(1), "it has no handles, not one"),
        ("cylinder", sheet(2, 2), "it hasn't two rims"),
        ("circle", ball(1), "it is closed"),
        ("square", tube(5, 2), "its rim has no corners, not four"),
        ("file_uv", sheet(2, 2), "the file has no texture coordinates"),
        ("flat", ball(1), "its faces look all ways"),
        ("rough_cut", ball(1), "it has no handles to be cut open"),
    ],
)
def test_wishes_that_do_not_suit_are_refused_in_a_sentence(wish, mesh, reason):
    with pytest.raises(ValueError, match=f"does not suit this part: {reason}"):
        mapped(mesh, wish=wish)


def test_a_map_that_is_not_there_is_named():
    with pytest.raises(KeyError, match="mercator"):
        mapped(ball(1), wish="mercator")


@pytest.mark.parametrize(
    ("mesh", "reason"),
    [
        (PolygonMesh.of(np.zeros((0, 3)), []), "without faces"),
        (together(sheet(1, 1), sheet(1, 1)), "only connected parts"),
        (PolygonMesh.of(np.eye(3), [(0, 1, 2), (0, 2, 1)]), "needs four vertices"),
    ],
    ids=["empty", "two parts", "two sides of a triangle"],
)
def test_what_can_not_be_mapped_is_refused_in_a_sentence(mesh, reason):
    with pytest.raises(ValueError, match=reason):
        mapped(mesh)


@pytest.mark.parametrize("points", [(0, 1, 2), (0, 0, 1, 2), (0, 1, 2, 900), (0, 1, 2, -1)])
def test_wrong_cone_points_are_refused(points):
    with pytest.raises(ValueError, match="cone points: "):
        mapped(ball(2), wish="pillow", cone_points=points)


@pytest.mark.parametrize(
    "name", ["ball", "open ball", "torus", "two handles", "tube", "bent sheet"]
)
def test_progress_goes_up_to_one(name):
    shares = []
    mapped(BODIES[name][0], progress=lambda share, words: shares.append(share))
    assert shares == sorted(shares)
    assert (shares[0], shares[-1]) == (0.0, 1.0)
    assert len(shares) >= 4


class CanceledError(Exception):
    pass


@pytest.mark.parametrize("after", range(4))
def test_progress_may_cancel_at_every_step(after):
    left = [after]

    def progress(share, words):
        if not left[0]:
            raise CanceledError
        left[0] -= 1

    with pytest.raises(CanceledError):
        mapped(ball(2), progress=progress)


# Bad shapes -----------------------------------------------------------------------------------


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=25, deadline=None)
def test_closed_bodies_of_bad_triangles_are_mapped_without_flips(seed):
    random = np.random.default_rng(seed)
    mesh = ball(2)
    points = mesh.vertices * 10.0 ** random.uniform(-1.5, 1.5, 3)
    # Some vertices where a neighbor is, or nearly: triangles without area and needles.
    moved = random.choice(len(points), 8, replace=False)
    near = mesh.corners[mesh.following[[np.flatnonzero(mesh.corners == v)[0] for v in moved]]]
    points[moved] = points[near] + random.choice([0.0, 1e-9, 1e-4], 8)[:, None] * points[moved]
    bad = mesh.with_vertices(points)
    found = mapped(bad)
    assert found.flips == 0
    assert_seams_fit(bad, found)


def test_vertices_of_no_face_do_not_matter():
    mesh = ball(2)
    more = PolygonMesh.of(np.concatenate([mesh.vertices, [(9, 9, 9)]]), mesh.faces)
    assert_array_equal(mapped(more).parameters, mapped(mesh).parameters)


def test_parameters_turn_with_nothing_but_the_mesh_s_shape():
    mesh = ball(3, (2.0, 1.0, 1.3))
    larger = mesh.with_vertices(1000.0 * mesh.vertices)
    assert_allclose(mapped(larger).parameters, mapped(mesh).parameters, atol=1e-9)


def test_faces_that_reach_half_around_are_told():
    assert any("half around" in note for note in mapped(TETRAHEDRON).notes)
    assert not mapped(ball(4)).notes


def test_filled_holes_and_cuts_are_told():
    (note,) = mapped(without(ball(4), [0, 100, 200])).notes
    assert note == "3 holes were filled for the map"
    assert "with 2 handles the part was cut open" in mapped(rings(2)).notes[-1]


# Distortion -----------------------------------------------------------------------------------


def test_stretch_tells_how_angles_and_areas_change():
    mesh = sheet(2, 3)
    parameters = mesh.vertices[mesh.corners, :2] * (3.0, 1.0)
    found = stretch(mesh, parameters)
    assert_allclose(found.angles, 3.0)
    assert_allclose(found.areas, 1.0)
    parameters[mesh.starts[0] : mesh.starts[1]] *= 2.0
    assert_allclose(stretch(mesh, parameters).areas, np.array([4.0, 1, 1, 1, 1, 1]) / 1.5)


def test_a_collapsed_face_has_infinite_stretch():
    mesh = sheet(1, 2)
    parameters = mesh.vertices[mesh.corners, :2].copy()
    parameters[:4, 1] = 0.0
    assert np.isinf(stretch(mesh, parameters).angles).tolist() == [True, False]


def test_faces_turned_over_are_counted_and_marked():
    mesh = PolygonMesh.of(sheet(1, 3).vertices, sheet(1, 3).triangles()[0])
    parameters = mesh.vertices[mesh.corners, :2].copy()
    parameters[3:6, 0] *= -1.0
    assert flips(mesh, parameters) == 1
    assert flipped(mesh, parameters).tolist() == [False, True, False, False, False, False]


def test_a_face_flat_up_to_rounding_is_not_turned_over():
    mesh = PolygonMesh.of(np.eye(3), [(0, 1, 2)])
    parameters = np.array([[0.1, 0.1], [0.3, 0.3], [0.2, 0.2 + 1e-17]])
    assert flips(mesh, parameters) == 0
