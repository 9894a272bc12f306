"""Distances of points from triangles in space, by the case distinction of the books."""

import numpy as np


def from_segments(points, a, b):
    """(...) distances of points (..., 3) from segments."""
    way = b - a
    length = (way * way).sum(axis=-1)
    along = ((points - a) * way).sum(axis=-1)
    share = np.clip(np.divide(along, length, out=np.zeros_like(along), where=length > 0), 0, 1)
    return np.linalg.norm(points - a - share[..., None] * way, axis=-1)


def from_triangles(points, a, b, c):
    """(...) distances of points (..., 3) from triangles: their edges, or the plane inside."""
    a, b, c = (np.broadcast_to(each, points.shape) for each in (a, b, c))
    edges = np.minimum(from_segments(points, a, b), from_segments(points, b, c))
    edges = np.minimum(edges, from_segments(points, c, a))
    normal = np.cross(b - a, c - a)
    square = (normal * normal).sum(axis=-1)
    square = np.where(square > 0.0, square, np.inf)
    third = (np.cross(b - a, points - a) * normal).sum(axis=-1) / square
    second = (np.cross(points - a, c - a) * normal).sum(axis=-1) / square
    height = np.abs(((points - a) * normal).sum(axis=-1)) / np.sqrt(square)
    inside = (second >= 0.0) & (third >= 0.0) & (second + third <= 1.0) & np.isfinite(square)
    return np.where(inside, np.minimum(height, edges), edges)
