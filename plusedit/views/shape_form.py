"""The numbers of the selected shapes as wholes."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from plusedit.commands.base import Command, Together
from plusedit.commands.curves import ChangeFamily, SetMagnitude
from plusedit.commands.shapes import Rename, SetStyle
from plusedit.document.shape import Shape, ShapeId, Style
from plusedit.geometry.bases import families
from plusedit.geometry.curve import PlusCurve
from plusedit.views.basis_form import BasisForm, row_label
from plusedit.views.color_button import ColorButton
from plusedit.views.desk import Desk
from plusedit.views.fields import Choice, NumberField, TextField
from plusedit.views.live import common, title

TITLES = {"bezier": "Bézier", "bspline": "B-spline", "rag": "Rational Gaussian"}
USUAL_WIDTH = 2.0  # logical pixels of a curve that says nothing of it


def family_titles() -> dict[str, str]:
    """The families by name, as they are called in the window."""
    return {name: TITLES.get(name, name.capitalize()) for name in families}


def family_of(curve: PlusCurve) -> str:
    """The name of the family that a curve's basis belongs to."""
    return next(name for name, kind in families.items() if isinstance(curve.basis, kind))


class ShapeForm(QWidget):
    """Name, family, s and style of the selected shapes; "mixed" where they differ."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._shapes: dict[ShapeId, Shape] = {}
        self._curves: dict[ShapeId, PlusCurve] = {}
        self._title = title("")
        self._name = TextField("name", self._rename)
        self._family = Choice("family", family_titles(), self._change_family)
        self._basis = BasisForm(desk)
        self._s = NumberField("s", self._set_s, step=0.1)
        self._ratio = NumberField("s / L", self._set_ratio, step=0.01)
        self._color = ColorButton(self._set_color)
        self._width = NumberField("width", self._set_width, step=0.5)
        self._above, self._below = self._rows(), self._rows()
        self._fill()

    def _rows(self) -> QFormLayout:
        form = QFormLayout()
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        return form

    def _fill(self) -> None:
        self._above.addRow(row_label("Name"), self._name)
        self._above.addRow(row_label("Family"), self._family)
        self._below.addRow(row_label("s"), self._s)
        self._below.addRow(row_label("s / L"), self._ratio)
        self._below.addRow(row_label("Color"), self._color)
        self._below.addRow(row_label("Width"), self._width)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(self._title)
        column.addSpacing(4)
        column.addLayout(self._above)
        column.addWidget(self._basis)
        column.addLayout(self._below)

    def show_shapes(self, shapes: dict[ShapeId, Shape]) -> None:
        """Show these shapes, one or more."""
        self._shapes = shapes
        self._curves = {i: s.curve for i, s in shapes.items() if s.curve is not None}
        self._title.setText("Shape" if len(shapes) == 1 else f"{len(shapes)} shapes")
        self._name.show_value(common(shape.name for shape in shapes.values()))
        self._name.setEnabled(len(shapes) == 1)
        self._basis.show_curves(self._curves)
        has_curves = bool(self._curves)
        self._above.setRowVisible(self._family, has_curves)
        for field in (self._s, self._ratio):
            self._below.setRowVisible(field, has_curves)
        if has_curves:
            self._family.show_value(common(family_of(c) for c in self._curves.values()))
            self._s.show_value(common(curve.s for curve in self._curves.values()))
            ratios = (self._desk.lengths.ratio(i, curve) for i, curve in self._curves.items())
            self._ratio.show_value(common(round(ratio, 9) for ratio in ratios))
        styles = [shape.style for shape in shapes.values()]
        self._color.show_color([s.color for s in styles], self._desk.theme.color("plus"))
        self._width.show_value(common(s.width or USUAL_WIDTH for s in styles))

    def _rename(self, name: str) -> str:
        return self._desk.commit(Rename(next(iter(self._shapes)), name))

    def _change_family(self, family: str) -> str:
        return self._desk.commit(ChangeFamily(tuple(self._curves), family))

    def _set_s(self, value: float) -> str:
        return self._desk.commit(SetMagnitude(dict.fromkeys(self._curves, value)))

    def _set_ratio(self, value: float) -> str:
        lengths = {i: self._desk.lengths.of(i, curve) for i, curve in self._curves.items()}
        return self._desk.commit(SetMagnitude({i: value * length for i, length in lengths.items()}))

    def _set_color(self, color: str | None) -> str:
        return self._restyle("color", lambda style: replace(style, color=color))

    def _set_width(self, width: float) -> str:
        if not 0.0 < width <= 100.0:
            return "a width lies between 0 and 100"
        return self._restyle("width", lambda style: replace(style, width=width))

    def _restyle(self, what: str, change: Callable[[Style], Style]) -> str:
        edits: tuple[Command, ...] = tuple(
            SetStyle((i,), change(shape.style)) for i, shape in self._shapes.items()
        )
        noun = "" if len(edits) == 1 else f" of {len(edits)} shapes"
        return self._desk.commit(Together(f"Set {what}{noun}", edits))
