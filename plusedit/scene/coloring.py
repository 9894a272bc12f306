"""Surfaces colored by values on them: which color stands for what, on all shapes shown alike.

The overlay that is switched on gives the values. Those of surfaces of meshes may take long: they
are kept with what is drawn of the surface, and windows have them found beside. Until then a surface
has the colors that it had before its last change.
"""

from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TypeAlias
from weakref import WeakKeyDictionary

import numpy as np

from plusedit.document.shape import ShapeId
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.surface import PlusSurface
from plusedit.scene.color_scale import SCALES, Colors, Span
from plusedit.scene.drawn_surface import Grids
from plusedit.scene.items import Legend
from plusedit.scene.mesh_drawing import DrawnNet, MeshDrawing
from plusedit.scene.overlays import CONTRAST, Coloring, Numbers, Overlay, in_order

ROUND = (1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)  # ends of scales, times a power of ten
SHADES = 33  # colors that a legend is drawn with
RECENT = 4  # pictures whose colors are kept
USUAL: Numbers = MappingProxyType({})

Key: TypeAlias = tuple[str, frozenset[tuple[str, float]]]
"""An overlay and its settings"""

_OF_MESHES: "WeakKeyDictionary[MeshDrawing, dict[Key, Floats]]" = WeakKeyDictionary()
_LATEST: "WeakKeyDictionary[DrawnNet, dict[str, Floats]]" = WeakKeyDictionary()
"""Those of the last drawing with that net, which may be gone by now."""
_OF_SURFACES: "WeakKeyDictionary[PlusSurface, dict[tuple[Key, Grids], Floats]]"
_OF_SURFACES = WeakKeyDictionary()


@dataclass(frozen=True, eq=False)
class Tints:
    """The colors of all surfaces that are shown, and what they stand for."""

    by_shape: Mapping[ShapeId, Colors] = field(default_factory=lambda: MappingProxyType({}))
    """as many as there are points that are drawn; none for a shape that is not colored"""
    legend: Legend | None = None
    """None where nothing is colored"""


NO_TINTS = Tints()


def coloring_overlay(names: Iterable[str]) -> Overlay | None:
    """The overlay that colors surfaces while those are switched on: one at most."""
    chosen = frozenset(names)
    return next((o for o in in_order() if o.name in chosen and (o.colors or o.compares)), None)


def mesh_values(
    entry: Overlay, surface: MeshSurface, drawing: MeshDrawing, numbers: Numbers = USUAL
) -> Floats | None:
    """(n,) the values at the points that are drawn, found if need be; in whatever thread.

    `numbers` are the settings of the overlay that are not as usual. None where the overlay has no
    values for meshes.
    """
    kept, key = _OF_MESHES.setdefault(drawing, {}), _key(entry, numbers)
    if key not in kept:
        values = entry.mesh_values(surface, drawing, numbers)
        if values is None:
            return None
        kept[key] = _LATEST.setdefault(drawing.net, {})[entry.name] = values
    return kept[key]


def has_values(entry: Overlay, drawing: MeshDrawing, numbers: Numbers = USUAL) -> bool:
    """Whether the values of just that drawing are known."""
    return _key(entry, numbers) in _OF_MESHES.get(drawing, {})


def known_values(
    entry: Overlay, surface: MeshSurface, drawing: MeshDrawing, numbers: Numbers = USUAL
) -> Floats | None:
    """(n,) the values, or else those before the last change; None while there are neither."""
    kept = _OF_MESHES.get(drawing, {}).get(_key(entry, numbers))
    return _LATEST.get(drawing.net, {}).get(entry.name) if kept is None else kept


def _key(entry: Overlay, numbers: Numbers) -> Key:
    return entry.name, frozenset(item for item in numbers.items() if item[0] != CONTRAST.name)


def surface_values(
    entry: Overlay, surface: PlusSurface, grids: Grids, numbers: Numbers = USUAL
) -> Floats | None:
    """(m_u, m_v) the values at the points that are drawn; None where the overlay has none."""
    kept = _OF_SURFACES.setdefault(surface, {})
    key = _key(entry, numbers), grids
    if key not in kept:
        u, v = (grid.parameters for grid in grids)
        values = entry.surface_values(surface, u, v, numbers)
        if values is None:
            return None
        kept[key] = values
    return kept[key]


_recent: deque[tuple[tuple[Coloring, float], tuple[Floats, ...], tuple[list[Colors], Legend]]]
_recent = deque(maxlen=RECENT)


def tinted(entry: Overlay, values: Mapping[ShapeId, Floats], numbers: Numbers = USUAL) -> Tints:
    """The colors for the values of all shapes, on one scale. The same arrays for the same values.

    `numbers` are the settings of the overlay, of which the contrast counts. Nothing is colored
    where no value is a number.
    """
    arrays = tuple(values.values())
    by = entry.coloring, numbers.get(CONTRAST.name, CONTRAST.usual)
    found = next((made for key, old, made in _recent if _is_same(by, key, old, arrays)), None)
    if found is None:
        span = span_of(entry.coloring, arrays, by[1])
        if span is None:
            return NO_TINTS
        scale = SCALES[entry.coloring.kind]
        colors = [scale.at(span.shares(array)) for array in arrays]
        found = colors, legend_of(entry, span, arrays)
        _recent.append((by, arrays, found))
    return Tints(MappingProxyType(dict(zip(values, found[0], strict=True))), found[1])


def _is_same(
    by: tuple[Coloring, float],
    key: tuple[Coloring, float],
    old: tuple[Floats, ...],
    arrays: tuple[Floats, ...],
) -> bool:
    is_as_many = by == key and len(old) == len(arrays)
    return is_as_many and all(a is b for a, b in zip(old, arrays, strict=True))


def span_of(coloring: Coloring, arrays: Iterable[Floats], contrast: float = 1.0) -> Span | None:
    """The span of the scale: whole for every shape but for outliers, with round ends.

    With more contrast so many times shorter. None where no value is a number.
    """
    finite = [kept for array in arrays if len(kept := array[np.isfinite(array)])]
    if not finite:
        return None
    shares = coloring.outliers, 100.0 - coloring.outliers
    ends = np.array([np.percentile(array, shares) for array in finite]) / contrast
    low, high = float(ends[:, 0].min()), float(ends[:, 1].max())
    if coloring.kind == "diverging":
        reach = rounded(max(-low, high, coloring.least))
        low, high = -reach, reach
    elif low >= 0.0:
        low, high = 0.0, rounded(max(high, coloring.least))
    fixed_low, fixed_high = coloring.fixed
    low = low if fixed_low is None else fixed_low
    high = high if fixed_high is None else fixed_high
    return Span(low, high if high > low else low + (coloring.least or 1.0))


def rounded(value: float) -> float:
    """The next round number upwards, 1, 1.5, 2, 3, ... times a power of ten; 1 for zero."""
    if value <= 0.0:
        return 1.0
    power = 10.0 ** np.floor(np.log10(value))
    return float(next(r for r in ROUND if r * power >= value * (1.0 - 1e-9)) * power)


def legend_of(entry: Overlay, span: Span, arrays: Iterable[Floats]) -> Legend:
    """What the colors of those values stand for."""
    known = np.concatenate([array[np.isfinite(array)] for array in arrays])
    slack = 1e-9 * (span.high - span.low)
    return Legend(
        title=entry.coloring.title or entry.title,
        unit=entry.coloring.unit,
        colors=SCALES[entry.coloring.kind].hexadecimal(SHADES),
        ticks=tuple(
            ((value - span.low) / (span.high - span.low), text) for value, text in span.ticks()
        ),
        is_open=(
            float(known.min()) < span.low - slack,
            float(known.max()) > span.high + slack,
        ),
    )
