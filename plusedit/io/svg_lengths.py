"""Lengths, transforms and view boxes of SVG."""

import re
from dataclasses import dataclass
from math import isfinite

import numpy as np
from svgelements import Matrix

from plusedit.geometry.arrays import Floats
from plusedit.io.svg_paths import numbers_of

LENGTH = re.compile(r"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([a-zA-Z]*|%)\Z")
PIXELS = {
    "": 1.0,
    "px": 1.0,
    "pt": 96.0 / 72.0,
    "pc": 16.0,
    "in": 96.0,
    "cm": 96.0 / 2.54,
    "mm": 9.6 / 2.54,
    "q": 2.4 / 2.54,
    # Without fonts: those of a letter 16 pixels high.
    "em": 16.0,
    "rem": 16.0,
    "ex": 8.0,
    "ch": 8.0,
}
LONGEST_TRANSFORM = 10_000  # characters; the expressions that take it apart are not linear
IDENTITY: Floats = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])


def length(text: str, whole: float, default: float = 0.0) -> float:
    """A length in user units; `whole` is what 100 % means. `default` where it is none."""
    found = LENGTH.match(text)
    if found is None:
        return default
    value, unit = float(found.group(1)), found.group(2).lower()
    factor = whole / 100.0 if unit == "%" else PIXELS.get(unit, 0.0)
    value *= factor
    return value if isfinite(value) and factor else default


def joined(outer: Floats, inner: Floats) -> Floats:
    """The map (2, 3) that does `inner`, then `outer`."""
    together: Floats = np.column_stack([outer[:, :2] @ inner[:, :2], outer[:, :2] @ inner[:, 2]])
    together[:, 2] += outer[:, 2]
    return together


def shift(x: float, y: float) -> Floats:
    """The map (2, 3) that moves by (x, y)."""
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y]])


def transform(text: str) -> Floats:
    """The map (2, 3) of an attribute `transform`. ValueError where it is none."""
    if not text:
        return IDENTITY
    if len(text) > LONGEST_TRANSFORM:
        raise ValueError("a transform is too long")
    try:
        m = Matrix(text)
        m.render(ppi=96.0, width=0.0, height=0.0)
        entries = np.array([[m.a, m.c, m.e], [m.b, m.d, m.f]], dtype=np.float64)
    except Exception as error:  # the parser ends bad input with whatever error comes along
        raise ValueError(f"a transform is not readable: {text[:40]!r}") from error
    if not np.isfinite(entries).all():
        raise ValueError(f"a transform is not finite: {text[:40]!r}")
    return entries


@dataclass(frozen=True)
class ViewBox:
    """The rectangle of user units that fills a viewport."""

    x: float
    y: float
    width: float
    height: float

    @classmethod
    def of(cls, text: str) -> "ViewBox | None":
        """The view box of the attribute, None where it is none or empty."""
        numbers = numbers_of(text)
        if len(numbers) != 4 or numbers[2] <= 0.0 or numbers[3] <= 0.0:
            return None
        return cls(*numbers)

    def fitted(self, width: float, height: float, aspect: str) -> Floats:
        """The map (2, 3) to a viewport of that size, as `preserveAspectRatio` asks."""
        across, up = width / self.width, height / self.height
        if aspect.startswith("none"):
            return np.array([[across, 0.0, -self.x * across], [0.0, up, -self.y * up]])
        scale = max(across, up) if aspect.endswith("slice") else min(across, up)
        free_x, free_y = width - self.width * scale, height - self.height * scale
        left = 0.0 if "xMin" in aspect else free_x if "xMax" in aspect else free_x / 2.0
        top = 0.0 if "YMin" in aspect else free_y if "YMax" in aspect else free_y / 2.0
        return np.array([[scale, 0.0, left - self.x * scale], [0.0, scale, top - self.y * scale]])


def scale_of(matrix: Floats) -> float:
    """By what a map stretches lengths on average: the root of its determinant."""
    (a, c), (b, d) = matrix[:, :2].tolist()
    return float(abs(a * d - b * c) ** 0.5)
