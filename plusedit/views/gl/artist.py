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

from plusedit.scene.items import (
    Item,
    Markers,
    Mesh,
    Patch,
    Polygon,
    Polyline,
    Segments,
    Words,
)
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.stripes import Stripes
from plusedit.scene.theme import Theme
from plusedit.views.gl import functions as gl_names
from plusedit.views.gl.batches import Fills, Lines, Marks
from plusedit.views.gl.colors import Palette
from plusedit.views.gl.functions import Functions
from plusedit.views.gl.ground import Ground, ground_of
from plusedit.views.gl.groups import Group, by_kind, runs_of
from plusedit.views.gl.meshes import Meshes
from plusedit.views.gl.patches import Patches, frame_of
from plusedit.views.gl.programs import Programs
from plusedit.views.gl.sight import WHOLE, Box, Crop, Sight
from plusedit.views.gl.tripod import tripod_camera, tripod_items

HIDDEN = 0.3  # opacity of handles behind a surface
PUSH = (1.0, 1.0)  # by which surfaces stand back so that lines on them are seen: slopes, steps
Flat: TypeAlias = Polyline | Segments | Markers | Polygon
Solid: TypeAlias = Patch | Mesh


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
    stripes: Stripes | None = None
    transparent: bool = False
    """nothing where nothing is drawn, instead of the canvas"""

    @property
    def styles(self) -> tuple[str, ...]:
        """Names that are defined in shaders of light."""
        clay = ("MATCAP",) if self.shading == "matcap" else ()
        return clay if self.stripes is None else (*clay, "STRIPES", self.stripes.kind.upper())


class SpaceArtist:
    """Draws items in one context of OpenGL, and keeps there what is drawn again.

    Everything must be called while that context is current.
    """

    def __init__(self, gl: Functions) -> None:
        self._gl = gl
        self._palette: Palette | None = None
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
    ) -> Sight:
        """Draw a frame into what is bound, which is cleared first; labels are left out.

        What comes back tells where in clip space things were drawn.
        `ratio` is pixels of the device to a logical one. What is seen through is told by the colors
        of the theme, whatever the layer.
        """
        palette = self._palette = self._palette_of(theme)
        solids, flats = _parted(chain(layers.solids, layers.glass, layers.lines))
        ground = ground_of(camera) if look.ground else None
        self._show(solids, flats, layers.handles, ground, camera, palette)
        boxes = self._boxes(solids)
        sight = Sight.of(camera, boxes, palette, look.styles, ratio, crop, look.stripes)
        with self._state(palette, look):
            # First of all: its lines would cross whatever reaches below the ground.
            if ground is not None:
                self._draw_ground(ground, sight)
            self._draw_solids([item for item in solids if _is_opaque(item, palette)], sight)
            self._draw_lines(sight)
            self._draw_veils([item for item in solids if not _is_opaque(item, palette)], sight)
            self._draw_handles(sight)
            if look.axes:
                self._draw_tripod(sight, look.hovered)
        return sight

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
        palette: Palette,
    ) -> None:
        self._patches.show(item for item in solids if isinstance(item, Patch))
        self._meshes.show(item for item in solids if isinstance(item, Mesh))
        veils = [item for item in flats if isinstance(item, Polygon) and _is_veil(item, palette)]
        faint = [item for item in flats if _is_faint_line(item, palette)]
        apart: set[Item] = {*veils, *faint}
        fills, lines, marks = by_kind(item for item in flats if item not in apart)
        self._faint.show(faint, palette, camera)
        self._flats.show((fills, [*veils, *lines], marks), palette, camera)
        self._veils.show((_nearest_last(veils, camera), [], []), palette, camera)
        runs = list(runs_of(handles))
        while len(self._handles) < len(runs):
            self._handles.append(self._group())
        while len(self._handles) > len(runs):
            self._handles.pop().release()
        for group, run in zip(self._handles, runs, strict=True):
            group.show(run, palette, camera)
        self._ground.show([] if ground is None else ground.items, palette, camera)

    def _boxes(self, solids: Sequence[Solid]) -> Iterator[Box]:
        for item in solids:
            if isinstance(item, Patch):
                yield frame_of(item.surface).box(item.surface.s)
            elif len(item.points):
                yield self._meshes.box(item)
        for group in (self._flats, self._veils, *self._handles):
            yield from group.boxes()
        for lines in (self._faint, self._ground):
            if lines.box is not None:
                yield lines.box

    # What is drawn

    @contextmanager
    def _state(self, palette: Palette, look: Look) -> Iterator[None]:
        """The settings that drawing relies on; afterwards those that Qt and others expect."""
        gl, names = self._gl, gl_names
        gl.ColorMask(1, 1, 1, 1)
        gl.DepthMask(1)
        gl.ClearDepth(1.0)
        red, green, blue, _ = palette.shade("canvas")
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

    def _draw_solids(self, solids: Sequence[Solid], sight: Sight) -> None:
        gl = self._gl
        gl.Disable(gl_names.BLEND)
        gl.Enable(gl_names.POLYGON_OFFSET_FILL)
        gl.PolygonOffset(*PUSH)
        for item in solids:
            self._draw_solid(item, sight)
        gl.Disable(gl_names.POLYGON_OFFSET_FILL)
        gl.Enable(gl_names.BLEND)

    def _draw_solid(self, item: Solid, sight: Sight) -> None:
        if isinstance(item, Patch):
            self._patches.draw(item, sight)
        else:
            self._meshes.draw(item, sight)

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

    def _draw_veils(self, veils: Sequence[Solid], sight: Sight) -> None:
        """What lets through: the farthest first, of each the side that looks away first."""
        gl = self._gl
        gl.DepthMask(0)
        self._veils.draw(sight)
        gl.Enable(gl_names.CULL_FACE)
        for item in sorted(veils, key=lambda item: -_depth(item, sight.camera)):
            for culled in (gl_names.FRONT, gl_names.BACK):
                gl.CullFace(culled)
                self._draw_solid(item, sight)
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

    def _draw_tripod(self, sight: Sight, hovered: str | None) -> None:
        small = tripod_camera(sight.camera)
        for group, layer in zip(self._tripod, tripod_items(sight.camera, hovered), strict=True):
            group.show(by_kind(layer), sight.palette, small)
        boxes = [box for group in self._tripod for box in group.boxes()]
        sight = Sight.of(small, boxes, sight.palette, (), sight.ratio, sight.crop)
        self._gl.Clear(gl_names.DEPTH_BUFFER_BIT)
        for group in self._tripod:
            group.draw(sight)

    # What there is of its own

    def _palette_of(self, theme: Theme) -> Palette:
        """The same for the same colors."""
        kept = self._palette
        return kept if kept is not None and kept.theme == theme else Palette(theme)

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
        elif not isinstance(item, Words):
            flats.append(item)
    return solids, flats


def _is_opaque(item: Solid, palette: Palette) -> bool:
    return all(not palette.lets_through(color) for color in (item.front, item.back))


def _is_veil(item: Polygon, palette: Palette) -> bool:
    return palette.lets_through(item.fill)


def _is_faint_line(item: Item, palette: Palette) -> bool:
    return isinstance(item, Polyline | Segments) and palette.lets_through(item.color)


def _nearest_last(veils: Sequence[Polygon], camera: SpaceCamera) -> list[Item]:
    return [*sorted(veils, key=lambda item: -float(camera.depths(item.points).mean()))]


def _depth(item: Solid, camera: SpaceCamera) -> float:
    if isinstance(item, Patch):
        low, high = frame_of(item.surface).box(item.surface.s)
    else:
        low, high = item.points.min(axis=0), item.points.max(axis=0)
    return float(camera.depths((low + high)[None] / 2.0)[0])
