"""The numbers of the selected shapes as wholes."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from plusedit.commands.base import Command, Together
from plusedit.commands.curves import SetMagnitude
from plusedit.commands.directions import ScaleDirections
from plusedit.commands.shapes import Rename, SetStyle
from plusedit.document.shape import PlusGeometry, Shape, ShapeId, Style
from plusedit.geometry.surface import WAYS, PlusSurface, Way
from plusedit.views.basis_form import row_label
from plusedit.views.color_button import ColorButton
from plusedit.views.desk import Desk
from plusedit.views.family_form import FamilyForm
from plusedit.views.fields import NumberField, TextField
from plusedit.views.live import common, title
from plusedit.views.mesh_form import MeshForm

SHARE = "How strongly s pulls by the lengths of rows; scales every direction by"
USUAL_WIDTH = 2.0  # logical pixels of a curve that says nothing of it


class ShapeForm(QWidget):
    """Name, family, s and style of the selected shapes; "mixed" where they differ."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._shapes: dict[ShapeId, Shape] = {}
        self._plus: dict[ShapeId, PlusGeometry] = {}
        self._title = title("")
        self._name = TextField("name", self._rename)
        self._families = [FamilyForm(desk), *(FamilyForm(desk, way) for way in WAYS)]
        self._s = NumberField("s", self._set_s, step=0.1)
        self._ratio = NumberField("s / L", self._set_ratio, step=0.01)
        self._shares = [
            NumberField(f"s / L along {way}", lambda v, way=way: self._set_share(way, v), step=0.01)  # type: ignore[misc]
            for way in WAYS
        ]
        self._color = ColorButton(self._set_color)
        self._width = NumberField("width", self._set_width, step=0.5)
        self._meshes = MeshForm(desk)
        self._above, self._below = self._rows(), self._rows()
        self._fill()

    def _rows(self) -> QFormLayout:
        form = QFormLayout()
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        return form

    def _fill(self) -> None:
        self._above.addRow(row_label("Name"), self._name)
        self._below.addRow(row_label("s"), self._s)
        self._below.addRow(row_label("s / L"), self._ratio)
        for way, field in zip(WAYS, self._shares, strict=True):
            self._below.addRow(row_label(f"s / L by {way}"), field)
            field.setToolTip(f"{SHARE} {way}")
        self._below.addRow(row_label("Color"), self._color)
        self._below.addRow(row_label("Width"), self._width)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(self._title)
        column.addSpacing(4)
        column.addLayout(self._above)
        for family in self._families:
            column.addWidget(family)
        column.addWidget(self._meshes)
        column.addLayout(self._below)

    def show_shapes(self, shapes: dict[ShapeId, Shape]) -> None:
        """Show these shapes, one or more."""
        self._shapes = shapes
        self._plus = {i: s.plus for i, s in shapes.items() if s.plus is not None}
        self._title.setText("Shape" if len(shapes) == 1 else f"{len(shapes)} shapes")
        self._name.show_value(common(shape.name for shape in shapes.values()))
        self._name.setEnabled(len(shapes) == 1)
        for family in self._families:
            family.show_shapes(self._plus)
        for field in (self._s, self._ratio):
            self._below.setRowVisible(field, bool(self._plus))
        self._s.show_value(common(shape.s for shape in self._plus.values()))
        ratios = (self._desk.lengths.ratio(i, shape) for i, shape in self._plus.items())
        self._ratio.show_value(common(round(ratio, 9) for ratio in ratios))
        self._show_shares()
        styles = [shape.style for shape in shapes.values()]
        self._meshes.show_meshes({i: s.mesh for i, s in shapes.items() if s.mesh is not None})
        are_surfaces = [shape.curve is None for shape in shapes.values()]
        has_none_but = bool(are_surfaces) and all(are_surfaces)
        usual = self._desk.theme.color("front" if has_none_but else "plus")
        self._color.show_color([s.color for s in styles], usual)
        self._below.setRowVisible(self._width, not has_none_but)
        self._width.show_value(common(s.width or USUAL_WIDTH for s in styles))

    def _rename(self, name: str) -> str:
        return self._desk.commit(Rename(next(iter(self._shapes)), name))

    def _show_shares(self) -> None:
        surfaces = [g for g in self._plus.values() if isinstance(g, PlusSurface)]
        is_all = bool(surfaces) and len(surfaces) == len(self._plus)
        for number, field in enumerate(self._shares):
            self._below.setRowVisible(field, is_all)
            if is_all:
                shares = (shares_of(surface)[number] for surface in surfaces)
                field.show_value(common(round(share, 9) for share in shares))

    def _set_s(self, value: float) -> str:
        return self._desk.commit(SetMagnitude(dict.fromkeys(self._plus, value)))

    def _set_ratio(self, value: float) -> str:
        lengths = {i: self._desk.lengths.of(i, shape) for i, shape in self._plus.items()}
        return self._desk.commit(SetMagnitude({i: value * length for i, length in lengths.items()}))

    def _set_share(self, way: Way, value: float) -> str:
        """Scale all directions by u, or by v, so that s pulls that strongly along them."""
        edits: list[Command] = []
        for shape_id, surface in self._plus.items():
            if isinstance(surface, PlusSurface):
                now = shares_of(surface)[WAYS.index(way)]
                if not now:
                    return f"{self._shapes[shape_id].name} has no pull along {way} to scale"
                numbers = {shape_id: tuple(range(len(surface.planes)))}
                edits.append(ScaleDirections(numbers, value / now, side=way))
        return self._desk.commit(Together(f"Set s / L along {way}", tuple(edits)))

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


def shares_of(surface: PlusSurface) -> tuple[float, float]:
    """s times the mean length of the directions by u, in units of L_u; and so by v."""
    from plusedit.geometry.surface_magnitude import natural_lengths

    means = np.linalg.norm(surface.directions, axis=-1).mean(axis=(1, 2))
    shares = [
        surface.s * float(mean) / length if length else 0.0
        for mean, length in zip(means, natural_lengths(surface), strict=True)
    ]
    return shares[0], shares[1]
