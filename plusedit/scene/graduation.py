"""Steps of grids and rulers: 1, 2 or 5 times a power of ten, as fits the zoom."""

from dataclasses import dataclass
from functools import lru_cache
from math import floor, log10

import numpy as np

from plusedit.geometry.arrays import Floats

APART = 72.0  # pixels between two numbers, at least
PARTS = {1: 5, 2: 4, 5: 5}  # minor steps in a major one, by its first digit
FADED, CLEAR = 12.0, 32.0  # pixels between minor lines where they are faintest and strongest
FAINTEST = 0.35
MOST_DIGITS = 6  # of a number on a ruler, before it is written with an exponent


@dataclass(frozen=True)
class Graduation:
    """Where major and minor lines stand."""

    major: float
    """lines with a number, that many units apart"""
    parts: int
    """minor steps in a major one"""
    strength: float
    """of the minor lines, from 0.35 where they are dense to 1"""

    @property
    def minor(self) -> float:
        """The distance of all lines; what points snap to."""
        return self.major / self.parts

    def between(self, low: float, high: float) -> tuple[Floats, Floats]:
        """Positions of the major lines, and of the minor lines between them."""
        counts = np.arange(floor(low / self.minor), floor(high / self.minor) + 2)
        is_major = counts % self.parts == 0
        # Numbers of lines are whole: multiplied, not added up, so that 0.3 is not 0.30000000004.
        lines = counts * self.major / self.parts
        return lines[is_major], lines[~is_major]

    def text(self, value: float) -> str:
        """The number beside a major line, with as many digits as the step asks for."""
        if abs(value) < self.minor / 2.0:
            return "0"
        digits = max(0, -floor(log10(self.major) + 1e-9))
        if digits > MOST_DIGITS or abs(value) >= 10.0**MOST_DIGITS:
            significant = max(0, floor(log10(abs(value)) + 1e-9) - floor(log10(self.major) + 1e-9))
            written = f"{value:.{significant}e}"
        else:
            written = f"{value:.{digits}f}"
        return written.replace("-", "\N{MINUS SIGN}")


@lru_cache(maxsize=16)
def graduation(pixel: float) -> Graduation:
    """The graduation for a view in which a pixel is that long."""
    least = APART * pixel
    power = 10.0 ** floor(log10(least))
    digit = next((d for d in (1, 2, 5) if d * power >= least * (1.0 - 1e-9)), 10)
    if digit == 10:
        digit, power = 1, power * 10.0
    spacing = digit * power / PARTS[digit] / pixel
    share = float(np.clip((spacing - FADED) / (CLEAR - FADED), 0.0, 1.0))
    return Graduation(digit * power, PARTS[digit], FAINTEST + (1.0 - FAINTEST) * share)
