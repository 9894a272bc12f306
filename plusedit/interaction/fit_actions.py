"""Actions that fit curves anew, with as few control lines as a tolerance asks for."""

import numpy as np

from plusedit.commands.base import Command, Together
from plusedit.commands.fitting import FitSource, JoinFitted, Refit, fit_source
from plusedit.document.design import EditError
from plusedit.geometry.arrays import Floats
from plusedit.geometry.chaining import chained
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.tessellate import tessellation
from plusedit.interaction.actions import EditAction
from plusedit.interaction.curve_actions import MENU, curves_of
from plusedit.interaction.places import in_space
from plusedit.interaction.tool import Outcome, Stage

COARSE = 5e-3  # of the size of a curve: the tolerance that it is fitted within at first
FINER = 0.1  # of the tolerance: how near the points that are fitted come to the curve
LOOSER, CLOSER = 2.0, 0.5
MOST = 2000  # points
GAP, WIDEST = 12.0, 0.05  # pixels, and of the size: ends of curves so near are joined


def sampled(curve: PlusCurve) -> FitSource:
    """Points of a curve to fit another one to, within a small part of its size."""
    size = float(np.ptp(curve.lines.points, axis=0).max()) or 1.0
    points: Floats = curve.sample(tessellation(curve, FINER * COARSE * size))
    if len(points) > MOST:
        points = points[np.linspace(0, len(points) - 1, MOST).round().astype(int)]
    return FitSource(points, COARSE * size, curve.closed)


def fitted(stage: Stage, factor: float) -> Outcome:
    """Fit the selected curves: with so many times the tolerance where they were fitted before.

    A curve that was not is fitted to what it looks like.
    """
    steps: list[Command] = []
    for shape_id in curves_of(stage):
        shape = stage.design[shape_id]
        known = fit_source(shape)
        if known is None:
            source = sampled(stage.design.curve(shape_id))
        else:
            source = known.within(factor * known.tolerance)
        if float(np.ptp(source.points, axis=0).max()) == 0.0:
            raise EditError(f"{shape.name} is a single point: there is nothing to fit.")
        if factor < 1.0:
            _refuse_what_no_curve_follows(shape.name, source)
        steps.append(Refit(shape_id, source))
    return steps[0] if len(steps) == 1 else Together(f"Fit {len(steps)} curves", tuple(steps))


def _refuse_what_no_curve_follows(name: str, source: FitSource) -> None:
    """EditError where the points, as those of a hand or a scan, are not smooth to the tolerance."""
    if source.fitted.largest <= source.tolerance:
        return
    raise EditError(
        f"{name}: the {len(source.points)} points that it is fitted to are not smooth to within "
        f"{source.tolerance:.3g}; it stays as it is."
    )


def joined(stage: Stage) -> Outcome:
    """Fit one curve to all selected ones, which meet end to end."""
    ids = curves_of(stage)
    if len(ids) < 2:
        raise EditError("Select two curves or more that meet end to end.")
    curves = [stage.design.curve(shape_id) for shape_id in ids]
    ends = np.concatenate([in_space(curve.at([0.0, 1.0])) for curve in curves])
    points = np.concatenate([in_space(curve.lines.points) for curve in curves])
    size = float(np.ptp(points, axis=0).max()) or 1.0
    gap = min(GAP * float(stage.camera.pixel_at(ends).max()), WIDEST * size)
    try:
        chain = chained(curves, FINER * COARSE * size, gap)
    except ValueError as error:
        raise EditError(str(error)) from error
    source = FitSource(chain.points, COARSE * size, chain.closed, corners=chain.corners)
    return JoinFitted(ids, source)


ACTIONS = (
    EditAction("fit", "Fit with few lines", (), f"{MENU}/Fit", lambda stage: fitted(stage, 1.0)),
    EditAction(
        "fit_closer", "Fit more closely", (), f"{MENU}/Fit", lambda stage: fitted(stage, CLOSER)
    ),
    EditAction(
        "fit_looser",
        "Fit more loosely",
        (),
        f"{MENU}/Fit",
        lambda stage: fitted(stage, LOOSER),
    ),
    EditAction("join_fitted", "Join into one fitted curve", ("Ctrl+J",), f"{MENU}/Fit", joined),
)
