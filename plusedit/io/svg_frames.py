"""The frame of an SVG drawing: its view box and the size it is shown at.

Designs read from SVG keep the frame under `extra["svg"]`, so that writing restores it and other
programs find every shape at the same coordinates. User units are the world's units, y turned up.
"""

from dataclasses import dataclass

import numpy as np

from plusedit.document.shape import Json, Tree
from plusedit.geometry.arrays import Floats
from plusedit.io.svg_lengths import ViewBox, length, scale_of
from plusedit.io.svg_tree import Element

UPWARDS: Floats = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0]])
"""From user units, y down, to the world, y up"""

LARGE_SIDE = 800.0  # pixels of the longer side of a drawing that has no frame yet
MARGIN = 0.05  # of the longer side
USUAL_SIZE = (300.0, 150.0)  # pixels of a drawing that says nothing


@dataclass(frozen=True)
class Frame:
    """View box and size of an outermost <svg>, as its attributes say."""

    view_box: ViewBox | None = None
    width: str = ""
    """such as "72pt"; "" where not given"""
    height: str = ""
    aspect: str = ""
    """preserveAspectRatio"""

    @classmethod
    def of(cls, root: Element) -> "Frame":
        """The frame that the attributes of <svg> describe."""
        box = ViewBox.of(root.get("viewBox"))
        return cls(box, root.get("width"), root.get("height"), root.get("preserveAspectRatio"))

    @classmethod
    def around(cls, low: Floats, high: Floats) -> "Frame":
        """A frame for a world that lies between two corners (2,)."""
        side = float((high - low).max())
        side = side if side > 0.0 else 1.0
        low, high = low - MARGIN * side, high + MARGIN * side
        width, height = (high - low).tolist()
        pixels = LARGE_SIDE / max(width, height)
        box = ViewBox(float(low[0]), -float(high[1]), width, height)
        return cls(box, f"{width * pixels:.6g}", f"{height * pixels:.6g}")

    @property
    def viewport(self) -> tuple[float, float]:
        """Width and height in user units: what percentages mean."""
        if self.view_box is not None:
            return self.view_box.width, self.view_box.height
        return length(self.width, 0.0) or USUAL_SIZE[0], length(self.height, 0.0) or USUAL_SIZE[1]

    @property
    def pixels(self) -> float:
        """Pixels per user unit where the drawing is shown at its own size."""
        if self.view_box is None:
            return 1.0
        width, height = length(self.width, 0.0), length(self.height, 0.0)
        if width <= 0.0 and height <= 0.0:
            return 1.0
        width = width or height / self.view_box.height * self.view_box.width
        height = height or width / self.view_box.width * self.view_box.height
        return scale_of(self.view_box.fitted(width, height, self.aspect)) or 1.0

    def tree(self) -> dict[str, Json]:
        """The frame as JSON, for `Design.extra`."""
        tree: dict[str, Json] = {}
        if self.view_box is not None:
            box = self.view_box
            numbers: list[Json] = [box.x, box.y, box.width, box.height]
            tree["viewBox"] = numbers
        named = {"width": self.width, "height": self.height, "preserveAspectRatio": self.aspect}
        return tree | {key: value for key, value in named.items() if value}


def frame_in(extra: Tree) -> Frame | None:
    """The frame kept in the extra keys of a design, None if there is none or it is no frame."""
    tree = extra.get("svg")
    if not isinstance(tree, dict):
        return None
    box = tree.get("viewBox")
    numbers = box if isinstance(box, list) else []
    texts = [tree.get(key) for key in ("width", "height", "preserveAspectRatio")]
    kept = [text if isinstance(text, str) else "" for text in texts]
    return Frame(ViewBox.of(" ".join(map(str, numbers))), *kept)
