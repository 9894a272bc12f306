"""Mesh surfaces of every domain for tests, and the definition, written out, as their oracle."""

import numpy as np

from plusedit.geometry.mesh.domains import CylinderDomain, PillowDomain, PlaneDomain, TorusDomain
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh

PILLOW = PillowDomain(1.3)
TORUS = TorusDomain(0.7)


def grid_corners(u, v):
    """(k, 3, 2) parameters of two triangles for each cell of a grid."""
    a, b = np.meshgrid(u[:-1], v[:-1], indexing="ij")
    c, d = np.meshgrid(u[1:], v[1:], indexing="ij")
    low_left, low_right = np.stack([a, b], axis=-1), np.stack([c, b], axis=-1)
    high_right, high_left = np.stack([c, d], axis=-1), np.stack([a, d], axis=-1)
    lower = np.stack([low_left, low_right, high_right], axis=-2)
    upper = np.stack([low_left, high_right, high_left], axis=-2)
    return np.concatenate([lower.reshape(-1, 3, 2), upper.reshape(-1, 3, 2)])


def spanned(domain, corners, shape, **options):
    """The surface of triangles with those parameters, their vertices on a shape (u, v) -> x."""
    places = corners.reshape(-1, 2)
    vertices = np.stack(np.broadcast_arrays(*shape(*places.T)), axis=1)
    mesh = PolygonMesh.of_rows(vertices, np.arange(len(places)).reshape(-1, 3))
    return MeshSurface(mesh, domain, places, **options)


def uneven(start, end, count, seed=3):
    """Count + 1 numbers from start to end, some gaps three times as wide as others."""
    gaps = np.random.default_rng(seed).uniform(1.0, 3.0, count)
    return start + (end - start) * np.concatenate([[0.0], np.cumsum(gaps) / gaps.sum()])


def height_field(count=9, seed=5, **options):
    """u, v = x, y over uneven cells, moved about, with random heights."""
    corners = grid_corners(uneven(0.0, 1.0, count), uneven(0.0, 1.0, count, 4))
    bend = corners + 0.02 * np.sin(9.0 * corners[..., ::-1])
    heights = np.random.default_rng(seed).normal(size=(97, 89))

    def shape(u, v):
        return u, v, 0.1 * heights[(1e6 * u).astype(int) % 97, (1e6 * v).astype(int) % 89]

    return spanned(PlaneDomain(), bend, shape, **options)


def cylinder(**options):
    corners = grid_corners(uneven(0.0, 1.0, 12), uneven(-0.4, 0.5, 8))

    def shape(u, v):
        return np.cos(2 * np.pi * u), np.sin(2 * np.pi * u) * (1.0 + 0.3 * v), v

    return spanned(CylinderDomain(), corners, shape, **options)


def torus(**options):
    corners = grid_corners(uneven(0.0, 1.0, 12), uneven(0.0, TORUS.height, 9))

    def shape(u, v):
        out = 2.0 + np.cos(2 * np.pi * v / TORUS.height)
        around = 2 * np.pi * u
        return out * np.cos(around), out * np.sin(around), np.sin(2 * np.pi * v / TORUS.height)

    return spanned(TORUS, corners, shape, **options)


def pillow(**options):
    """z^2 = (1 - x^2)(1 - y^2): a closed surface with corners, of which u and v are angles."""
    corners = grid_corners(uneven(0.0, 2.0 * PILLOW.width, 14), uneven(0.0, 0.5, 6))

    def shape(u, v):
        a, b = np.pi * u / PILLOW.width, 2 * np.pi * v
        return np.cos(a), np.cos(b), np.sin(a) * np.sin(b)

    return spanned(PILLOW, corners, shape, **options)


EVERY_KIND = (height_field, cylinder, torus, pillow)


def sizes_of(surface):
    """How far the domain's cell, or the mesh's parameters, reach by u and v."""
    spans = np.ptp(surface.parameters, axis=0)
    return np.where(np.isfinite(surface.domain.periods), surface.domain.periods, spans)


def inner_places(surface, count=30, seed=1):
    """Places all over the cell, some a little outside of it."""
    low = surface.parameters.min(axis=0)
    share = np.random.default_rng(seed).uniform(-0.1, 1.1, (count, 2))
    return low + share * sizes_of(surface)


def definition(surface, places, around=3):
    """S, S_u and S_v as the module docstring writes them, over `around` periods each way."""
    planes, sigmas = surface.planes, surface.sigmas
    periods = [p if np.isfinite(p) else 0.0 for p in surface.domain.periods]
    numbers = [range(-around, around + 1) if p else (0,) for p in periods]
    motions = [
        (sign, np.array([m * periods[0], n * periods[1]]))
        for sign in ((1.0, -1.0) if surface.domain.turns else (1.0,))
        for m in numbers[0]
        for n in numbers[1]
    ]
    used = planes.radii > 0.0
    rows = []
    for x in np.asarray(places, dtype=np.float64):
        away = np.concatenate([x - sign * planes.centers[used] - t for sign, t in motions])
        by_u = np.concatenate([surface.s * sign * planes.gradients_u[used] for sign, _ in motions])
        by_v = np.concatenate([surface.s * sign * planes.gradients_v[used] for sign, _ in motions])
        width = np.tile(sigmas[used], len(motions))
        weights = np.tile(planes.weights[used], len(motions))
        exponents = -0.5 * (away**2).sum(axis=1) / width**2
        shares = weights * np.exp(exponents - exponents.max())
        shares /= shares.sum()
        values = np.tile(planes.points[used], (len(motions), 1)) + away[:, :1] * by_u
        values += away[:, 1:] * by_v
        point = shares @ values
        slopes = -away / width[:, None] ** 2
        row = [point]
        for axis, pull in enumerate((by_u, by_v)):
            row.append(shares @ (pull + slopes[:, axis : axis + 1] * (values - point)))
        rows.append(row)
    return tuple(np.array(rows).transpose(1, 0, 2))
