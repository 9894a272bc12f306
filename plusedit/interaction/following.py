"""Places of the world that follow the pointer along an axis, in a plane, or across the view.

A shift in a subspace with the basis A is seen as J c, to first order, c being its coordinates; in
perspective what comes nearer grows, so that pixels d are matched by c / (1 - k c) with J c = d.
That has a horizon, where the pointer would be at infinity: from halfway to it on the shift goes on
at the pace it has reached. An axis or a plane that is seen end on has no c to speak of: what can't
be seen then follows the pointer up or down. So no small step of the pointer is ever a large one.
"""

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.scene.camera import Camera

FLATTEST = 0.2  # sine of the angle to the eye's ray below which a direction is end on
PROBE = 20.0  # pixels over which the view is measured
HALFWAY = 0.5  # to the horizon: how far a shift is as it is seen


class Follower:
    """How far a point has to go in a subspace to stay under the pointer."""

    def __init__(self, camera: Camera, point: Floats, basis: Floats) -> None:
        """`point` (3,) is what was taken hold of; `basis` (m, 3) are perpendicular unit vectors."""
        self._basis = basis
        pixel = float(camera.pixel_at(point[None])[0])
        seen, growth = _seen(camera, point, basis, PROBE * pixel)
        left, sizes, right = np.linalg.svd(seen * pixel, full_matrices=False)
        end_on = sizes < FLATTEST
        if len(basis) == 1 and end_on[0]:
            up = -1.0 if seen[1, 0] <= 0.0 else 1.0
            left, right = np.array([[0.0], [up]]), np.ones((1, 1))
        self._growth = np.zeros(len(basis)) if end_on.any() else growth
        self._inverse: Floats = pixel * (right.T / np.where(end_on, 1.0, sizes)) @ left.T

    def by(self, pixels: Floats) -> Floats:
        """(3,) the shift that belongs to a way of the pointer (2,), to the right and downwards."""
        return self.amounts(pixels) @ self._basis

    def amounts(self, pixels: Floats) -> Floats:
        """(m,) the same by vectors of the basis."""
        plain: Floats = self._inverse @ pixels
        near = float(self._growth @ plain)
        if near <= HALFWAY:
            return plain / (1.0 - near)
        # At the horizon's half the shift is twice the plain one and grows four times as fast.
        return plain * (4.0 * near - 1.0) / near


def _seen(camera: Camera, point: Floats, basis: Floats, step: float) -> tuple[Floats, Floats]:
    """(2, m) pixels per unit along each vector at the point, and (m,) how fast a pixel grows."""
    there = point + step * basis
    at = camera.to_screen(point[None])[0]
    pixels = camera.pixel_at(np.vstack([point[None], there]))
    ratio = pixels[1:] / pixels[0]
    seen = (camera.to_screen(there) - at) * ratio[:, None] / step
    return seen.T, (ratio - 1.0) / step
