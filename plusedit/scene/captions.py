"""Where captions lie in a picture, and what they are drawn as; pixels from the upper left corner.

They stand in the lower left corner, one upon the other; those for which there is no room, or which
would cover the picture or a legend, are left out. Legends have the corner on the right.
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from typing import TypeAlias

from plusedit.scene.items import Caption, Item, Legend
from plusedit.scene.legends import (
    MARGIN,
    NUMBERS,
    WORDS,
    PlacedLegend,
    Word,
    placed,
    width_of,
)

PADDING = 7.0  # around what is in the box
LINE = 15.0  # from one line of words to the next
SHARE = 0.6  # of the height of a picture: higher, nothing wide is written but the lowest caption
NARROW = 0.3  # of the width of a picture: what is no wider may stand higher
NARROWER = 0.9  # of what letters are taken to be wide: what is short may be estimated closely
BETWEEN = 6.0  # from one caption to the next
COLUMNS = 14.0  # from the words of a row to its number, at least
SAMPLE, ASIDE = 14.0, 7.0  # of a color: how long, and from there to the words
THICK = 3.0  # the line that shows a color


Box: TypeAlias = tuple[float, float, float, float]


@dataclass(frozen=True)
class PlacedCaption:
    """A caption in its place."""

    box: Box
    """left, top, width and height of the ground that it stands on"""
    samples: tuple[tuple[float, float, float, str], ...]
    """left, right and height of lines that show colors, with the color of each"""
    words: tuple[Word, ...]


def stacked(captions: Iterable[Caption], left: float = 0.0) -> tuple[Caption, ...]:
    """The captions one upon the other, by their titles, so many pixels from the left edge."""
    found, height = [], 0.0
    for caption in sorted(captions, key=lambda each: each.title):
        found.append(replace(caption, at=(left, height)))
        height += _height(caption) + BETWEEN
    return tuple(found)


def in_corners(
    words: Iterable[Legend | Caption], left: float = 0.0
) -> tuple[Legend | Caption, ...]:
    """A legend, the first of them, and all captions stacked, so many pixels from the left edge."""
    words = tuple(words)
    legends = [item for item in words if isinstance(item, Legend)]
    captions = stacked((item for item in words if isinstance(item, Caption)), left)
    return (*legends[:1], *captions)


def clear_of_legends(items: Iterable[Item], size: tuple[float, float]) -> Iterator[Item]:
    """The items without captions that would cover a legend before them in so small a picture."""
    legend = None
    for item in items:
        if isinstance(item, Legend):
            legend = placed(item, size)
        elif legend is not None and isinstance(item, Caption):
            caption = placed_caption(item, size)
            if caption is not None and _meet(caption.box, legend.box):
                continue
        yield item


def boxes_of(items: Iterable[Item], size: tuple[float, float]) -> Iterator[Box]:
    """What legends and captions among the items cover of a picture."""
    for item in clear_of_legends(items, size):
        match item:
            case Legend():
                found: PlacedLegend | PlacedCaption | None = placed(item, size)
            case Caption():
                found = placed_caption(item, size)
            case _:
                continue
        if found is not None:
            yield found.box


def _meet(one: Box, other: Box) -> bool:
    return all(
        one[axis] < other[axis] + other[axis + 2] and other[axis] < one[axis] + one[axis + 2]
        for axis in (0, 1)
    )


def placed_caption(caption: Caption, size: tuple[float, float]) -> PlacedCaption | None:
    """The caption in a picture of that width and height; None where there is no room."""
    width, height = _width(caption), _height(caption)
    left = MARGIN + caption.at[0]
    top = size[1] - MARGIN - caption.at[1] - height
    is_high = caption.at[1] > 0.0 and size[1] - top > SHARE * size[1]
    is_wide = width > NARROW * size[0]
    if (is_high and is_wide) or top < MARGIN or left + width > size[0] - MARGIN:
        return None
    first = top + PADDING + WORDS - 1.0
    words = [Word(left + PADDING, first, caption.title, "text", WORDS)] if caption.title else []
    samples = []
    x = left + PADDING + _indent(caption)
    for place, row in enumerate(caption.rows):
        base = first + LINE * (place + bool(caption.title))
        words.append(Word(x, base, row.text, "quiet", NUMBERS))
        if row.value:
            right = left + width - PADDING
            words.append(Word(right, base, row.value, "text", NUMBERS, "right"))
        if row.color:
            at = left + PADDING
            samples.append((at, at + SAMPLE, base - 0.36 * NUMBERS, row.color))
    return PlacedCaption((left, top, width, height), tuple(samples), tuple(words))


def _indent(caption: Caption) -> float:
    """What the words of rows leave free for colors."""
    return SAMPLE + ASIDE if any(row.color for row in caption.rows) else 0.0


def _width(caption: Caption) -> float:
    texts = max((NARROWER * width_of(row.text, NUMBERS) for row in caption.rows), default=0.0)
    values = max((NARROWER * width_of(row.value, NUMBERS) for row in caption.rows), default=0.0)
    inner = _indent(caption) + texts + (COLUMNS + values if values else 0.0)
    return 2.0 * PADDING + max(inner, width_of(caption.title, WORDS))


def _height(caption: Caption) -> float:
    lines = len(caption.rows) + bool(caption.title)
    return 2.0 * PADDING + WORDS + LINE * max(lines - 1, 0)
