"""Frames of the 3D view: a drag of one control plane, the s slider, and what is not drawing.

    xvfb-run -a .venv/bin/python tests/benchmarks/space_frames.py

A surface of 20 x 20 control planes at 257 x 257 samples in a view of 1200 x 800. A frame is a mouse
move, or another s, sent to the view and everything that follows until the window is composed. The
peer is a static redraw: the same frame with nothing changed. All take turns. `besides` is what of
it is not drawing, in time of the processor: the edit, evaluation, upload and our own Python, with
OpenGL told to draw nothing.
"""

import os
import platform
import sys
import time
from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

os.environ.setdefault("QT_QPA_PLATFORM", "xcb")

import PySide6
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from plusedit.document.design import Design
from plusedit.document.selection import LineId, Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.blend import Grid
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.interaction.gesture import Gestures
from plusedit.machine import display
from plusedit.scene import space_scene
from plusedit.scene.options import ViewOptions
from plusedit.scene.space_camera import SpaceCamera
from plusedit.views.gl.functions import RENDERER
from plusedit.views.opengl import prepare_opengl

SIZE = (1200, 800)
PLANES, SAMPLES = 20, 257
FRAMES, ROUNDS = 40, 3
SHEET = ShapeId("sheet")
HELD = 10 * PLANES + 10
DRAWS = ("DrawArrays", "DrawArraysInstanced", "DrawElements", "Clear", "Finish")
BARE = ViewOptions(frozenset(), "none", isolines=False, ground=False)
LOOKS = {"surface alone": BARE, "as it opens": ViewOptions(handles="selected")}

Frame = Callable[[int], None]


@dataclass(frozen=True)
class Timing:
    """Milliseconds of a frame."""

    static: float
    drag: float
    slider: float


def sheet() -> Design:
    """A gently waved sheet."""
    across = np.linspace(-3.0, 3.0, PLANES)
    x, y = np.meshgrid(across, across, indexing="ij")
    planes = ControlPlanes.of(np.stack([x, y, np.sin(1.3 * x) * np.cos(y)], axis=-1))
    surface = PlusSurface(BSpline(PLANES), BSpline(PLANES), planes, 3.0)
    return Design({SHEET: Shape(surface, "Sheet")})


class View:
    """The 3D view of a sheet, and what is done to it."""

    def __init__(self, options: ViewOptions) -> None:
        from plusedit.views.space_canvas import SpaceCanvas

        self.session = Session(sheet())
        camera = SpaceCamera((1.0, 1.0))
        self.canvas = SpaceCanvas(self.session, Gestures(self.session, camera))
        self.canvas.is_animated = False
        self.canvas.set_options(options)
        self.canvas.resize(*SIZE)
        self.canvas.show()
        settle()
        self.canvas.frame_all()
        self.session.select(Selection.of_lines([LineId(SHEET, HELD)]))
        settle()
        point = self.session.design.surface(SHEET).planes.control_points[[HELD]]
        self.grabbed = self.canvas.camera.to_screen(point)[0]

    @property
    def gl(self) -> object:
        """The functions that the view draws with."""
        return self.canvas._drawn.gl

    def press(self) -> None:
        """Take hold of the control plane in the middle."""
        self._send(QEvent.Type.MouseMove, self.grabbed, Qt.MouseButton.NoButton)
        self._send(QEvent.Type.MouseButtonPress, self.grabbed, Qt.MouseButton.LeftButton)

    def drag(self, number: int) -> None:
        """Move it somewhere else."""
        turn = 0.3 * (number + 1)
        at = self.grabbed + 40.0 * np.array([np.sin(turn), 1.0 - np.cos(turn)])
        self._send(QEvent.Type.MouseMove, at, Qt.MouseButton.LeftButton)

    def let_go(self) -> None:
        """Give the drag up."""
        self._send(QEvent.Type.MouseButtonRelease, self.grabbed, Qt.MouseButton.LeftButton)
        if self.session.undo_label is not None:
            self.session.undo()

    def slide(self, number: int) -> None:
        """Another s."""
        design = self.session.design
        surface = replace(design.surface(SHEET), s=3.0 + 0.01 * (number + 1))
        shape = replace(design[SHEET], geometry=surface)
        self.session.open(design.with_shape(SHEET, shape))

    def redraw(self, _number: int) -> None:
        """The same once more."""
        self.canvas.update()

    def _send(self, kind: QEvent.Type, at: np.ndarray, held: Qt.MouseButton) -> None:
        is_move = kind == QEvent.Type.MouseMove
        event = QMouseEvent(
            kind,
            QPointF(*at),
            self.canvas.mapToGlobal(QPointF(*at)),
            Qt.MouseButton.NoButton if is_move else held,
            held if kind != QEvent.Type.MouseButtonRelease else Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
        )
        QApplication.sendEvent(self.canvas, event)


def settle() -> None:
    """Let Qt do what is due: the paint event among it."""
    QApplication.processEvents()


def whole(act: Frame, number: int) -> float:
    """Seconds of a frame."""
    start = time.perf_counter()
    act(number)
    settle()
    return time.perf_counter() - start


class Besides:
    """Seconds of the processor that a frame takes before and in the painting of our view."""

    def __init__(self, view: View) -> None:
        self._draw, self._spent = view.canvas.draw, 0.0
        view.canvas.draw = self._timed_draw

    def __call__(self, act: Frame, number: int) -> float:
        self._spent = 0.0
        start = time.thread_time()
        act(number)
        before = time.thread_time() - start
        settle()
        return before + self._spent

    def _timed_draw(self) -> None:
        start = time.thread_time()
        self._draw()
        self._spent += time.thread_time() - start


def measured(view: View, clock: Callable[[Frame, int], float]) -> Timing:
    """The three kinds of frames by turns; medians of frames, and of rounds of them."""

    def timed(act: Frame) -> float:
        return 1e3 * float(np.median([clock(act, number) for number in range(FRAMES)]))

    rounds = []
    for _ in range(ROUNDS):
        static = timed(view.redraw)
        view.press()
        drag = timed(view.drag)
        assert view.session.is_previewing, "the drag did not take hold"
        view.let_go()
        rounds.append((static, drag, timed(view.slide)))
        view.session.select(Selection.of_lines([LineId(SHEET, HELD)]))
        settle()
    return Timing(*np.median(rounds, axis=0).tolist())


def without_drawing(view: View) -> Timing:
    """The same while everything that draws does nothing."""
    kept = {name: getattr(view.gl, name) for name in DRAWS}
    for name in DRAWS:
        setattr(view.gl, name, lambda *_: None)
    try:
        return measured(view, Besides(view))
    finally:
        for name, function in kept.items():
            setattr(view.gl, name, function)


def main() -> None:
    """Print a table: milliseconds, and ratios to the static redraw."""
    if display() is None or os.environ["QT_QPA_PLATFORM"] == "offscreen":
        print("not measured: the 3D view needs a display, such as xvfb-run gives one")
        return
    prepare_opengl()
    application = QApplication.instance() or QApplication(sys.argv[:1])
    grids = Grid.uniform(SAMPLES), Grid.uniform(SAMPLES)
    space_scene.surface_grids = lambda *_arguments, **_options: grids
    for name, options in LOOKS.items():
        view = View(options)
        if name == next(iter(LOOKS)):
            print(
                f"Python {platform.python_version()}, numpy {np.__version__}, "
                f"PySide6 {PySide6.__version__}, {view.gl.text(RENDERER)}, {os.cpu_count()} cores, "
                f"{SIZE[0]} x {SIZE[1]}, {PLANES} x {PLANES} planes, {SAMPLES} x {SAMPLES} samples"
            )
            print(f"{'':<16}{'static':>9}{'drag':>9}{'ratio':>7}{'s':>9}{'ratio':>7}   (ms)")
        for row, timing in ((name, measured(view, whole)), ("  besides", without_drawing(view))):
            ratios = timing.drag / timing.static, timing.slider / timing.static
            print(
                f"{row:<16}{timing.static:>9.2f}{timing.drag:>9.2f}{ratios[0]:>7.2f}"
                f"{timing.slider:>9.2f}{ratios[1]:>7.2f}"
            )
        view.canvas.close()
        view.canvas.deleteLater()
        settle()
    del application


if __name__ == "__main__":
    main()
