"""The numbers of the selected control lines."""

from collections.abc import Callable
from math import degrees, radians

import numpy as np
from PySide6.QtWidgets import QCheckBox, QFormLayout, QVBoxLayout, QWidget

from plusedit.commands.base import Command, Targets, Together
from plusedit.commands.directions import ResetDirections, SetAngle, SetDirection, SetLength
from plusedit.commands.lines import SetCoordinate, SetWeight
from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.views.basis_form import check, row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import common, title

AXES = "xyz"


class LineForm(QWidget):
    """Point, direction and weight of the selected control lines; "mixed" where they differ."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._targets: Targets = {}
        self._title = title("")
        self._form = QFormLayout()
        self._form.setSpacing(4)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._points = [
            self._number(name, name, lambda v, a=a: SetCoordinate(self._targets, a, v))  # type: ignore[misc]
            for a, name in enumerate(AXES)
        ]
        self._angle = self._number(
            "Angle °", "angle", lambda v: SetAngle(self._targets, radians(v)), step=5.0
        )
        self._length = self._number(
            "Length", "length", lambda v: SetLength(self._targets, v), step=0.1
        )
        self._automatic = QCheckBox("follows its neighbors")
        self._automatic.setAccessibleName("automatic direction")
        self._automatic.clicked.connect(self._switch_automatic)
        self._form.addRow(row_label("Automatic"), self._automatic)
        self._weight = self._number(
            "Weight", "weight", lambda v: SetWeight(self._targets, v), step=0.1
        )
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(8)
        column.addWidget(self._title)
        column.addLayout(self._form)

    def _number(
        self, label: str, name: str, edit: Callable[[float], Command], *, step: float = 1.0
    ) -> NumberField:
        field = NumberField(name, lambda value: self._desk.commit(edit(value)), step=step)
        self._form.addRow(row_label(label), field)
        return field

    def show_lines(self, targets: Targets, curves: dict[ShapeId, PlusCurve], step: float) -> None:
        """Show these lines of these curves; points change by `step`."""
        self._targets = targets
        count = sum(len(rows) for rows in targets.values())
        self.setVisible(count > 0)
        if not count:
            return
        if count == 1:
            number = next(rows for rows in targets.values() if rows)[0]
            self._title.setText(f"Control line {number + 1}")
        else:
            self._title.setText(f"{count} control lines")
        self._show_points(curves, step)
        self._show_directions(curves)
        weights = [
            1.0 if curves[i].lines.weights is None else float(curves[i].lines.weights[row])  # type: ignore[index]
            for i, rows in targets.items()
            for row in rows
        ]
        self._weight.show_value(common(weights))

    def _show_points(self, curves: dict[ShapeId, PlusCurve], step: float) -> None:
        dimension = min(curves[i].dimension for i in self._targets)
        for axis, field in enumerate(self._points):
            self._form.setRowVisible(field, axis < dimension)
            field.step = step
            if axis < dimension:
                field.show_value(
                    common(
                        float(curves[i].lines.points[row, axis])
                        for i, rows in self._targets.items()
                        for row in rows
                    )
                )

    def _show_directions(self, curves: dict[ShapeId, PlusCurve]) -> None:
        directions = [
            curves[i].directions[row] for i, rows in self._targets.items() for row in rows
        ]
        flags = [
            bool(curves[i].lines.automatic[row])
            for i, rows in self._targets.items()
            for row in rows
        ]
        self._angle.show_value(
            common(angle_of(d) for d in directions), mixed=self._none(directions)
        )
        self._length.show_value(common(round(float(np.linalg.norm(d)), 12) for d in directions))
        check(self._automatic, flags)

    def _none(self, directions: list[Floats]) -> str:
        return "none" if not any(d.any() for d in directions) else "mixed"

    def _switch_automatic(self) -> None:
        curves = self._desk.selected_curves()
        flags = [
            curves[i].lines.automatic[row] for i, rows in self._targets.items() for row in rows
        ]
        if not all(flags):
            self._desk.commit(ResetDirections(self._targets))
            return
        keep = tuple(
            SetDirection(i, row, curves[i].directions[row])
            for i, rows in self._targets.items()
            for row in rows
        )
        noun = "direction" if len(keep) == 1 else f"{len(keep)} directions"
        self._desk.commit(Together(f"Keep {noun}", keep))


def angle_of(direction: Floats) -> float | None:
    """In degrees from the x axis towards the y axis, seen from the top; None of no direction."""
    if not direction[:2].any():
        return None
    return round(degrees(float(np.arctan2(direction[1], direction[0]))), 10)
