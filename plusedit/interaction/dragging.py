"""From the answers of a drag to previews of a session, and in the end to a step of it."""

from collections.abc import Callable
from dataclasses import replace

from plusedit.document.design import EditError
from plusedit.document.selection import Selection
from plusedit.document.session import Session
from plusedit.events import Event
from plusedit.interaction.running import USUAL_REACH, Running
from plusedit.interaction.tool import Drag, Feedback, Held, Pointer, Shown, Stage
from plusedit.scene.camera import Camera


class Dragging:
    """One drag at a time, or none: what it says is shown, and why something can't be done."""

    def __init__(
        self, session: Session, feedback: Event[Feedback], panned: Event[float, float]
    ) -> None:
        self.ended: Event[()] = Event()
        """it was accepted; not emitted where that failed"""
        self._session = session
        self._feedback = feedback
        self._panned = panned
        self._running: Running | None = None
        self._reach = USUAL_REACH

    @property
    def is_on(self) -> bool:
        """Whether a drag is under way."""
        return self._running is not None

    @property
    def is_modal(self) -> bool:
        """Whether it was begun by a key, so that no button holds it."""
        return self._running is not None and self._running.modal

    def start(
        self, make: Callable[[Pointer, Stage], Drag], at: Pointer, stage: Stage, *, modal: bool
    ) -> None:
        """Begin the drag that `make` gives; there may be nothing to be dragged."""
        try:
            drag = make(at, stage)
            first = next(drag)
        except StopIteration:
            return
        except EditError as error:
            self._feedback.emit(Feedback(error=str(error)))
            return
        self._running = Running(drag, stage, modal, at, stage.selection, self._reach)
        self._show(self._running, first)

    def follow(self, to: Pointer, camera: Camera) -> None:
        """Go on to the pointer, as the camera sees it now."""
        running = self._running
        if running is None:
            return
        if self._session.committed is not running.stage.design:
            # Undo, redo or another design in the midst of a drag: it has lost its ground.
            self._running = None
            running.drag.close()
            return
        try:
            shown = running.answer(to, camera)
        except StopIteration:
            self.accept()
            return
        except EditError as error:
            self._feedback.emit(Feedback(error=str(error)))
            return
        self._show(running, shown)

    def key(self, key: str, held: Held, camera: Camera) -> None:
        """Enter accepts the drag; other keys lock axes, or are numbers that it takes."""
        running = self._running
        if key == "Enter":
            self.accept()
        elif running is not None and running.takes(key, held):
            self.follow(running.pointer, camera)

    def widen(self, notches: float, camera: Camera) -> bool:
        """Let a soft move reach farther, or less far; false if it is none."""
        running = self._running
        if running is None or not running.widen(notches):
            return False
        self.follow(running.pointer, camera)
        return True

    def accept(self) -> None:
        """End the drag, and make what was shown last a step."""
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
                self._feedback.emit(Feedback(error=str(error)))
                return
        self.ended.emit()

    def cancel(self) -> None:
        """Give the drag up: design and selection are as before."""
        running, self._running = self._running, None
        if running is not None:
            running.drag.close()
            self._session.abort()
            self._session.select(running.selection)

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
            self._panned.emit(*shown.pan)
        self._feedback.emit(feedback)
