"""The fields of a basis as a form, made from the fields of its dataclass.

A new family needs nothing here: whole numbers, switches and rows of numbers are told apart by
the types that the family declares; `metadata` may give another title or key.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import Field as Declared
from dataclasses import fields
from typing import Any, get_type_hints

from PySide6.QtWidgets import QCheckBox, QFormLayout, QWidget

from plusedit.commands.base import Command
from plusedit.commands.curves import ChangeOrder, SetBasisField, SetClosed
from plusedit.commands.surfaces import ChangeOrderOf, SetBasisFieldOf, SetClosedOf
from plusedit.document.shape import ShapeId
from plusedit.geometry.bases import Basis
from plusedit.geometry.surface import Way
from plusedit.views.arithmetic import calculated, written
from plusedit.views.desk import Desk
from plusedit.views.fields import MIXED, Field, NumberField
from plusedit.views.live import common

Numbers = tuple[float, ...]
USUAL = "uniform"  # what a row of numbers is called that the family works out itself


def numbers_from(text: str) -> Numbers | float | None:
    """One number, several between spaces, commas or semicolons, or None for an empty text."""
    words = text.replace(";", " ").replace(",", " ").replace("[", " ").replace("]", " ").split()
    if not words:
        return None
    values = tuple(calculated(word) for word in words)
    return values[0] if len(values) == 1 else values


def numbers_text(value: Numbers | float | None) -> str:
    """Such as "0.5" or "0 0.25 1": what `numbers_from` reads."""
    if value is None:
        return ""
    row = value if isinstance(value, tuple) else (value,)
    return "  ".join(written(number) for number in row)


def declared(kind: type[Basis]) -> list[Declared[Any]]:
    """The fields that a family can be asked for: all but how many control lines there are."""
    return [f for f in fields(kind) if f.name != "size"]  # type: ignore[arg-type]


class BasisForm(QWidget):
    """The parameters of the basis that the selected shapes have in common, one way or all."""

    def __init__(self, desk: Desk, way: Way | None = None) -> None:
        super().__init__()
        self._desk, self._way = desk, way
        self._ids: tuple[ShapeId, ...] = ()
        self._kind: type[Basis] | None = None
        self._show: dict[str, Callable[[Sequence[object]], None]] = {}
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.setSpacing(4)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)

    def show_bases(self, by_shape: Mapping[ShapeId, Basis]) -> None:
        """Show the fields of these bases if they are of one family, else nothing."""
        self._ids = tuple(by_shape)
        bases = list(by_shape.values())
        kind = common(type(basis) for basis in bases)
        if kind is not self._kind:
            self._build(kind)
        for name, show in self._show.items():
            show([getattr(basis, name) for basis in bases])
        self.setVisible(bool(self._show))

    def _build(self, kind: type[Basis] | None) -> None:
        self._kind = kind
        self._show = {}
        while self._form.rowCount():
            self._form.removeRow(0)
        if kind is None:
            return
        hints = get_type_hints(kind)
        for field in declared(kind):
            key = str(field.metadata.get("key", field.name))
            make = {bool: self._switch, int: self._whole}.get(hints[field.name], self._row)
            widget, show = make(
                field.name, key if self._way is None else f"{key} along {self._way}"
            )
            self._form.addRow(row_label(str(field.metadata.get("title", key.capitalize()))), widget)
            self._show[field.name] = show

    def _set(self, name: str, value: object) -> str:
        make = self._of_curves if self._way is None else self._of_surfaces
        return self._desk.commit(make(name, value))

    def _of_curves(self, name: str, value: object) -> Command:
        if name == "order" and isinstance(value, int):
            return ChangeOrder(self._ids, value)
        if name == "closed":
            return SetClosed(self._ids, bool(value))
        return SetBasisField(self._ids, name, value)

    def _of_surfaces(self, name: str, value: object) -> Command:
        way: Way = self._way or "u"
        if name == "order" and isinstance(value, int):
            return ChangeOrderOf(self._ids, way, value)
        if name == "closed":
            return SetClosedOf(self._ids, way, bool(value))
        return SetBasisFieldOf(self._ids, way, name, value)

    def _switch(self, name: str, key: str) -> tuple[QWidget, Callable[[Sequence[object]], None]]:
        box = QCheckBox()
        box.setAccessibleName(key)
        box.clicked.connect(lambda: self._set(name, not all(box.property("values"))))

        def show(values: Sequence[object]) -> None:
            box.setProperty("values", list(values))
            check(box, [bool(value) for value in values])

        return box, show

    def _whole(self, name: str, key: str) -> tuple[QWidget, Callable[[Sequence[object]], None]]:
        field = NumberField(key, lambda value: self._set(name, round(value)), whole=True)

        def show(values: Sequence[object]) -> None:
            value = common(values)
            field.show_value(value if isinstance(value, int) else None)

        return field, show

    def _row(self, name: str, key: str) -> tuple[QWidget, Callable[[Sequence[object]], None]]:
        field: Field[Numbers | float | None] = Field(
            key, numbers_from, numbers_text, lambda value: self._set(name, value)
        )
        field.setToolTip("Numbers with spaces between them")

        def show(values: Sequence[object]) -> None:
            value = common(values)
            is_usual = all(each is None for each in values)
            field.show_value(
                value if isinstance(value, float | tuple) else None,
                mixed=USUAL if is_usual else MIXED,
            )
            field.setToolTip(field.text() or "Numbers with spaces between them")

        return field, show


def check(box: QCheckBox, values: Sequence[bool]) -> None:
    """Show a switch as on, off, or half where the values differ."""
    from PySide6.QtCore import Qt

    mixed = any(values) and not all(values)
    box.setTristate(mixed)
    state = Qt.CheckState.Checked if all(values) else Qt.CheckState.Unchecked
    box.setCheckState(Qt.CheckState.PartiallyChecked if mixed else state)


LABEL_WIDTH = 76  # logical pixels, so that all fields of a pane begin on one line


def row_label(text: str) -> QWidget:
    """The label of one row of a form."""
    from plusedit.views.live import quiet

    label = quiet(text)
    label.setFixedWidth(LABEL_WIDTH)
    return label
