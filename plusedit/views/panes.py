"""The 2D view and the 3D view side by side; each can have the room of both.

The 3D view is made when it is first shown: OpenGL and what draws with it take longer to load than
all the rest of the program.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING, TypeAlias

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, Signal
from PySide6.QtWidgets import QSplitter, QWidget

from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.interaction.gesture import Gestures
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.options import ShownPanes, ViewOptions
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.hands import Hands
from plusedit.views.mesh_evaluation import MeshEvaluation
from plusedit.views.mesh_measuring import MeshMeasuring
from plusedit.views.pair_measuring import PairMeasuring

if TYPE_CHECKING:
    from plusedit.views.space_canvas import SpaceCanvas

Canvas: TypeAlias = "PlaneCanvas | SpaceCanvas"


class Panes(QSplitter):
    """Both views of one session, and which of them is in use."""

    context_menu_requested = Signal(QPoint)
    """a place on the screen"""
    pointer_moved = Signal(object)
    """the coordinates under the pointer: (axis, value) for each that the view can tell"""
    pointer_left = Signal()
    camera_changed = Signal()
    setting_changed = Signal(str, float)
    """a number of an overlay was set in a view, by "overlay.setting" """

    def __init__(self, session: Session) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.changed: Event[()] = Event()
        """other panes are shown, or another one is in use"""
        self.entered: Event[()] = Event()
        """the pointer came into a view, which is in use now"""
        self._session = session
        self._shown: ShownPanes = "2d"
        self._options, self._theme = ViewOptions(), LIGHT
        self.is_animated = True
        """whether the 3D view glides from one camera to the next"""
        self.plane = PlaneCanvas(session, Gestures(session, PlaneCamera((800.0, 600.0))))
        self.space: SpaceCanvas | None = None
        """None until it is first shown, and where there is no OpenGL"""
        self._missing: QWidget | None = None
        self.hands = Hands(self.plane.gestures)
        self.meshes = MeshEvaluation(session, self)
        self.measuring = MeshMeasuring(session, self.meshes, self)
        self.meshes.ready.listen(self._redraw_meshes)
        self.measuring.ready.listen(self._recolor)
        self.pairs = PairMeasuring(session, self)
        self.meshes.ready.listen(self.pairs.begin)
        self.pairs.ready.listen(self._redraw)
        self.setChildrenCollapsible(False)
        self.setHandleWidth(5)
        self._take_in(self.plane)
        self.plane.pointer_moved.connect(self._moved_in_plane)

    # What is shown

    @property
    def shown(self) -> ShownPanes:
        """Which of both views are seen."""
        return self._shown

    def show_panes(self, shown: ShownPanes) -> None:
        """Show one view or both, and use one that is seen."""
        if shown != "2d":
            self._make_space()
        self._shown = shown
        self.plane.setVisible(shown != "3d")
        other = self.space or self._missing
        if other is not None:
            other.setVisible(shown != "2d")
        if shown == "both":
            half = max(self.width() // 2, 1)
            self.setSizes([half, half])
        if self.active.isHidden():
            self.use(self.plane if shown == "2d" or self.space is None else self.space)
        self.changed.emit()

    @property
    def canvases(self) -> "Iterator[Canvas]":
        """The views that have been made."""
        yield self.plane
        if self.space is not None:
            yield self.space

    @property
    def active(self) -> "Canvas":
        """The view in use: where the pointer was last."""
        space = self.space
        return space if space is not None and space.gestures is self.hands.current else self.plane

    def use(self, canvas: "Canvas") -> None:
        """Let menus and keys act in that view."""
        if canvas is not self.active:
            self.hands.use(canvas.gestures)
            self.changed.emit()

    def focus(self) -> None:
        """Give the view in use the keys."""
        self.active.setFocus()

    # What both views are told

    @property
    def options(self) -> ViewOptions:
        """What is shown besides the shapes."""
        return self._options

    def set_options(self, options: ViewOptions) -> None:
        """Show that besides the shapes, in both views."""
        self._options = options
        for canvas in self.canvases:
            canvas.set_options(options)
        self.measuring.set_options(options)
        self.pairs.set_options(options)

    def set_theme(self, theme: Theme) -> None:
        """Draw in those colors."""
        self._theme = theme
        for canvas in self.canvases:
            canvas.set_theme(theme)

    def frame_all(self) -> None:
        """See the whole design, in both views."""
        for canvas in self.canvases:
            canvas.frame_all()

    def frame_selected(self) -> None:
        """See what is selected, in both views."""
        for canvas in self.canvases:
            canvas.frame_selected()

    @property
    def space_camera(self) -> SpaceCamera | None:
        """What the 3D view sees; None before it was ever shown."""
        return None if self.space is None else self.space.camera

    def set_space_camera(self, camera: SpaceCamera | None, *, whole: bool = False) -> None:
        """See that in the 3D view, now or when it is first shown; None: all of the design.

        `whole`: look the way of that camera, but at all of the design.
        """
        self._camera_at_first, self._whole_at_first = camera, whole
        if self.space is not None:
            if camera is None:
                # From the usual side, whatever the design before was seen from.
                self.space.set_camera(SpaceCamera(self.space.camera.size))
                self.space.frame_at_next_paint()
            else:
                self._look_by(self.space, camera)

    _camera_at_first: SpaceCamera | None = None
    _whole_at_first = False

    def _look_by(self, space: "SpaceCanvas", camera: SpaceCamera) -> None:
        space.set_camera(replace(camera, size=space.camera.size))
        if self._whole_at_first:
            space.frame_at_next_paint()

    def _make_space(self) -> None:
        """Make the 3D view, or a pane that says why there is none."""
        if self.space is not None or self._missing is not None:
            return
        from plusedit.views.opengl import opengl_problem

        problem = opengl_problem()
        if problem:
            from plusedit.views.missing_space import MissingSpace

            self._missing = MissingSpace(problem)
            self.addWidget(self._missing)
            return
        from plusedit.views.space_canvas import SpaceCanvas

        gestures = Gestures(self._session, SpaceCamera((800.0, 600.0)))
        self.hands.add(gestures)
        self.space = SpaceCanvas(self._session, gestures)
        self.space.is_animated = self.is_animated
        self.space.set_options(self._options)
        self.space.set_theme(self._theme)
        if self._camera_at_first is not None:
            self._look_by(self.space, self._camera_at_first)
        self._take_in(self.space)
        self.space.pointer_moved.connect(self._moved_in_space)

    def _redraw(self) -> None:
        for canvas in self.canvases:
            canvas.redraw()

    def _redraw_meshes(self) -> None:
        for canvas in self.canvases:
            canvas.redraw_meshes()

    def _recolor(self) -> None:
        """The plane view needs it only where an overlay draws what was found of meshes."""
        for canvas in self.canvases:
            if canvas is not self.plane or self.measuring.serves_overlays:
                canvas.redraw()

    def _take_in(self, canvas: "Canvas") -> None:
        self.addWidget(canvas)
        canvas.installEventFilter(self)
        canvas.pointer_left.connect(self.pointer_left)
        canvas.camera_changed.connect(self.camera_changed)
        canvas.setting_changed.connect(self.setting_changed)
        canvas.context_menu_requested.connect(
            lambda at: self.context_menu_requested.emit(canvas.mapToGlobal(at))
        )

    def _moved_in_plane(self, x: float, y: float) -> None:
        across, up = self.plane.camera.axes
        self.pointer_moved.emit(((across, x), (up, y)))

    def _moved_in_space(self, x: float, y: float, z: float) -> None:
        self.pointer_moved.emit(((0, x), (1, y), (2, z)))

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Enter, QEvent.Type.FocusIn) and not self.hands.is_held:
            for canvas in self.canvases:
                if watched is canvas:
                    self.use(canvas)
            if event.type() == QEvent.Type.Enter:
                self.entered.emit()
        return super().eventFilter(watched, event)
