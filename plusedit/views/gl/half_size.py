"""Frames of half the width and height, for while the view moves and the processor draws."""

from collections.abc import Callable

from plusedit.views.gl import functions as names
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.targets import Target


class HalfSize:
    """Draws a frame with a quarter of the pixels, and spreads it over what is bound."""

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self._target: Target | None = None

    def draw(self, paint: Callable[[], None], width: int, height: int) -> None:
        """Call `paint` for a picture of half of that many pixels, and spread it over all of them.

        OpenGLError if there is no room for one.
        """
        gl = self._gl
        bound = gl.integer(names.FRAMEBUFFER_BINDING)
        target = self._fitting(max(1, (width + 1) // 2), max(1, (height + 1) // 2))
        target.bind()
        paint()
        target.spread(bound, width, height)

    def release(self) -> None:
        """Free what it holds on the card."""
        if self._target is not None:
            self._target.release()
            self._target = None

    def _fitting(self, width: int, height: int) -> Target:
        kept = self._target
        if kept is None or (kept.width, kept.height) != (width, height):
            self.release()
            kept = self._target = Target(self._gl, width, height)
        return kept
