"""History: designs in order, as many as fit the budget."""

import numpy as np

from plusedit.commands.lines import MovePoints
from plusedit.document.design import Design
from plusedit.document.history import BUDGET, History
from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from tests.designs import BOW, WING, a_curve, a_design
from tests.scene.meshes import HILL, a_hill, a_landscape

LARGE = 1000  # control lines: 33 kB of arrays


def a_large_design():
    points = np.arange(2.0 * LARGE).reshape(LARGE, 2)
    basis = a_curve().basis.of_size(LARGE)
    return Design({WING: Shape(PlusCurve(basis, ControlLines.of(points, list(points))), "wing")})


def pushed(history, count, make=Design):
    """The designs that were pushed."""
    designs = [make() for _ in range(count)]
    for number, design in enumerate(designs):
        history.push(f"Step {number}", design)
    return designs


def steps_back(history):
    """How often undo leads to another design."""
    count = 0
    while history.undo_label is not None:
        history.undo()
        count += 1
    return count


def test_undo_and_redo_lead_through_the_very_same_designs():
    history = History(start := Design())
    designs = pushed(history, 5)
    for design in [*designs[-2::-1], start, start]:
        history.undo()
        assert history.design is design
    for design in [*designs, designs[-1]]:
        history.redo()
        assert history.design is design


def test_undo_and_redo_are_named():
    history = History(Design())
    pushed(history, 2)
    history.undo()
    assert (history.undo_label, history.redo_label) == ("Step 0", "Step 1")


def test_a_new_step_forgets_what_could_have_been_redone():
    history = History(Design())
    pushed(history, 2)
    history.undo()
    pushed(history, 1)
    assert history.redo_label is None
    assert steps_back(history) == 2


def test_the_same_design_is_no_step():
    history = History(start := Design())
    history.push("Nothing", start)
    assert history.undo_label is None


def test_the_budget_is_512_megabytes():
    assert BUDGET == 512 * 2**20


def test_ten_thousand_small_steps_can_all_be_undone():
    history = History(a_design())
    design = history.design
    curve = a_curve()
    for _ in range(10_000):
        design = design.with_curve(WING, curve)
        history.push("Move", design)
    assert steps_back(history) == 10_000


def test_beyond_the_budget_the_oldest_are_forgotten():
    history = History(a_large_design(), budget=1_000_000)
    designs = pushed(history, 100, a_large_design)
    kept = steps_back(history)
    assert 1_000_000 / 40_000 < kept < 1_000_000 / 30_000
    assert history.design is designs[99 - kept]


def test_the_last_step_can_be_undone_however_large_it_was():
    history = History(Design(), budget=1)
    pushed(history, 3, a_large_design)
    assert steps_back(history) == 1


def test_what_was_undone_and_replaced_no_longer_counts():
    history = History(a_large_design(), budget=1_000_000)
    for _ in range(100):
        history.push("Move", a_large_design())
        history.undo()
    pushed(history, 20, a_large_design)
    assert steps_back(history) == 20


def test_arrays_that_are_shared_are_not_counted():
    start = a_large_design()
    history = History(start, budget=1_000_000)
    design = start
    for s in range(200):
        curve = design.curve(WING)
        design = design.with_curve(WING, PlusCurve(curve.basis, curve.lines, float(s)))
        history.push("s", design)
    assert steps_back(history) == 200


def test_a_shape_that_is_shared_is_not_counted():
    start = a_large_design().with_shape(BOW, Shape(a_curve(), "bow"))
    history = History(start, budget=1_000_000)
    design = start
    for _ in range(200):
        design = design.with_curve(BOW, a_curve())
        history.push("Move", design)
    assert steps_back(history) == 200


def test_undo_to_what_was_saved_is_saved():
    history = History(Design())
    pushed(history, 1)
    assert not history.is_saved
    history.mark_saved()
    pushed(history, 1)
    assert not history.is_saved
    history.undo()
    assert history.is_saved


def test_what_was_never_saved_is_unsaved():
    history = History(Design())
    history.mark_unsaved()
    assert not history.is_saved


def test_an_edited_face_takes_the_points_of_all_and_shares_their_gradients():
    history = History(a_landscape(a_hill(40)))
    for step in range(3):
        history.push("Move", MovePoints({HILL: (step,)}, np.ones(3)).apply(history.design))
    first, second, third = (step.size for step in history._steps[1:])
    assert first > second == third
    assert 40 * 40 * 3 * 8 <= second < 2 * 40 * 40 * 3 * 8
