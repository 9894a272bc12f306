"""The bar of s, always in sight: how strongly the control lines and planes of shapes pull."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel

from plusedit.commands.curves import SetMagnitude
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.natural import best_s_of
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import LiveWidget, common
from plusedit.views.magnitude_slider import STEP, MagnitudeSlider

RESET = 0.5  # s / L that a double-click goes back to
NAMED = 1  # shapes that are called by name
ROOM = 112  # logical pixels for the name, so that the slider stands still when it changes


class MagnitudeBar(LiveWidget):
    """Slider and number fields for s of the selected shapes, of all visible ones if none is."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.slider = MagnitudeSlider()
        self.ratio_field = NumberField("s / L", self._set_ratio, step=STEP, digits=4)
        self.s_field = NumberField("s", self._set_s, step=0.1, digits=5)
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
        for text, field in (("s / L", self.ratio_field), ("s", self.s_field)):
            label = QLabel(text)
            label.setBuddy(field)
            label.setProperty("quiet", True)
            field.setFixedWidth(76)
            field.setAlignment(Qt.AlignmentFlag.AlignRight)
            row.addSpacing(4)
            row.addWidget(label)
            row.addWidget(field)

    def targets(self) -> Mapping[ShapeId, PlusGeometry]:
        """The shapes that the bar acts on: editable ones, as they are on the screen."""
        design = self.desk.session.design
        chosen = self.desk.session.selection.shapes
        shapes = {i: geometry for i, geometry in design.drawn() if design[i].editable}
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
            self.desk.lengths.measure(shape_id, geometry)
        self.desk.commit(self._edit(RESET))
        self._soon()

    def refresh(self) -> None:
        self.slider.theme = self.desk.theme
        lengths = self.desk.lengths
        lengths.keep_only(self.desk.session.design)
        targets = self.targets()
        for widget in (self.slider, self.ratio_field, self.s_field):
            widget.setEnabled(bool(targets))
        self._what.setText(self._named(targets))
        ratio = common(round(lengths.ratio(i, shape), 9) for i, shape in targets.items())
        self.slider.show_ratio(ratio, self._best(targets))
        empty = "mixed" if targets else ""
        self.ratio_field.show_value(ratio, mixed=empty)
        self.s_field.show_value(common(shape.s for shape in targets.values()), mixed=empty)
        self.slider.update()

    def _best(self, targets: Mapping[ShapeId, PlusGeometry]) -> float | None:
        """s* / L of a single shape; of several each has its own, and none is shown."""
        if len(targets) != 1:
            return None
        (shape_id, shape) = next(iter(targets.items()))
        best, length = best_s_of(shape), self.desk.lengths.of(shape_id, shape)
        return best / length if best is not None and length else None

    def _named(self, targets: Mapping[ShapeId, PlusGeometry]) -> str:
        if not targets:
            return "No shape"
        if len(targets) == NAMED:
            name = self.desk.session.design[next(iter(targets))].name
            end = Qt.TextElideMode.ElideRight
            return self._what.fontMetrics().elidedText(name, end, ROOM)
        is_of_curves = all(isinstance(shape, PlusCurve) for shape in targets.values())
        noun = "curves" if is_of_curves else "shapes"
        if self.desk.session.selection.shapes:
            return f"{len(targets)} {noun}"
        return f"All {len(targets)} {noun}"

    def _edit(self, ratio: float) -> SetMagnitude:
        lengths = {i: self.desk.lengths.of(i, shape) for i, shape in self.targets().items()}
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
