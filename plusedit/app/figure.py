"""A live figure: a plus curve whose control lines can be turned and whose s can be dragged."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFrame, QVBoxLayout

from plusedit.commands.curves import SetMagnitude
from plusedit.document.design import Design
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.geometry.magnitude import best_s, polygon_length
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import ViewOptions
from plusedit.scene.theme import Theme
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.magnitude_slider import MagnitudeSlider

POINTS = [[0.0, 0.0], [1.4, 2.2], [3.6, 2.6], [5.0, 0.2], [7.2, 0.0], [8.4, 2.2]]
CURVE = ShapeId("curve")


class Figure(QFrame):
    """A canvas with one curve, and the slider of its s below it."""

    def __init__(self) -> None:
        super().__init__()
        self.setProperty("framed", True)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        curve = PlusCurve(BSpline(len(POINTS), 4), ControlLines.of(POINTS))
        self._length = polygon_length(curve)
        self.session = Session(Design({CURVE: Shape(curve, "Curve")}))
        self.session.commit(SetMagnitude({CURVE: 0.5 * self._length}))
        gestures = Gestures(self.session, PlaneCamera((400.0, 240.0)))
        self.canvas = PlaneCanvas(self.session, gestures)
        self.canvas.set_options(ViewOptions(handles="all", grid=False, rulers=False))
        self.canvas.setMinimumSize(320, 224)
        self.canvas.setAccessibleName("A curve to try")
        self.slider = MagnitudeSlider()
        self.slider.moved.connect(lambda ratio: self.session.preview(self._edit(ratio)))
        self.slider.settled.connect(lambda: self.session.commit(self._edit(self._ratio())))
        self.slider.dropped.connect(self.session.abort)
        self.slider.reset_asked.connect(lambda: self.session.commit(self._edit(0.5)))
        self.session.changed.listen(lambda *_: self._show())
        column = QVBoxLayout(self)
        column.setContentsMargins(4, 4, 4, 8)
        column.setSpacing(8)
        column.addWidget(self.canvas, 1)
        around = QVBoxLayout()
        around.setContentsMargins(12, 0, 12, 0)
        around.addWidget(self.slider)
        column.addLayout(around)
        self._show()
        self.canvas.frame_all()

    def set_theme(self, theme: Theme) -> None:
        """Draw in those colors."""
        self.canvas.set_theme(theme)
        self.slider.theme = theme

    def _show(self) -> None:
        curve = self.session.design.curve(CURVE)
        best = best_s(curve)
        self.slider.show_ratio(self._ratio(), None if best is None else best / self._length)

    def _ratio(self) -> float:
        return self.session.design.curve(CURVE).s / self._length

    def _edit(self, ratio: float) -> SetMagnitude:
        return SetMagnitude({CURVE: ratio * self._length})
