"""What is changed of the faces of selected meshes: the smoothness there, and edited planes."""

from collections.abc import Callable, Mapping

import numpy as np
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from plusedit.commands.base import Targets, many
from plusedit.commands.faces import ResetPlanes, SetFactor, factors_of
from plusedit.document.shape import ShapeId
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.views.basis_form import row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import quiet, title
from plusedit.views.magnitude_slider import MagnitudeSlider, Scale

OF_FACTOR = Scale(
    "local smoothness",
    "By what S is multiplied at the selected faces: less keeps more detail there.\n"
    "Double-click: back to 1. Keys − and + or the wheel: 2 %.",
    8.0,
    low=0.125,
    usual=1.0,
    marks=((0.125, "⅛"), (0.25, "¼"), (0.5, "½"), (2.0, "2"), (4.0, "4"), (8.0, "8")),
    special=((1.0, "1"),),
    step=0.02,
    is_logarithmic=True,
)


class FaceForm(QWidget):
    """The local factor of S, and what is changed of faces, to be taken back; hidden without a mesh.

    Of a mesh that is selected as a whole all faces are meant.
    """

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._targets: Targets = {}
        self._moved: SetFactor | None = None
        self.slider = MagnitudeSlider(OF_FACTOR)
        self.factor = NumberField("local S", self._set_factor, step=0.1, digits=4)
        self._local = QWidget()
        self.edited = _Changes("edited planes", self._reset_planes)
        self.uneven = _Changes("local S", lambda: self._set_factor(1.0))
        self._fill()
        self.slider.moved.connect(self._preview)
        self.slider.settled.connect(self._settle)
        self.slider.dropped.connect(self._drop)
        self.slider.reset_asked.connect(lambda: self._set_factor(1.0))

    def _fill(self) -> None:
        field = QFormLayout()
        field.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        field.addRow(row_label("S times"), self.factor)
        steps = QHBoxLayout()
        steps.setSpacing(8)
        for text, factor, tip in (
            ("Sharper", 0.5, "Halve S at these faces"),
            ("Smoother", 2.0, "Double S at these faces"),
        ):
            steps.addWidget(_button(text, tip, lambda factor=factor: self._multiply(factor)), 1)  # type: ignore[misc]
        local = QVBoxLayout(self._local)
        local.setContentsMargins(0, 0, 0, 0)
        local.setSpacing(4)
        local.addWidget(title("Smoothness at these faces"))
        local.addLayout(field)
        local.addWidget(self.slider)
        local.addLayout(steps)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(8)
        for part in (self._local, self.edited, self.uneven):
            column.addWidget(part)

    def show_faces(self, targets: Targets, meshes: Mapping[ShapeId, MeshSurface]) -> None:
        """Show what is changed of these faces; of a mesh without any of all."""
        self._targets = {i: targets.get(i, ()) for i in meshes}
        has_faces = any(self._targets.values())
        if has_faces:
            self._targets = {i: rows for i, rows in self._targets.items() if rows}
        self._local.setVisible(has_faces)
        factors, edited = [np.ones(0)], 0
        for shape_id, rows in self._targets.items():
            surface, meant = meshes[shape_id], list(rows) or slice(None)
            factors.append(factors_of(surface)[meant])
            marked = np.zeros(surface.mesh.face_count, dtype=np.bool_)
            marked[list(surface.edited)] = True
            edited += int(marked[meant].sum())
        every = np.concatenate(factors)
        same = float(every[0]) if len(every) and (every == every[0]).all() else None
        self.factor.show_value(same)
        self.slider.theme = self._desk.theme
        self.slider.show_ratio(same, None)
        self.edited.show_count(edited, "edited plane")
        self.uneven.show_count(int((every != 1.0).sum()), "face", " with local S")
        self.setVisible(has_faces or edited > 0 or bool((every != 1.0).any()))

    def _preview(self, value: float) -> None:
        if self._moved is None:
            self._desk.gestures.cancel()
        self._moved = SetFactor(self._targets, value)
        if not self._desk.preview(self._moved):
            self.slider.show_ratio(value, None)

    def _settle(self) -> None:
        edit, self._moved = self._moved, None
        if edit is not None:
            self._desk.commit(edit)

    def _drop(self) -> None:
        self._moved = None
        self._desk.session.abort()

    def _set_factor(self, value: float) -> str:
        return self._desk.commit(SetFactor(self._targets, value))

    def _multiply(self, factor: float) -> str:
        return self._desk.commit(SetFactor(self._targets, factor, relative=True))

    def _reset_planes(self) -> str:
        return self._desk.commit(ResetPlanes(self._targets))


class _Changes(QWidget):
    """How many of something there are, with a button that takes them back; hidden without any."""

    def __init__(self, name: str, take_back: Callable[[], object]) -> None:
        super().__init__()
        self.count: QLabel = quiet()
        self.button = _button("Reset", f"Take {name} back", take_back)
        self.button.setAccessibleName(f"reset {name}")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.count, 1)
        row.addWidget(self.button)

    def show_count(self, count: int, noun: str, more: str = "") -> None:
        """Such as "edited plane" or "3 edited planes"."""
        self.setVisible(count > 0)
        self.count.setText(f"{'1 ' if count == 1 else ''}{many({noun: count})}{more}")


def _button(text: str, tip: str, act: Callable[[], object]) -> QPushButton:
    button = QPushButton(text)
    button.setToolTip(tip)
    button.clicked.connect(lambda: act())
    return button
