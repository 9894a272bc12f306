"""Pictures in the card's memory, to draw into and read back."""

import numpy as np
from numpy.typing import NDArray

from plusedit.views.gl import functions as names
from plusedit.views.gl.functions import Functions, OpenGLError, address


class Target:
    """A picture with depth and several samples to a pixel; bind it, draw, then read."""

    def __init__(self, gl: Functions, width: int, height: int, samples: int = 0) -> None:
        """OpenGLError if the card refuses one of that size."""
        self._gl, self.width, self.height = gl, width, height
        samples = min(samples, gl.integer(names.MAX_SAMPLES))
        self._color, self._depth, self._plain = (gl.made("Renderbuffers") for _ in range(3))
        self._drawn, self._resolved = gl.made("Framebuffers"), gl.made("Framebuffers")
        self._attach(self._drawn, names.COLOR_ATTACHMENT0, self._color, names.RGBA8, samples)
        depth = names.DEPTH_STENCIL_ATTACHMENT, self._depth, names.DEPTH24_STENCIL8
        self._attach(self._drawn, *depth, samples)
        self._attach(self._resolved, names.COLOR_ATTACHMENT0, self._plain, names.RGBA8, 0)
        for name in (self._drawn, self._resolved):
            gl.BindFramebuffer(names.FRAMEBUFFER, name)
            if gl.CheckFramebufferStatus(names.FRAMEBUFFER) != names.FRAMEBUFFER_COMPLETE:
                self.release()
                raise OpenGLError(f"OpenGL refuses a picture of {width} by {height} pixels")

    def bind(self) -> None:
        """Draw into it from now on."""
        self._gl.BindFramebuffer(names.FRAMEBUFFER, self._drawn)
        self._gl.Viewport(0, 0, self.width, self.height)

    def read(self) -> NDArray[np.uint8]:
        """(height, width, 4) red, green, blue, times opacity, and opacity; the top row first."""
        gl, size = self._gl, (self.width, self.height)
        gl.BindFramebuffer(names.READ_FRAMEBUFFER, self._drawn)
        gl.BindFramebuffer(names.DRAW_FRAMEBUFFER, self._resolved)
        gl.BlitFramebuffer(0, 0, *size, 0, 0, *size, names.COLOR_BUFFER_BIT, names.NEAREST)
        gl.BindFramebuffer(names.FRAMEBUFFER, self._resolved)
        gl.PixelStorei(names.PACK_ALIGNMENT, 4)
        pixels = np.empty((self.height, self.width, 4), np.uint8)
        gl.ReadPixels(0, 0, *size, names.RGBA, names.UNSIGNED_BYTE, address(pixels))
        return pixels[::-1]

    def depths(self) -> NDArray[np.float32]:
        """(height, width) how deep what is drawn lies, from 0 to 1; only of one without samples."""
        gl, size = self._gl, (self.width, self.height)
        gl.BindFramebuffer(names.FRAMEBUFFER, self._drawn)
        gl.PixelStorei(names.PACK_ALIGNMENT, 4)
        found = np.empty((self.height, self.width), np.float32)
        gl.ReadPixels(0, 0, *size, names.DEPTH_COMPONENT, names.FLOAT, address(found))
        return found[::-1]

    def spread(self, framebuffer: int, width: int, height: int) -> None:
        """Show it in another framebuffer, as large as that; draw there from now on."""
        gl = self._gl
        gl.BindFramebuffer(names.READ_FRAMEBUFFER, self._drawn)
        gl.BindFramebuffer(names.DRAW_FRAMEBUFFER, framebuffer)
        corners = 0, 0, self.width, self.height, 0, 0, width, height
        gl.BlitFramebuffer(*corners, names.COLOR_BUFFER_BIT, names.LINEAR)
        gl.BindFramebuffer(names.FRAMEBUFFER, framebuffer)
        gl.Viewport(0, 0, width, height)

    def release(self) -> None:
        """Free it; what was bound is no longer."""
        gl = self._gl
        gl.BindFramebuffer(names.FRAMEBUFFER, 0)
        for name in (self._drawn, self._resolved):
            gl.delete("Framebuffers", name)
        for name in (self._color, self._depth, self._plain):
            gl.delete("Renderbuffers", name)

    def _attach(self, target: int, place: int, memory: int, kind: int, samples: int) -> None:
        gl = self._gl
        gl.BindRenderbuffer(names.RENDERBUFFER, memory)
        gl.RenderbufferStorageMultisample(
            names.RENDERBUFFER, samples, kind, self.width, self.height
        )
        gl.BindFramebuffer(names.FRAMEBUFFER, target)
        gl.FramebufferRenderbuffer(names.FRAMEBUFFER, place, names.RENDERBUFFER, memory)
