"""Undo and redo. An edit has no inverse: the history keeps the designs themselves."""

from collections.abc import Iterator
from dataclasses import dataclass

from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.polygons import Numbers
from plusedit.geometry.net import Flags
from plusedit.geometry.surface import PlusSurface

BUDGET = 512 * 2**20  # bytes that old designs may hold before the oldest are forgotten
SMALL = 2000  # bytes that any shape takes besides its arrays, roughly
PLACE = 100  # bytes that a design takes to list one shape, its own or a shared one


@dataclass(frozen=True, eq=False)
class Step:
    """A design and the edit that led to it."""

    label: str
    design: Design
    size: int
    """bytes that this design does not share with the one before"""


class History:
    """Designs in the order in which they were made, and where among them we are.

    There are as many as fit the budget, in bytes, and one more in any case: the last edit can
    be undone however large it was.
    """

    def __init__(self, design: Design, *, budget: int = BUDGET) -> None:
        self._steps = [Step("", design, 0)]
        self._at = 0
        self._size = 0
        self._budget = budget
        self._saved: Design | None = design

    @property
    def design(self) -> Design:
        """The current design."""
        return self._steps[self._at].design

    @property
    def undo_label(self) -> str | None:
        """What undo would take back, or None."""
        return self._steps[self._at].label if self._at else None

    @property
    def redo_label(self) -> str | None:
        """What redo would do again, or None."""
        return self._steps[self._at + 1].label if self._at + 1 < len(self._steps) else None

    @property
    def is_saved(self) -> bool:
        """Whether the current design is the one that was saved last."""
        return self._saved is self.design

    def mark_saved(self) -> None:
        """The current design is on disk."""
        self._saved = self.design

    def mark_unsaved(self) -> None:
        """No design of this history is on disk."""
        self._saved = None

    def push(self, label: str, design: Design) -> None:
        """Add a step after the current one; what could have been redone is gone.

        A design that is the current one is no step.
        """
        if design is self.design:
            return
        self._size -= sum(step.size for step in self._steps[self._at + 1 :])
        step = Step(label, design, _bytes_not_shared(self.design, design))
        self._steps[self._at + 1 :] = [step]
        self._size += step.size
        self._at += 1
        self._forget_the_oldest()

    def undo(self) -> None:
        """Go one step back, if there is one."""
        self._at = max(0, self._at - 1)

    def redo(self) -> None:
        """Go one step on, if there is one."""
        self._at = min(len(self._steps) - 1, self._at + 1)

    def _forget_the_oldest(self) -> None:
        gone = 0
        while self._size > self._budget and gone < self._at - 1:
            gone += 1
            self._size -= self._steps[gone].size
        del self._steps[:gone]
        self._at -= gone


def _bytes_not_shared(old: Design, new: Design) -> int:
    total = PLACE * len(new)
    for shape_id, shape in new.shapes.items():
        before = old.shapes.get(shape_id)
        if before is not shape:
            shared = {id(array) for array in _arrays(before)}
            total += SMALL
            total += sum(array.nbytes for array in _arrays(shape) if id(array) not in shared)
    return total


def _arrays(shape: Shape | None) -> Iterator[Floats | Flags | Numbers]:
    # The arrays themselves, not the flat views of them: what is shared is told by identity.
    match shape and shape.geometry:
        case PlusCurve(lines=net) | PlusSurface(planes=net):
            yield from (net.points, net.given, net.automatic)
            if net.weights is not None:
                yield net.weights
        case MeshSurface() as surface:
            yield from _of_mesh(surface)


def _of_mesh(surface: MeshSurface) -> Iterator[Floats | Numbers]:
    mesh = surface.mesh
    yield from (mesh.vertices, mesh.corners, mesh.starts, surface.parameters)
    if surface.factors is not None:
        yield surface.factors
    if surface.edited:
        # An edited surface keeps control planes of its own, but for what the edit before had.
        yield from (surface.net.control_points, surface.net.vectors)
