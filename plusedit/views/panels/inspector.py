"""The Inspector: the numbers of whatever is selected, to be read and typed."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QScrollArea, QVBoxLayout, QWidget

from plusedit.views.constraint_form import ConstraintForm
from plusedit.views.desk import Desk
from plusedit.views.face_form import FaceForm
from plusedit.views.fit_form import FitForm
from plusedit.views.line_form import LineForm
from plusedit.views.live import LiveWidget, quiet, rule
from plusedit.views.numbers_form import NumbersForm
from plusedit.views.panels import panel
from plusedit.views.shape_form import ShapeForm

EMPTY = (
    "Nothing is selected.\n\n"
    "Click a curve or a surface to see its numbers, or press P and draw a curve."
)
LEAST_WIDTH = 264  # pixels, where no field is cut


@panel("inspector", title="Inspector", area="right", order=1)
class Inspector(LiveWidget):
    """Shapes, control lines and planes of the selection; each edit is one undo step."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.setMinimumWidth(LEAST_WIDTH)
        self._empty = quiet(EMPTY)
        self._shape = ShapeForm(desk)
        self._rule = rule()
        self._lines = LineForm(desk)
        self._numbers = NumbersForm()
        self._fit = FitForm(desk)
        self._constraints = ConstraintForm(desk)
        self._faces = FaceForm(desk)
        inside = QWidget()
        inside.setProperty("panel", True)
        inside.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        column = QVBoxLayout(inside)
        column.setContentsMargins(12, 12, 12, 12)
        column.setSpacing(12)
        for part in (
            self._empty,
            self._lines,
            self._faces,
            self._rule,
            self._shape,
            self._numbers,
            self._fit,
            self._constraints,
        ):
            column.addWidget(part)
        column.addStretch(1)
        area = QScrollArea()
        area.setWidget(inside)
        area.setWidgetResizable(True)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        around = QVBoxLayout(self)
        around.setContentsMargins(0, 0, 0, 0)
        around.addWidget(area)

    def refresh(self) -> None:
        session = self.desk.session
        shapes = {i: s for i, s in session.design.shapes.items() if i in session.selection.shapes}
        self._empty.setVisible(not shapes)
        self._shape.setVisible(bool(shapes))
        targets = {i: rows for i, rows in session.selection.by_shape().items() if i in shapes}
        self._rule.setVisible(bool(targets))
        if shapes:
            self._shape.show_shapes(shapes)
        self._numbers.show_curves({i: s.curve for i, s in shapes.items() if s.curve is not None})
        self._fit.show_shapes(shapes)
        self._constraints.show_shapes(shapes)
        geometries = {i: shape.geometry for i, shape in shapes.items()}
        self._lines.show_lines(targets, geometries, self.desk.gestures.grid_step)
        meshes = {i: shape.mesh for i, shape in shapes.items() if shape.mesh is not None}
        self._faces.show_faces({i: targets.get(i, ()) for i in meshes}, meshes)
