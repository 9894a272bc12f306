"""The blending functions of the leading curve or surface, with a cursor tied to the drawing."""

from collections.abc import Callable, Sequence

import numpy as np
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QLabel

from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.blending_functions import curve_functions, row_functions
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import WAYS
from plusedit.interaction.spotting import Spot, spot_under
from plusedit.interaction.tool import Pointer, Stage
from plusedit.scene.blending_plots import FunctionPlots, curve_plots, surface_plots
from plusedit.views.arithmetic import true_minus
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget
from plusedit.views.panels import panel
from plusedit.views.plot import PlotView
from plusedit.views.plot_row import stacked_plots

EMPTY = (
    "Select a curve or a surface to see the functions that blend its control lines, and some of "
    "its lines to see theirs in color."
)
MIDDLE = (0.5, 0.5)
NAMED = 3  # lines whose numbers are written


@panel(
    "blending",
    title="Blending functions",
    area="below",
    order=11,
    menu="View",
    shortcut="Ctrl+5",
    is_shown=False,
)
class Blending(LiveWidget):
    """Two plots of a curve's functions, four of a surface's."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        names = ("functions of u", "reaches of u", "functions of v", "reaches of v")
        self.plots = [PlotView(name) for name in names]
        self.numbers = QLabel()
        self._shape_id: ShapeId | None = None
        self._place: tuple[float, float] = MIDDLE
        """u and v that are told of"""
        self._is_pointed = False
        self._made: tuple[object, ...] = ()
        """what the plots were made of"""
        self._shown: tuple[FunctionPlots, ...] = ()
        self._deaf: Callable[[], object] = _nothing
        self._stack = stacked_plots(self, self.plots, self.numbers, EMPTY)
        for number, plot in enumerate(self.plots):
            plot.pointed.connect(lambda x, way=number // 2: self._point(way, x))

    def refresh(self) -> None:
        leading = self.desk.leading
        self._stack.setCurrentIndex(int(leading is None))
        self._shape_id = None if leading is None else leading[0]
        if leading is None:
            self._shown, self._made = (), ()
        else:
            self._show_functions(leading[1], self._lines())
        for number, plot in enumerate(self.plots):
            way, is_reach = divmod(number, 2)
            plots = self._shown[way] if way < len(self._shown) else None
            plot.setVisible(plots is not None)
            if plots is not None:
                plot.show_plot(plots.reaches if is_reach else plots.values, self.desk.theme)
        self._show_place()

    def showEvent(self, event: QShowEvent) -> None:
        self._deaf = self.desk.pointer_moved.listen(self._follow)
        super().showEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self._deaf()
        self._deaf = _nothing
        self.desk.marked.emit(None)
        super().hideEvent(event)

    def _lines(self) -> tuple[int, ...]:
        if self._shape_id is None:
            return ()
        return self.desk.session.selection.by_shape().get(self._shape_id, ())

    def _show_functions(self, geometry: PlusGeometry, lines: tuple[int, ...]) -> None:
        """Work functions out anew where they are others; moving points leaves them as they are."""
        if isinstance(geometry, PlusCurve):
            made: tuple[object, ...] = geometry.basis, _bytes(geometry.lines.weights), lines
        else:
            weights = geometry.planes.weights
            made = *geometry.bases, _bytes(weights), lines, weights is None or self._place
        if made != self._made:
            self._made = made
            if isinstance(geometry, PlusCurve):
                self._shown = curve_plots(geometry, lines)
            else:
                self._shown = surface_plots(geometry, lines, self._place)

    # The cursor

    def _follow(self, at: Pointer | None, stage: Stage) -> None:
        """The pointer is there in a view."""
        spot = None
        if at is not None and self._shape_id is not None:
            spot = spot_under(at.at, stage, self._shape_id)
        self._is_pointed = spot is not None
        if spot is not None:
            self._move(spot.place)
        self._show_place()

    def _point(self, way: int, x: float | None) -> None:
        """The pointer is there in a plot by u or by v, or has left it."""
        self._is_pointed = x is not None
        if x is not None and self._shape_id is not None:
            x = x % 1.0 if x not in (0.0, 1.0) else x
            place = list(self._place)
            place[way] = x
            is_curve = len(self._shown) == 1
            self._move(tuple(place[:1] if is_curve else place))
            self.desk.marked.emit(Spot(self._shape_id, tuple(place[:1] if is_curve else place)))
        else:
            self.desk.marked.emit(None)
        self._show_place()

    def _move(self, place: Sequence[float]) -> None:
        self._place = (place[0], place[1] if len(place) > 1 else self._place[1])
        leading = self.desk.leading
        if leading is not None and not isinstance(leading[1], PlusCurve):
            weights = leading[1].planes.weights
            if weights is not None:
                self.refresh()

    def _show_place(self) -> None:
        for number, plot in enumerate(self.plots):
            plot.show_cursor(self._place[number // 2] if self._is_pointed else None)
        self.numbers.setText(self._told())

    def _told(self) -> str:
        """The numbers at the cursor; without one what can be done here."""
        leading = self.desk.leading
        if not self._is_pointed or leading is None:
            return "Point at the shape or at a plot: the same place is marked in both."
        geometry, parts = leading[1], []
        for number, plots in enumerate(self._shown):
            at = np.array([self._place[number]])
            if isinstance(geometry, PlusCurve):
                found = curve_functions(geometry, at)
            else:
                found = row_functions(geometry, WAYS[number], at, self._place[1 - number])
            parts.append(f"{plots.way} {at[0]:.4f}")
            parts += [
                f"{i + 1}: {found.values[0, i]:.4f}, {found.reaches[0, i]:.4f}"
                for i in plots.chosen[:NAMED]
            ]
        return true_minus("     ".join(parts))


def _nothing() -> None:
    """Nobody listens."""


def _bytes(weights: Floats | None) -> bytes | None:
    return None if weights is None else weights.tobytes()
