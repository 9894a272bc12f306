from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.blend import Grid
from plusedit.geometry.surface_nearest import nearest_on_surface
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.drawn_mesh import drawing_of
from plusedit.scene.items import Caption, Segments
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import Seen, overlays
from plusedit.scene.scene import scene_items
from plusedit.scene.shape_pairs import Pair, comparison, known_comparison, pair_of, values_at
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import space_items
from tests.geometry.curves import random_curve
from tests.geometry.surfaces import a_surface
from tests.scene.meshes import a_hill

ENTRY = overlays["two_shapes"]
SHOWN = ViewOptions(overlays=frozenset({"two_shapes"}))
CAMERA = PlaneCamera((800.0, 600.0), scale=200.0)
IN_SPACE = SpaceCamera((800.0, 600.0), height=6.0)
CURVE = random_curve("bspline")


def design_of(**geometries):
    return Design({ShapeId(name): Shape(each, name) for name, each in geometries.items()})


def a_design():
    return design_of(
        sheet=a_surface(), bow=CURVE, arc=CURVE.classical, hill=a_hill(), ghost=CURVE.classical
    )


def hidden(design, name):
    return design.with_shape(ShapeId(name), replace(design[ShapeId(name)], visible=False))


def items(design, chosen=(), waits=True, **settings):
    numbers = {**ENTRY.numbers({}), **settings}
    seen = Seen(CAMERA, settings=numbers, waits=waits)
    return list(ENTRY.draw_design(design, frozenset(map(ShapeId, chosen)), seen))


def caption(found):
    (words,) = (item for item in found if isinstance(item, Caption))
    return words


@pytest.mark.parametrize(
    ("chosen", "pair"),
    [
        (["bow", "arc"], {"bow", "arc"}),
        (["sheet", "hill"], {"sheet", "hill"}),
        (["bow"], {"bow", "ghost"}),
        (["hill"], {"sheet", "hill"}),
        ([], {"ghost", "arc"}),
        (["bow", "sheet"], None),
        (["bow", "arc", "ghost"], None),
    ],
)
def test_two_of_a_kind_are_compared(chosen, pair):
    found = pair_of(a_design(), frozenset(map(ShapeId, chosen)))
    assert (set(found) if found else None) == pair


def test_hidden_shapes_are_not():
    design = hidden(a_design(), "ghost")
    assert set(pair_of(design, frozenset())) == {"sheet", "hill"}
    assert pair_of(design_of(one=CURVE), frozenset()) is None


def test_hairs_run_from_the_first_curve_to_the_second():
    design = design_of(first=CURVE, second=CURVE.classical)
    drawn = next(i for i in items(design, ["first"], density=33.0) if isinstance(i, Segments))
    assert len(drawn.starts) == 33
    fine = np.linspace(0.0, 1.0, 4001)
    for points, curve in ((drawn.starts, CURVE), (drawn.ends, CURVE.classical)):
        apart = np.linalg.norm(points[:, None] - curve.at(fine)[None], axis=2).min(axis=1)
        assert apart.max() < 1e-2


def test_the_caption_tells_the_distances_both_ways():
    design = design_of(first=CURVE, second=CURVE.classical)
    found = comparison(design, Pair(ShapeId("first"), ShapeId("second")))
    words = caption(items(design, ["first"]))
    values = [row.value for row in words.rows]
    assert words.title == "first and second"
    assert values[0] == f"{found.there.largest:.4g} units"
    assert values[2] == f"{found.back.largest:.4g} units"
    assert values[4] == f"{found.hausdorff:.4g} units"


def test_a_plane_curve_and_one_of_space_are_compared_in_space():
    flat, high = CURVE, random_curve("bspline", dimension=3)
    found = comparison(design_of(a=flat, b=high), Pair(ShapeId("a"), ShapeId("b")))
    assert found.there.points.shape[1] == 3


def test_without_a_pair_it_says_what_to_select():
    assert "select" in caption(items(design_of(one=CURVE))).rows[0].text


def test_what_takes_long_is_not_waited_for_where_nobody_may():
    design = design_of(one=a_surface(s=0.3), two=a_surface(s=0.9))
    assert "measured" in caption(items(design, waits=False)).rows[0].text
    items(design)
    assert len(caption(items(design, waits=False)).rows) == 5


def test_what_was_found_is_kept():
    design = design_of(one=a_surface(), two=a_surface(5, 5))
    pair = Pair(ShapeId("one"), ShapeId("two"))
    assert comparison(design, pair) is comparison(design, pair, wait=False)
    assert known_comparison(design[pair.first].surface, design[pair.second].surface)


def test_after_an_edit_what_was_known_before_serves_on():
    pair = Pair(ShapeId("one"), ShapeId("two"))
    before = comparison(design_of(one=a_surface(), two=a_surface(5, 5)), pair)
    edited = design_of(one=a_surface(s=0.7), two=a_surface(5, 5))
    assert comparison(edited, pair, wait=False) is before


def test_the_first_surface_is_colored_by_its_distances():
    first, second = a_surface(s=0.2), a_surface(5, 5, s=1.0)
    design = design_of(first=first, second=second)
    found = comparison(design, Pair(ShapeId("first"), ShapeId("second")))
    grids = Grid.uniform(7), Grid.uniform(5)
    values = values_at(found, grids)
    points = first.sample(*grids).reshape(-1, 3)
    nearest = [second.at(*np.array(nearest_on_surface(second, p))[:, None])[0, 0] for p in points]
    apart = np.linalg.norm(points - nearest, axis=1).reshape(7, 5)
    assert_allclose(values, apart, atol=0.02 * apart.max())
    assert values is values_at(found, grids)


def test_a_mesh_is_colored_at_the_points_that_are_drawn():
    hill, higher = a_hill(), a_hill().transformed(np.eye(3), [0.0, 0.0, 0.25])
    found = comparison(design_of(a=hill, b=higher), Pair(ShapeId("a"), ShapeId("b")))
    values = values_at(found, drawing_of(hill))
    assert values.shape == (len(drawing_of(hill).points),)
    assert 0.0 < values.max() <= 0.25 + 1e-9


def test_in_space_it_has_a_legend_and_in_the_plane_lines():
    design = design_of(first=a_surface(s=0.2), second=a_surface(5, 5, s=1.0))
    layers = space_items(design, IN_SPACE, SHOWN, Selection())
    colored = [item for item in layers.solids if getattr(item, "colors", None) is not None]
    assert len(colored) == 1
    assert any(getattr(item, "title", "") == "Distance" for item in layers.labels)
    flat = scene_items(design, CAMERA, SHOWN)
    assert flat.legends
    assert flat.captions
