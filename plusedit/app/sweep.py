"""Playing s: the selected shapes go from s = 0 to the end of their family and back, on and on.

These are previews only: neither history nor files take notice. Any key or click ends it, and all is
as before.
"""

from collections.abc import Callable, Mapping
from math import cos, tau

from PySide6.QtCore import QElapsedTimer, QEvent, QObject, Qt, QTimer
from PySide6.QtWidgets import QApplication

from plusedit.commands.curves import SetMagnitude
from plusedit.document.design import Design, EditError
from plusedit.document.shape import Geometry, ShapeId
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.natural import natural_length_of
from plusedit.scene.options import ViewOptions
from plusedit.scene.overlays import overlays
from plusedit.views.desk import Desk

FAMILY = "s_family"  # the overlay that shows all of a family at once
PERIOD = 4.0  # seconds, there and back
FRAME = 16  # milliseconds
REACH_OF_MESHES = 1.5  # s
NOTHING = "There is no shape whose s could be played."
ENDS = (QEvent.Type.KeyPress, QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick)


class Sweep(QObject):
    """Plays s while it is running."""

    def __init__(
        self,
        desk: Desk,
        targets: Callable[[], Mapping[ShapeId, Geometry]],
        options: Callable[[], ViewOptions],
        parent: QObject,
    ) -> None:
        """`targets` are the shapes that follow; how far they go is a setting of the overlay."""
        super().__init__(parent)
        self._desk, self._targets, self._options = desk, targets, options
        self._highest: dict[ShapeId, float] = {}
        self._shown: Design | None = None
        self._clock = QElapsedTimer()
        self._timer = QTimer(self, interval=FRAME, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._step)

    @property
    def is_running(self) -> bool:
        """Whether s is being played."""
        return self._timer.isActive()

    def toggle(self) -> None:
        """Begin, or end."""
        self.stop() if self.is_running else self._start()

    def stop(self) -> None:
        """End; the shapes are as they were."""
        application = QApplication.instance()
        if not self.is_running or application is None:
            return
        self._timer.stop()
        application.removeEventFilter(self)
        if self._desk.session.design is self._shown:
            self._desk.session.abort()
        self._shown = None

    def show_at(self, seconds: float) -> None:
        """Give all shapes the s that they have so long after the beginning."""
        share = (1.0 - cos(tau * seconds / PERIOD)) / 2.0
        edit = SetMagnitude({i: share * highest for i, highest in self._highest.items()})
        self._desk.session.preview(edit)
        self._shown = self._desk.session.design

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride:
            # The key is to come here as a key, and not to set off what it is a shortcut of.
            event.accept()
            return True
        if event.type() in ENDS:
            self.stop()
            return True
        return super().eventFilter(watched, event)

    def _start(self) -> None:
        self._desk.gestures.cancel()
        self._highest = {i: self._highest_of(shape) for i, shape in self._targets().items()}
        application = QApplication.instance()
        if not self._highest or application is None:
            self._desk.say(NOTHING)
            return
        self._desk.say("Playing s: any key or click ends it.")
        self._shown = self._desk.session.design
        application.installEventFilter(self)
        self._clock.start()
        self._timer.start()

    def _highest_of(self, shape: Geometry) -> float:
        if isinstance(shape, MeshSurface):
            return REACH_OF_MESHES
        reach = overlays[FAMILY].numbers(self._options().settings)["reach"]
        return reach * natural_length_of(shape)

    def _step(self) -> None:
        if self._desk.session.design is not self._shown:
            # Something else has changed the design: this is over.
            self._shown = None
            self.stop()
            return
        try:
            self.show_at(self._clock.elapsed() / 1000.0)
        except EditError as error:
            self.stop()
            self._desk.say(str(error))
