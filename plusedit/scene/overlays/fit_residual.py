"""What a fitted curve was fitted to: the points, and how far the curve is from each."""

from collections.abc import Iterator
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.commands.fitting import fit_source
from plusedit.document.shape import Shape
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.residual import Residual, residual
from plusedit.scene.items import Caption, Item, Markers, Row, Segments
from plusedit.scene.overlays import Seen, overlay

MOST = 300  # points that are shown: so many feet are found within a frame of a drag
LOUD = "hover"

fit_residual = overlay(
    "fit_residual",
    title="Points of the fit",
    order=58,
    shortcut="Shift+J",
    group="Comparison",
)

_KNOWN: "WeakKeyDictionary[Shape, Residual]" = WeakKeyDictionary()


@fit_residual.of_curves
def points_of_fit(shape: Shape, curve: PlusCurve, seen: Seen) -> Iterator[Item]:
    """Hairs from the points to the curve, the points themselves, and the distances in words."""
    source = fit_source(shape)
    if source is None:
        return
    known = _KNOWN.get(shape)
    if known is None:
        step = max(1, -(-len(source.points) // MOST))
        known = _KNOWN[shape] = residual(curve, source.points[::step])
    yield Segments(known.points, known.feet, LOUD, 1.0)
    yield Markers(known.points, "circle", 3.5, LOUD, LOUD, 0.5)
    worst = int(known.distances.argmax())
    yield Markers(known.points[[worst]], "ring", 12.0, None, LOUD, 1.5)
    rows = (
        Row("control lines", str(len(curve.lines))),
        Row("largest distance", _written(known.largest), LOUD),
        Row("rms", _written(known.rms)),
        Row("tolerance", _written(source.tolerance)),
        Row("points looked at", f"{len(known.points):,} of {len(source.points):,}"),
    )
    yield Caption(f"Fit of {shape.name}", rows)


def _written(value: float) -> str:
    return f"{value:.3g}" if np.isfinite(value) else "–"
