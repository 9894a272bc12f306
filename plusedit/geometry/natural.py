"""The natural unit of s, and the s that serves best, of curves and surfaces alike."""

from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.magnitude import best_s, polygon_length
from plusedit.geometry.surface import PlusSurface
from plusedit.geometry.surface_magnitude import best_surface_s, natural_length


def natural_length_of(shape: PlusCurve | PlusSurface) -> float:
    """L: the length of the control polygon; of a surface the mean of those by u and by v."""
    return polygon_length(shape) if isinstance(shape, PlusCurve) else natural_length(shape)


def best_s_of(shape: PlusCurve | PlusSurface) -> float | None:
    """s*, which brings the shape closest to its control points; None if s changes nothing."""
    return best_s(shape) if isinstance(shape, PlusCurve) else best_surface_s(shape)
