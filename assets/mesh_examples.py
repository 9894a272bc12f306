"""The designs of meshes among the examples; `make_examples.py` writes them.

All of their meshes are computed: a canyon that rivers have cut, a rabbit, and a knee.
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from canyon import canyon as cut_canyon
from rabbit_and_knee import KNEE, RABBIT
from surface_examples import Eye, scene
from surface_nets import surface

from plusedit.document.design import Design
from plusedit.document.map_record import MapRecord, with_map
from plusedit.document.shape import Style
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import PillowDomain
from plusedit.geometry.mesh.mapping import mapped
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import PolygonMesh

WIDTH = 100.0  # of the canyon
DIGITS, FEWER = 7, 6  # of parameters, and of those of coarse meshes
ROCK, FUR, BONE, CARTILAGE = "#C98F65", "#B9A48C", "#DDD0B4", "#D3C3A0"
LEVELS = (0.7, 3.0)  # of Figure 8


@cache
def land(columns: int, rows: int) -> MeshSurface:
    """The canyon as a height field of (columns - 1) x (rows - 1) quads."""
    heights = cut_canyon(columns, rows, WIDTH)
    step = WIDTH / (columns - 1)
    x, y = np.meshgrid(np.arange(columns) * step, np.arange(rows) * step, indexing="ij")
    vertices = np.stack([x, y, heights], axis=2).reshape(-1, 3)
    numbers = np.arange(columns * rows).reshape(columns, rows)
    around = (numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:])
    faces = np.stack(around, axis=-1).reshape(-1, 4)
    mesh = PolygonMesh.of_rows(np.round(vertices, 3) + 0.0, faces)
    return smooth(mesh, is_height_field=True)


@cache
def body(name: str, coarser: float = 1.0) -> MeshSurface:
    """The rabbit or a bone of the knee."""
    part = RABBIT if name == "rabbit" else KNEE[name]
    mesh = surface(part.body, part.box, coarser * part.step)
    return smooth(mesh, FEWER if coarser > 1.0 else DIGITS)


def smooth(
    mesh: PolygonMesh, digits: int = DIGITS, *, is_height_field: bool = False
) -> MeshSurface:
    """The surface of a mesh by the map that suits it, with short numbers."""
    found = mapped(mesh, is_height_field=is_height_field)
    domain, parameters = found.domain, found.parameters
    if isinstance(domain, PillowDomain):
        # Rounded before the parameters, so that faces on both sides of a seam agree.
        domain = PillowDomain(round(domain.width, digits))
    return MeshSurface(mesh, domain, np.round(parameters, digits) + 0.0)


def mesh_scene(
    layers: Iterable[tuple[str, MeshSurface, Style]], about: str, eye: Eye, overlays: str = ""
) -> Design:
    """A design of meshes, seen in space, that tells by which maps they got their parameters."""
    made = scene(layers, about, eye, overlays)
    for shape_id, found in made.meshes():
        is_body = isinstance(found.domain, PillowDomain)
        record = MapRecord("pillow" if is_body else "height_field")
        shape = made.shapes[shape_id]
        made = made.with_shape(shape_id, replace(shape, extra=with_map(shape.extra, record)))
    return made


# --- designs --------------------------------------------------------------------------------


def canyon() -> Design:
    """Layered rock that a river and the streams that join it have cut."""
    about = (
        "A canyon as a height field of quads. Rivers have cut it (stream power along ways found by"
        " priority-flood), hard layers stand as cliffs and soft ones lie as benches. Drag the"
        " slider: with a larger S the gullies go first, then the cliffs."
    )
    eye = Eye((55.0, 41.0, 6.5), 88.0, 0.95, 0.55)
    return mesh_scene([("canyon", land(101, 76), Style(ROCK))], about, eye)


def rabbit() -> Design:
    """A closed mesh with thin ears."""
    about = (
        "A rabbit of ellipsoids and round cones that run into each other, as a mesh of quads. It is"
        " closed, so its parameters come from a pillow: a flat sphere with four corners."
    )
    eye = Eye((0.05, 0.04, 1.06), 2.8, 0.5, 0.22)
    return mesh_scene([("rabbit", body("rabbit"), Style(FUR))], about, eye)


def knee() -> Design:
    """Four bones."""
    about = (
        "A right knee: the ends of femur and tibia, the patella before its groove and the head of"
        " the fibula, each a closed mesh with a pillow for a map and with its own S."
    )
    eye = Eye((0.2, -0.4, 0.9), 32.5, 0.75, 0.18)
    colors = {"patella": CARTILAGE}
    layers = [(name, body(name), Style(colors.get(name, BONE))) for name in KNEE]
    return mesh_scene(layers, about, eye)


@dataclass(frozen=True)
class Panel:
    """What Figure 8 shows of a mesh."""

    surface: MeshSurface
    turn: float
    """degrees counterclockwise as seen from above"""
    size: float
    color: str

    def at(self, place: Floats, smoothness: float) -> MeshSurface:
        """The surface with its middle there."""
        angle = np.radians(self.turn)
        cos, sin = np.cos(angle), np.sin(angle)
        low, high = self.surface.mesh.bounds
        scale = self.size / float((high - low).max())
        matrix = scale * np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
        moved = self.surface.transformed(matrix, place - matrix @ ((low + high) / 2.0))
        mesh = moved.mesh.with_vertices(np.round(moved.mesh.vertices, 4) + 0.0)
        return replace(moved, mesh=mesh, smoothness=smoothness, shared=None)


def figure_8() -> Design:
    """A terrain, an animal and a bone: each as a mesh, and at two levels of smoothness."""
    eye = Eye((0.0, 0.0, 0.0), 11.4, 0.0, 0.5, perspective=False)
    bodies = (
        Panel(land(43, 32), -35.0, 3.3, ROCK),
        Panel(body("rabbit", 1.62), -35.0, 2.6, FUR),
        Panel(body("femur", 1.8), -140.0, 3.0, BONE),
    )
    about = (
        "Polygon meshes and RaG+ surfaces that approximate them. (a), (d), (g) The meshes: a"
        " canyon, a rabbit and a femur. (b), (e), (h) With the smoothness S = 0.7, close to the"
        " mesh. (c), (f), (i) With S = 3, where detail is gone. The paper shows the Grand Canyon,"
        " the Stanford bunny and a knee; these three meshes are computed, for want of data that"
        " could be given away."
    )
    layers = []
    for row, panel in enumerate(bodies):
        for column, smoothness in enumerate((LEVELS[0], *LEVELS)):
            place = np.array([4.4 * (column - 1), 0.0, (3.7, 0.2, -4.2)[row]])
            style = Style(panel.color, facets=column == 0)
            letter = "abcdefghi"[3 * row + column]
            layers.append((f"({letter})", panel.at(place, smoothness), style))
    return mesh_scene(layers, about, eye, "names")


MESHES: tuple[Callable[[], Design], ...] = (figure_8, canyon, rabbit, knee)
