"""What the selected shapes keep, and why some of it can't be kept now."""

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from plusedit.commands.constraints import Constrain, Release
from plusedit.document.constraining import problems_of
from plusedit.document.shape import Shape, ShapeId
from plusedit.geometry.constraints import Wish, constraints
from plusedit.interaction.constraint_actions import wish_of
from plusedit.views.desk import Desk
from plusedit.views.live import quiet, title

ON, PARTLY, OFF = Qt.CheckState.Checked, Qt.CheckState.PartiallyChecked, Qt.CheckState.Unchecked


class ConstraintForm(QWidget):
    """A box for every constraint that the selected shapes can have."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._shapes: dict[ShapeId, Shape] = {}
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addWidget(title("Constraints"))
        self.boxes: dict[str, QCheckBox] = {}
        for kind in sorted(constraints, key=lambda kind: constraints[kind].order):
            box = QCheckBox(constraints[kind].title)
            box.clicked.connect(partial(self._switch, kind))
            self.boxes[kind] = box
            column.addWidget(box)
        self.problems = quiet()
        column.addWidget(self.problems)

    def show_shapes(self, shapes: dict[ShapeId, Shape]) -> None:
        """Show what these shapes keep; hidden where none of them can keep anything."""
        self._shapes = {i: shape for i, shape in shapes.items() if shape.plus is not None}
        self.setVisible(bool(self._shapes))
        for kind, box in self.boxes.items():
            taking = self._taking(kind)
            box.setVisible(bool(taking))
            kept = [self._kept(shape, kind) for shape in taking.values()]
            count = sum(wish is not None for wish in kept)
            box.setTristate(0 < count < len(kept))
            box.setCheckState(ON if kept and count == len(kept) else PARTLY if count else OFF)
            box.setText(_worded(kind, [wish for wish in kept if wish is not None]))
        told = dict.fromkeys(
            words for shape in self._shapes.values() for words in problems_of(shape).values()
        )
        self.problems.setText("\n".join(told))
        self.problems.setVisible(bool(told))

    def _taking(self, kind: str) -> dict[ShapeId, Shape]:
        return {
            i: shape
            for i, shape in self._shapes.items()
            if shape.plus is not None and constraints[kind].takes(shape.plus)
        }

    @staticmethod
    def _kept(shape: Shape, kind: str) -> Wish | None:
        return next((wish for wish in shape.constraints if wish.kind == kind), None)

    def _switch(self, kind: str) -> None:
        """Set it for all shapes that can have it, or release it where all keep it."""
        taking = self._taking(kind)
        if all(self._kept(shape, kind) is not None for shape in taking.values()):
            self._desk.commit(Release(tuple(taking), kind))
        else:
            stage = self._desk.gestures.stage()
            self._desk.commit(Constrain({i: wish_of(stage, i, kind) for i in taking}))
        # Where it can't be kept the box has to go back to what is so.
        design = self._desk.session.design
        self.show_shapes({i: design[i] for i in self._shapes if i in design})


def _worded(kind: str, wishes: list[Wish]) -> str:
    """The title, with how many points or corners are meant."""
    name = constraints[kind].title
    if len(wishes) != 1 or constraints[kind].counts == "none":
        return name
    return f"{name} ({len(wishes[0].numbers)})"
