"""What can be asked of convex bodies in tests."""

import numpy as np


def _planes(mesh):
    """Corners and outward unit normals of the triangles that have one."""
    a, b, c = mesh.points[mesh.triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    sizes = np.linalg.norm(normals, axis=1)
    # The plane of a sliver is known only roughly.
    longest = np.maximum(np.linalg.norm(b - a, axis=1), np.linalg.norm(c - a, axis=1))
    known = sizes > 1e-4 * longest**2
    return a[known], normals[known] / sizes[known, None]


def outside(mesh, points):
    """How far the points stand off the body, at most, seen from its triangles."""
    corners, normals = _planes(mesh)
    heights = points @ normals.T - (corners * normals).sum(axis=1)
    return heights.max() if heights.size else 0.0


def volume(mesh):
    """Positive where the triangles are counter-clockwise as seen from outside."""
    a, b, c = (mesh.points[mesh.triangles] - mesh.points[0]).transpose(1, 0, 2)
    return (a * np.cross(b, c)).sum() / 6.0
