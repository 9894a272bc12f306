"""What is shown and how: switches, projection and theme, kept with designs and in settings."""

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
        self.set_options(options_of(settings.view))  # type: ignore[arg-type]

    @property
    def options(self) -> ViewOptions:
        """The switches as they are."""
        return self._canvas.options

    @property
    def projection(self) -> Projection:
        """Along which axis the view looks."""
        return self._canvas.camera.projection

    def set_options(self, options: ViewOptions) -> None:
        """Show that, and begin with it the next time."""
        self._canvas.set_options(options)
        self._settings.view = view_tree(options, old=NOTHING)
        self.changed.emit()

    def toggle_overlay(self, name: str) -> None:
        """Switch an overlay on or off."""
        self.set_options(self.options.toggled(name))

    def toggle(self, name: str) -> None:
        """Switch "grid", "rulers" or "snap" on or off."""
        value = not getattr(self.options, name)
        self.set_options(replace(self.options, **{name: value}))  # type: ignore[arg-type]

    def set_handles(self, handles: Handles) -> None:
        """Choose whose control lines are shown."""
        self.set_options(replace(self.options, handles=handles))

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
        """Set the view up as the design says; an untitled one leaves the switches as they are."""
        if design.view:
            self._canvas.set_options(options_of(design.view))
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
