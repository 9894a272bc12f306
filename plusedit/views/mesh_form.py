"""The numbers of selected surfaces of meshes."""

from dataclasses import replace

from PySide6.QtWidgets import QCheckBox, QFormLayout, QLabel, QWidget

from plusedit.commands.base import Command, Together
from plusedit.commands.curves import SetMagnitude
from plusedit.commands.meshes import SetAreaWeights, SetSmoothness
from plusedit.commands.shapes import SetStyle
from plusedit.document.map_record import map_of
from plusedit.document.shape import ShapeId, Style
from plusedit.geometry.mesh.maps import maps
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.views.basis_form import row_label
from plusedit.views.desk import Desk
from plusedit.views.fields import NumberField
from plusedit.views.live import common


class MeshForm(QWidget):
    """S, s, weights by area, and what the mesh is made of; hidden where there is none."""

    def __init__(self, desk: Desk) -> None:
        super().__init__()
        self._desk = desk
        self._meshes: dict[ShapeId, MeshSurface] = {}
        self.smoothness = NumberField("smoothness S", self._set_smoothness, step=0.05)
        self.magnitude = NumberField("s of meshes", self._set_magnitude, step=0.05)
        self.weights = QCheckBox("Weigh faces by area")
        self.weights.clicked.connect(self._set_weights)
        self.facets = QCheckBox("Show the mesh itself")
        self.facets.setToolTip("In the 3D view, with flat faces, in place of the surface")
        self.facets.clicked.connect(self._set_facets)
        self.counts = QLabel()
        self.map, self.domain = QLabel(), QLabel()
        for label in (self.counts, self.map):
            label.setWordWrap(True)
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setSpacing(4)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.addRow(row_label("S"), self.smoothness)
        form.addRow(row_label("s"), self.magnitude)
        form.addRow(row_label(""), self.weights)
        form.addRow(row_label(""), self.facets)
        form.addRow(row_label("Mesh"), self.counts)
        form.addRow(row_label("Map"), self.map)
        form.addRow(row_label("Domain"), self.domain)

    def show_meshes(self, meshes: dict[ShapeId, MeshSurface]) -> None:
        """Show these; "mixed" where they differ."""
        self._meshes = meshes
        self.setVisible(bool(meshes))
        surfaces = meshes.values()
        self.smoothness.show_value(common(mesh.smoothness for mesh in surfaces))
        self.magnitude.show_value(common(mesh.s for mesh in surfaces))
        self.weights.setChecked(bool(common(mesh.area_weights for mesh in surfaces)))
        self.facets.setChecked(bool(common(self._style_of(i).facets for i in meshes)))
        faces = sum(mesh.mesh.face_count for mesh in surfaces)
        vertices = sum(mesh.mesh.vertex_count for mesh in surfaces)
        self.counts.setText(f"{faces:,} faces, {vertices:,} vertices")
        self.domain.setText(common(mesh.domain.kind for mesh in surfaces) or "mixed")
        self.map.setText(common(map(self._map_of, meshes)) or "mixed")

    def _map_of(self, shape_id: ShapeId) -> str:
        """What the map of a mesh is called."""
        record = map_of(self._desk.session.design[shape_id])
        if record is None:
            return "unknown"
        return maps[record.name].title if record.name in maps else record.name

    def _style_of(self, shape_id: ShapeId) -> Style:
        return self._desk.session.design[shape_id].style

    def _set_facets(self, is_itself: bool) -> None:
        edits: tuple[Command, ...] = tuple(
            SetStyle((i,), replace(self._style_of(i), facets=is_itself)) for i in self._meshes
        )
        name = "Show the mesh itself" if is_itself else "Show the surface of the mesh"
        self._desk.commit(Together(name, edits))

    def _set_smoothness(self, value: float) -> str:
        return self._desk.commit(SetSmoothness(dict.fromkeys(self._meshes, value)))

    def _set_magnitude(self, value: float) -> str:
        return self._desk.commit(SetMagnitude(dict.fromkeys(self._meshes, value)))

    def _set_weights(self, are_on: bool) -> None:
        self._desk.commit(SetAreaWeights(tuple(self._meshes), are_on))
