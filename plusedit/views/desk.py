"""What every panel is given: the session, a way to edit it, and a way to speak."""

from collections.abc import Callable, Mapping

from PySide6.QtWidgets import QWidget

from plusedit.document.design import EditError
from plusedit.document.map_record import MapRecord
from plusedit.document.selection import Selection
from plusedit.document.session import Edit, Session
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.events import Event
from plusedit.geometry.curve import PlusCurve
from plusedit.interaction.spotting import Spot
from plusedit.interaction.tool import Pointer, Stage
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.hands import Hands
from plusedit.views.lengths import Lengths


class Desk:
    """The session as panels see it. They hold no data: they show the design and send commands."""

    def __init__(self, session: Session, gestures: Hands) -> None:
        self.session = session
        self.gestures = gestures
        self.said: Event[str] = Event()
        """a sentence for the status bar"""
        self.pointed: Event[str, str] = Event()
        """numbers of the place under the pointer, and of what is there, told by a panel"""
        self.hinted: Event[str] = Event()
        """what can be done where the pointer is, told by a panel"""
        self.entered: Event[QWidget] = Event()
        """the pointer came into a view of a panel, which takes keys"""
        self.map_asked: Event[ShapeId, MapRecord] = Event()
        """a mesh is to get the parameters of another map, which takes its time"""
        self.pointer_moved: Event[Pointer | None, Stage] = Event()
        """the pointer is there in the view in use, or in none; told while a panel listens"""
        self.marked: Event[Spot | None] = Event()
        """a panel points at a place of a shape, which views are to mark"""
        self.lengths = Lengths()
        self.theme: Theme = LIGHT
        self.theme_changed: Event[Theme] = Event()

    def commit(self, edit: Edit) -> str:
        """Make `edit` a step of the history; why it can't be done, or an empty text."""
        self.gestures.cancel()
        return self._tried(lambda: self.session.commit(edit))

    def preview(self, edit: Edit) -> str:
        """Show `edit` on top of the design; why it can't be done, or an empty text."""
        return self._tried(lambda: self.session.preview(edit))

    def select(self, selection: Selection) -> None:
        """Select something, after whatever is under way has been dropped."""
        self.gestures.cancel()
        self.session.select(selection)

    def say(self, sentence: str) -> None:
        """Show a sentence in the status bar."""
        self.said.emit(sentence)

    def set_theme(self, theme: Theme) -> None:
        """Tell everyone who draws of another theme."""
        self.theme = theme
        self.theme_changed.emit(theme)

    def selected_curves(self) -> Mapping[ShapeId, PlusCurve]:
        """The curves among the selected shapes, back to front."""
        chosen = self.session.selection.shapes
        return {i: curve for i, curve in self.session.design.curves() if i in chosen}

    def selected_shapes(self) -> Mapping[ShapeId, PlusGeometry]:
        """The curves and surfaces among the selected shapes, back to front."""
        chosen = self.session.selection.shapes
        return {i: geometry for i, geometry in self.session.design.drawn() if i in chosen}

    @property
    def leading(self) -> tuple[ShapeId, PlusGeometry] | None:
        """The curve or surface that a panel speaks of that shows one only.

        That with the active control line, else the first selected, else the only one there is.
        """
        shapes = dict(self.session.design.drawn())
        chosen = [i for i in shapes if i in self.session.selection.shapes]
        active = self.session.selection.active
        if active is not None and active.shape in shapes:
            return active.shape, shapes[active.shape]
        found = chosen if chosen or len(shapes) != 1 else [*shapes]
        return (found[0], shapes[found[0]]) if found else None

    def _tried(self, act: Callable[[], None]) -> str:
        try:
            act()
        except EditError as error:
            self.say(str(error))
            return str(error)
        return ""
