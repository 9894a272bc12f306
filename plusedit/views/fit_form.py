"""How closely a fitted curve follows its points."""

from PySide6.QtWidgets import QFormLayout, QWidget

from plusedit.commands.fitting import FitSource, Refit, fit_source
from plusedit.document.design import EditError
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.residual import residual
from plusedit.views.basis_form import row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import quiet, title
from plusedit.views.newest import Newest

MOST = 400  # points of which the distances are told


class FitForm(QWidget):
    """The tolerance, and what it costs and brings; hidden where no fitted curve is selected."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._shape_id: ShapeId | None = None
        self._shape: Shape | None = None
        self._source: FitSource | None = None
        self._work = Newest(self)
        self.tolerance = NumberField("tolerance", self._set_tolerance, step=0.01)
        self.told = quiet()
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(title("Fit"))
        form.addRow(row_label("Tolerance"), self.tolerance)
        form.addRow(self.told)

    def show_shapes(self, shapes: dict[ShapeId, Shape]) -> None:
        """Show the one that is selected, if it was fitted to points."""
        only = next(iter(shapes.items())) if len(shapes) == 1 else None
        source = fit_source(only[1]) if only is not None else None
        self.setVisible(source is not None)
        if only is None or source is None:
            self._shape_id = self._shape = self._source = None
            return
        if self._shape is only[1]:
            return
        self._shape_id, self._shape = only
        self._source = source
        self.tolerance.show_value(source.tolerance)
        self.told.setText(_told(only[1], source))

    def _set_tolerance(self, value: float) -> str:
        source, shape_id = self._source, self._shape_id
        if source is None or shape_id is None:
            return ""
        if not value > 0.0:
            return "a tolerance is a length above 0"
        wanted = source.within(value)
        self.told.setText("Fitting …")

        def fit() -> str:
            try:
                _ = wanted.fitted
            except EditError as error:
                return str(error)
            return ""

        def take(problem: str) -> None:
            self._shape = None
            if problem:
                self._desk.say(problem)
            elif shape_id in self._desk.session.design:
                self._desk.commit(Refit(shape_id, wanted))

        self._work.ask(fit, take)
        return ""


def _told(shape: Shape, source: FitSource) -> str:
    curve = shape.curve
    if curve is None:
        return ""
    step = max(1, -(-len(source.points) // MOST))
    found = residual(curve, source.points[::step])
    return (
        f"{len(curve.lines)} control lines for {len(source.points):,} points; largest distance "
        f"{found.largest:.3g}, rms {found.rms:.3g}"
    )
