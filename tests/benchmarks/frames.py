"""From a mouse event to the painted frame: a drag of one curve among 1, 10 and 100.

    .venv/bin/python tests/benchmarks/frames.py

A frame is a mouse move sent to the canvas and everything that follows until the pixels are in
the window's memory. The peer paints all shapes anew in every frame, as a canvas does that keeps
nothing from one frame to the next. Both take turns. Runs without a display; with QT_QPA_PLATFORM
set to xcb it shows a window.
"""

import os
import platform
import sys
import time
from dataclasses import dataclass

import numpy as np

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import PySide6
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from plusedit.document.design import Design
from plusedit.document.selection import Selection
from plusedit.document.session import Session
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.bases import families
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.strata import Strata

SIZE = (1280, 800)
LINES = 10
MOVES = 200
ROUNDS = 3


@dataclass(frozen=True)
class Timing:
    """Seconds."""

    median: float
    high: float
    """the 95th percentile"""


def scene(count: int) -> Design:
    """Open B-spline+ curves of ten lines, in rows and columns over the whole view."""
    random = np.random.default_rng(1)
    columns = int(np.ceil(np.sqrt(count * SIZE[0] / SIZE[1])))
    rows = int(np.ceil(count / columns))
    cell = np.array([SIZE[0] / columns, SIZE[1] / rows])
    shapes = {}
    for index in range(count):
        corner = np.array([index % columns, index // columns]) * cell
        points = corner + cell * (0.1 + 0.8 * random.random((LINES, 2)))
        lines = ControlLines.of(points)
        curve = PlusCurve(families["bspline"].of_size(LINES), lines, float(cell.mean()))
        shapes[ShapeId(f"c{index}")] = Shape(curve, f"Curve {index}")
    return Design(shapes)


def timed(count: int, *, forced: bool) -> Timing:
    """A drag of one control point of the last curve of the scene."""
    design = scene(count)
    session = Session(design)
    canvas = PlaneCanvas(session, Gestures(session, PlaneCamera(SIZE)))
    canvas.resize(*SIZE)
    canvas.show()
    settle()
    last = list(design)[-1]
    session.select(Selection.of_shapes([last]))
    settle()
    grabbed = canvas.camera.to_screen(design.curve(last).lines.points[4:5])[0]
    send(canvas, QEvent.Type.MouseMove, grabbed, Qt.MouseButton.NoButton)
    send(canvas, QEvent.Type.MouseButtonPress, grabbed, Qt.MouseButton.LeftButton)
    seconds = []
    for turn in np.linspace(0.1, 11.0, MOVES):
        at = grabbed + 60.0 * np.array([np.sin(turn), 1.0 - np.cos(turn)])
        if forced:
            canvas._strata = Strata()
        start = time.perf_counter()
        send(canvas, QEvent.Type.MouseMove, at, Qt.MouseButton.LeftButton)
        settle()
        seconds.append(time.perf_counter() - start)
    send(canvas, QEvent.Type.MouseButtonRelease, at, Qt.MouseButton.LeftButton)
    assert session.undo_label is not None, "the drag did not take hold"
    canvas.close()
    canvas.deleteLater()
    settle()
    return Timing(float(np.median(seconds)), float(np.percentile(seconds, 95)))


def send(canvas: PlaneCanvas, kind: QEvent.Type, at: np.ndarray, held: Qt.MouseButton) -> None:
    """One mouse event, as the window system sends it."""
    is_move = kind == QEvent.Type.MouseMove
    place = QPointF(*at)
    event = QMouseEvent(
        kind,
        place,
        canvas.mapToGlobal(place),
        Qt.MouseButton.NoButton if is_move else held,
        held if kind != QEvent.Type.MouseButtonRelease else Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
    )
    QApplication.sendEvent(canvas, event)


def settle() -> None:
    """Let Qt do what is due: the paint event among it."""
    QApplication.processEvents()


def main() -> None:
    """Print a table: milliseconds, and the ratio to the forced repaint."""
    application = QApplication(sys.argv[:1])
    print(
        f"Python {platform.python_version()}, numpy {np.__version__}, "
        f"PySide6 {PySide6.__version__}, {application.platformName()}, {os.cpu_count()} cores, "
        f"{SIZE[0]} x {SIZE[1]}, {LINES} control lines a curve"
    )
    print(f"{'curves':>7}{'median':>10}{'p95':>10}{'forced':>10}{'p95':>10}{'ratio':>8}   (ms)")
    for count in (1, 10, 100):
        runs = [(timed(count, forced=False), timed(count, forced=True)) for _ in range(ROUNDS)]
        ours = Timing(*(float(np.median([getattr(r[0], f) for r in runs])) for f in FIELDS))
        peer = Timing(*(float(np.median([getattr(r[1], f) for r in runs])) for f in FIELDS))
        numbers = (ours.median, ours.high, peer.median, peer.high)
        cells = "".join(f"{1e3 * number:>10.2f}" for number in numbers)
        print(f"{count:>7}{cells}{ours.median / peer.median:>8.2f}")


FIELDS = ("median", "high")

if __name__ == "__main__":
    main()
