"""Draw a curve by hand: the stroke becomes a B-spline+ of few control lines."""

from typing import ClassVar

import numpy as np

from plusedit.commands.fitting import DrawFitted, FitSource
from plusedit.geometry.arrays import Floats
from plusedit.interaction.places import on_sheet, sheet_of
from plusedit.interaction.tool import (
    Drag,
    Feedback,
    Outcome,
    Pointer,
    Shown,
    Stage,
    register,
)
from plusedit.scene.items import Item, Markers, Polyline

APART = 2.0  # pixels between the points that are kept of a stroke
SHORTEST = 8.0  # pixels: less is a slip of the hand
CLOSES = 12.0  # pixels from the start, within which a stroke closes
TOLERANCE = 2.0  # pixels
MOST = 400  # points that a curve is fitted to

HINT = "Draw a curve by hand: it is fitted when you let go · ends near its start close it"
CLOSING_HINT = "Let go to close the curve · Esc"
DRAWING_HINT = "Let go to fit a curve to the stroke · Esc"


@register("pencil")
class Pencil:
    """Follows the hand, and fits a curve to where it went."""

    title: ClassVar[str] = "Pencil"
    shortcut: ClassVar[str] = "B"
    order: ClassVar[int] = 22

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """Collect the stroke; the curve comes when the button is let go."""
        pixels = [start.at]
        now = yield Shown(feedback=Feedback(hint=DRAWING_HINT, cursor="cross"))
        while True:
            if np.hypot(*(now.at - pixels[-1])) >= APART:
                pixels.append(now.at)
            stroke = np.array(pixels)
            closes = _closes(stroke)
            points = _on_ground(stroke, stage)
            feedback = Feedback(
                tuple(_shown(points, closes=closes)),
                CLOSING_HINT if closes else DRAWING_HINT,
                cursor="cross",
            )
            command = None
            if _length(stroke) >= SHORTEST:
                command = DrawFitted(_source(_thinned(points), stage, closes=closes))
            now = yield Shown(feedback=feedback, at_end=command)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Nothing: a curve needs a stroke."""
        return None

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """A press like any other."""
        return None

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """What a stroke would do."""
        return Feedback(hint=HINT, cursor="cross")

    def keys(self, stage: Stage) -> frozenset[str]:
        """None of its own."""
        return frozenset()

    def key(self, key: str, stage: Stage) -> Outcome:
        """Never called."""
        return None

    def reset(self) -> None:
        """Nothing is remembered between gestures."""


def _source(points: Floats, stage: Stage, *, closes: bool) -> FitSource:
    tolerance = TOLERANCE * float(stage.camera.pixel_at(points).mean())
    order = stage.new_curves.order if stage.new_curves.family == "bspline" else 4
    return FitSource(points, tolerance, closes, order)


def _shown(points: Floats, *, closes: bool) -> list[Item]:
    items: list[Item] = [Polyline(points, "hover", 2.0)]
    if closes:
        items.append(Markers(points[:1], "ring", 2.0 * CLOSES, None, "hover", 2.0))
    return items


def _on_ground(stroke: Floats, stage: Stage) -> Floats:
    """(m, dim) where the stroke is in the world."""
    like = sheet_of(stage.camera)
    return np.array([on_sheet(pixel, like, stage.camera) for pixel in stroke])


def _closes(stroke: Floats) -> bool:
    return bool(_length(stroke) > 6.0 * CLOSES and np.hypot(*(stroke[-1] - stroke[0])) <= CLOSES)


def _length(stroke: Floats) -> float:
    return float(np.hypot(*np.diff(stroke, axis=0).T).sum()) if len(stroke) > 1 else 0.0


def _thinned(points: Floats) -> Floats:
    """At most so many points as a fit needs, the first and the last among them."""
    if len(points) <= MOST:
        return points
    thinned: Floats = points[np.linspace(0, len(points) - 1, MOST).round().astype(int)]
    return thinned
