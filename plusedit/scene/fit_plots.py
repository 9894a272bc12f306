"""How near families of shapes come to the same points, plotted over what they are made of."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Literal, TypeAlias

import numpy as np

from plusedit.geometry.comparison import KINDS, Fit, Kind, is_plus
from plusedit.scene.items import Dash
from plusedit.scene.plots import Axis, Plot, PlotLine, axis_for

Measure: TypeAlias = Literal["rms", "largest"]
Count: TypeAlias = Literal["elements", "numbers"]

KIND_TITLES: Mapping[Kind, str] = MappingProxyType(
    {"bezier": "Bézier", "bezier+": "Bézier+", "bspline": "B-spline", "bspline+": "B-spline+"}
)
MEASURES: Mapping[Measure, str] = MappingProxyType(
    {"rms": "rms distance", "largest": "largest distance"}
)
COUNTS: Mapping[Count, str] = MappingProxyType(
    {"elements": "control elements", "numbers": "numbers stored"}
)
COLORS: Mapping[Kind, str] = MappingProxyType(
    {"bezier": "u", "bezier+": "u", "bspline": "accent", "bspline+": "accent"}
)
DASHES: Mapping[bool, Dash] = MappingProxyType({False: "dash", True: "solid"})
"""By whether the control elements are lines: classical families are dashed."""
LEAST = 1e-12  # of the largest distance: less is drawn as that much


def fit_plot(fits: Iterable[Fit], count: Count, measure: Measure) -> Plot:
    """Distances over how many control elements there are, or over how many numbers are stored."""
    found = list(fits)
    tops = [float(getattr(fit, measure)) for fit in found]
    least = LEAST * (max(tops, default=1.0) or 1.0)
    lines = []
    for kind in KINDS:
        row = sorted((fit for fit in found if fit.kind == kind), key=lambda fit: fit.elements)
        if row:
            x = np.array([getattr(fit, count) for fit in row], dtype=np.float64)
            y = np.array([max(getattr(fit, measure), least) for fit in row])
            dash = DASHES[is_plus(kind)]
            lines.append(PlotLine(x, y, COLORS[kind], dash=dash))
    title = f"{MEASURES[measure].capitalize()} over {COUNTS[count]}"
    if not lines:
        return Plot(title, Axis(0.0, 1.0), Axis(1e-3, 1.0, is_logarithmic=True))
    across = axis_for(*(line.x for line in lines))
    upwards = axis_for(*(line.y for line in lines), even=False)
    return Plot(title, across, upwards, tuple(lines), unit="units")


def nearest_fits(fits: Iterable[Fit], count: Count, wanted: float) -> dict[Kind, Fit]:
    """Of each family the fit with the count nearest to that; the lower one where two are."""
    found: dict[Kind, Fit] = {}
    for fit in sorted(fits, key=lambda fit: fit.elements):
        before = found.get(fit.kind)
        away = abs(getattr(fit, count) - wanted)
        if before is None or away < abs(getattr(before, count) - wanted):
            found[fit.kind] = fit
    return {kind: found[kind] for kind in KINDS if kind in found}
