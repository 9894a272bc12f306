"""Directions of the world by two angles, as settings of overlays give them."""

from math import cos, radians, sin

Vector = tuple[float, float, float]


def vector_at(height: float, bearing: float) -> Vector:
    """A unit vector that many degrees above the ground, turned by the bearing from x to y."""
    up, around = radians(height), radians(bearing)
    return cos(up) * cos(around), cos(up) * sin(around), sin(up)
