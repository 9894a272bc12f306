"""What is shown and how: panes, switches, cameras and theme, kept with designs and in settings."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
from PySide6.QtWidgets import QApplication

from plusedit.app.settings import Settings
from plusedit.document.design import Design
from plusedit.document.shape import NOTHING
from plusedit.events import Event
from plusedit.scene.camera import AXES, PlaneCamera, Projection
from plusedit.scene.options import (
    Handles,
    ShownPanes,
    ViewOptions,
    camera_of,
    options_of,
    panes_of,
    space_camera_of,
    view_tree,
)
from plusedit.scene.space_camera import STANDARD
from plusedit.scene.theme import Theme
from plusedit.views.desk import Desk
from plusedit.views.look import apply_look, theme_for
from plusedit.views.panes import Panes

TITLES = {"2d": "2D view", "3d": "3D view", "both": "Both views"}


class ViewState:
    """The one place that changes what the views show besides the design."""

    def __init__(self, desk: Desk, panes: Panes, settings: Settings) -> None:
        self.changed: Event[()] = Event()
        self._desk, self._panes, self._settings = desk, panes, settings
        self._is_chosen = False
        """whether a person chose the panes for this design, or the design says which"""
        panes.camera_changed.connect(self._keep_step)
        panes.setting_changed.connect(self.set_setting)
        panes.changed.listen(self.changed.emit)
        panes.is_animated = settings.animated
        panes.set_options(self._own())
        desk.session.stepped.listen(self._suit)

    # Panes and cameras

    @property
    def panes(self) -> ShownPanes:
        """Which views are seen."""
        return self._panes.shown

    def show_panes(self, panes: ShownPanes) -> None:
        """Show the 2D view, the 3D view or both, as a person asked for."""
        self._desk.gestures.cancel()
        self._is_chosen = True
        self._panes.show_panes(panes)
        self._panes.focus()

    @property
    def looks_from(self) -> str:
        """The name of the view that the pane in use has; empty where it has none."""
        camera = self._panes.active.camera
        if isinstance(camera, PlaneCamera):
            return camera.projection
        now = camera.yaw, camera.pitch
        return next((name for name, way in STANDARD.items() if np.allclose(way, now)), "")

    def look_from(self, name: str) -> None:
        """Turn the view in use to that side."""
        self._desk.gestures.cancel()
        active = self._panes.active
        if active is self._panes.plane:
            if name not in AXES:
                self._desk.say("The 2D view looks from the top, the front or the right.")
                return
            self.set_projection(name)
            return
        self._panes.space.look_from(name)  # type: ignore[union-attr]
        self.changed.emit()

    @property
    def is_perspective(self) -> bool:
        """Whether the 3D view shows far things smaller."""
        camera = self._panes.space_camera
        return camera is not None and camera.perspective

    def toggle_perspective(self) -> None:
        """Perspective or parallel projection in the 3D view."""
        if self._panes.space is not None:
            self._panes.space.toggle_perspective()
            self.changed.emit()

    @property
    def projection(self) -> Projection:
        """Along which axis the 2D view looks."""
        return self._panes.plane.camera.projection

    def set_projection(self, projection: Projection) -> None:
        """Look along another axis in the 2D view."""
        self._desk.gestures.cancel()
        self._panes.plane.set_projection(projection)
        self.changed.emit()

    def set_animated(self, is_animated: bool) -> None:
        """Whether cameras glide from one view to the next."""
        self._settings.animated = self._panes.is_animated = is_animated
        if self._panes.space is not None:
            self._panes.space.is_animated = is_animated

    # Switches

    @property
    def options(self) -> ViewOptions:
        """The switches as they are."""
        return self._panes.options

    def toggle_overlay(self, name: str) -> None:
        """Switch an overlay on or off."""
        is_on = name not in self.options.overlays
        self._switch(lambda options: options.with_overlay(name, is_on))

    def toggle(self, name: str) -> None:
        """Switch "grid", "rulers", "snap", "ground", ... on or off."""
        value = not getattr(self.options, name)
        self._switch(lambda options: replace(options, **{name: value}))  # type: ignore[arg-type]

    def set_option(self, name: str, value: object) -> None:
        """Give one of the options a value."""
        self._switch(lambda options: replace(options, **{name: value}))  # type: ignore[arg-type]

    def set_setting(self, name: str, value: float) -> None:
        """Give an overlay a number, by "overlay.setting"."""
        self._switch(lambda options: options.with_setting(name, value))

    def set_handles(self, handles: Handles) -> None:
        """Choose whose control lines are shown."""
        self._switch(lambda options: replace(options, handles=handles))

    def _switch(self, change: Callable[[ViewOptions], ViewOptions]) -> None:
        """Change what is shown now, and what designs begin with that say nothing of it.

        Not the one into the other: else the switches of a design that was only looked at would
        stay for all others.
        """
        self._panes.set_options(change(self.options))
        self._settings.view = view_tree(change(self._own()), old=NOTHING)
        self.changed.emit()

    def _own(self) -> ViewOptions:
        """The person's own switches."""
        return options_of(self._settings.view)  # type: ignore[arg-type]

    def set_look(self, look: str) -> None:
        """Give the whole program a look: "light", "dark" or "system"."""
        self._settings.look = look
        self._desk.set_theme(look_of_program(look))
        self._panes.set_theme(self._desk.theme)
        self.changed.emit()

    # Designs

    def kept_with(self, design: Design) -> Design:
        """The design with the view as it is now."""
        tree = view_tree(
            self.options,
            self._panes.plane.camera,
            old=design.view,
            camera_3d=self._panes.space_camera,
            panes=self._panes.shown if self._is_chosen else None,
        )
        return replace(design, view=tree)

    def show_design(self, design: Design, *, whole: bool = False) -> None:
        """Set the view up as the design says; as the person likes it where it says nothing.

        `whole`: from the side that it says, see all of it, whatever the size of the view.
        """
        self._panes.set_options(options_of(design.view) if design.view else self._own())
        said = panes_of(design.view)
        self._is_chosen = said is not None
        self._panes.show_panes(said or ("both" if design.is_spatial else "2d"))
        self._show_plane(design)
        self._panes.set_space_camera(space_camera_of(design.view, (800.0, 600.0)), whole=whole)
        self.changed.emit()

    def _show_plane(self, design: Design) -> None:
        plane = self._panes.plane
        camera = camera_of(design.view, plane.camera.size)
        if camera is not None:
            plane.set_camera(camera)
        elif len(design):
            plane.set_projection("top")
            plane.frame_at_next_paint()
        else:
            plane.set_camera(PlaneCamera(plane.camera.size))

    def _suit(self) -> None:
        """Show the 3D view once there is something in space, unless a person chose otherwise."""
        design = self._desk.session.committed
        if not self._is_chosen and self._panes.shown == "2d" and design.is_spatial:
            self._panes.show_panes("both")

    def _keep_step(self) -> None:
        # A view offers the grid that is seen; a step of one's own comes before it.
        if (step := self._settings.grid_step) is not None:
            self._desk.gestures.grid_step = step


def look_of_program(look: str) -> Theme:
    """Give all of the program that look; the theme that it came to."""
    application = QApplication.instance()
    if isinstance(application, QApplication):
        return apply_look(application, look)
    return theme_for(look)
