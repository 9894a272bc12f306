"""The gestures of all views as one: what a window, its menus and its panels speak to.

Every view has gestures of its own, since they know its camera. One of them is in use: that of
the view where the pointer was last. A tool is chosen for all of them alike.
"""

from collections.abc import Callable

from plusedit.events import Event
from plusedit.interaction.gesture import Gestures
from plusedit.interaction.tool import Feedback, NewCurves, Outcome, Pointer, Stage


class Hands:
    """Gestures of one view or more; whoever asks is answered by those in use."""

    def __init__(self, first: Gestures) -> None:
        self.feedback: Event[Feedback] = Event()
        self.tool_changed: Event[str] = Event()
        self.current = first
        """the gestures in use"""
        self._all: list[Gestures] = []
        self._is_choosing = False
        self.add(first)

    def add(self, gestures: Gestures) -> None:
        """Those of one more view; they take the tool that the others have in hand."""
        self._all.append(gestures)
        gestures.new_curves = self.current.new_curves
        if gestures.tool_name != self.tool_name:
            gestures.choose(self.tool_name)
        gestures.feedback.listen(self.feedback.emit)
        gestures.tool_changed.listen(self._chosen)

    def use(self, gestures: Gestures) -> None:
        """Answer by those from now on; what others had begun is given up."""
        if gestures is self.current:
            return
        self.current.cancel()
        gestures.new_curves = self.current.new_curves
        self.current = gestures

    @property
    def tool_name(self) -> str:
        """The name of the chosen tool on its shelf."""
        return self.current.tool_name

    def choose(self, name: str) -> None:
        """Take another tool in every view; what is under way is given up."""
        self.current.choose(name)

    @property
    def is_busy(self) -> bool:
        """Whether a button is down or a drag under way in any view."""
        return any(gestures.is_busy for gestures in self._all)

    @property
    def is_held(self) -> bool:
        """Whether the mouse holds something, so that no other view may be used now."""
        return self.current.is_busy and not self.current.is_modal

    def cancel(self) -> bool:
        """Give up what is under way in any view. True if there was any."""
        given_up = [gestures.cancel() for gestures in self._all]
        return any(given_up)

    def begin(self, drag: str, at: Pointer) -> None:
        """Move, turn or scale what is selected, in the view in use."""
        self.current.begin(drag, at)

    def stage(self) -> Stage:
        """What a tool may know now, in the view in use."""
        return self.current.stage()

    def perform(self, outcome: Outcome) -> None:
        """Make a command a step, or select."""
        self.current.perform(outcome)

    def perform_by(self, make: Callable[[], Outcome]) -> None:
        """Perform what `make` gives."""
        self.cancel()
        self.current.perform_by(make)

    @property
    def new_curves(self) -> NewCurves:
        """What kind of curve the pen draws."""
        return self.current.new_curves

    @new_curves.setter
    def new_curves(self, kind: NewCurves) -> None:
        for gestures in self._all:
            gestures.new_curves = kind

    @property
    def grid_step(self) -> float:
        """What points snap to and arrow keys move by, in the view in use."""
        return self.current.grid_step

    @grid_step.setter
    def grid_step(self, step: float) -> None:
        for gestures in self._all:
            gestures.grid_step = step

    def _chosen(self, name: str) -> None:
        if self._is_choosing:
            return
        self._is_choosing = True
        try:
            for gestures in self._all:
                if gestures.tool_name != name:
                    gestures.choose(name)
        finally:
            self._is_choosing = False
        self.tool_changed.emit(name)
