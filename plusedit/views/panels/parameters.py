"""The parameters of a mesh: its faces in u and v, and by which map they got there."""

from PySide6.QtWidgets import QVBoxLayout

from plusedit.document.map_record import MapRecord, map_of
from plusedit.document.selection import Selection
from plusedit.document.shape import Shape, ShapeId
from plusedit.scene.parameter_colors import Measure
from plusedit.views.desk import Desk
from plusedit.views.live import LiveWidget
from plusedit.views.panels import panel
from plusedit.views.parameter_bar import ParameterBar
from plusedit.views.parameter_legend import ParameterLegend
from plusedit.views.parameter_view import ParameterView

PILLOW, FILLED = "pillow", "filled_pillow"  # maps with cone points, of closed and of open meshes


@panel(
    "parameters",
    title="Parameters",
    area="beside",
    order=9,
    menu="View",
    shortcut="Ctrl+4",
    is_shown=False,
)
class Parameters(LiveWidget):
    """Follows the selection: the selected mesh, or the only one there is."""

    def __init__(self, desk: Desk) -> None:
        super().__init__(desk)
        self.bar, self.view, self.legend = ParameterBar(), ParameterView(), ParameterLegend()
        self._shape_id: ShapeId | None = None
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.bar)
        column.addWidget(self.view, 1)
        column.addWidget(self.legend)
        self.view.hand.selected.listen(self._select)
        self.view.hand.cones_chosen.listen(self._set_cones)
        self.view.known.listen(self._show_map)
        self.view.pointed.listen(desk.pointed.emit)
        self.view.hinted.listen(desk.hinted.emit)
        self.view.entered.listen(desk.entered.emit)
        self.bar.map_chosen.listen(lambda name: self._ask(MapRecord(name)))
        self.bar.cones_from_faces.listen(self._set_cones_at_faces)
        self.bar.cones_reset.listen(lambda: self._ask(MapRecord(self._pillow)))
        self.bar.measure_chosen.listen(self._set_measure)

    @property
    def shape(self) -> Shape | None:
        """The mesh that is shown."""
        shapes = self.desk.session.design.shapes
        return None if self._shape_id is None else shapes.get(self._shape_id)

    def refresh(self) -> None:
        session = self.desk.session
        self._shape_id = self._chosen_mesh()
        shape = self.shape
        self.view.set_theme(self.desk.theme)
        self.view.show_mesh(
            self._shape_id,
            None if shape is None else shape.mesh,
            session.selection,
            settled=not session.is_previewing,
        )
        self._show_map()

    def _chosen_mesh(self) -> ShapeId | None:
        session = self.desk.session
        meshes = [i for i, _ in session.design.meshes()]
        chosen = [i for i in meshes if i in session.selection.shapes]
        active = session.selection.active
        if active is not None and active.shape in chosen:
            return active.shape
        return chosen[0] if chosen else meshes[0] if len(meshes) == 1 else None

    def _show_map(self) -> None:
        shape, sheet = self.shape, self.view.sheet
        self.legend.show_sheet(sheet, self.view.measure, self.desk.theme)
        self.bar.show_sheet(
            sheet,
            None if shape is None else map_of(shape),
            faces=len(self._faces()),
            free=shape is not None and shape.editable,
        )

    def _set_measure(self, measure: Measure) -> None:
        self.view.set_measure(measure)
        self._show_map()

    def _faces(self) -> tuple[int, ...]:
        if self._shape_id is None:
            return ()
        return self.desk.session.selection.by_shape().get(self._shape_id, ())

    def _select(self, selection: Selection) -> None:
        self.desk.select(selection)
        self.refresh()

    @property
    def _pillow(self) -> str:
        """The map with cone points that the mesh has, or can have."""
        shape, sheet = self.shape, self.view.sheet
        record = None if shape is None else map_of(shape)
        if record is not None and record.name in (PILLOW, FILLED):
            return record.name
        is_closed = sheet is not None and not len(sheet.unfolding.mesh.topology.border)
        return PILLOW if is_closed else FILLED

    def _set_cones(self, points: tuple[int, ...]) -> None:
        self._ask(MapRecord(self._pillow, points))

    def _set_cones_at_faces(self) -> None:
        sheet = self.view.sheet
        if sheet is None:
            return
        mesh, points = sheet.unfolding.mesh, list[int]()
        for face in self._faces():
            around = mesh.corners[mesh.starts[face] : mesh.starts[face + 1]].tolist()
            # Faces beside each other may have a vertex in common.
            points.append(next((v for v in around if v not in points), around[0]))
        self._set_cones(tuple(points))

    def _ask(self, record: MapRecord) -> None:
        if self._shape_id is not None:
            self.desk.map_asked.emit(self._shape_id, record)
