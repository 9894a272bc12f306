"""The numbers of the selected control lines and control planes."""

from collections.abc import Callable

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from plusedit.commands.base import Command, Targets
from plusedit.commands.lines import SetCoordinate, SetWeight
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import WAYS, PlusSurface
from plusedit.views.basis_form import row_label
from plusedit.views.desk import Desk
from plusedit.views.direction_rows import DirectionRows
from plusedit.views.fields import NumberField
from plusedit.views.live import common, title

AXES = "xyz"


class LineForm(QWidget):
    """Point, directions and weight of what is selected; "mixed" where they differ."""

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
        self._weight = self._number(
            "Weight", "weight", lambda v: SetWeight(self._targets, v), step=0.1
        )
        self._directions = [DirectionRows(desk, self._form, way) for way in (None, *WAYS)]
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

    def show_lines(self, targets: Targets, shapes: dict[ShapeId, Geometry], step: float) -> None:
        """Show these lines and planes of these shapes; points change by `step`."""
        self._targets = targets
        count = sum(len(rows) for rows in targets.values())
        self.setVisible(count > 0)
        if not count:
            return
        self._title.setText(titled(targets, shapes))
        self._show_points(shapes, step)
        for rows in self._directions:
            rows.show(targets, shapes)
        self._show_weights(shapes)

    def _show_weights(self, shapes: dict[ShapeId, Geometry]) -> None:
        weighted = {i: rows for i, rows in self._targets.items() if has_weights(shapes[i])}
        self._form.setRowVisible(self._weight, len(weighted) == len(self._targets))
        weights = []
        for i, numbers in weighted.items():
            row = shapes[i].net.weight_row
            weights += [1.0 if row is None else float(row[number]) for number in numbers]
        self._weight.show_value(common(weights))

    def _show_points(self, shapes: dict[ShapeId, Geometry], step: float) -> None:
        dimension = min(shapes[i].dimension for i in self._targets)
        for axis, field in enumerate(self._points):
            self._form.setRowVisible(field, axis < dimension)
            field.step = step
            if axis < dimension:
                field.show_value(
                    common(
                        float(shapes[i].net.control_points[row, axis])
                        for i, rows in self._targets.items()
                        for row in rows
                    )
                )


def titled(targets: Targets, shapes: dict[ShapeId, Geometry]) -> str:
    """Such as "Control line 3", "Control plane 2, 1" or "4 control planes"."""
    chosen = [(shapes[i], row) for i, rows in targets.items() for row in rows]
    is_plane = [not isinstance(geometry, PlusCurve) for geometry, _ in chosen]
    if len(chosen) > 1:
        noun = "planes" if all(is_plane) else "lines and planes" if any(is_plane) else "lines"
        return f"{len(chosen)} control {noun}"
    return f"Control {element_name(*chosen[0])}"


def element_name(geometry: Geometry, number: int) -> str:
    """Such as "line 3", or "plane 2, 1": counted from 1, along u first. Of a face "plane 17"."""
    if isinstance(geometry, PlusSurface):
        row, column = divmod(number, geometry.planes.shape[1])
        return f"plane {row + 1}, {column + 1}"
    return f"{'line' if isinstance(geometry, PlusCurve) else 'plane'} {number + 1}"


def has_weights(geometry: Geometry) -> bool:
    """Whether its lines or planes have weights that can be set; those of a mesh have none."""
    return not isinstance(geometry, MeshSurface)
