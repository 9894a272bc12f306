from tests.interaction.hand import Hand


def test_a_drag_shifts_the_view_by_as_many_pixels_as_the_pointer_goes():
    hand = Hand(tool="pan")
    shifts = []
    hand.gestures.panned.listen(lambda x, y: shifts.append((x, y)))
    before = hand.session.design
    hand.drag((0.0, 0.0), (1.0, 0.5), moves=5)
    assert [round(sum(column)) for column in zip(*shifts, strict=True)] == [100, -50]
    assert hand.session.design is before
