"""The bar of s, always in sight: how strongly the control lines and planes of shapes pull."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel

from plusedit.commands.curves import SetMagnitude
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.natural import best_s_of
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import LiveWidget, common
from plusedit.views.magnitude_slider import OF_LENGTH, OF_MESHES, STEP, MagnitudeSlider
from plusedit.views.smoothness_bar import SmoothnessBar

RESET = 0.5  # s / L that a double-click goes back to
RESET_OF_MESHES = 1.0  # s
NAMED = 1  # shapes that are called by name
ROOM = 112  # logical pixels for the name, so that the slider stands still when it changes


class MagnitudeBar(LiveWidget):
    """Slider and number fields for s of the selected shapes, of all visible ones if none is."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.slider = MagnitudeSlider()
        self.ratio_field = NumberField("s / L", self._set_ratio, step=STEP, digits=4)
        self.s_field = NumberField("s", self._set_s, step=0.1, digits=5)
        self.smoothness = SmoothnessBar(desk)
        self._of_length = QLabel("s / L")
        self._what = QLabel()
        self._what.setProperty("quiet", True)
        self._what.setFixedWidth(ROOM)
        self._lay_out()
        self.slider.moved.connect(self._preview)
        self.slider.settled.connect(self._settle)
        self.slider.dropped.connect(desk.session.abort)
        self.slider.reset_asked.connect(self.reset)
        self._moved: SetMagnitude | None = None

    def _lay_out(self) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 4, 12, 0)
        row.setSpacing(8)
        row.addWidget(self._what)
        row.addWidget(self.slider, 1)
        for label, field in ((self._of_length, self.ratio_field), (QLabel("s"), self.s_field)):
            label.setBuddy(field)
            label.setProperty("quiet", True)
            field.setFixedWidth(76)
            field.setAlignment(Qt.AlignmentFlag.AlignRight)
            row.addSpacing(4)
            row.addWidget(label)
            row.addWidget(field)
        row.addWidget(self.smoothness, 1)

    def finish(self) -> None:
        """Settle now what waits for a pause."""
        self.slider.finish()
        self.smoothness.slider.finish()

    def targets(self) -> Mapping[ShapeId, Geometry]:
        """The shapes that the bar acts on: editable ones, as they are on the screen."""
        design = self.desk.session.design
        chosen = self.desk.session.selection.shapes
        shapes = {i: shape.geometry for i, shape in design.shapes.items() if shape.editable}
        picked = {i: geometry for i, geometry in shapes.items() if i in chosen}
        return picked if chosen else shapes

    def forget(self) -> None:
        """Another design was opened: its L are measured when they are needed."""
        self.desk.lengths.forget()
        self._soon()

    def reset(self) -> None:
        """Measure L anew and put s back to half of it."""
        targets = self.targets()
        for shape_id, geometry in targets.items():
            if not isinstance(geometry, MeshSurface):
                self.desk.lengths.measure(shape_id, geometry)
        self.desk.commit(self._edit(RESET_OF_MESHES if are_meshes(targets) else RESET))
        self._soon()

    def refresh(self) -> None:
        self.slider.theme = self.desk.theme
        lengths = self.desk.lengths
        lengths.keep_only(self.desk.session.design)
        targets = self.targets()
        for widget in (self.slider, self.ratio_field, self.s_field):
            widget.setEnabled(bool(targets))
        self._what.setText(self._named(targets))
        ratio = common(round(self._ratio(i, shape), 9) for i, shape in targets.items())
        self._suit(targets)
        self.slider.show_ratio(ratio, self._best(targets))
        empty = "mixed" if targets else ""
        self.ratio_field.show_value(ratio, mixed=empty)
        self.s_field.show_value(common(shape.s for shape in targets.values()), mixed=empty)

    def _suit(self, targets: Mapping[ShapeId, Geometry]) -> None:
        """Run over s itself for meshes, which have no length of a polygon; show their S."""
        for_meshes = are_meshes(targets)
        scale = OF_MESHES if for_meshes else OF_LENGTH
        if self.slider.scale is not scale:
            self.slider.set_scale(scale)
        for widget in (self._of_length, self.ratio_field):
            widget.setVisible(not for_meshes)
        meshes = {i: shape for i, shape in targets.items() if isinstance(shape, MeshSurface)}
        self.smoothness.show_meshes(meshes)

    def _ratio(self, shape_id: ShapeId, shape: Geometry) -> float:
        return shape.s / self._length(shape_id, shape) if self._length(shape_id, shape) else 0.0

    def _length(self, shape_id: ShapeId, shape: Geometry) -> float:
        """L of a shape; of a mesh one."""
        return 1.0 if isinstance(shape, MeshSurface) else self.desk.lengths.of(shape_id, shape)

    def _best(self, targets: Mapping[ShapeId, Geometry]) -> float | None:
        """s* / L of a single shape; of several each has its own, and none is shown."""
        if len(targets) != 1:
            return None
        (shape_id, shape) = next(iter(targets.items()))
        if isinstance(shape, MeshSurface):
            return None
        best, length = best_s_of(shape), self.desk.lengths.of(shape_id, shape)
        return best / length if best is not None and length else None

    def _named(self, targets: Mapping[ShapeId, Geometry]) -> str:
        if not targets:
            return "No shape"
        if len(targets) == NAMED:
            name = self.desk.session.design[next(iter(targets))].name
            end = Qt.TextElideMode.ElideRight
            return self._what.fontMetrics().elidedText(name, end, ROOM)
        is_of_curves = all(isinstance(shape, PlusCurve) for shape in targets.values())
        noun = "curves" if is_of_curves else "meshes" if are_meshes(targets) else "shapes"
        if self.desk.session.selection.shapes:
            return f"{len(targets)} {noun}"
        return f"Both {noun}" if len(targets) == 2 else f"All {len(targets)} {noun}"

    def _edit(self, ratio: float) -> SetMagnitude:
        lengths = {i: self._length(i, shape) for i, shape in self.targets().items()}
        return SetMagnitude({i: ratio * length for i, length in lengths.items() if length})

    def _preview(self, ratio: float) -> None:
        if self._moved is None:
            self.desk.gestures.cancel()
        self._moved = self._edit(ratio)
        if not self.desk.preview(self._moved):
            # The knob is under the pointer now, whatever the panels wait for.
            self.slider.show_ratio(ratio, self.slider.best)

    def _settle(self) -> None:
        edit, self._moved = self._moved, None
        if edit is not None:
            self.desk.commit(edit)
        self._soon()

    def _set_ratio(self, ratio: float) -> str:
        return self.desk.commit(self._edit(ratio))

    def _set_s(self, value: float) -> str:
        return self.desk.commit(SetMagnitude(dict.fromkeys(self.targets(), value)))


def are_meshes(shapes: Mapping[ShapeId, Geometry]) -> bool:
    """Whether there are shapes, and all of them are surfaces of meshes."""
    return bool(shapes) and all(isinstance(shape, MeshSurface) for shape in shapes.values())
