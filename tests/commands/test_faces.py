"""Edits of the faces of a mesh: all edits of control planes, and those that only faces have."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.commands.bearing import SetBearing
from plusedit.commands.faces import ResetPlanes, SetFactor
from plusedit.commands.lines import (
    Landing,
    MovePoints,
    ResetDirections,
    ReverseDirections,
    Rotate,
    ScaleDirections,
    SetCoordinate,
    SetDirection,
    SetLength,
    SetWeight,
    SoftMove,
    Transform,
    Turn,
)
from plusedit.commands.rotation import rotation
from plusedit.document.design import EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import ShapeId
from tests.designs import BOW, a_design
from tests.scene.meshes import HILL, a_hill, a_landscape

FACES = {HILL: (7, 14)}
BY = np.array([0.5, -0.25, 1.0])
TURN = rotation(np.array([0.0, 0.6, 0.8]), 0.5)

EDITS = {
    "Move 2 control planes": MovePoints(FACES, BY),
    "Softly move 2 control planes": SoftMove(FACES, BY, 0.3),
    "Set z of 2 control planes": SetCoordinate(FACES, 2, 3.0),
    "Mirror 2 control planes": Transform(FACES, np.diag([-1.0, 1.0, 1.0]), BY, "Mirror"),
    "Rotate 2 control planes": Rotate(FACES, TURN),
    "Rotate control plane": Turn({HILL: (7,)}, 0.5, (0, 2)),
    "Stretch 2 control planes": ScaleDirections(FACES, 2.0, "u"),
    "Set length of 2 control planes": SetLength(FACES, 2.0),
    "Set azimuth of 2 control planes": SetBearing(FACES, azimuth=1.0, side="v"),
    "Reverse 2 control planes": ReverseDirections(FACES),
    "Set direction": SetDirection(HILL, 7, BY, "u"),
    "Make 2 control planes sharper": SetFactor(FACES, 0.5, relative=True),
    "Make control plane smoother": SetFactor({HILL: (7,)}, 2.0, relative=True),
    "Set local S of 2 control planes": SetFactor(FACES, 3.0),
}
every_edit = pytest.mark.parametrize("label, edit", EDITS.items(), ids=EDITS)


def faces_edited(design):
    return list(design.mesh(HILL).edited)


def others(design):
    return np.setdiff1d(np.arange(design.mesh(HILL).mesh.face_count), FACES[HILL])


@every_edit
def test_an_edit_of_faces_is_a_step_and_undo_brings_the_identical_design_back(label, edit):
    session = Session(a_landscape())
    before = session.design
    session.select(Selection.of_lines([LineId(HILL, 7), LineId(HILL, 14)]))
    session.commit(edit)
    assert session.undo_label == label
    assert session.selection.by_shape() == FACES
    session.undo()
    assert session.design is before


@every_edit
def test_an_edit_of_faces_leaves_mesh_and_other_faces_alone(label, edit):
    before = a_landscape()
    after = edit.apply(before).mesh(HILL)
    assert after.mesh is before.mesh(HILL).mesh
    if not isinstance(edit, SoftMove):
        assert set(after.edited) <= set(FACES[HILL])
        rest = others(before)
        assert_array_equal(after.vectors[:, rest], before.mesh(HILL).vectors[:, rest])


@every_edit
@pytest.mark.parametrize("state", [{"locked": True}, {"visible": False}])
def test_faces_of_locked_and_hidden_meshes_stay(label, edit, state):
    with pytest.raises(EditError, match="Hill is"):
        edit.apply(a_landscape(**state))


@every_edit
def test_a_face_that_is_not_there_is_named(label, edit):
    if not hasattr(edit, "targets"):
        return
    wrong = type(edit)(**{**vars(edit), "targets": {HILL: (3, 36)}})
    with pytest.raises(EditError, match="Hill has no control plane 37"):
        wrong.apply(a_landscape())


def test_faces_move_by_the_same_vector_and_land_exactly():
    goal = np.array([0.1, 0.2, 0.3])
    landing = Landing(HILL, 7, goal)
    before = a_landscape()
    after = MovePoints(FACES, BY, landing).apply(before).mesh(HILL)
    assert_array_equal(after.edited[7].point, goal)
    assert_allclose(after.edited[14].point, before.mesh(HILL).planes.points[14] + BY)
    assert after.edited[7].gradient_u is None


def test_a_rotation_keeps_the_lengths_and_the_angle_of_gradients():
    before, after = a_landscape().mesh(HILL), Rotate(FACES, TURN).apply(a_landscape()).mesh(HILL)
    rows = list(FACES[HILL])
    assert_allclose(after.vectors[:, rows], before.vectors[:, rows] @ TURN.T)
    assert after.edited[7].point is None


def test_a_few_faces_are_turned_as_a_body_with_their_gradients():
    before = a_landscape().mesh(HILL)
    after = Transform(FACES, TURN, BY).apply(a_landscape()).mesh(HILL)
    rows = list(FACES[HILL])
    assert_allclose(after.planes.points[rows], before.planes.points[rows] @ TURN.T + BY)
    assert_allclose(after.vectors[:, rows], before.vectors[:, rows] @ TURN.T)


@pytest.mark.parametrize("command", [MovePoints, lambda t, by: SoftMove(t, by, 0.3)])
@pytest.mark.parametrize("rows", [(), tuple(range(36))])
def test_all_faces_move_with_their_mesh(command, rows):
    before = a_landscape()
    after = command({HILL: rows}, BY).apply(before).mesh(HILL)
    assert_allclose(after.mesh.vertices, before.mesh(HILL).mesh.vertices + BY)
    assert not after.edited


def test_a_soft_move_takes_neighbors_along():
    before = a_landscape().mesh(HILL)
    after = SoftMove({HILL: (14,)}, BY, 0.3).apply(a_landscape()).mesh(HILL)
    shares = np.linalg.norm(after.planes.points - before.planes.points, axis=1)
    away = np.linalg.norm(before.planes.points - before.planes.points[14], axis=1)
    assert_allclose(shares[14], np.linalg.norm(BY))
    assert_array_equal(shares > 0.0, away < 0.3)


def test_directions_of_a_mesh_that_is_meant_as_a_whole_are_those_of_all_faces():
    before = a_landscape().mesh(HILL)
    after = ReverseDirections({HILL: ()}).apply(a_landscape()).mesh(HILL)
    assert_array_equal(after.vectors, -before.vectors)


def test_directions_that_are_reset_are_the_faces_own():
    design = Rotate(FACES, TURN).apply(MovePoints({HILL: (7,)}, BY).apply(a_landscape()))
    after = ResetDirections(FACES).apply(design)
    assert faces_edited(after) == [7]
    assert_array_equal(after.mesh(HILL).vectors, a_landscape().mesh(HILL).vectors)


def test_planes_that_are_reset_are_the_faces_own():
    design = Rotate(FACES, TURN).apply(MovePoints({HILL: (3, 7)}, BY).apply(a_landscape()))
    assert faces_edited(ResetPlanes(FACES).apply(design)) == [3]
    assert faces_edited(ResetPlanes({HILL: ()}).apply(design)) == []
    assert ResetPlanes({HILL: (5,)}).apply(design) is design
    assert ResetPlanes(FACES).label_in(design) == "Reset 2 control planes"
    assert ResetPlanes({HILL: ()}).label_in(design) == "Reset mesh"


@pytest.mark.parametrize(
    "edit",
    [
        MovePoints(FACES, np.zeros(3)),
        SoftMove(FACES, np.zeros(3), 1.0),
        Rotate(FACES, np.eye(3)),
        ScaleDirections(FACES, 1.0),
        Transform(FACES, np.eye(3), np.zeros(3)),
        ResetDirections(FACES),
        ResetPlanes(FACES),
        SetWeight(FACES, 1.0),
        SetFactor(FACES, 1.0),
        SetFactor({HILL: ()}, 1.0, relative=True),
    ],
    ids=lambda edit: type(edit).__name__,
)
def test_an_edit_that_changes_nothing_is_no_step(edit):
    design = a_landscape()
    assert edit.apply(design) is design


def test_keeping_the_direction_that_a_face_has_is_no_edit():
    design = a_landscape()
    own = design.mesh(HILL).vectors[0, 7]
    assert SetDirection(HILL, 7, own, "u").apply(design) is design


def test_faces_have_no_weights():
    with pytest.raises(EditError, match="faces of a mesh have no weights"):
        SetWeight(FACES, 2.0).apply(a_landscape())


def test_smoothness_is_changed_at_some_faces_by_a_factor():
    sharper = SetFactor(FACES, 0.5).apply(a_landscape())
    surface = sharper.mesh(HILL)
    assert_allclose(surface.sigmas[7], 0.5 * a_landscape().mesh(HILL).sigmas[7])
    rest = others(sharper)
    assert_array_equal(surface.sigmas[rest], a_landscape().mesh(HILL).sigmas[rest])
    again = SetFactor({HILL: (7,)}, 0.5, relative=True).apply(sharper).mesh(HILL)
    assert_array_equal(again.factors[[7, 14, 0]], [0.25, 0.5, 1.0])


def test_factors_that_are_all_one_are_none():
    design = SetFactor(FACES, 0.5).apply(a_landscape())
    assert SetFactor(FACES, 1.0).label_in(design) == "Reset local S of 2 control planes"
    assert SetFactor(FACES, 1.0).apply(design).mesh(HILL).factors is None


def test_the_factors_of_a_whole_mesh_are_those_of_all_faces():
    design = SetFactor({HILL: ()}, 2.0).apply(a_landscape())
    assert_array_equal(design.mesh(HILL).factors, np.full(36, 2.0))


@pytest.mark.parametrize("factor", [0.0, -1.0, 1e9, float("nan"), float("inf")])
def test_a_factor_is_positive_and_of_use(factor):
    with pytest.raises(EditError, match="a factor of S"):
        SetFactor(FACES, factor).apply(a_landscape())


def test_only_meshes_have_faces():
    with pytest.raises(EditError, match="is not a mesh"):
        SetFactor({BOW: (0,)}, 2.0).apply(a_design())
    with pytest.raises(EditError, match="is not a mesh"):
        ResetPlanes({BOW: (0,)}).apply(a_design())
    with pytest.raises(EditError, match="no shape"):
        ResetPlanes({ShapeId("x"): ()}).apply(a_design())


def test_faces_and_lines_are_edited_together():
    design = a_landscape().with_shape(BOW, a_design()[BOW])
    targets = FACES | {BOW: (0,)}
    after = MovePoints(targets, BY).apply(design)
    assert faces_edited(after) == [7, 14]
    moved = design.curve(BOW).lines.points[0] + BY[:2]
    assert_allclose(after.curve(BOW).lines.points[0], moved)
    label = MovePoints(targets, BY).label_in(design)
    assert label == "Move control line and 2 control planes"


def test_a_drag_of_a_face_keeps_all_that_does_not_depend_on_it():
    before = a_hill()
    after = MovePoints(FACES, BY).apply(a_landscape(before)).mesh(HILL)
    assert after.foundation is before.foundation
    assert after.vectors is before.net.vectors
