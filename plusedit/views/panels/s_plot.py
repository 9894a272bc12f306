"""What s does to the leading curve or surface: plots with a cursor that sets s when dragged."""

from math import isfinite

import numpy as np
from PySide6.QtWidgets import QLabel

from plusedit.commands.curves import SetMagnitude
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.magnitude_profile import (
    MagnitudeProfile,
    distances_to_points,
    magnitude_profile,
)
from plusedit.geometry.natural import best_s_of
from plusedit.scene.magnitude_plots import curvature_plot, distance_plot, energy_plot, ratios
from plusedit.scene.plots import Plot
from plusedit.views.arithmetic import true_minus
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget
from plusedit.views.newest import Newest
from plusedit.views.panels import panel
from plusedit.views.plot import PlotView
from plusedit.views.plot_row import stacked_plots

EMPTY = "Select a curve or a surface to see what its s does to distance, bending and curvature."


@panel(
    "s_plot",
    title="What s does",
    area="below",
    order=12,
    menu="View",
    shortcut="Ctrl+6",
    is_shown=False,
)
class SPlot(LiveWidget):
    """Three plots over s / L; dragged, the cursor is live, and one undo step."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        names = ("distance by s", "energy by s", "curvature by s")
        self.plots = [PlotView(name, draggable=True) for name in names]
        self.numbers = QLabel()
        self._shape_id: ShapeId | None = None
        self._known: tuple[object, ...] = ()
        """what the plots were made of, or are being made of"""
        self._profile: MagnitudeProfile | None = None
        self._moved: SetMagnitude | None = None
        self._newest = Newest(self)
        self._stack = stacked_plots(self, self.plots, self.numbers, EMPTY)
        for plot in self.plots:
            plot.moved.connect(self._preview)
            plot.settled.connect(self._settle)
            plot.dropped.connect(self._drop)

    def refresh(self) -> None:
        leading = self.desk.leading
        self._stack.setCurrentIndex(int(leading is None))
        if leading is None:
            self._shape_id, self._known, self._profile = None, (), None
            return
        shape_id, geometry = leading
        if shape_id != self._shape_id:
            self._shape_id, self._profile = shape_id, None
        length = self.desk.lengths.of(shape_id, geometry)
        known = _kind(geometry), geometry.net, length
        if not self._is_known(known):
            self._known = known
            self._look(shape_id, geometry, length)
        self._show_plots(geometry, length)

    def _is_known(self, known: tuple[object, ...]) -> bool:
        return len(self._known) == 3 and (
            self._known[0] == known[0] and self._known[1] is known[1] and self._known[2] == known[2]
        )

    def _look(self, shape_id: ShapeId, geometry: PlusGeometry, length: float) -> None:
        """Have all that takes its time worked out beside; the newest alone counts."""

        def take(profile: MagnitudeProfile) -> None:
            if shape_id == self._shape_id:
                self._profile = profile
                self._soon()

        self._newest.ask(lambda: magnitude_profile(geometry, length * ratios()), take)

    def _show_plots(self, geometry: PlusGeometry, length: float) -> None:
        best_s = best_s_of(geometry)
        best = None if best_s is None or not length else best_s / length
        found: list[Plot | None] = [
            distance_plot(distances_to_points(geometry, length * ratios()), best)
        ]
        if self._profile is None:
            found += [None, None]
        else:
            is_curve = isinstance(geometry, PlusCurve)
            found.append(energy_plot(self._profile, best, is_curve=is_curve))
            found.append(curvature_plot(self._profile, best))
        for view, plot in zip(self.plots, found, strict=True):
            view.show_plot(plot, self.desk.theme)
            view.show_cursor(geometry.s / length if length else None)
        self.numbers.setText(self._told(geometry, length))

    def _told(self, geometry: PlusGeometry, length: float) -> str:
        """The numbers at the cursor."""
        ratio = geometry.s / length if length else 0.0
        distances = distances_to_points(geometry, np.array([geometry.s]))
        parts = [
            f"s {_written(geometry.s)}",
            f"s / L {ratio:.3f}",
            f"distance {_written(float(distances.mean[0]))} rms, "
            f"{_written(float(distances.largest[0]))} largest",
        ]
        if self._profile is not None and 0.0 <= ratio <= ratios()[-1]:
            bending = "energy" if isinstance(geometry, PlusCurve) else "∫ H² dA"
            for name, values in (
                (bending, self._profile.energy),
                ("curvature", self._profile.curvature),
            ):
                parts.append(f"{name} {_written(float(np.interp(ratio, ratios(), values)))}")
        # A line ends between numbers, not within what belongs together.
        return "     ".join(part.replace(" ", "\N{NO-BREAK SPACE}") for part in parts)

    # The cursor

    def _preview(self, ratio: float) -> None:
        leading = self.desk.leading
        if leading is None:
            return
        if self._moved is None:
            self.desk.gestures.cancel()
        shape_id, geometry = leading
        self._moved = SetMagnitude({shape_id: ratio * self.desk.lengths.of(shape_id, geometry)})
        self.desk.preview(self._moved)
        for plot in self.plots:
            plot.show_cursor(ratio)

    def _settle(self) -> None:
        edit, self._moved = self._moved, None
        if edit is not None:
            self.desk.commit(edit)
        self._soon()

    def _drop(self) -> None:
        self._moved = None
        self.desk.session.abort()
        self._soon()


def _kind(geometry: PlusGeometry) -> tuple[object, ...]:
    return (geometry.basis,) if isinstance(geometry, PlusCurve) else geometry.bases


def _written(value: float) -> str:
    """Four digits, or what stands for none."""
    return true_minus(f"{value:.4g}") if isfinite(value) else "–"
