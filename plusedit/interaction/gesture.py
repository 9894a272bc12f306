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
from plusedit.interaction.modal import modal_drags
from plusedit.interaction.running import USUAL_REACH, Running, means_something
from plusedit.interaction.tool import (
    Drag,
    Feedback,
    Held,
    NewCurves,
    Outcome,
    Pointer,
    Shown,
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
        self._running: Running | None = None
        self._pointer: Pointer | None = None
        self._reach = USUAL_REACH
        session.changed.listen(lambda old, new: self._look_again())
        session.selected.listen(lambda old, new: self._look_again())

    # What a view tells

    def press(self, at: Pointer) -> None:
        """The left button went down; during a drag begun by a key this accepts it."""
        self._pointer = at
        if self._running is not None:
            if self._running.modal:
                self._follow(at)
                self._finish()
            return
        self._pressed = at

    def move(self, to: Pointer) -> None:
        """The pointer moved, with the button down or up."""
        self._pointer = to
        if self._running is None and self._pressed is not None:
            start = self._pressed
            if hypot(to.x - start.x, to.y - start.y) < DRAG_STARTS_AT:
                return
            self._pressed = None
            self._start(self._tool.drag, start, modal=False)
        if self._running is not None:
            self._follow(to)
        else:
            self._look_again()

    def release(self, at: Pointer) -> None:
        """The left button was let go: the drag is over, or it was a click."""
        self._pointer = at
        if self._running is not None:
            if not self._running.modal:
                self._follow(at)
                self._finish()
            return
        if self._pressed is not None:
            self._pressed = None
            self.perform_by(lambda: self._tool.click(at, self.stage()))
            self._look_again()

    def double_click(self, at: Pointer) -> None:
        """The second press of a double click; to a tool that has no use for it, just a press."""
        if self._running is not None:
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
        if self._running is None:
            self.feedback.emit(Feedback())

    def begin(self, drag: str, at: Pointer) -> None:
        """Move, turn or scale what is selected, as "move", "turn" or "scale", from now on."""
        self.cancel()
        self._pointer = at
        self._start(modal_drags[drag], at, modal=True)
        if self._running is not None:
            self._follow(at)

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
        if self._running is not None:
            self._key_of_drag(self._running, key, held)
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
        running = self._running
        if running is None or not running.widen(notches):
            return False
        self._follow(running.pointer)
        return True

    # What a window asks for

    @property
    def tool_name(self) -> str:
        """The name of the chosen tool on its shelf."""
        return self._tool_name

    @property
    def is_busy(self) -> bool:
        """Whether a button is down or a drag under way."""
        return self._running is not None or self._pressed is not None

    @property
    def is_modal(self) -> bool:
        """Whether a drag begun by a key is under way, which no button holds."""
        return self._running is not None and self._running.modal

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
        running, was_busy = self._running, self.is_busy
        self._pressed = self._running = None
        if running is not None:
            running.drag.close()
            self._tool.reset()
            self._session.abort()
            self._session.select(running.selection)
            self._look_again()
        return was_busy

    # Drags

    def _start(self, make: Callable[[Pointer, Stage], Drag], at: Pointer, *, modal: bool) -> None:
        stage = self.stage()
        try:
            drag = make(at, stage)
            first = next(drag)
        except StopIteration:
            return
        except EditError as error:
            self.feedback.emit(Feedback(error=str(error)))
            return
        self._running = Running(drag, stage, modal, at, stage.selection, self._reach)
        self._show(self._running, first)

    def _follow(self, to: Pointer) -> None:
        running = self._running
        if running is None:
            return
        if self._session.committed is not running.stage.design:
            # Undo, redo or another design in the midst of a drag: it has lost its ground.
            self._running = None
            running.drag.close()
            return
        try:
            shown = running.answer(to, self.camera)
        except StopIteration:
            self._finish()
            return
        except EditError as error:
            self.feedback.emit(Feedback(error=str(error)))
            return
        self._show(running, shown)

    def _show(self, running: Running, shown: Shown) -> None:
        outcome, feedback = shown.outcome, shown.feedback
        try:
            if isinstance(outcome, Selection):
                self._session.select(outcome)
            elif outcome is not None:
                self._session.preview(outcome)
                running.command = outcome
            running.command = shown.at_end or running.command
        except EditError as error:
            # What was shown before stays, and is what would be committed.
            feedback = replace(feedback, error=str(error))
        if shown.pan != (0.0, 0.0):
            running.pans = True
            self.panned.emit(*shown.pan)
        self.feedback.emit(feedback)

    def _finish(self) -> None:
        running, self._running = self._running, None
        if running is None:
            return
        running.drag.close()
        self._reach = running.reach
        command = running.command
        if command is None:
            self._session.abort()
        else:
            try:
                self._session.commit(command)
            except EditError as error:
                # Only what has not been shown before can fail.
                self._session.abort()
                self.feedback.emit(Feedback(error=str(error)))
                return
        self._look_again()

    def _key_of_drag(self, running: Running, key: str, held: Held) -> None:
        if key == "Escape":
            self.cancel()
        elif key == "Enter":
            self._finish()
        elif running.takes(key, held):
            self._follow(running.pointer)

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
