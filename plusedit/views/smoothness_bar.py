"""S of the selected meshes: a logarithmic slider and a number field, beside those of s."""

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from plusedit.commands.meshes import SetSmoothness
from plusedit.document.shape import ShapeId
from plusedit.geometry.mesh.mesh_surface import USUAL_SMOOTHNESS, MeshSurface
from plusedit.views.desk import Desk
from plusedit.views.deviation_label import DeviationLabel
from plusedit.views.fields import NumberField
from plusedit.views.live import common
from plusedit.views.magnitude_slider import OF_SMOOTHNESS, MagnitudeSlider


class SmoothnessBar(QWidget):
    """Slider and number field for S; a drag is one undo step."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._meshes: Mapping[ShapeId, MeshSurface] = {}
        self._moved: SetSmoothness | None = None
        self.slider = MagnitudeSlider(OF_SMOOTHNESS)
        self.field = NumberField("S", self._set, step=0.05, digits=4)
        self.field.setFixedWidth(76)
        self.field.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.numbers = DeviationLabel()
        label = QLabel("S")
        label.setBuddy(self.field)
        label.setProperty("quiet", True)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.slider, 1)
        row.addWidget(label)
        row.addWidget(self.field)
        row.addWidget(self.numbers)
        self.slider.moved.connect(self._preview)
        self.slider.settled.connect(self._settle)
        self.slider.dropped.connect(self._drop)
        self.slider.reset_asked.connect(lambda: self._set(USUAL_SMOOTHNESS))

    def show_meshes(self, meshes: Mapping[ShapeId, MeshSurface]) -> None:
        """Show S of these; hide where there are none."""
        self._meshes = meshes
        self.setVisible(bool(meshes))
        self.slider.theme = self._desk.theme
        smoothness = common(mesh.smoothness for mesh in meshes.values())
        self.slider.show_ratio(smoothness, None)
        self.field.show_value(smoothness)
        design = self._desk.session.design
        self.numbers.show_meshes(meshes, {i: design[i].name for i in meshes})

    def _preview(self, value: float) -> None:
        if self._moved is None:
            self._desk.gestures.cancel()
        self._moved = SetSmoothness(dict.fromkeys(self._meshes, value))
        if not self._desk.preview(self._moved):
            # The knob is under the pointer now, whatever the panels wait for.
            self.slider.show_ratio(value, None)

    def _settle(self) -> None:
        edit, self._moved = self._moved, None
        if edit is not None:
            self._desk.commit(edit)

    def _drop(self) -> None:
        self._moved = None
        self._desk.session.abort()

    def _set(self, value: float) -> str:
        return self._desk.commit(SetSmoothness(dict.fromkeys(self._meshes, value)))
