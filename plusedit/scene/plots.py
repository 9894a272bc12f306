"""Plots of functions as data: lines, marks, axes with round numbers. Nothing here draws."""

from collections.abc import Iterator
from dataclasses import dataclass
from math import ceil, floor, log10

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.graduation import APART, graduation
from plusedit.scene.items import Dash

ACROSS, UPWARDS = 40.0, 24.0  # pixels, at least, from one number of an axis to the next
HEADROOM = 0.06  # of what is shown, left free above and below
UNEVEN = 30.0  # ratio of values from which on their logarithms are shown
DASHES: dict[Dash, str] = {"solid": "solid line", "dash": "dashed line", "dot": "dotted line"}


@dataclass(frozen=True, eq=False)
class PlotLine:
    """A line of a plot; where a value is not finite there is a gap."""

    x: Floats
    """(m,) rising"""
    y: Floats
    """(m,)"""
    color: str
    width: float = 1.75
    dash: Dash = "solid"
    name: str = ""
    """for the legend; a line without one is not in it"""


@dataclass(frozen=True)
class PlotMark:
    """A place on the axis of x: a line across the plot, or a tick at its foot."""

    x: float
    color: str
    text: str = ""
    is_tick: bool = False
    dash: Dash = "solid"


@dataclass(frozen=True)
class Axis:
    """What an axis runs over, and how."""

    low: float
    high: float
    is_logarithmic: bool = False

    def share(self, value: float) -> float:
        """How far along the axis a value lies: 0 at its low end, 1 at its high one."""
        return float(self.shares(np.array([value]))[0])

    def shares(self, values: Floats) -> Floats:
        """The same for many; nan for what a logarithmic axis does not have."""
        with np.errstate(all="ignore"):
            if self.is_logarithmic:
                low, high = log10(self.low), log10(self.high)
                found: Floats = (np.log10(values) - low) / (high - low)
            else:
                found = (values - self.low) / (self.high - self.low)
        return np.where(np.isfinite(found), found, np.nan)

    def value(self, share: float) -> float:
        """The value that lies so far along."""
        if self.is_logarithmic:
            return float(self.low * (self.high / self.low) ** share)
        return self.low + share * (self.high - self.low)

    def ticks(self, length: float, apart: float = ACROSS) -> tuple[tuple[float, str], ...]:
        """Round values and how they are written, for an axis of that many pixels."""
        if length <= 0.0:
            return ()
        if self.is_logarithmic:
            return tuple(self._powers(length, apart))
        marks = graduation((self.high - self.low) / length * apart / APART)
        slack = 1e-9 * (self.high - self.low)
        lines = marks.between(self.low, self.high)[0]
        within = lines[(lines >= self.low - slack) & (lines <= self.high + slack)]
        return tuple((float(value), marks.text(float(value))) for value in within)

    def _powers(self, length: float, apart: float) -> Iterator[tuple[float, str]]:
        decades = log10(self.high / self.low)
        digits = (1, 2, 5) if decades * apart * 3.0 <= length else (1,)
        every = max(1, ceil(decades * apart / length))
        for power in range(floor(log10(self.low)), ceil(log10(self.high)) + 1):
            for digit in digits if power % every == 0 else ():
                value = digit * 10.0**power
                if self.low * (1.0 - 1e-9) <= value <= self.high * (1.0 + 1e-9):
                    yield value, written(value)


@dataclass(frozen=True, eq=False)
class Plot:
    """All that a plot shows but its cursor."""

    title: str
    x: Axis
    y: Axis
    lines: tuple[PlotLine, ...] = ()
    """the first one farthest back"""
    marks: tuple[PlotMark, ...] = ()
    unit: str = ""
    """of y; empty where there is none"""
    x_name: str = ""
    inside: tuple[float, float] | None = None
    """where x means something by itself; what lies outside repeats it, and is dimmed"""

    @property
    def words(self) -> str:
        """What it shows, for where the title or the legend find no room."""
        lines = (f"{line.name}: {DASHES[line.dash]}" for line in self.lines if line.name)
        return "\n".join([", ".join(filter(None, (self.title, self.unit))), *lines])


def axis_for(*rows: Floats, from_zero: bool = False, even: bool = True) -> Axis:
    """An axis on which all finite values of rows have room.

    `from_zero`: zero is on it. Unless `even`, one with logarithms where values are positive and
    differ much.
    """
    values = np.concatenate([row[np.isfinite(row)] for row in rows])
    if not len(values):
        return Axis(0.0, 1.0)
    low, high = float(values.min()), float(values.max())
    if not even and low > 0.0 and high > UNEVEN * low:
        room = (high / low) ** HEADROOM
        return Axis(low / room, high * room, is_logarithmic=True)
    if from_zero:
        low, high = min(low, 0.0), max(high, 0.0)
    if from_zero and low == high:
        return Axis(0.0, 1.0)
    if high - low <= 1e-12 * max(abs(low), abs(high), 1e-300):
        low, high = low - (abs(low) or 1.0) / 2.0, high + (abs(high) or 1.0) / 2.0
    room = HEADROOM * (high - low)
    return Axis(low if from_zero and low == 0.0 else low - room, high + room)


def written(value: float) -> str:
    """A round number, short: 0.02, 5, 2000, 1e5."""
    if value == 0.0:
        return "0"
    power = floor(log10(abs(value)) + 1e-9)
    if -3 <= power <= 3:
        return f"{value:.{max(0, -power)}f}".replace("-", "\N{MINUS SIGN}")
    return f"{value / 10.0**power:.3g}e{power}".replace("-", "\N{MINUS SIGN}")
