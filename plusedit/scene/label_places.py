"""Where labels lie on the screen, and which of them give way where they are crowded."""

from collections import defaultdict
from collections.abc import Sequence
from dataclasses import replace
from typing import TypeGuard

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera
from plusedit.scene.items import Item, Label

CHARACTER = 0.6  # of the height of a font: about the width of a letter
BETWEEN = 2.0  # pixels from one label to the next, at least
ROW = 16.0  # pixels: labels are looked up by rows about as high as they are


def label_box(label: Label) -> Floats:
    """(2, 2) the corners of about what a label covers, in pixels from its point."""
    width = CHARACTER * label.size * len(label.text)
    left = {"left": 0.0, "center": -0.5, "right": -1.0}[label.anchor] * width
    return np.array([[left, -label.size], [left + width, label.size / 3.0]]) + label.offset


def uncrowded(items: Sequence[Item], camera: Camera) -> tuple[Item, ...]:
    """The items without those labels that find no room among the others that give way.

    Each takes the first of its places that is free, those of the lowest rank first, and of one rank
    the last, which is in front. The order is kept, and what does not give way stays as it is.
    """
    giving_way = {i: item for i, item in enumerate(items) if _gives_way(item)}
    if not giving_way:
        return tuple(items)
    taken = _Taken()
    found = dict(enumerate(items))
    for number in sorted(giving_way, key=lambda i: (giving_way[i].rank, -i)):
        placed = _placed(giving_way[number], camera, taken)
        if placed is None:
            del found[number]
        else:
            found[number] = placed
    return tuple(found.values())


def _gives_way(item: Item) -> TypeGuard[Label]:
    return isinstance(item, Label) and item.rank is not None


def _placed(label: Label, camera: Camera, taken: "_Taken") -> Label | None:
    """The label where there is room for it, which it takes; None if there is none."""
    point = camera.to_screen(label.at[None])[0]
    for offset in (label.offset, *label.instead):
        moved = label if offset == label.offset else replace(label, offset=offset)
        if taken.take(point + label_box(moved)):
            return moved
    return None


class _Taken:
    """The part of the screen that labels lie on."""

    def __init__(self) -> None:
        self._rows: defaultdict[int, list[Floats]] = defaultdict(list)

    def take(self, box: Floats) -> bool:
        """Lay a label on the box (2, 2), unless another lies there; whether it does now.

        A place that is not a number is as good as any: nothing is drawn there.
        """
        if not np.isfinite(box).all():
            return True
        low, high = np.floor(box[:, 1] / ROW)
        rows = [self._rows[row] for row in range(int(low), int(high) + 1)]
        if any(_meet(box, other) for row in rows for other in row):
            return False
        for row in rows:
            row.append(box)
        return True


def _meet(one: Floats, other: Floats) -> bool:
    return bool((one[0] < other[1] + BETWEEN).all() and (other[0] < one[1] + BETWEEN).all())
