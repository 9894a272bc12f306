"""What overlays show at the point under the pointer, worked out once for each place of it."""

from plusedit.interaction.spotting import Spot, is_followed, spot_items, spot_under
from plusedit.interaction.tool import Pointer, Stage
from plusedit.scene.items import Item


class Spots:
    """The items at the point under the pointer of one view."""

    def __init__(self) -> None:
        self._spot: Spot | None = None
        self._seen: tuple[Pointer, Stage] | None = None
        self._items: tuple[Item, ...] = ()

    def items(self, at: Pointer | None, stage: Stage, *, is_busy: bool) -> tuple[Item, ...]:
        """What to draw in front; the same as before while nothing that it depends on changes.

        While something is dragged (`is_busy`) the shape stays that which was pointed at before.
        """
        if at is None or not is_followed(stage):
            self._spot, self._seen, self._items = None, None, ()
            return ()
        if self._seen is not None and self._seen[0] == at and _is_same(self._seen[1], stage):
            return self._items
        if not is_busy:
            self._spot = spot_under(at.at, stage)
        elif self._spot is not None:
            self._spot = spot_under(at.at, stage, self._spot.shape) or self._spot
        is_there = self._spot is not None and self._spot.shape in stage.design
        self._items = tuple(spot_items(self._spot, stage)) if self._spot and is_there else ()
        self._seen = at, stage
        return self._items


def _is_same(one: Stage, other: Stage) -> bool:
    is_same_view = one.camera == other.camera and one.options == other.options
    return one.design is other.design and is_same_view and one.selection == other.selection
