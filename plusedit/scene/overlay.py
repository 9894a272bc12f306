"""One overlay: what it sees, its settings and coloring, and the functions that draw."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import Literal, TypeAlias, get_args

from plusedit.document.design import Design
from plusedit.document.shape import Geometry, Shape, ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.camera import Camera
from plusedit.scene.color_scale import Kind
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.items import Item
from plusedit.scene.mesh_drawing import MeshDrawing

Taken: TypeAlias = Literal["curve", "surface", "mesh"]
Group: TypeAlias = Literal["", "Constructions", "Curve analysis", "Surface analysis", "Comparison"]
"""The submenus of the View menu that overlays stand in; "" is the menu itself."""
GROUPS: tuple[Group, ...] = get_args(Group)


@dataclass(frozen=True)
class Setting:
    """A positive number that changes how an overlay is drawn; set by dragging, in even ratios."""

    name: str
    title: str
    usual: float
    least: float
    most: float


CONTRAST = Setting("contrast", "Contrast", 1.0, 0.01, 100.0)
"""Of an overlay that colors surfaces: by how much the span of its scale is narrowed."""


@dataclass(frozen=True, eq=False)
class Seen:
    """All that an overlay may know of the view that it is drawn in."""

    camera: Camera
    lines: tuple[int, ...] = ()
    """the selected control lines or planes of the shape, rising"""
    settings: Mapping[str, float] = field(default_factory=dict)
    """the numbers of the overlay, each by its name"""
    design: Design | None = None
    """what else there is, so that sizes may be the same for all of it"""
    findings: object = None
    """what was found beside of a mesh (`finding_of_meshes`); None while it is not known"""
    is_selected: bool = False
    """whether the shape is"""
    is_hurried: bool = False
    """whether an edit is going on, and what takes its time can be told once it rests; of designs"""
    waits: bool = True
    """whether what is found beside is waited for, as in pictures; of designs"""


DrawCurve: TypeAlias = Callable[[Shape, PlusCurve, Seen], Iterable[Item]]
DrawSurface: TypeAlias = Callable[[Shape, PlusSurface, Seen], Iterable[Item]]
DrawMesh: TypeAlias = Callable[[Shape, MeshSurface, Seen], Iterable[Item]]
DrawDesign: TypeAlias = Callable[[Design, frozenset[ShapeId], Seen], Iterable[Item]]
DrawPlace: TypeAlias = Callable[[Shape, Geometry, tuple[float, ...], Seen], Iterable[Item]]
Numbers: TypeAlias = Mapping[str, float]
SurfaceValues: TypeAlias = (
    Callable[[PlusSurface, Floats, Floats], Floats]
    | Callable[[PlusSurface, Floats, Floats, Numbers], Floats]
)
MeshValues: TypeAlias = (
    Callable[[MeshSurface, MeshDrawing], Floats]
    | Callable[[MeshSurface, MeshDrawing, Numbers], Floats]
)
DrawnSurfaces: TypeAlias = Mapping[ShapeId, Grids | MeshDrawing]
"""How surfaces are drawn: at every pair of some parameters, or as a net of triangles."""
DesignValues: TypeAlias = Callable[
    [Design, frozenset[ShapeId], DrawnSurfaces, bool], Mapping[ShapeId, Floats]
]
FindOfMesh: TypeAlias = Callable[[MeshSurface, Numbers], object]
StripeKind: TypeAlias = Literal["", "zebra", "reflection", "isophotes"]


@dataclass(frozen=True)
class Coloring:
    """How values become colors, and what the legend says of them."""

    title: str = ""
    """of the legend; that of the overlay if empty"""
    unit: str = ""
    kind: Kind = "sequential"
    """diverging where zero is in the middle and both signs count alike"""
    fixed: tuple[float | None, float | None] = (None, None)
    """the values at the ends of the scale; where None, by what is shown: from zero, for values that
    are all positive, to a round number that but a few are beyond"""
    least: float = 0.0
    """the largest value is taken to be that at least, so that rounding errors have no colors"""
    outliers: float = 1.0
    """percent of the values of a shape at either end that may lie beyond the scale"""


USUAL_COLORING = Coloring()


@dataclass
class Overlay:
    """One entry of the shelf."""

    name: str
    title: str
    """what the View menu says"""
    order: int
    """its place in the menu, and in drawing: the lowest lies below all others"""
    shortcut: str
    """such as "Shift+H", or nothing"""
    coloring: Coloring = USUAL_COLORING
    settings: tuple[Setting, ...] = ()
    group: Group = ""
    """where in the menu it stands"""
    stripes: StripeKind = ""
    """what light makes of surfaces in space; "" leaves it as it is"""
    _of_designs: DrawDesign | None = field(default=None, init=False, repr=False)
    _under_pointer: DrawPlace | None = field(default=None, init=False, repr=False)
    _of_curves: DrawCurve | None = field(default=None, init=False, repr=False)
    _of_surfaces: DrawSurface | None = field(default=None, init=False, repr=False)
    _of_meshes: DrawMesh | None = field(default=None, init=False, repr=False)
    _surface_values: SurfaceValues | None = field(default=None, init=False, repr=False)
    _mesh_values: MeshValues | None = field(default=None, init=False, repr=False)
    _design_values: DesignValues | None = field(default=None, init=False, repr=False)
    _find_of_mesh: FindOfMesh | None = field(default=None, init=False, repr=False)
    finds_by: tuple[str, ...] = field(default=(), init=False)
    """the settings that what is found of meshes depends on"""

    @property
    def takes(self) -> frozenset[Taken]:
        """What it can be drawn of, or colors."""
        draws: dict[Taken, object] = {
            "curve": self._of_curves,
            "surface": self._of_surfaces,
            "mesh": self._of_meshes,
        }
        striped: frozenset[Taken] = frozenset({"surface", "mesh"} if self.stripes else ())
        return self.colors | striped | {kind for kind, draw in draws.items() if draw is not None}

    @property
    def is_of_designs(self) -> bool:
        """Whether it draws something about a design as a whole."""
        return self._of_designs is not None

    @property
    def follows_pointer(self) -> bool:
        """Whether it draws something at the place under the pointer."""
        return self._under_pointer is not None

    @property
    def colors(self) -> frozenset[Taken]:
        """What it colors; nothing if it draws items alone."""
        values: dict[Taken, object] = {"surface": self._surface_values, "mesh": self._mesh_values}
        return frozenset(kind for kind, given in values.items() if given is not None)

    @property
    def compares(self) -> bool:
        """Whether it colors shapes of a design by others."""
        return self._design_values is not None

    @property
    def finds(self) -> bool:
        """Whether what it draws of meshes has to be found beside."""
        return self._find_of_mesh is not None

    def find_of_mesh(self, surface: MeshSurface, numbers: Numbers) -> object:
        """What it needs to know to draw a mesh; takes its time, in whatever thread."""
        return None if self._find_of_mesh is None else self._find_of_mesh(surface, numbers)

    @property
    def paints(self) -> bool:
        """Whether it changes what surfaces look like: of such only one is switched on."""
        return bool(self.colors) or self.compares or bool(self.stripes)

    def surface_values(
        self, surface: PlusSurface, u: Floats, v: Floats, numbers: Numbers | None = None
    ) -> Floats | None:
        """(m_u, m_v) what a surface is colored by at parameters u and v; None if by nothing.

        `numbers` are settings that are not as usual.
        """
        if self._surface_values is None:
            return None
        return self._surface_values(surface, u, v, *self._arguments(numbers))

    def mesh_values(
        self, surface: MeshSurface, drawing: MeshDrawing, numbers: Numbers | None = None
    ) -> Floats | None:
        """(n,) what a surface is colored by at the points that are drawn; None if by nothing."""
        if self._mesh_values is None:
            return None
        return self._mesh_values(surface, drawing, *self._arguments(numbers))

    def design_values(
        self, design: Design, chosen: frozenset[ShapeId], drawn: DrawnSurfaces, wait: bool
    ) -> Mapping[ShapeId, Floats]:
        """What the shapes of a design are colored by, at the points that are drawn.

        The same arrays for the same shapes. Without `wait` what is known by now.
        """
        if self._design_values is None:
            return {}
        return self._design_values(design, chosen, drawn, wait)

    def _arguments(self, numbers: Numbers | None) -> tuple[Numbers, ...]:
        if all(setting is CONTRAST for setting in self.settings):
            return ()
        return ({**self.numbers({}), **(numbers or {})},)

    def draw(self, shape: Shape, geometry: Geometry, seen: Seen) -> Iterable[Item]:
        """What is drawn of a shape; nothing of a kind that it does not take."""
        if isinstance(geometry, PlusCurve):
            return self._of_curves(shape, geometry, seen) if self._of_curves else ()
        if isinstance(geometry, MeshSurface):
            return self._of_meshes(shape, geometry, seen) if self._of_meshes else ()
        return self._of_surfaces(shape, geometry, seen) if self._of_surfaces else ()

    def draw_design(self, design: Design, chosen: frozenset[ShapeId], seen: Seen) -> Iterable[Item]:
        """What is drawn of a design as a whole, of which some shapes are selected."""
        return () if self._of_designs is None else self._of_designs(design, chosen, seen)

    def draw_place(
        self, shape: Shape, geometry: Geometry, place: tuple[float, ...], seen: Seen
    ) -> Iterable[Item]:
        """What is drawn at the place of a shape that is under the pointer.

        The place is (u,) of a curve, (u, v) of a surface.
        """
        if self._under_pointer is None:
            return ()
        return self._under_pointer(shape, geometry, place, seen)

    def numbers(self, values: Mapping[str, float]) -> dict[str, float]:
        """The settings, each by its name, from values by "overlay.setting"; else the usual."""
        return {
            setting.name: min(
                max(values.get(f"{self.name}.{setting.name}", setting.usual), setting.least),
                setting.most,
            )
            for setting in self.settings
        }

    def of_curves(self, draw: DrawCurve) -> DrawCurve:
        """A decorator: draw curves like that."""
        self._of_curves = draw
        return draw

    def of_surfaces(self, draw: DrawSurface) -> DrawSurface:
        """A decorator: draw surfaces like that."""
        self._of_surfaces = draw
        return draw

    def of_meshes(self, draw: DrawMesh) -> DrawMesh:
        """A decorator: draw surfaces of meshes like that."""
        self._of_meshes = draw
        return draw

    def finding_of_meshes(self, *settings: str) -> Callable[[FindOfMesh], FindOfMesh]:
        """A decorator: find that beside, by these settings; `Seen.findings` when meshes are drawn.

        For what takes longer than a frame may.
        """

        def register(find: FindOfMesh) -> FindOfMesh:
            self._find_of_mesh, self.finds_by = find, settings
            return find

        return register

    def of_designs(self, draw: DrawDesign) -> DrawDesign:
        """A decorator: draw all of a design like that, at once."""
        self._of_designs = draw
        return draw

    def under_pointer(self, draw: DrawPlace) -> DrawPlace:
        """A decorator: draw the place of a shape under the pointer like that."""
        self._under_pointer = draw
        return draw

    def coloring_of_surfaces(self, values: SurfaceValues) -> SurfaceValues:
        """A decorator: color surfaces by those values."""
        self._surface_values = values
        return values

    def coloring_of_meshes(self, values: MeshValues) -> MeshValues:
        """A decorator: color surfaces of meshes by those values."""
        self._mesh_values = values
        return values

    def coloring_of_designs(self, values: DesignValues) -> DesignValues:
        """A decorator: color some shapes of a design by those values, which others decide."""
        self._design_values = values
        return values
