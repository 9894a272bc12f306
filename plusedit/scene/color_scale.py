"""Scales of colors for maps: even to the eye, and told apart by those who are color-blind.

A scale is a way through OKLab, the color space of Ottosson (2020) in which equal distances look
alike: between given colors the way is straight, and it is cut into steps of equal length. Along the
sequential scale lightness rises all the way, so that it can be read without any hue; the diverging
one runs from blue over white to orange, which all kinds of color-blindness keep apart.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.scene.graduation import APART, graduation

Kind: TypeAlias = Literal["sequential", "diverging"]
Colors: TypeAlias = NDArray[np.float32]
"""(n, 3) or (m_u, m_v, 3) red, green and blue, 0 to 1, as they stand in files"""

STEPS = 512  # of a scale; more than the eye, or eight bits, can tell apart
MOST_TICKS = 7
UNKNOWN = (0.56, 0.56, 0.58)  # where a value is not a number

# Ottosson, "A perceptual color space for image processing".
_TO_CONES = np.array(
    [
        [0.4122214708, 0.5363325363, 0.0514459929],
        [0.2119034982, 0.6806995451, 0.1073969566],
        [0.0883024619, 0.2817188376, 0.6299787005],
    ]
)
_TO_LAB = np.array(
    [
        [0.2104542553, 0.7936177850, -0.0040720468],
        [1.9779984951, -2.4285922050, 0.4505937099],
        [0.0259040371, 0.7827717662, -0.8086757660],
    ]
)


@dataclass(frozen=True)
class Span:
    """The values from one end of a scale to the other."""

    low: float
    high: float

    def shares(self, values: Floats) -> Floats:
        """How far along the scale values lie: 0 at its low end, 1 at its high end."""
        found: Floats = (values - self.low) / (self.high - self.low)
        return found

    def ticks(self, most: int = MOST_TICKS) -> tuple[tuple[float, str], ...]:
        """Round values within the span, at most so many, each with how it is written."""
        marks = graduation((self.high - self.low) / (most - 1) / APART)
        slack = 1e-9 * (self.high - self.low)
        lines = marks.between(self.low, self.high)[0]
        within = lines[(lines >= self.low - slack) & (lines <= self.high + slack)]
        return tuple((float(value), marks.text(float(value))) for value in within)


@dataclass(frozen=True)
class ColorScale:
    """Colors from low values to high ones."""

    colors: tuple[str, ...]
    """"#rrggbb" that it runs through"""
    is_diverging: bool = False
    """whether the middle one of the colors stands for the middle of the values"""

    def at(self, shares: Floats) -> Colors:
        """Red, green and blue for shares of the way, (...) to (..., 3).

        Below 0 and above 1 the colors of the ends; gray where a share is not a number.
        """
        is_known = ~np.isnan(shares)
        places = np.where(is_known, np.clip(shares, 0.0, 1.0), 0.0) * STEPS
        found: Colors = self._table[np.rint(places).astype(np.intp)]
        found[~is_known] = UNKNOWN
        return found

    def hexadecimal(self, count: int) -> tuple[str, ...]:
        """ "#rrggbb" of `count` colors, evenly from one end to the other."""
        rows = np.rint(255.0 * self.at(np.linspace(0.0, 1.0, count))).astype(int)
        return tuple("#" + "".join(f"{part:02X}" for part in row) for row in rows)

    @cached_property
    def _table(self) -> Colors:
        stations = oklab_of(np.array([_channels(color) for color in self.colors]))
        if not self.is_diverging:
            return rgb_of(_evenly(stations, STEPS)).astype(np.float32)
        middle = len(stations) // 2
        lower, upper = stations[: middle + 1], stations[middle:]
        halves = _evenly(lower, STEPS // 2), _evenly(upper, STEPS // 2)[1:]
        return rgb_of(np.concatenate(halves)).astype(np.float32)


def oklab_of(rgb: Floats) -> Floats:
    """(n, 3) lightness and two hues of colors (n, 3)."""
    linear = np.where(rgb <= 0.04045, rgb / 12.92, ((rgb + 0.055) / 1.055) ** 2.4)
    found: Floats = np.cbrt(linear @ _TO_CONES.T) @ _TO_LAB.T
    return found


def rgb_of(oklab: Floats) -> Floats:
    """(n, 3) red, green and blue, the nearest that there are."""
    cones = (oklab @ np.linalg.inv(_TO_LAB).T) ** 3
    linear = np.clip(cones @ np.linalg.inv(_TO_CONES).T, 0.0, 1.0)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1.0 / 2.4) - 0.055)


def _evenly(stations: Floats, steps: int) -> Floats:
    """(steps + 1, 3) places on the way through stations, as far from one to the next."""
    lengths = np.linalg.norm(np.diff(stations, axis=0), axis=1)
    passed = np.append(0.0, np.cumsum(lengths))
    wanted = np.linspace(0.0, passed[-1], steps + 1)
    return np.stack([np.interp(wanted, passed, column) for column in stations.T], axis=1)


def _channels(color: str) -> Sequence[float]:
    return [int(color[i : i + 2], 16) / 255.0 for i in (1, 3, 5)]


SCALES: dict[Kind, ColorScale] = {
    "sequential": ColorScale(("#3F3C8E", "#2F6AA6", "#1F9396", "#5DBA72", "#B5D65A", "#F7E874")),
    "diverging": ColorScale(
        ("#1D4F91", "#5B93CB", "#F2F1EE", "#DE8F45", "#8E3B06"), is_diverging=True
    ),
}
