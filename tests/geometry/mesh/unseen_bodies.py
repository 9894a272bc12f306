"""Meshes of all kinds that people come along with, good, bad and impossible."""

import numpy as np

from plusedit.geometry.mesh.polygons import PolygonMesh
from tests.geometry.mesh.bodies import cube, cylinder, ribbon, sheet, together, torus
from tests.geometry.mesh.mapped_bodies import (
    ball,
    blocks,
    ramp,
    rings,
    tube,
    turned_in_space,
    without,
)

TETRAHEDRON = PolygonMesh.of(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
)


def klein_bottle(around=16, across=12):
    """Quads of a Klein bottle in the shape of a figure eight: closed, with one side."""
    u, v = np.meshgrid(*(2.0 * np.pi * np.arange(n) / n for n in (around, across)), indexing="ij")
    radius = 2.0 + np.cos(u / 2) * np.sin(v) - np.sin(u / 2) * np.sin(2 * v)
    height = np.sin(u / 2) * np.sin(v) + np.cos(u / 2) * np.sin(2 * v)
    points = np.stack([radius * np.cos(u), radius * np.sin(u), height], axis=-1)
    # Moved along each ring so that nothing is at one place where the eight crosses itself.
    points += 1e-3 * np.random.default_rng(0).normal(size=points.shape)
    number = np.arange(around * across).reshape(around, across)
    after = np.vstack([number[1:], number[:1, -np.arange(across)]])
    up, after_up = np.roll(number, -1, axis=1), np.roll(after, -1, axis=1)
    quads = np.stack([number, after, after_up, up], axis=-1)
    return PolygonMesh.of(points.reshape(-1, 3), quads.reshape(-1, 4))


def triangles(mesh):
    """The mesh cut into triangles."""
    return PolygonMesh.of(mesh.vertices, mesh.triangles()[0])


def shaken(mesh, size, seed=0):
    """The mesh with every vertex moved at random."""
    noise = np.random.default_rng(seed).normal(size=mesh.vertices.shape)
    return mesh.with_vertices(mesh.vertices + size * noise)


def touching(mesh, vertices):
    """Two copies of a mesh that have only these vertices in common."""
    count = mesh.vertex_count
    faces = [[v if v in vertices else v + count for v in face] for face in mesh.faces]
    points = np.concatenate([mesh.vertices, mesh.vertices * (1.0, 1.0, 1.5) + (2.0, 0.1, 0.0)])
    return PolygonMesh.of(points, [*mesh.faces, *faces])


def slivers(aspect, count=60):
    """A band of triangles so much longer than wide, around a tube."""
    mesh = tube(count, 3, radius=1.0, height=1.0)
    return triangles(mesh.with_vertices(mesh.vertices * (1.0, 1.0, aspect / 10.0)))


def fan(count, height=0.3):
    """A cone of triangles around one vertex."""
    angle = 2.0 * np.pi * np.arange(count) / count
    ring = np.stack([np.cos(angle), np.sin(angle), np.zeros(count)], axis=1)
    return PolygonMesh.of(
        np.vstack([ring, [(0, 0, height)]]), [(i, (i + 1) % count, count) for i in range(count)]
    )


def polygon(count, seed=None):
    """One face; with a seed, concave and not plane."""
    angle = 2.0 * np.pi * np.arange(count) / count
    random = np.random.default_rng(seed)
    radius = np.ones(count) if seed is None else random.uniform(0.3, 1.0, count)
    height = np.zeros(count) if seed is None else random.uniform(-0.2, 0.2, count)
    points = np.stack([radius * np.cos(angle), radius * np.sin(angle), height], axis=1)
    return PolygonMesh.of(points, [tuple(range(count))])


def t_junctions():
    """A cube of which two opposite faces are halved, and their neighbors know nothing of it."""
    mesh = cube()
    points = [*mesh.vertices, (0.5, 0, 1), (0.5, 1, 1)]
    top = next(face for face in mesh.faces if set(face) == {4, 5, 6, 7})
    rest = [face for face in mesh.faces if face != top]
    return PolygonMesh.of(points, [*rest, (4, 8, 9, 6), (8, 5, 7, 9)])


def spiky(seed=0):
    """A ball with some vertices far out."""
    mesh = ball(3)
    random = np.random.default_rng(seed)
    points = mesh.vertices.copy()
    points[random.choice(len(points), 12, replace=False)] *= random.uniform(3, 30, (12, 1))
    return mesh.with_vertices(points)


def branching(depth=3):
    """Bars of cubes that branch again and again at right angles."""
    cells, ends = {(0, 0, 0)}, [((0, 0, 0), 0)]
    for level in range(depth):
        length, grown = 2 ** (depth - level) + 1, []
        for end, axis in ends:
            for side in (-1, 1):
                step = np.eye(3, dtype=int)[(axis + 1) % 3] * side
                row = [tuple(int(x) for x in np.add(end, k * step)) for k in range(1, length + 1)]
                cells.update(row)
                grown.append((row[-1], (axis + 1) % 3))
        ends = grown
    return blocks(cells)


def soup(count, seed=0):
    """Triangles anywhere, without anything in common."""
    points = np.random.default_rng(seed).uniform(size=(3 * count, 3))
    return PolygonMesh.of(points, np.arange(3 * count).reshape(-1, 3))


def tangle(points, faces, seed=0):
    """Triangles between vertices drawn by lot."""
    random = np.random.default_rng(seed)
    corners = [random.choice(points, 3, replace=False) for _ in range(faces)]
    return PolygonMesh.of(random.normal(size=(points, 3)), np.array(corners))


SMOOTH = {
    "ball with five holes": without(ball(3), [0, 100, 200, 300, 400]),
    "ball with large holes": without(ball(3), [*range(60), *range(200, 330)]),
    "tetrahedron": TETRAHEDRON,
    "cube": cube(),
    "triangle": PolygonMesh.of(np.eye(3), [(0, 1, 2)]),
    "upright triangle": PolygonMesh.of([(0, 0, 0), (1, 0, 0), (0, 0, 1)], [(0, 1, 2)]),
    "polygon of 100 corners": polygon(100),
    "concave polygon that is not plane": polygon(31, seed=3),
    "cylinder of two triangles a side": cylinder(7, 40.0),
    "needle ball": ball(2, (1.0, 1.0, 100.0)),
    "flat ball": ball(3, (1.0, 1.0, 1e-3)),
    "very flat ball": ball(3, (1.0, 1.0, 1e-9)),
    "endless ball": ball(1, (1.0, 1.0, 1e3)),
    "slivers": slivers(1e3, 9),
    "thinnest slivers": slivers(1e6, 4),
    "fan of 200": fan(200),
    "flat fan of 200": fan(200, 0.0),
    "high fan": fan(50, 30.0),
    "long strip": sheet(1, 2000),
    "long strip somewhere": turned_in_space(sheet(1, 2000)),
    "long strip that winds up": ramp(12.0),
    "long tube": tube(6, 400, height=400.0),
    "short tube": tube(60, 1, height=0.05),
    "thick torus": torus(60, 40),
    "chain of three handles": rings(3),
    "many handles": rings(12),
    "double torus": rings(2).subdivided(1).mesh,
    "torus with holes": without(torus(30, 20), [5, 77, 200, 201, 202, 350]),
    "noisy sheet": turned_in_space(shaken(sheet(20, 20), 0.3)),
    "folded sheet": turned_in_space(shaken(sheet(20, 20), 2.0)),
    "noisy ball": shaken(ball(3), 0.05),
    "ball of noise": shaken(ball(3), 1.0),
    "noisy torus": shaken(torus(30, 20), 0.3),
    "spiky ball": spiky(),
    "branching body": branching(),
    "t-junctions": t_junctions(),
    "huge": ball(2).with_vertices(1e12 * ball(2).vertices),
    "tiny": ball(2).with_vertices(1e-12 * ball(2).vertices),
    "far away": ball(2).with_vertices(ball(2).vertices + 1e9),
    "tiny and far away": ball(2).with_vertices(1e-6 * ball(2).vertices + 1e6),
    "nested shells": together(ball(2), ball(2).with_vertices(2.0 * ball(2).vertices), apart=0.0),
    "balls that touch at a vertex": touching(ball(2), {0}),
    "balls that touch at an edge": touching(cube(), {0, 1}),
    "all faces twice": PolygonMesh.of(cube().vertices, [*cube().faces, *cube().faces]),
    "faces and their backs": PolygonMesh.of(
        ball(2).vertices, [*ball(2).faces, *(f[::-1] for f in ball(2).faces)]
    ),
    "soup": soup(9),
    "tangle": tangle(16, 50),
    "dense tangle": tangle(7, 60),
    "isolated vertices": PolygonMesh.of(
        np.vstack([[(9.0, 9, 9)] * 5, cube().vertices]), [[v + 5 for v in f] for f in cube().faces]
    ),
}
"""Every one becomes at least one surface."""

ONE_SIDED = {
    "Moebius strip": ribbon(1),
    "ribbon of three half turns": ribbon(3),
    "Klein bottle": klein_bottle(),
}

WITHOUT_AREA = {
    "one place": PolygonMesh.of(np.ones((5, 3)), [(0, 1, 2), (2, 3, 4)]),
    "one line": PolygonMesh.of(
        np.outer(np.arange(6.0), (1, 2, 3)), [(0, 1, 2), (3, 4, 5), (1, 2, 3)]
    ),
    "no faces": PolygonMesh.of(np.eye(3), []),
}
