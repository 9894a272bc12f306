"""Edits of whole surfaces, of their rows and columns, and curves taken from them."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from plusedit.commands.shapes import DeleteLines, Duplicate
from plusedit.commands.surfaces import (
    Balance,
    ChangeFamilyOf,
    ChangeOrderOf,
    DeletePlanes,
    ExtractBoundary,
    ExtractCurve,
    InsertRow,
    PassThroughSurface,
    ReverseWay,
    SetBasisFieldOf,
    SetClosedOf,
    TangentCorners,
    TangentToCornerPlanes,
    Transpose,
)
from plusedit.document.design import EditError
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.surface_magnitude import natural_lengths
from tests.commands.known import A, B, known, sheet

U = np.linspace(0.0, 1.0, 17)
V = np.linspace(0.0, 1.0, 23)


def committed(command, surface=None, selected=()):
    session = Session(known(sheet() if surface is None else surface))
    session.select(Selection.of_lines(LineId(A, number) for number in selected))
    session.commit(command)
    return session


def after(command, surface=None):
    return committed(command, surface).design.surface(A)


def numbers(session):
    return session.selection.by_shape().get(A, ())


def torus():
    return sheet(basis_u=BSpline(4, 3, closed=True), basis_v=BSpline(5, 4, closed=True))


# Rows and columns


@pytest.mark.parametrize("way, shape", [("u", (5, 5)), ("v", (4, 6))])
def test_an_inserted_row_is_selected_and_the_shape_stays(way, shape):
    session = committed(InsertRow(A, way, 0.5), selected=[19])
    surface = session.design.surface(A)
    assert surface.planes.shape == shape
    assert_allclose(surface.at(U, V), sheet().at(U, V), atol=1e-9)
    rows, columns = np.unravel_index(numbers(session), shape)
    line = rows if way == "u" else columns
    assert len(set(line)) == 1 and 1 <= line[0] <= 3
    assert len(numbers(session)) == shape[1 if way == "u" else 0]
    assert session.selection.active is not None


@pytest.mark.parametrize(
    "gone, rows, columns",
    [
        ((5, 6, 7, 8, 9), [0, 2, 3], [0, 1, 2, 3, 4]),
        ((1, 6, 11, 16), [0, 1, 2, 3], [0, 2, 3, 4]),
        ((0, 1, 2, 3, 4, 5, 10, 15), [1, 2, 3], [1, 2, 3, 4]),
    ],
)
@pytest.mark.parametrize("delete", [DeletePlanes, DeleteLines])
def test_deleting_rows_and_columns_keeps_the_others_as_they_were(delete, gone, rows, columns):
    surface = after(delete({A: gone}))
    expected = sheet().planes.taken(rows, columns)
    assert_array_equal(surface.planes.points, expected.points)
    assert_array_equal(surface.planes.given, expected.given)


@pytest.mark.parametrize("gone", [(7,), (5, 6, 7, 8), (5, 6, 7, 8, 9, 11), (0, 6, 12, 18)])
def test_planes_that_make_up_no_rows_are_not_deleted(gone):
    with pytest.raises(EditError, match=r"Select whole rows or columns .* to delete them\."):
        DeleteLines({A: gone}).apply(known(sheet()))


@pytest.mark.parametrize("gone", [range(20), range(15), [n for n in range(20) if n % 5]])
def test_a_surface_left_with_fewer_than_two_rows_goes_whole(gone):
    assert list(committed(DeleteLines({A: tuple(gone)})).design) == [B]


def test_after_deleting_the_row_before_is_selected_so_that_delete_can_go_on():
    row = (10, 11, 12, 13, 14)
    assert numbers(committed(DeleteLines({A: row}), selected=row)) == (5, 6, 7, 8, 9)
    first_column = (0, 5, 10, 15)
    session = committed(DeleteLines({A: first_column}), selected=first_column)
    assert numbers(session) == (0, 4, 8, 12)


def test_planes_that_stay_selected_keep_being_the_same_planes():
    session = committed(DeleteLines({A: (5, 6, 7, 8, 9)}), selected=[4, 7, 12])
    assert numbers(session) == (4, 7)


def test_lines_and_rows_are_deleted_in_one_step():
    session = Session(known(sheet()))
    row = (5, 6, 7, 8, 9)
    session.select(Selection.of_lines([LineId(A, n) for n in (*row, 19)] + [LineId(B, 3)]))
    session.commit(DeleteLines({A: row, B: (0, 1)}))
    assert session.undo_label == "Delete 2 control lines and 5 control planes"
    assert session.selection.by_shape() == {A: (14,), B: (1,)}
    assert session.design.surface(A).planes.shape == (3, 5)
    assert len(session.design.curve(B).lines) == 2


# Surfaces as wholes


@pytest.mark.parametrize(
    "command, turn",
    [
        (Transpose((A,)), lambda points: np.swapaxes(points, 0, 1)),
        (ReverseWay((A,), "u"), lambda points: points[::-1]),
        (ReverseWay((A,), "v"), lambda points: points[:, ::-1]),
    ],
    ids=["transpose", "u", "v"],
)
@pytest.mark.parametrize("start", [sheet, torus])
def test_a_surface_run_another_way_has_the_same_shape_and_keeps_its_selection(command, turn, start):
    session = committed(command, start(), selected=[1, 8, 15])
    surface = session.design.surface(A)
    assert_allclose(surface.at(U, U), turn(start().at(U, U)), atol=1e-12)
    old = start().planes.control_points[[1, 8, 15]]
    new = surface.planes.control_points[list(numbers(session))]
    assert set(map(tuple, new)) == set(map(tuple, old))


def test_the_active_plane_stays_active():
    session = committed(Transpose((A,)), selected=[7])
    assert session.selection.active == LineId(A, 2 * 4 + 1)


@pytest.mark.parametrize("family, kind", [("bezier", Bernstein), ("rag", RationalGaussian)])
def test_another_family_one_way_leaves_the_planes_and_the_other_way(family, kind):
    start = sheet()
    surface = after(ChangeFamilyOf((A,), "v", family), start)
    assert isinstance(surface.basis_v, kind)
    assert surface.basis_u is start.basis_u and surface.planes is start.planes


def test_a_surface_closes_and_opens_one_way():
    tube = SetClosedOf((A,), "v", True).apply(known(sheet()))
    assert tube.surface(A).closed == (False, True)
    assert SetClosedOf((A,), "v", False).apply(tube).surface(A).basis_v == sheet().basis_v


def test_the_order_one_way_is_at_most_the_number_of_planes():
    assert after(ChangeOrderOf((A,), "u", 9)).basis_u == BSpline(4, 4)


def test_what_a_basis_can_not_have_is_refused_in_words():
    with pytest.raises(EditError, match=r"A: .*no sigma"):
        SetBasisFieldOf((A,), "u", "sigma", 0.5).apply(known(sheet()))
    bezier = sheet(basis_u=Bernstein(4))
    with pytest.raises(EditError, match="never closed"):
        SetClosedOf((A,), "u", True).apply(known(bezier))


def test_curves_are_no_surfaces():
    with pytest.raises(EditError, match="B is not a surface"):
        Transpose((B,)).apply(known(sheet()))


def test_corners_become_tangent_to_the_net():
    surface = after(TangentCorners((A,)))
    _, along_u, along_v = surface.derivatives([0.0], [0.0], highest=1)
    points = surface.planes.points
    for way, edge in (
        (along_u, points[1, 0] - points[0, 0]),
        (along_v, points[0, 1] - points[0, 0]),
    ):
        assert_allclose(np.cross(way[0, 0], edge), 0.0, atol=1e-9)


def test_a_surface_touches_its_corner_planes():
    surface = after(TangentToCornerPlanes((A,)))
    normal = np.cross(*surface.directions[:, 0, 0])
    _, along_u, along_v = surface.derivatives([0.0], [0.0], highest=1)
    assert_allclose([along_u[0, 0] @ normal, along_v[0, 0] @ normal], 0.0, atol=1e-9)


def test_a_surface_passes_through_its_points():
    surface = after(PassThroughSurface((A,)))
    assert_allclose(
        surface.at(surface.basis_u.nodes, surface.basis_v.nodes), surface.planes.points, atol=1e-9
    )


def test_balanced_directions_are_as_long_as_the_net_each_way():
    surface = after(Balance((A,)))
    lengths = np.linalg.norm(surface.directions, axis=-1).mean(axis=(1, 2))
    length_u, length_v = natural_lengths(surface)
    assert lengths[0] / lengths[1] == pytest.approx(length_u / length_v)


def test_a_copied_surface_is_shifted_and_exact():
    session = committed(Duplicate((A,), np.array([1.0, 2.0, 3.0])))
    copied = session.design.surface("a-2")
    assert_allclose(copied.at(U, V), sheet().at(U, V) + np.array([1.0, 2.0, 3.0]), atol=1e-12)
    assert session.selection == Selection.of_shapes(["a-2"])


# Curves taken from surfaces


@pytest.mark.parametrize("way", ["u", "v"])
def test_a_curve_of_constant_u_or_v_lies_on_the_surface_and_is_selected(way):
    session = committed(ExtractCurve(A, way, 0.3))
    (added,) = session.selection.shapes
    on = sheet().at([0.3], U)[0] if way == "u" else sheet().at(U, [0.3])[:, 0]
    assert_allclose(session.design.curve(added).at(U), on, atol=1e-12)
    assert session.design[added].name == f"A, {way} = 0.30"


def test_the_edges_of_a_sheet_are_four_curves_in_front():
    session = committed(ExtractBoundary((A,)))
    assert len(session.selection.shapes) == 4
    assert list(session.design)[:2] == [A, B]
    names = [session.design[i].name for i in session.design if i in session.selection.shapes]
    assert names == ["A, edge", "A, edge 2", "A, edge 3", "A, edge 4"]


def test_a_torus_has_no_edges():
    with pytest.raises(EditError, match="A closes by u and by v: it has no edges"):
        ExtractBoundary((A,)).apply(known(torus()))
