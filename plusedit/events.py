"""An event is a list of callbacks: telling and listening without Qt."""

from collections.abc import Callable
from typing import Generic, TypeVarTuple

Arguments = TypeVarTuple("Arguments")


class Event(Generic[*Arguments]):
    """Calls everyone who listens, in the order in which they began to."""

    def __init__(self) -> None:
        self._listeners: list[Callable[[*Arguments], object]] = []

    def listen(self, listener: Callable[[*Arguments], object]) -> Callable[[], None]:
        """Call `listener` at every `emit` from now on; calling what comes back ends that."""
        self._listeners.append(listener)
        return lambda: self._listeners.remove(listener)

    @property
    def is_heard(self) -> bool:
        """Whether anyone listens, so that there is something to tell for."""
        return bool(self._listeners)

    def emit(self, *arguments: *Arguments) -> None:
        """Tell all who listened when this began; one that raises keeps the rest from hearing."""
        for listener in tuple(self._listeners):
            listener(*arguments)
