"""Another map for a mesh: worked out beside the window, then one step."""

from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from plusedit.app.background import CancelledError, Progress, in_background
from plusedit.commands.base import unlocked
from plusedit.commands.meshes import Remap
from plusedit.document.design import EditError
from plusedit.document.map_record import MapRecord
from plusedit.document.shape import ShapeId
from plusedit.scene.drawn_mesh import keep, previewed
from plusedit.scene.mesh_drawing import MeshDrawing
from plusedit.views.desk import Desk

if TYPE_CHECKING:
    from plusedit.geometry.mesh.mapping import Mapped
    from plusedit.geometry.mesh.mesh_surface import MeshSurface

MAPPED = 0.85  # of the time; then the surface is evaluated


class Remapping:
    """Does what is asked for on the desk."""

    def __init__(self, desk: Desk, parent: QWidget) -> None:
        self._desk, self._parent = desk, parent
        desk.map_asked.listen(self.remap)

    def remap(self, shape_id: ShapeId, record: MapRecord) -> None:
        """Give a mesh the parameters of that map; why it can't be done is said."""
        self._desk.gestures.cancel()
        design, progress = self._desk.session.committed, Progress()
        try:
            name, surface = unlocked(design, shape_id).name, design.mesh(shape_id)
            found, command, drawing = in_background(
                self._parent,
                f"Laying out {name} …",
                lambda: made(shape_id, surface, record, progress),
                progress=progress,
            )
        except CancelledError:
            self._desk.say(f"{name} keeps its map.")
        except (EditError, ValueError) as error:
            text = str(error)
            self._desk.say(text if text.endswith(".") else f"{text}.")
        else:
            if self._desk.session.committed is not design:
                self._desk.say(f"{name} was changed meanwhile and keeps its map.")
                return
            assert command.made is not None
            keep(command.made[1], drawing)
            if not self._desk.commit(command):
                self._desk.say(told(found))


def made(
    shape_id: ShapeId, surface: "MeshSurface", record: MapRecord, progress: Progress
) -> "tuple[Mapped, Remap, MeshDrawing]":
    """What the map gives, the edit, and the surface as it is to be drawn then.

    ValueError where the map does not suit the mesh.
    """
    from plusedit.geometry.mesh.mapping import mapped
    from plusedit.geometry.mesh.remapping import remapped

    found = mapped(
        surface.mesh,
        wish=record.name,
        cone_points=record.cone_points or None,
        progress=lambda share, words: progress.tell(MAPPED * share, words),
    )
    after = remapped(surface, found.domain, found.parameters)
    progress.tell(MAPPED, "evaluating the surface")
    command = Remap(
        shape_id,
        found.domain,
        after.parameters,
        record.name,
        record.cone_points,
        (surface, after),
    )
    return found, command, previewed(after)


def told(found: "Mapped") -> str:
    """Such as "The map is a disk now; 3 triangles are turned over by the map."."""
    return f"{'; '.join([f'The map is now: {found.title}', *found.notes])}."
