"""Move the view."""

from typing import ClassVar

from plusedit.interaction.tool import Drag, Feedback, Outcome, Pointer, Shown, Stage, register

HINT = "Drag to move the view · wheel zooms · F frames what is selected, Home all"


@register("pan")
class Pan:
    """The hand: nothing is edited."""

    title: ClassVar[str] = "Pan"
    shortcut: ClassVar[str] = "H"
    order: ClassVar[int] = 40

    def drag(self, start: Pointer, stage: Stage) -> Drag:
        """The view follows the pointer."""
        before = start
        now = yield Shown(feedback=Feedback(hint=HINT, cursor="grab"))
        while True:
            by = (now.x - before.x, now.y - before.y)
            before = now
            now = yield Shown(feedback=Feedback(hint=HINT, cursor="grab"), pan=by)

    def click(self, at: Pointer, stage: Stage) -> Outcome:
        """Nothing."""
        return None

    def double_click(self, at: Pointer, stage: Stage) -> Outcome:
        """A press like any other."""
        return None

    def hover(self, at: Pointer, stage: Stage) -> Feedback:
        """The open hand."""
        return Feedback(hint=HINT, cursor="hand")

    def keys(self, stage: Stage) -> frozenset[str]:
        """None of its own."""
        return frozenset()

    def key(self, key: str, stage: Stage) -> Outcome:
        """Never called."""
        return None

    def reset(self) -> None:
        """Nothing is remembered between gestures."""
