"""Numbers of curves in words."""

from math import isfinite

from plusedit.geometry.curve_numbers import CurveNumbers

DIGITS = 6


def length_text(known: CurveNumbers) -> str:
    """Such as "3.14159 units"."""
    return f"{known.length:.{DIGITS}g} units"


def energy_text(known: CurveNumbers) -> str:
    """Such as "6.28319 / unit"."""
    return f"{known.energy:.{DIGITS}g} / unit" if isfinite(known.energy) else "∞ (cusp)"


def inflections_text(known: CurveNumbers) -> str:
    """Such as "2 of at most 4"; empty of curves in space."""
    if known.inflections is None:
        return ""
    return str(known.inflections) + ("" if known.most is None else f" of at most {known.most}")
