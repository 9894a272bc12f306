"""How a shape changes with s, as plots over s / L: distance to its points, bending, curvature."""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.magnitude_profile import Distances, MagnitudeProfile
from plusedit.scene.plots import Axis, Plot, PlotLine, PlotMark, axis_for

REACH = 2.0  # of s / L
COUNT = 65  # values of s
X, NAME = Axis(0.0, REACH), "s / L"
MEAN, LARGEST = "accent", "#D2691E"


def ratios() -> Floats:
    """(k,) the values of s / L that are looked at."""
    return np.linspace(0.0, REACH, COUNT)


def distance_plot(distances: Distances, best: float | None) -> Plot:
    """The distances of the shape at its nodes from the control points; s* / L is marked."""
    x = ratios()
    lines = (
        PlotLine(x, distances.largest, LARGEST, dash="dash", name="largest"),
        PlotLine(x, distances.mean, MEAN, name="rms"),
    )
    y = axis_for(distances.mean, distances.largest, from_zero=True)
    return Plot("Distance to points", X, y, lines, _marks(best), "units", NAME)


def energy_plot(profile: MagnitudeProfile, best: float | None, *, is_curve: bool) -> Plot:
    """The bending energy of a curve; of a surface the integral of its squared mean curvature."""
    title, unit = ("Bending energy", "1 / unit") if is_curve else ("∫ H² dA", "")
    return _plot(title, unit, profile.energy, best)


def curvature_plot(profile: MagnitudeProfile, best: float | None) -> Plot:
    """The largest curvature."""
    return _plot("Largest curvature", "1 / unit", profile.curvature, best)


def _plot(title: str, unit: str, values: Floats, best: float | None) -> Plot:
    y = axis_for(values, from_zero=True, even=False)
    return Plot(title, X, y, (PlotLine(ratios(), values, MEAN),), _marks(best), unit, NAME)


def _marks(best: float | None) -> tuple[PlotMark, ...]:
    if best is None or not 0.0 <= best <= REACH:
        return ()
    return (PlotMark(best, "plus", "s*", dash="dash"),)
