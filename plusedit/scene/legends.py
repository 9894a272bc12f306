"""Where a legend lies in a picture, and what it is drawn as; pixels from the upper left corner.

It lies in the lower right corner, below the axes of the 3D view. Where a view is too low for both
it takes the lower left corner, and where it is too small for that, too, there is none.
"""

from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

from plusedit.scene.items import Legend

MARGIN = 12.0  # from the edges of the picture
PADDING = 10.0  # around what is in the box
AXES = 104.0  # high and wide: the upper right corner, where the 3D view has its axes
BAR = 14.0  # wide
LONGEST, SHORTEST = 176.0, 56.0  # of the bar
SHARE = 0.25, 0.4  # of the height and of the width of a picture: no longer in small ones
LINE = 16.0  # from one line of words to the next
TIP = 7.0  # high: the end of an open bar
TICK, GAP = 4.0, 5.0  # long, and from a tick to its number
APART = 15.0  # from one number to the next, at least
WORDS, NUMBERS = 12.0, 11.0  # heights of letters
LETTER = 0.62  # of the height of letters: as wide as they are taken to be


@dataclass(frozen=True)
class Word:
    """A short text on its base line."""

    x: float
    y: float
    text: str
    color: str
    size: float
    anchor: Literal["left", "center", "right"] = "left"


@dataclass(frozen=True)
class PlacedLegend:
    """A legend in its place."""

    box: tuple[float, float, float, float]
    """left, top, width and height of the ground that it stands on"""
    bar: tuple[float, float, float, float]
    """the same of the colors; the lowest is at the bottom"""
    colors: tuple[str, ...]
    tips: tuple[tuple[tuple[float, float], ...], ...]
    """corners of the triangles at the low end and at the high one; none where it is not open"""
    ticks: tuple[tuple[float, float, float], ...]
    """left, right and height of each"""
    words: tuple[Word, ...]


def placed(legend: Legend, size: tuple[float, float], axes: float = AXES) -> PlacedLegend | None:
    """The legend in a picture of that width and height; None where there is no room.

    The upper right corner, so many pixels high and wide, is left free.
    """
    heading = [text for text in (legend.title, legend.unit) if text]
    tips = TIP * sum(legend.is_open)
    around = 2.0 * PADDING + LINE * len(heading) + tips + NUMBERS / 2.0
    room = size[1] - 2.0 * MARGIN - around
    numbers = max((width_of(text, NUMBERS) for _, text in legend.ticks), default=0.0)
    inner = max(BAR + TICK + GAP + numbers, *(width_of(text, WORDS) for text in heading))
    width = inner + 2.0 * PADDING
    is_right = room - axes >= SHORTEST or size[0] < width + axes
    fair = max(SHORTEST, min(SHARE[0] * size[1], SHARE[1] * size[0]))
    length = min(LONGEST, fair, room - axes if is_right else room)
    if length < SHORTEST or size[0] < width + 2.0 * MARGIN:
        return None
    height = length + around
    left = size[0] - MARGIN - width if is_right else MARGIN
    top = size[1] - MARGIN - height
    bar = (
        left + PADDING,
        top + PADDING + LINE * len(heading) + NUMBERS / 2.0 + TIP * legend.is_open[1],
        BAR,
        length,
    )
    return PlacedLegend(
        box=(left, top, width, height),
        bar=bar,
        colors=legend.colors,
        tips=_tips(bar, legend.is_open),
        ticks=tuple((bar[0] + BAR, bar[0] + BAR + TICK, y) for y, _ in _marks(legend, bar)),
        words=(*_heading(heading, bar[0], top), *_numbers(legend, bar)),
    )


def _heading(heading: list[str], x: float, top: float) -> list[Word]:
    colors = ("text", "quiet")
    base = top + PADDING + WORDS - 2.0
    return [
        Word(x, base + LINE * line, text, colors[line], WORDS) for line, text in enumerate(heading)
    ]


def _numbers(legend: Legend, bar: tuple[float, float, float, float]) -> list[Word]:
    x = bar[0] + BAR + TICK + GAP
    return [Word(x, y + 0.36 * NUMBERS, text, "text", NUMBERS) for y, text in _marks(legend, bar)]


def _marks(legend: Legend, bar: tuple[float, float, float, float]) -> list[tuple[float, str]]:
    """Heights of the ticks with their numbers: every one, or as many as have room."""
    _, top, _, length = bar
    every = 1
    while len(legend.ticks) > 1 and every < len(legend.ticks):
        shares = [share for share, _ in legend.ticks[::every]]
        if min(b - a for a, b in pairwise(shares)) * length >= APART:
            break
        every += 1
    return [(top + (1.0 - share) * length, text) for share, text in legend.ticks[::every]]


def _tips(
    bar: tuple[float, float, float, float], is_open: tuple[bool, bool]
) -> tuple[tuple[tuple[float, float], ...], ...]:
    left, top, width, length = bar
    right, middle, bottom = left + width, left + width / 2.0, top + length
    low = ((left, bottom), (right, bottom), (middle, bottom + TIP)) if is_open[0] else ()
    high = ((left, top), (right, top), (middle, top - TIP)) if is_open[1] else ()
    return low, high


def width_of(text: str, size: float) -> float:
    """How wide a text is taken to be, in letters that high."""
    return LETTER * size * len(text)
