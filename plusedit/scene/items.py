"""What a canvas must be able to draw. Positions are of the world, sizes are logical pixels.

A color is "#rrggbb", "#rrggbbaa", or the name of a role of the theme such as "plus" or "selected";
"plus@40" is either at 40 % of its opacity.
"""

from dataclasses import dataclass
from typing import Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.blend import Grid
from plusedit.geometry.surface import PlusSurface

Dash: TypeAlias = Literal["solid", "dash", "dot"]
Anchor: TypeAlias = Literal["left", "center", "right"]
Mark: TypeAlias = Literal["circle", "square", "diamond", "ring", "cross"]


@dataclass(frozen=True, eq=False)
class Polyline:
    """A line through points (m, dim)."""

    points: Floats
    color: str
    width: float = 1.0
    dash: Dash = "solid"


@dataclass(frozen=True, eq=False)
class Polygon:
    """A filled area (m, dim), with or without an outline."""

    points: Floats
    fill: str
    outline: str | None = None
    width: float = 1.0


@dataclass(frozen=True, eq=False)
class Segments:
    """Separate segments between starts and ends, (m, dim) each."""

    starts: Floats
    ends: Floats
    color: str
    width: float = 1.0
    dash: Dash = "solid"


@dataclass(frozen=True, eq=False)
class Markers:
    """The same mark at every point (m, dim)."""

    points: Floats
    mark: Mark
    size: float
    """diameter"""
    fill: str | None
    """None: hollow, filled with the canvas"""
    outline: str
    width: float = 1.5


@dataclass(frozen=True, eq=False)
class Label:
    """A short text beside a point (dim,)."""

    at: Floats
    text: str
    color: str
    offset: tuple[float, float] = (0.0, 0.0)
    """of the anchor, on the base line, from the point; pixels to the right and downwards"""
    anchor: Anchor = "left"
    size: float = 12.0
    rank: int | None = None
    """of a label that gives way to those of lower ranks where they are crowded; None: it stays"""
    instead: tuple[tuple[float, float], ...] = ()
    """offsets that serve as well, if that one leads where there is no room"""


@dataclass(frozen=True, eq=False)
class Patch:
    """A plus surface, shaded; only the 3D view draws it.

    What it is made of stays while s changes: then nothing but one number goes to the screen.
    """

    surface: PlusSurface
    grid_u: Grid
    """parameters at which it is sampled, 0 and 1 among them"""
    grid_v: Grid
    front: str = "front"
    """the side that the normal S_u x S_v points to"""
    back: str = "back"
    wire: str | None = None
    """color of the lines between samples, None for none"""
    colors: NDArray[np.float32] | None = None
    """(m_u, m_v, 3) red, green and blue of every sample, 0 to 1, in place of those of both sides"""


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles, shaded; only the 3D view draws them."""

    points: Floats
    """(m, 3)"""
    triangles: NDArray[np.int32]
    """(k, 3) numbers of points, counter-clockwise as seen from the front"""
    normals: Floats | None = None
    """(m, 3) unit vectors, or None for flat triangles"""
    front: str = "front"
    back: str = "back"
    colors: NDArray[np.float32] | None = None
    """(m, 3) red, green and blue of every point, 0 to 1, in place of the colors of both sides"""


@dataclass(frozen=True, eq=False)
class Legend:
    """What the colors of surfaces stand for: a bar with numbers, in a corner of the picture."""

    title: str
    unit: str
    """empty where there is none"""
    colors: tuple[str, ...]
    """along the bar, from low values to high ones"""
    ticks: tuple[tuple[float, str], ...]
    """how far along the bar, 0 to 1, and what stands there"""
    is_open: tuple[bool, bool] = (False, False)
    """whether some values are below its low end, or above its high end"""


@dataclass(frozen=True)
class Row:
    """A line of a caption."""

    text: str
    value: str = ""
    """a number with its unit, at the right edge"""
    color: str = ""
    """what is drawn in that color is meant; empty if no color tells it"""


@dataclass(frozen=True, eq=False)
class Caption:
    """Words and numbers in a corner of the picture."""

    title: str
    rows: tuple[Row, ...] = ()
    at: tuple[float, float] = (0.0, 0.0)
    """pixels to the right and upwards from its usual place, in the lower left corner: where other
    captions are already"""


Words: TypeAlias = Label | Legend | Caption
"""What is written: in front of everything, by no light, at no depth."""
Item: TypeAlias = Polyline | Polygon | Segments | Markers | Label | Patch | Mesh | Legend | Caption
