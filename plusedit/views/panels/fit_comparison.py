"""Which family comes nearest to the same points: distance over what the shapes are made of."""

from collections.abc import Callable, Iterator
from functools import partial
from html import escape

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QMenu,
    QPushButton,
    QStackedLayout,
    QVBoxLayout,
    QWidget,
)

from plusedit.commands.naming import free_name
from plusedit.commands.shapes import AddShapes
from plusedit.document.shape import Geometry, Shape
from plusedit.geometry.comparison import KINDS, Check, Fit, Kind, curve_fits, is_plus
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.references import REFERENCES, Reference, sampled
from plusedit.geometry.surface_comparison import SampledSurface, surface_fits
from plusedit.scene.fit_plots import (
    COLORS,
    COUNTS,
    KIND_TITLES,
    MEASURES,
    Count,
    Measure,
    fit_plot,
    nearest_fits,
)
from plusedit.scene.theme import Theme
from plusedit.views.basis_form import row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import Choice
from plusedit.views.fit_run import FitRun
from plusedit.views.live import LiveWidget, quiet
from plusedit.views.look import tabular
from plusedit.views.panels import panel
from plusedit.views.plot import PlotView

SELECTED = "selected"
SIZES_OF_CURVES = (4, 5, 6, 7, 8, 10, 12, 14, 16, 20, 24)
SIZES_OF_SURFACES = (3, 4, 5, 6, 7, 8, 10, 12, 14)  # each way
ORDERS = {"3": "3 (quadratic)", "4": "4 (cubic)", "5": "5", "6": "6"}
HEADS = ("elements", "numbers", "distance")
WIDTH = 296  # pixels of what stands beside the plots: no number is cut
HINT = (
    "Curves and surfaces of four families, fitted to the same points by least squares. A control "
    "line takes twice the numbers of a point, a control plane three times: the plot on the right "
    "counts these."
)
NOTHING = "Select a curve or a surface first, or choose points from the list."


@panel(
    "fit_comparison",
    title="Fit comparison",
    area="below",
    order=13,
    menu="View",
    shortcut="Ctrl+7",
    is_shown=False,
    least_width=600,
)
class FitComparison(LiveWidget):
    """Two plots of the distance left, over control elements and over numbers stored."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.run = FitRun(self)
        self.run.changed.listen(self.refresh)
        self._source, self._order = SELECTED, 4
        self._measure: Measure = "rms"
        self._cursor: tuple[Count, float] | None = None
        self.plots: dict[Count, PlotView] = {}
        for count, title in COUNTS.items():
            plot = PlotView(f"distance over {title}", draggable=True)
            plot.moved.connect(partial(self._point, count))
            self.plots[count] = plot
        self.start, self.add = QPushButton("Compare"), QPushButton("Add")
        self.start.clicked.connect(self._toggle)
        self.add.setToolTip("Put one of the fits at the cursor into the design")
        self.add.setMenu(QMenu(self.add))
        self.add.menu().aboutToShow.connect(self._fill_menu)
        self.numbers = QLabel()
        self.numbers.setWordWrap(True)
        self.numbers.setTextFormat(Qt.TextFormat.RichText)
        self.numbers.setFont(tabular(self.numbers.font()))
        self._stack = QStackedLayout()
        self._lay_out()

    def refresh(self) -> None:
        fits = self.run.fits
        self._stack.setCurrentIndex(int(bool(fits)))
        for count, plot in self.plots.items():
            plot.show_plot(fit_plot(fits, count, self._measure), self.desk.theme)
            is_here = self._cursor is not None and self._cursor[0] == count
            plot.show_cursor(self._cursor[1] if is_here and self._cursor and fits else None)
        percent = f"Cancel ({self.run.share:.0%})"
        self.start.setText(percent if self.run.is_running else "Compare")
        self.add.setEnabled(bool(fits))
        self.numbers.setText(self._told())

    def compare(self) -> str:
        """Begin to fit; why that can't be, or an empty text."""
        chosen = self._chosen()
        if self._source != SELECTED:
            points = REFERENCES[self._source]()
            is_surface = isinstance(points, SampledSurface)
            make: Callable[[], Reference] = lambda: points  # noqa: E731
        elif chosen is None:
            self.desk.say(NOTHING)
            return NOTHING
        else:
            is_surface, make = not isinstance(chosen, PlusCurve), partial(sampled, chosen)
        sizes = SIZES_OF_SURFACES if is_surface else SIZES_OF_CURVES
        self._cursor = None
        self.run.begin(partial(_fits, make, sizes, self._order), len(KINDS) * len(sizes))
        return ""

    def _chosen(self) -> Geometry | None:
        """The first of the selected shapes, or the only one there is."""
        design, selection = self.desk.session.design, self.desk.session.selection
        found = [i for i in design if i in selection.shapes] or (list(design) * (len(design) == 1))
        return design[found[0]].geometry if found else None

    def _toggle(self) -> None:
        if self.run.is_running:
            self.run.cancel()
        else:
            self.compare()

    def _point(self, count: Count, x: float) -> None:
        self._cursor = count, x
        self.refresh()

    def _nearest(self) -> dict[Kind, Fit]:
        """What the numbers tell of: the fits at the cursor, or those made last."""
        count, x = self._cursor or ("elements", np.inf)
        return nearest_fits(self.run.fits, count, min(x, 1e9))

    def _told(self) -> str:
        """The legend of the plots, with the numbers at the cursor; or why there are none."""
        if self.run.problem:
            return escape(self.run.problem)
        found = self._nearest().values()
        rows = [(*_sample(fit.kind, self.desk.theme), fit) for fit in found]
        body = "".join(
            f"<tr><td style='color:{color}'>{dash}</td>"
            f"<td style='white-space:nowrap'>{KIND_TITLES[fit.kind]}</td>"
            f"<td align=right>{fit.elements}</td><td align=right>{fit.numbers}</td>"
            f"<td align=right>{getattr(fit, self._measure):.2g}</td></tr>"
            for color, dash, fit in rows
        )
        quiet_color = self.desk.theme.color("quiet")
        heads = "".join(f"<td align=right>{words}</td>" for words in HEADS)
        head = f"<tr style='color:{quiet_color}'><td></td><td></td>{heads}</tr>"
        return f"<table cellspacing=0 cellpadding=2 width=100%>{head}{body}</table>" if body else ""

    def _fill_menu(self) -> None:
        menu = self.add.menu()
        menu.clear()
        for kind, fit in self._nearest().items():
            words = f"{KIND_TITLES[kind]} of {fit.elements}: {getattr(fit, self._measure):.3g}"
            menu.addAction(words).triggered.connect(partial(self._add, fit))

    def _add(self, fit: Fit, _: bool = False) -> None:
        design = self.desk.session.design
        name = free_name(design, f"{KIND_TITLES[fit.kind]} of {fit.elements} elements")
        self.desk.commit(AddShapes(((design.unused_id("fit"), Shape(fit.shape, name)),), "Add fit"))

    def _choose_source(self, name: str) -> str:
        self._source = name
        return ""

    def _choose_order(self, order: str) -> str:
        self._order = int(order)
        return ""

    def _choose_measure(self, measure: str) -> str:
        self._measure = next(each for each in MEASURES if each == measure)
        self.refresh()
        return ""

    def _lay_out(self) -> None:
        form = QFormLayout()
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        sources = {SELECTED: "Selected shape", **{name: name for name in REFERENCES}}
        for words, options, shown, take in (
            ("Points of", sources, SELECTED, self._choose_source),
            ("Order", ORDERS, str(self._order), self._choose_order),
            (
                "Show",
                {str(key): text for key, text in MEASURES.items()},
                self._measure,
                self._choose_measure,
            ),
        ):
            choice = Choice(words.lower(), options, take)
            choice.show_value(shown)
            form.addRow(row_label(words), choice)
        buttons = QHBoxLayout()
        buttons.setSpacing(8)
        buttons.addWidget(self.start)
        buttons.addWidget(self.add)
        side = QVBoxLayout()
        side.setSpacing(8)
        side.addLayout(form)
        side.addLayout(buttons)
        side.addWidget(self.numbers)
        side.addStretch(1)
        beside = QWidget()
        beside.setFixedWidth(WIDTH)
        beside.setLayout(side)
        row = QHBoxLayout()
        row.setSpacing(8)
        row.addWidget(beside)
        plots = QHBoxLayout()
        plots.setSpacing(8)
        for plot in self.plots.values():
            plots.addWidget(plot, 1)
        page, hint = QWidget(), quiet(HINT)
        page.setLayout(plots)
        plots.setContentsMargins(0, 0, 0, 0)
        hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        hint.setMinimumWidth(1)
        for each in (hint, page):
            self._stack.addWidget(each)
        row.addLayout(self._stack, 1)
        self.setProperty("panel", True)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        row.setContentsMargins(8, 4, 8, 4)
        self.setLayout(row)


def _sample(kind: Kind, theme: Theme) -> tuple[str, str]:
    """The color that a family is drawn in, and a line in letters, dashed or not."""
    return theme.color(COLORS[kind]), "\u2501\u2501" if is_plus(kind) else "\u2578\u2578"


def _fits(
    make: Callable[[], Reference], sizes: tuple[int, ...], order: int, check: Check
) -> Iterator[Fit]:
    """In a thread: the points, and then all that comes near to them."""
    points = make()
    if isinstance(points, SampledSurface):
        yield from surface_fits(points, sizes, order=order, check=check)
    else:
        yield from curve_fits(points, sizes, order=order, check=check)
