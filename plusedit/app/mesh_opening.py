"""Files of meshes and terrains made into shapes that the window can draw at once."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from plusedit.commands.base import Together
from plusedit.commands.shapes import AddShapes, DeleteShapes, Reorder
from plusedit.document.design import Design
from plusedit.document.shape import Shape, ShapeId
from plusedit.io.opening import is_mesh, mesh_suffixes
from plusedit.scene.drawn_mesh import keep, previewed
from plusedit.scene.mesh_drawing import MeshDrawing

if TYPE_CHECKING:
    from plusedit.geometry.mesh.maps import Progress
    from plusedit.io.mesh_import import Imported, ImportOptions
    from plusedit.io.mesh_report import ImportReport

__all__ = ["MeshReading", "is_mesh", "mesh_suffixes", "opened", "read_again", "told"]

MADE = 0.85  # of the time, when there are surfaces; then they are evaluated
AT_ONCE = 1_000_000  # points evaluated before they are shown; the window has the others done


@dataclass(frozen=True, eq=False)
class MeshReading:
    """A file of a mesh as it was read."""

    path: Path
    options: "ImportOptions"
    imported: "Imported"
    drawings: tuple[MeshDrawing, ...] = ()
    """of the first parts"""
    ids: tuple[ShapeId, ...] = ()
    """what the parts are called in the design; empty before they are there"""

    @property
    def report(self) -> "ImportReport":
        return self.imported.report

    @property
    def design(self) -> Design:
        """Of the parts alone."""
        return self.imported.design

    def draw_at_once(self) -> None:
        """Have the surfaces drawn as they were evaluated; to be called in the window's thread."""
        for part, drawing in zip(self.imported.parts, self.drawings, strict=False):
            keep(part.surface, drawing)

    def placed(self, ids: tuple[ShapeId, ...]) -> "MeshReading":
        """The same, once its parts are in a design under those names."""
        return replace(self, ids=ids)


def opened(path: Path, tell: "Progress", options: "ImportOptions | None" = None) -> MeshReading:
    """The parts of a mesh or terrain as surfaces, the largest first.

    FormatError in one sentence; what `tell` raises.
    """
    from plusedit.io.mesh_import import ImportOptions, import_mesh

    wished = options or ImportOptions()
    found = import_mesh(path, wished, lambda share, words: tell(MADE * share, words))
    drawings: list[MeshDrawing] = []
    points = 0
    # Worked out here and not in the window's thread, which draws them next.
    for number, part in enumerate(found.parts):
        tell(MADE + (1.0 - MADE) * number / len(found.parts), "Evaluating the surfaces")
        if points <= AT_ONCE:
            drawings.append(previewed(part.surface))
            points += len(drawings[-1].points)
    tell(1.0, "Done")
    return MeshReading(path, wished, found, tuple(drawings))


def read_again(design: Design, before: MeshReading, now: MeshReading) -> Together:
    """The edit that puts the parts of a file, read in another way, in place of those before.

    Parts that the person has deleted are not missed. Where there are as many as before, each keeps
    the name and the style that it has been given.
    """
    gone = tuple(shape_id for shape_id in before.ids if shape_id in design)
    rest = design.without(*gone)
    are_alike = len(before.ids) == len(now.imported.parts)
    found: dict[ShapeId, Shape] = {}
    for number, (shape_id, shape) in enumerate(now.imported.shapes):
        if are_alike and before.ids[number] in design:
            shape_id, old = before.ids[number], design[before.ids[number]]
            shape = replace(shape, name=old.name, style=old.style)
        else:
            taken = {**design.shapes, **found}
            shape_id = replace(design, shapes=taken).unused_id(shape_id)
        found[shape_id] = shape
    name = f"Import {now.path.name} again"
    place = list(design).index(gone[0]) if gone else len(design)
    ahead = [shape_id for shape_id in list(design)[:place] if shape_id in rest]
    order = (*ahead, *found, *(shape_id for shape_id in rest if shape_id not in ahead))
    commands = (DeleteShapes(gone), AddShapes(tuple(found.items()), name), Reorder(order))
    return Together(name, commands)


def told(report: "ImportReport") -> tuple[str, ...]:
    """What is said at once, beside the report with all the numbers."""
    return (report.summary, *report.notes)
