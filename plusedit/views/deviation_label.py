"""How far surfaces of meshes are from their meshes, in two short lines beside the slider of S."""

from collections.abc import Iterator, Mapping

from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QLabel

from plusedit.document.shape import ShapeId
from plusedit.geometry.mesh.deviation import Deviation, Spread
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.scene.drawn_deviation import known_deviation
from plusedit.scene.drawn_mesh import known_drawing

LEAST = 0.001  # percent; less is said to be less
DIGITS = 2  # of percentages
DIGITS_OF_TIP = 3
MOST = 6  # shapes that the tip tells of
WIDEST = "rms < 0.001 % …"
WHAT = (
    "How far the surface is from the mesh, in percent of the mesh's size: the diagonal of the box "
    "around it"
)


class DeviationLabel(QLabel):
    """The root mean square and the largest distance; of several meshes those farthest off."""

    def __init__(self) -> None:
        super().__init__()
        self._meshes: Mapping[ShapeId, MeshSurface] = {}
        self._names: Mapping[ShapeId, str] = {}
        self._last: dict[ShapeId, Deviation] = {}
        self.setProperty("quiet", True)
        self.setAccessibleName("deviation from the mesh")
        self.setToolTip(WHAT)

    def show_meshes(
        self, meshes: Mapping[ShapeId, MeshSurface], names: Mapping[ShapeId, str]
    ) -> None:
        """Tell of these, as far as they are measured."""
        self._meshes, self._names = meshes, names
        self._last = {i: found for i, found in self._last.items() if i in meshes}
        self.refresh()

    def refresh(self) -> None:
        """Show what is known by now: with dots, what was before the last change."""
        # Here and not before: the font is that of the style, which comes later than the widget.
        self.setFixedWidth(QFontMetrics(self.font()).horizontalAdvance(WIDEST))
        known = {i: _known(surface) for i, surface in self._meshes.items()}
        self._last.update({i: found for i, found in known.items() if found is not None})
        dots = " …" if None in known.values() else ""
        spreads = [_in_percent(found) for found in self._last.values()]
        if spreads:
            rms, largest = (max(s.rms for s in spreads), max(s.largest for s in spreads))
            self.setText(f"rms {percentage(rms)}{dots}\nmax {percentage(largest)}")
        else:
            self.setText(dots.strip())
        self.setToolTip("\n".join((WHAT, *self._tips())))

    def _tips(self) -> Iterator[str]:
        for shape_id in list(self._last)[:MOST]:
            found = self._last[shape_id]
            yield ""
            yield f"{self._names.get(shape_id, '')}  (size {found.diagonal:.{DIGITS_OF_TIP}g})"
            yield f"mesh to surface: {_described(found.to_surface, found.diagonal)}"
            yield f"surface to mesh: {_described(found.to_mesh, found.diagonal)}"
        if len(self._last) > MOST:
            yield f"\nand {len(self._last) - MOST} more"


def percentage(value: float) -> str:
    """A percentage for the eye, such as "0.025 %"."""
    if 0.0 < value < LEAST:
        return f"< {LEAST} %"
    if value <= 0.0:
        return "0 %"
    text = f"{value:#.{DIGITS}g}" if value < 100.0 else f"{value:.0f}"
    return f"{text.rstrip('.')} %"


def _known(surface: MeshSurface) -> Deviation | None:
    drawing = known_drawing(surface)
    return None if drawing is None else known_deviation(drawing)


def _in_percent(found: Deviation) -> Spread:
    scale, spread = 100.0 / (found.diagonal or 1.0), found.to_surface
    return Spread(scale * spread.rms, scale * spread.median, scale * spread.largest)


def _described(spread: Spread, diagonal: float) -> str:
    scale = 100.0 / (diagonal or 1.0)
    parts = (("rms", spread.rms), ("median", spread.median), ("largest", spread.largest))
    return ", ".join(
        f"{name} {percentage(scale * value)} = {value:.{DIGITS_OF_TIP}g}" for name, value in parts
    )
