"""Edits of surfaces of meshes."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.commands.curves import SetMagnitude
from plusedit.commands.lines import MovePoints, Transform
from plusedit.commands.meshes import Remap, SetAreaWeights, SetSmoothness
from plusedit.document.design import EditError
from plusedit.document.map_record import map_of
from plusedit.document.selection import Selection
from plusedit.document.shape import ShapeId
from plusedit.geometry.mesh.domains import PlaneDomain, TorusDomain
from tests.designs import BOW, a_design
from tests.scene.meshes import HILL, a_hill, a_landscape


def test_smoothness_is_set_and_all_else_stays():
    design = a_landscape()
    edited = SetSmoothness({HILL: 2.5}).apply(design).mesh(HILL)
    assert edited.smoothness == 2.5
    assert edited.mesh is design.mesh(HILL).mesh
    assert edited.foundation is design.mesh(HILL).foundation


def test_setting_what_is_so_already_changes_nothing():
    design = a_landscape()
    surface = design.mesh(HILL)
    assert SetSmoothness({HILL: surface.smoothness}).apply(design) is design
    assert SetMagnitude({HILL: surface.s}).apply(design) is design
    assert SetAreaWeights((HILL,), surface.area_weights).apply(design) is design


@pytest.mark.parametrize("value", [0.0, -1.0, float("nan"), float("inf")])
def test_smoothness_is_positive(value):
    with pytest.raises(EditError, match="S lies between"):
        SetSmoothness({HILL: value}).apply(a_landscape())


def test_s_of_meshes_and_curves_is_set_together():
    design = a_landscape().with_shape(BOW, a_design()[BOW])
    edited = SetMagnitude({HILL: 0.5, BOW: 3.0}).apply(design)
    assert edited.mesh(HILL).s == 0.5
    assert edited.curve(BOW).s == 3.0


def test_weights_by_area_are_switched():
    assert SetAreaWeights((HILL,), True).apply(a_landscape()).mesh(HILL).area_weights


@pytest.mark.parametrize("state", [{"locked": True}, {"visible": False}])
def test_locked_and_hidden_meshes_stay(state):
    with pytest.raises(EditError, match="Hill is"):
        SetSmoothness({HILL: 2.0}).apply(a_landscape(**state))


def test_what_is_no_mesh_has_no_smoothness():
    with pytest.raises(EditError, match="is not a mesh"):
        SetSmoothness({BOW: 2.0}).apply(a_design())
    with pytest.raises(EditError, match="no shape"):
        SetSmoothness({ShapeId("x"): 2.0}).apply(a_design())


def test_meshes_move_and_turn_with_the_points_of_curves():
    design = a_landscape().with_shape(BOW, a_design()[BOW])
    targets = Selection.of_shapes([HILL, BOW]).targets(design)
    by = np.array([1.0, 2.0, 3.0])
    moved = MovePoints(targets, by).apply(design)
    vertices = design.mesh(HILL).mesh.vertices
    assert_allclose(moved.mesh(HILL).mesh.vertices, vertices + by)
    assert_allclose(moved.curve(BOW).lines.points, design.curve(BOW).lines.points + by[:2])
    doubled = Transform(targets, 2.0 * np.eye(3), np.zeros(3)).apply(design)
    assert_allclose(doubled.mesh(HILL).mesh.vertices, 2.0 * vertices)


def test_a_map_that_moves_nothing_leaves_the_design_as_it_is():
    design = a_landscape()
    assert MovePoints({HILL: ()}, np.zeros(3)).apply(design) is design


def test_labels_speak_of_meshes():
    design = a_landscape()
    assert MovePoints({HILL: ()}, np.ones(3)).label_in(design) == "Move mesh"
    assert SetSmoothness({HILL: 1.0, BOW: 1.0}).label == "Set S of 2 meshes"


def other_parameters(design):
    return design.mesh(HILL).parameters @ np.array([[0.0, 2.0], [-1.0, 0.5]])


def test_another_map_gives_the_mesh_other_parameters_and_is_told_of():
    design = a_landscape(a_hill().with_plane(3, gradient_u=[0.0, 1.0, 1.0]))
    parameters = other_parameters(design)
    edited = Remap(HILL, TorusDomain(9.0), parameters, "torus").apply(design)
    surface = edited.mesh(HILL)
    assert surface.domain == TorusDomain(9.0)
    assert_allclose(surface.parameters, parameters)
    assert map_of(edited[HILL]).name == "torus"
    assert set(surface.edited) == {3}
    assert surface.mesh is design.mesh(HILL).mesh


def test_the_same_map_again_changes_nothing():
    design = a_landscape()
    command = Remap(HILL, PlaneDomain(), other_parameters(design), "flat")
    once = command.apply(design)
    assert command.apply(once) is once


def test_cone_points_that_a_person_chose_are_told_of_until_they_are_reset():
    design = a_landscape()
    parameters = other_parameters(design)
    chosen = Remap(HILL, PlaneDomain(), parameters, "pillow", (4, 8, 1, 9)).apply(design)
    assert map_of(chosen[HILL]).cone_points == (4, 8, 1, 9)
    reset = Remap(HILL, PlaneDomain(), parameters, "pillow").apply(chosen)
    assert map_of(reset[HILL]).cone_points == ()


def test_parameters_that_make_no_surface_are_refused():
    design = a_landscape()
    nothing = np.zeros_like(design.mesh(HILL).parameters)
    with pytest.raises(EditError, match="Hill: parameters: no face has any extent"):
        Remap(HILL, PlaneDomain(), nothing, "flat").apply(design)
    with pytest.raises(EditError, match="Hill is locked"):
        Remap(HILL, PlaneDomain(), nothing, "flat").apply(a_landscape(locked=True))
