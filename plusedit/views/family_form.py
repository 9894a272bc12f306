"""Family and basis of the selected curves, or of the selected surfaces by u or by v."""

from PySide6.QtWidgets import QFormLayout, QVBoxLayout, QWidget

from plusedit.commands.curves import ChangeFamily
from plusedit.commands.surfaces import ChangeFamilyOf
from plusedit.document.shape import PlusGeometry, ShapeId
from plusedit.geometry.bases import Basis, families
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.sizes import family_of
from plusedit.geometry.surface import Way
from plusedit.geometry.surface_sizes import basis_along
from plusedit.views.basis_form import BasisForm, row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import Choice
from plusedit.views.live import common, title

FAMILY_TITLES = {"bezier": "Bézier", "bspline": "B-spline", "rag": "Rational Gaussian"}
HEADS: dict[Way, str] = {"u": "Along u", "v": "Along v"}


def family_titles() -> dict[str, str]:
    """The families by name, as they are called in the window."""
    return {name: FAMILY_TITLES.get(name, name.capitalize()) for name in families}


class FamilyForm(QWidget):
    """The family, and the fields that its basis has; hidden where there is no such shape."""

    def __init__(self, desk: Desk, way: Way | None = None) -> None:
        super().__init__()
        self._desk, self._way = desk, way
        self._ids: tuple[ShapeId, ...] = ()
        called = "family" if way is None else f"family along {way}"
        self._family = Choice(called, family_titles(), self._change_family)
        self._basis = BasisForm(desk, way)
        form = QFormLayout()
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(row_label("Family"), self._family)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        if way is not None:
            column.addSpacing(4)
            column.addWidget(title(HEADS[way]))
        column.addLayout(form)
        column.addWidget(self._basis)

    def show_shapes(self, shapes: dict[ShapeId, PlusGeometry]) -> None:
        """Show what the shapes of this kind have in common."""
        bases = {i: basis for i, g in shapes.items() if (basis := self._of(g)) is not None}
        self._ids = tuple(bases)
        self.setVisible(bool(bases))
        if bases:
            self._family.show_value(common(map(family_of, bases.values())))
            self._basis.show_bases(bases)

    def _of(self, geometry: PlusGeometry) -> Basis | None:
        if isinstance(geometry, PlusCurve):
            return geometry.basis if self._way is None else None
        return None if self._way is None else basis_along(geometry, self._way)

    def _change_family(self, family: str) -> str:
        if self._way is None:
            return self._desk.commit(ChangeFamily(self._ids, family))
        return self._desk.commit(ChangeFamilyOf(self._ids, self._way, family))
