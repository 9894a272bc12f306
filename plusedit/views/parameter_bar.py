"""Above a view of parameters: which map the mesh has, its cone points, and what colors mean."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAction, QStandardItemModel
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QMenu, QSizePolicy, QToolButton, QWidget

from plusedit.document.map_record import MapRecord
from plusedit.events import Event
from plusedit.geometry.mesh.mapping import MapOffer
from plusedit.geometry.mesh.maps import maps
from plusedit.scene.parameter_colors import MEASURES, Measure
from plusedit.scene.parameter_sheet import ParameterSheet

UNKNOWN = "unknown map"
CONES = 4  # of a pillow
KEPT_IN_FILE = "Texture coordinates are read with a file only; undo brings these back."


class ParameterBar(QWidget):
    """Shows what is so, and tells what was chosen."""

    def __init__(self) -> None:
        super().__init__()
        self.map_chosen: Event[str] = Event()
        """the name of a map"""
        self.cones_from_faces: Event[()] = Event()
        self.cones_reset: Event[()] = Event()
        self.measure_chosen: Event[Measure] = Event()
        self._shown: tuple[object, object] = None, None
        self.map, self.measure = QComboBox(), QComboBox()
        self.cones = QToolButton()
        self.from_faces = QAction("At the four selected faces", self)
        self.reset = QAction("Automatic", self)
        self._make_choices()
        self._make_cones()
        row = QHBoxLayout(self)
        row.setContentsMargins(8, 4, 8, 4)
        row.setSpacing(8)
        row.addWidget(self.map, 1)
        row.addWidget(self.cones)
        row.addWidget(self.measure, 1)

    def _make_choices(self) -> None:
        self.map.setAccessibleName("map")
        self.map.setToolTip("How the faces are laid out in u and v")
        self.map.setPlaceholderText(UNKNOWN)
        self.map.activated.connect(self._choose)
        self.measure.setAccessibleName("colors of faces")
        self.measure.setToolTip("What the colors of the faces stand for")
        for name, title in MEASURES.items():
            self.measure.addItem(title, name)
        self.measure.activated.connect(
            lambda _: self.measure_chosen.emit(self.measure.currentData())
        )
        for combo in (self.map, self.measure):
            combo.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
            combo.setFocusPolicy(Qt.FocusPolicy.ClickFocus)

    def _make_cones(self) -> None:
        self.cones.setText("Cone points")
        self.cones.setAccessibleName("cone points")
        self.cones.setProperty("field", True)
        self.cones.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.cones.setToolTip("The four corners of the pillow; drag A, B, C and D to move them")
        self.from_faces.setToolTip("Select four faces here or on the surface before")
        menu = QMenu(self.cones)
        menu.setToolTipsVisible(True)
        menu.addActions([self.from_faces, self.reset])
        self.cones.setMenu(menu)
        self.from_faces.triggered.connect(lambda: self.cones_from_faces.emit())
        self.reset.triggered.connect(lambda: self.cones_reset.emit())

    def show_sheet(
        self, sheet: ParameterSheet | None, record: MapRecord | None, *, faces: int, free: bool
    ) -> None:
        """Show the map of a mesh of which so many faces are selected; `free`: it may be changed."""
        self.map.setEnabled(sheet is not None and free)
        self.cones.setVisible(sheet is not None and bool(sheet.cone_points))
        self.cones.setEnabled(free)
        self.from_faces.setEnabled(faces == CONES)
        self.reset.setEnabled(record is not None and bool(record.cone_points))
        if self._shown != (sheet, record):
            self._shown = sheet, record
            self._fill(() if sheet is None else sheet.offers, record)

    def _fill(self, offers: tuple[MapOffer, ...], record: MapRecord | None) -> None:
        self.map.clear()
        current = None if record is None else record.name
        model = self.map.model()
        assert isinstance(model, QStandardItemModel)
        for number, offer in enumerate(offers):
            self.map.addItem(offer.title, offer.name)
            if offer.objection:
                model.item(number).setEnabled(False)
                tip = f"Can't be had: {offer.objection}."
                self.map.setItemData(number, tip, Qt.ItemDataRole.ToolTipRole)
        if offers and current is not None and current in maps and self.map.findData(current) < 0:
            self.map.addItem(maps[current].title, current)
            self.map.setItemData(self.map.count() - 1, KEPT_IN_FILE, Qt.ItemDataRole.ToolTipRole)
        self.map.setCurrentIndex(self.map.findData(current))

    def _choose(self, number: int) -> None:
        name = self.map.itemData(number)
        record = self._shown[1]
        current = record.name if isinstance(record, MapRecord) else None
        # Until it has been laid out the mesh has the map that it had.
        self.map.setCurrentIndex(self.map.findData(current))
        if name != current:
            self.map_chosen.emit(name)
