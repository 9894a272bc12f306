"""Length, bending energy and inflections of the selected curves."""

from collections.abc import Mapping, Sequence

from PySide6.QtWidgets import QFormLayout, QLabel, QWidget

from plusedit.document.shape import ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.curve_numbers import CurveNumbers, curve_numbers, known_numbers, together
from plusedit.scene.curve_words import energy_text, inflections_text, length_text
from plusedit.views.basis_form import row_label
from plusedit.views.look import tabular
from plusedit.views.newest import Newest

MANY = 200  # curves, of which none are told of: each takes some milliseconds
LATER = "…"
BOUND = (
    "How often the curve changes its sense of turning, and how often one of its degree can: "
    "a plus curve twice more than the curve of its points"
)


class NumbersForm(QWidget):
    """Found beside the window's thread: while something moves the numbers may lag behind."""

    def __init__(self) -> None:
        super().__init__()
        self._curves: tuple[PlusCurve, ...] = ()
        self._work = Newest(self)
        self.length, self.energy, self.inflections = QLabel(), QLabel(), QLabel()
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setSpacing(4)
        for name, label in (
            ("Length", self.length),
            ("Bending", self.energy),
            ("Inflections", self.inflections),
        ):
            label.setFont(tabular(label.font()))
            label.setAccessibleName(f"{name.lower()} of the curve")
            self._form.addRow(row_label(name), label)
        self.energy.setToolTip("The integral of the squared curvature along the curve")
        self.inflections.setToolTip(BOUND)

    def show_curves(self, curves: Mapping[ShapeId, PlusCurve]) -> None:
        """Tell of these together, as soon as they are known; hidden where there are none."""
        shown = tuple(curves.values())
        self.setVisible(0 < len(shown) <= MANY)
        if self.isHidden() or shown == self._curves:
            return
        self._curves = shown
        self._form.setRowVisible(self.inflections, any(c.dimension == 2 for c in shown))
        if None not in map(known_numbers, shown):
            self._show(shown)
            return
        for label in (self.length, self.energy, self.inflections):
            if not label.text().endswith(LATER):
                label.setText(f"{label.text()} {LATER}".strip())
        self._work.ask(lambda: [curve_numbers(curve) for curve in shown], self._found)

    def _found(self, numbers: Sequence[CurveNumbers]) -> None:
        if None not in map(known_numbers, self._curves):
            self._show(self._curves)

    def _show(self, curves: Sequence[PlusCurve]) -> None:
        known = together(curve_numbers(curve) for curve in curves)
        self.length.setText(length_text(known))
        self.energy.setText(energy_text(known))
        self.inflections.setText(inflections_text(known))
