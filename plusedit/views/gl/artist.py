"""Items of a view in space, drawn with OpenGL.

Colors are laid over each other as on paper, not as light, so that lines look as in the plane view.
Every shader gives colors multiplied by their opacity: over an empty ground the picture has the
right opacity, too.
"""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from itertools import chain
from typing import TypeAlias

import numpy as np

from plusedit.scene.items import Item, Label, Markers, Mesh, Patch, Polygon, Polyline, Segments
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.theme import Theme
from plusedit.views.gl import functions as gl_names
from plusedit.views.gl.batches import Batch, Fills, Lines, Marks
from plusedit.views.gl.colors import shade_of
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.ground import Ground, ground_of
from plusedit.views.gl.meshes import Meshes
from plusedit.views.gl.patches import Patches, frame_of
from plusedit.views.gl.programs import Programs
from plusedit.views.gl.sight import WHOLE, Box, Crop, Sight
from plusedit.views.gl.tripod import tripod_camera, tripod_items

HIDDEN = 0.3  # opacity of handles behind a surface
PUSH = (1.0, 1.0)  # by which surfaces stand back so that lines on them are seen: slopes, steps
Flat: TypeAlias = Polyline | Segments | Markers | Polygon
Solid: TypeAlias = Patch | Mesh
Kinds: TypeAlias = tuple[list[Item], list[Item], list[Item]]
"""Areas; lines, with the outlines of areas; marks"""


@dataclass(frozen=True)
class Look:
    """What a frame shows besides the items."""

    ground: bool = False
    """the grid on the ground"""
    axes: bool = False
    """the axes in the upper right corner"""
    hovered: str | None = None
    """the view whose end of the axes is under the pointer"""
    shading: str = "studio"
    """or "matcap" """
    transparent: bool = False
    """nothing where nothing is drawn, instead of the canvas"""


@dataclass(eq=False)
class Group:
    """Areas, lines and marks that are drawn after each other, each kind at once."""

    fills: Fills
    lines: Lines
    marks: Marks

    @property
    def batches(self) -> tuple[Batch, Batch, Batch]:
        """In the order in which they are drawn."""
        return self.fills, self.lines, self.marks

    def show(self, items: Kinds, theme: Theme, camera: SpaceCamera) -> None:
        """Hold those areas, lines and marks."""
        for batch, kind in zip(self.batches, items, strict=True):
            batch.show(kind, theme, camera)

    def boxes(self) -> Iterator[Box]:
        """What the batches lie in."""
        for batch in self.batches:
            if batch.box is not None:
                yield batch.box

    def draw(self, sight: Sight, opacity: float = 1.0) -> None:
        """Draw all of it."""
        for batch in self.batches:
            batch.draw(sight, opacity)

    def release(self) -> None:
        """Free it."""
        for batch in self.batches:
            batch.release()


class SpaceArtist:
    """Draws items in one context of OpenGL, and keeps there what is drawn again.

    Everything must be called while that context is current.
    """

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self._programs = Programs(gl)
        self._patches = Patches(gl, self._programs)
        self._meshes = Meshes(gl, self._programs)
        self._faint = self._lines()
        self._flats = self._group()
        self._veils = self._group()
        self._handles: list[Group] = []
        self._fading = self._programs.named("line", "line", "FADING")
        self._ground = Lines(gl, self._fading)
        self._tripod = [self._group() for _ in range(3)]

    def paint(
        self,
        layers: SpaceLayers,
        camera: SpaceCamera,
        theme: Theme,
        look: Look = Look(),
        *,
        ratio: float = 1.0,
        crop: Crop = WHOLE,
    ) -> None:
        """Draw a frame into what is bound, which is cleared first; labels are left out.

        `ratio` is pixels of the device to a logical one. What is seen through is told by the colors
        of the theme, whatever the layer.
        """
        solids, flats = _parted(chain(layers.solids, layers.glass, layers.lines))
        ground = ground_of(camera) if look.ground else None
        self._show(solids, flats, layers.handles, ground, camera, theme)
        sight = Sight.of(camera, self._boxes(solids), ratio, crop)
        with self._state(theme, look):
            self._draw_solids(
                [item for item in solids if _is_opaque(item, theme)], sight, theme, look
            )
            if ground is not None:
                self._draw_ground(ground, sight)
            self._draw_lines(sight)
            self._draw_veils(
                [item for item in solids if not _is_opaque(item, theme)], sight, theme, look
            )
            self._draw_handles(sight)
            if look.axes:
                self._draw_tripod(camera, theme, look, ratio, crop)

    def release(self) -> None:
        """Free everything on the card; nothing can be drawn afterwards."""
        groups = [self._flats, self._veils, *self._handles, *self._tripod]
        for group in groups:
            group.release()
        for lines in (self._faint, self._ground):
            lines.release()
        self._patches.release()
        self._meshes.release()
        self._programs.release()
        self._handles = []

    # What is sent to the card

    def _show(
        self,
        solids: Sequence[Solid],
        flats: Sequence[Flat],
        handles: Sequence[Item],
        ground: Ground | None,
        camera: SpaceCamera,
        theme: Theme,
    ) -> None:
        self._patches.show(item for item in solids if isinstance(item, Patch))
        self._meshes.show(item for item in solids if isinstance(item, Mesh))
        veils = [item for item in flats if isinstance(item, Polygon) and _is_veil(item, theme)]
        self._faint.show([item for item in flats if _is_faint_line(item, theme)], theme, camera)
        through: set[Item] = {*veils, *self._faint.items}
        opaque = [item for item in flats if item not in through]
        self._flats.show(_by_kind([*opaque, *(_outline(item) for item in veils)]), theme, camera)
        self._veils.show((_nearest_last(veils, camera), [], []), theme, camera)
        runs = list(_runs(handles))
        while len(self._handles) < len(runs):
            self._handles.append(self._group())
        while len(self._handles) > len(runs):
            self._handles.pop().release()
        for group, run in zip(self._handles, runs, strict=True):
            group.show(run, theme, camera)
        self._ground.show([] if ground is None else ground.items, theme, camera)

    def _boxes(self, solids: Sequence[Solid]) -> Iterator[Box]:
        for item in solids:
            if isinstance(item, Patch):
                yield frame_of(item.surface).box(item.surface.s)
            elif len(item.points):
                yield item.points.min(axis=0), item.points.max(axis=0)
        for group in (self._flats, self._veils, *self._handles):
            yield from group.boxes()
        for lines in (self._faint, self._ground):
            if lines.box is not None:
                yield lines.box

    # What is drawn

    @contextmanager
    def _state(self, theme: Theme, look: Look) -> Iterator[None]:
        """The settings that drawing relies on; afterwards those that Qt and others expect."""
        gl, names = self._gl, gl_names
        gl.ColorMask(1, 1, 1, 1)
        gl.DepthMask(1)
        gl.ClearDepth(1.0)
        red, green, blue, _ = shade_of(theme, "canvas")
        gl.ClearColor(*((0.0,) * 4 if look.transparent else (red, green, blue, 1.0)))
        gl.Clear(names.COLOR_BUFFER_BIT | names.DEPTH_BUFFER_BIT)
        gl.Enable(names.DEPTH_TEST)
        gl.Enable(names.BLEND)
        gl.BlendFunc(names.ONE, names.ONE_MINUS_SRC_ALPHA)
        for off in (names.CULL_FACE, names.STENCIL_TEST, names.SCISSOR_TEST):
            gl.Disable(off)
        gl.DepthFunc(names.LEQUAL)
        gl.FrontFace(names.COUNTERCLOCKWISE)
        try:
            yield
        finally:
            for off in (names.DEPTH_TEST, names.CULL_FACE, names.POLYGON_OFFSET_FILL, names.BLEND):
                gl.Disable(off)
            gl.DepthFunc(names.LESS)
            gl.DepthMask(1)
            gl.BindVertexArray(0)
            gl.BindBuffer(names.ARRAY_BUFFER, 0)
            gl.UseProgram(0)

    def _draw_solids(self, solids: Sequence[Solid], sight: Sight, theme: Theme, look: Look) -> None:
        gl = self._gl
        gl.Disable(gl_names.BLEND)
        gl.Enable(gl_names.POLYGON_OFFSET_FILL)
        gl.PolygonOffset(*PUSH)
        for item in solids:
            self._draw_solid(item, sight, theme, look)
        gl.Disable(gl_names.POLYGON_OFFSET_FILL)
        gl.Enable(gl_names.BLEND)

    def _draw_solid(self, item: Solid, sight: Sight, theme: Theme, look: Look) -> None:
        styles = ("MATCAP",) if look.shading == "matcap" else ()
        if isinstance(item, Patch):
            self._patches.draw(item, sight, theme, *styles)
        else:
            self._meshes.draw(item, sight, theme, *styles)

    def _draw_ground(self, ground: Ground, sight: Sight) -> None:
        self._fading.use()
        near = ground.middle - self._ground.origin
        self._fading.set("fading", *near.tolist(), ground.reach)
        self._gl.DepthMask(0)
        self._ground.draw(sight)
        self._gl.DepthMask(1)

    def _draw_lines(self, sight: Sight) -> None:
        gl = self._gl
        gl.Enable(gl_names.POLYGON_OFFSET_FILL)
        self._flats.fills.draw(sight)
        gl.Disable(gl_names.POLYGON_OFFSET_FILL)
        # Faint lines, such as the glow of a selected curve, hide nothing: not even themselves.
        gl.DepthMask(0)
        self._faint.draw(sight)
        gl.DepthMask(1)
        self._flats.lines.draw(sight)
        self._flats.marks.draw(sight)

    def _draw_veils(self, veils: Sequence[Solid], sight: Sight, theme: Theme, look: Look) -> None:
        """What lets through: the farthest first, of each the side that looks away first."""
        gl = self._gl
        gl.DepthMask(0)
        self._veils.draw(sight)
        gl.Enable(gl_names.CULL_FACE)
        for item in sorted(veils, key=lambda item: -_depth(item, sight.camera)):
            for culled in (gl_names.FRONT, gl_names.BACK):
                gl.CullFace(culled)
                self._draw_solid(item, sight, theme, look)
        gl.Disable(gl_names.CULL_FACE)
        gl.DepthMask(1)

    def _draw_handles(self, sight: Sight) -> None:
        gl = self._gl
        gl.DepthMask(0)
        for function, opacity in ((gl_names.GREATER, HIDDEN), (gl_names.LEQUAL, 1.0)):
            gl.DepthFunc(function)
            for group in self._handles:
                group.draw(sight, opacity)
        gl.DepthMask(1)

    def _draw_tripod(
        self, camera: SpaceCamera, theme: Theme, look: Look, ratio: float, crop: Crop
    ) -> None:
        small = tripod_camera(camera)
        layers = tripod_items(camera, look.hovered)
        for group, layer in zip(self._tripod, layers, strict=True):
            group.show(_by_kind(layer), theme, small)
        boxes = [box for group in self._tripod for box in group.boxes()]
        sight = Sight.of(small, boxes, ratio, crop)
        self._gl.Clear(gl_names.DEPTH_BUFFER_BIT)
        for group in self._tripod:
            group.draw(sight)

    # What there is of its own

    def _group(self) -> Group:
        gl, named = self._gl, self._programs.named
        marks = Marks(gl, named("marker", "marker"))
        return Group(Fills(gl, named("fill", "fill")), self._lines(), marks)

    def _lines(self) -> Lines:
        named = self._programs.named
        return Lines(self._gl, named("line", "line"), named("line", "line", "DASHED"))


def _parted(items: Iterable[Item]) -> tuple[list[Solid], list[Flat]]:
    solids: list[Solid] = []
    flats: list[Flat] = []
    for item in items:
        if isinstance(item, Patch | Mesh):
            solids.append(item)
        elif not isinstance(item, Label):
            flats.append(item)
    return solids, flats


def _is_opaque(item: Solid, theme: Theme) -> bool:
    return all(shade_of(theme, color)[3] >= 1.0 for color in (item.front, item.back))


def _is_veil(item: Polygon, theme: Theme) -> bool:
    return shade_of(theme, item.fill)[3] < 1.0


def _is_faint_line(item: Item, theme: Theme) -> bool:
    return isinstance(item, Polyline | Segments) and shade_of(theme, item.color)[3] < 1.0


def _outline(item: Polygon) -> Polyline:
    points = np.concatenate([item.points, item.points[:1]])
    return Polyline(points, item.outline or f"{item.fill}@0", item.width)


def _rank(item: Item) -> int:
    match item:
        case Polygon():
            return 0
        case Polyline() | Segments():
            return 1
        case _:
            return 2


def _by_kind(items: Iterable[Item]) -> Kinds:
    """Areas; lines, with the outlines of areas; marks."""
    kinds: Kinds = ([], [], [])
    for item in items:
        kinds[_rank(item)].append(item)
    kinds[1][:0] = kinds[0]
    return kinds


def _runs(items: Iterable[Item]) -> Iterator[Kinds]:
    """Groups of items whose order allows areas, lines and marks to be drawn at once each."""
    run: list[Item] = []
    for item in items:
        if isinstance(item, Patch | Mesh | Label):
            continue
        if run and _rank(item) < _rank(run[-1]):
            yield _by_kind(run)
            run = []
        run.append(item)
    if run:
        yield _by_kind(run)


def _nearest_last(veils: Sequence[Polygon], camera: SpaceCamera) -> list[Item]:
    return [*sorted(veils, key=lambda item: -float(camera.depths(item.points).mean()))]


def _depth(item: Solid, camera: SpaceCamera) -> float:
    if isinstance(item, Patch):
        low, high = frame_of(item.surface).box(item.surface.s)
    else:
        low, high = item.points.min(axis=0), item.points.max(axis=0)
    return float(camera.depths((low + high)[None] / 2.0)[0])
