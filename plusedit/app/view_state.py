"""What is shown and how: switches, projection and theme, kept with designs and in settings."""

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtWidgets import QApplication

from plusedit.app.settings import Settings
from plusedit.document.design import Design
from plusedit.document.shape import NOTHING
from plusedit.events import Event
from plusedit.scene.camera import PlaneCamera, Projection
from plusedit.scene.options import Handles, ViewOptions, camera_of, options_of, view_tree
from plusedit.scene.theme import Theme
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.desk import Desk
from plusedit.views.look import apply_look, theme_for


class ViewState:
    """The one place that changes what the canvas shows besides the design."""

    def __init__(self, desk: Desk, canvas: PlaneCanvas, settings: Settings) -> None:
        self.changed: Event[()] = Event()
        self._desk, self._canvas, self._settings = desk, canvas, settings
        canvas.camera_changed.connect(self._keep_step)
        canvas.set_options(self._own())

    @property
    def options(self) -> ViewOptions:
        """The switches as they are."""
        return self._canvas.options

    @property
    def projection(self) -> Projection:
        """Along which axis the view looks."""
        return self._canvas.camera.projection

    def toggle_overlay(self, name: str) -> None:
        """Switch an overlay on or off."""
        is_on = name not in self.options.overlays
        self._switch(lambda options: options.with_overlay(name, is_on))

    def toggle(self, name: str) -> None:
        """Switch "grid", "rulers" or "snap" on or off."""
        value = not getattr(self.options, name)
        self._switch(lambda options: replace(options, **{name: value}))  # type: ignore[arg-type]

    def set_handles(self, handles: Handles) -> None:
        """Choose whose control lines are shown."""
        self._switch(lambda options: replace(options, handles=handles))

    def _switch(self, change: Callable[[ViewOptions], ViewOptions]) -> None:
        """Change what is shown now, and what designs begin with that say nothing of it.

        Not the one into the other: else the switches of a design that was only looked at would
        stay for all others.
        """
        self._canvas.set_options(change(self.options))
        self._settings.view = view_tree(change(self._own()), old=NOTHING)
        self.changed.emit()

    def _own(self) -> ViewOptions:
        """The person's own switches."""
        return options_of(self._settings.view)  # type: ignore[arg-type]

    def set_projection(self, projection: Projection) -> None:
        """Look along another axis."""
        self._desk.gestures.cancel()
        self._canvas.set_projection(projection)
        self.changed.emit()

    def set_look(self, look: str) -> None:
        """Give the whole program a look: "light", "dark" or "system"."""
        self._settings.look = look
        self._desk.set_theme(look_of_program(look))
        self._canvas.set_theme(self._desk.theme)
        self.changed.emit()

    def kept_with(self, design: Design) -> Design:
        """The design with the view as it is now."""
        tree = view_tree(self.options, self._canvas.camera, old=design.view)
        return replace(design, view=tree)

    def show_design(self, design: Design) -> None:
        """Set the view up as the design says; as the person likes it where it says nothing."""
        self._canvas.set_options(options_of(design.view) if design.view else self._own())
        camera = camera_of(design.view, self._canvas.camera.size)
        if camera is not None:
            self._canvas.set_camera(camera)
        elif len(design):
            self._canvas.set_projection("top")
            self._canvas.frame_all()
        else:
            self._canvas.set_camera(PlaneCamera(self._canvas.camera.size))
        self.changed.emit()

    def _keep_step(self) -> None:
        # The canvas offers the grid that is seen; a step of one's own comes before it.
        if (step := self._settings.grid_step) is not None:
            self._desk.gestures.grid_step = step


def look_of_program(look: str) -> Theme:
    """Give all of the program that look; the theme that it came to."""
    application = QApplication.instance()
    if isinstance(application, QApplication):
        return apply_look(application, look)
    return theme_for(look)
