"""Bringing points to the grid and to an axis, and angles to round ones."""

from math import ceil, log10, pi

import numpy as np

from plusedit.geometry.arrays import Floats

ROUND_ANGLE = pi / 12.0  # 15 degrees

PEN_ANGLE = pi / 4.0  # from point to point with Shift held

AXES = ("x", "y", "z")


def to_grid(values: Floats, step: float) -> Floats:
    """The nearest multiples of `step`, as short decimals where the step is 1, 0.5, 0.1, ..."""
    if step < 1.0:
        parts = round(1.0 / step)
        if abs(parts * step - 1.0) < 1e-9:
            # 3 / 10 is the number that 0.3 stands for; 3 * 0.1 is not.
            snapped: Floats = np.round(values * parts) / parts
            return snapped + 0.0
    multiples: Floats = np.round(values / step) * step
    return multiples + 0.0


def to_step(value: float, step: float) -> float:
    """The nearest multiple of `step`."""
    return round(value / step) * step


def along_axis(vector: Floats, axes: str | None) -> Floats:
    """What the vector has along "x", "y" or "z", or two of them, as "xy"; all of it for None."""
    if axes is None:
        return vector
    kept = [name in axes for name in AXES[: len(vector)]]
    return np.where(kept, vector, 0.0)


def along_longer(vector: Floats) -> Floats:
    """The vector's largest component alone."""
    result = np.zeros_like(vector)
    index = int(np.abs(vector).argmax())
    result[index] = vector[index]
    return result


def decimals(pixel: float) -> int:
    """How many decimals tell neighboring pixels apart."""
    return int(np.clip(ceil(-log10(pixel)), 0, 9))
