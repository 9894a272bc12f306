"""From pointers and keys to previews and steps of a session.

One drag at a time. Its first answer comes from the press, every further one from a move; each
command is shown as a preview, the last is committed when the button is let go. Given up, the
design is the very object it was before.
"""

from collections.abc import Callable
from dataclasses import replace
from math import hypot

from plusedit.document.design import EditError
from plusedit.document.selection import Selection
from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.interaction.dragging import Dragging
from plusedit.interaction.modal import modal_drags
from plusedit.interaction.running import means_something
from plusedit.interaction.tool import (
    Feedback,
    Held,
    NewCurves,
    Outcome,
    Pointer,
    Stage,
    Tool,
    tools,
)
from plusedit.scene.camera import Camera
from plusedit.scene.options import ViewOptions

DRAG_STARTS_AT = 3.0  # pixels; a press and release within it is a click

FIRST_TOOL = "select"


class Gestures:
    """Turns pointers into drags, clicks, previews and steps of a session."""

    def __init__(self, session: Session, camera: Camera, tool: str = FIRST_TOOL) -> None:
        self.feedback: Event[Feedback] = Event()
        self.tool_changed: Event[str] = Event()
        self.panned: Event[float, float] = Event()
        """pixels to the right and downwards by which the view is to shift"""
        self.camera = camera
        self.options = ViewOptions()
        self.new_curves = NewCurves()
        self.grid_step = 1.0
        self._session = session
        self._tool_name = tool
        self._tool: Tool = tools[tool]()
        self._pressed: Pointer | None = None
        self._pointer: Pointer | None = None
        self._dragging = Dragging(session, self.feedback, self.panned)
        self._dragging.ended.listen(self._look_again)
        session.changed.listen(lambda old, new: self._look_again())
        session.selected.listen(lambda old, new: self._look_again())

    # What a view tells

    def press(self, at: Pointer) -> None:
        """The left button went down; during a drag begun by a key this accepts it."""
        self._pointer = at
        if self._dragging.is_modal:
            self._dragging.follow(at, self.camera)
            self._dragging.accept()
        elif not self._dragging.is_on:
            self._pressed = at

    def move(self, to: Pointer) -> None:
        """The pointer moved, with the button down or up."""
        self._pointer = to
        if not self._dragging.is_on and self._pressed is not None:
            start = self._pressed
            if hypot(to.x - start.x, to.y - start.y) < DRAG_STARTS_AT:
                return
            self._pressed = None
            self._dragging.start(self._tool.drag, start, self.stage(), modal=False)
        if self._dragging.is_on:
            self._dragging.follow(to, self.camera)
        else:
            self._look_again()

    def release(self, at: Pointer) -> None:
        """The left button was let go: the drag is over, or it was a click."""
        self._pointer = at
        if self._dragging.is_on:
            if not self._dragging.is_modal:
                self._dragging.follow(at, self.camera)
                self._dragging.accept()
            return
        if self._pressed is not None:
            self._pressed = None
            self.perform_by(lambda: self._tool.click(at, self.stage()))
            self._look_again()

    def double_click(self, at: Pointer) -> None:
        """The second press of a double click; to a tool that has no use for it, just a press."""
        if self._dragging.is_on:
            self.press(at)
            return
        self._pressed, self._pointer = None, at
        try:
            outcome = self._tool.double_click(at, self.stage())
        except EditError as error:
            self.feedback.emit(Feedback(error=str(error)))
            return
        if outcome is None:
            self.press(at)
        else:
            self.perform(outcome)
            self._look_again()

    def hold(self, held: Held) -> None:
        """Other modifiers are held now, with the pointer where it was."""
        if self._pointer is not None and self._pointer.held != held:
            self.move(replace(self._pointer, held=held))

    def leave(self) -> None:
        """The pointer left the view; a drag goes on."""
        self._pointer = None
        if not self._dragging.is_on:
            self.feedback.emit(Feedback())

    def begin(self, drag: str, at: Pointer) -> None:
        """Move, turn or scale what is selected, as "move", "turn" or "scale", from now on."""
        self.cancel()
        self._pointer = at
        self._dragging.start(modal_drags[drag], at, self.stage(), modal=True)
        self._dragging.follow(at, self.camera)

    def takes(self, key: str, held: Held = Held.NONE) -> bool:
        """Whether `key` would do something here, so that no shortcut may take it."""
        key, chord = _name(key), bool(held & (Held.CTRL | Held.ALT))
        if self.is_busy:
            # Ctrl and Alt are held to snap and to stretch; only undo is never meant for a drag.
            return means_something(key) and not (chord and key == "Z")
        if chord:
            return False
        return key in self._tool.keys(self.stage()) or self._leaves_tool(key)

    def _leaves_tool(self, key: str) -> bool:
        """Whether the key goes back to the first tool, the chosen one having no use for it."""
        return key == "Escape" and self._tool_name != FIRST_TOOL

    def key(self, key: str, held: Held = Held.NONE) -> bool:
        """A key was pressed; true if it was meant for the drag or the tool."""
        key = _name(key)
        if not self.takes(key, held):
            return False
        if self._dragging.is_on:
            if key == "Escape":
                self.cancel()
            else:
                self._dragging.key(key, held, self.camera)
        elif self._pressed is not None:
            if key == "Escape":
                self._pressed = None
        elif key not in self._tool.keys(self.stage()):
            self.choose(FIRST_TOOL)
        else:
            self.perform_by(lambda: self._tool.key(key, self.stage()))
            self._look_again()
        return True

    def wheel(self, notches: float) -> bool:
        """The wheel was turned, away from the hand if positive; true if it was meant for a drag."""
        return self._dragging.widen(notches, self.camera)

    # What a window asks for

    @property
    def tool_name(self) -> str:
        """The name of the chosen tool on its shelf."""
        return self._tool_name

    @property
    def is_busy(self) -> bool:
        """Whether a button is down or a drag under way."""
        return self._dragging.is_on or self._pressed is not None

    @property
    def is_modal(self) -> bool:
        """Whether a drag begun by a key is under way, which no button holds."""
        return self._dragging.is_modal

    def choose(self, name: str) -> None:
        """Take another tool; what is under way is given up. KeyError if there is none such."""
        tool = tools[name]()
        self.cancel()
        self._tool.reset()
        self._tool, self._tool_name = tool, name
        self.tool_changed.emit(name)
        self._look_again()

    def stage(self) -> Stage:
        """What a tool may know now."""
        return Stage(
            self._session.committed,
            self.camera,
            self._session.selection,
            self.options,
            self.new_curves,
            self.grid_step,
        )

    def perform(self, outcome: Outcome) -> None:
        """Make a command a step, or select; why it can't be done goes to `feedback`."""
        self.perform_by(lambda: outcome)

    def perform_by(self, make: Callable[[], Outcome]) -> None:
        """Perform what `make` gives; its EditError is told in the same way."""
        self.cancel()
        try:
            outcome = make()
            if isinstance(outcome, Selection):
                self._session.select(outcome)
            elif outcome is not None:
                self._session.commit(outcome)
        except EditError as error:
            self.feedback.emit(Feedback(error=str(error)))

    def cancel(self) -> bool:
        """Give up what is under way: design and selection are as before. True if there was any."""
        was_busy = self.is_busy
        self._pressed = None
        if self._dragging.is_on:
            self._tool.reset()
            self._dragging.cancel()
            self._look_again()
        return was_busy

    def _look_again(self) -> None:
        """Say and show what is under the pointer now, unless a drag or nobody is there."""
        if self._pointer is None or self.is_busy:
            return
        self.feedback.emit(self._tool.hover(self._pointer, self.stage()))


def _name(key: str) -> str:
    """The key as it is called here: letters are capitals, "Return" is "Enter"."""
    if len(key) == 1:
        return key.upper()
    return "Enter" if key == "Return" else key
