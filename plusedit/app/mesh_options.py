"""How a mesh is to be read: a short form, and what it remembers."""

from collections.abc import Mapping
from dataclasses import replace
from typing import cast, get_args

from PySide6.QtWidgets import QCheckBox, QComboBox, QLineEdit, QWidget

from plusedit.app.export_dialogs import Question
from plusedit.commands.meshes import LEAST, MOST
from plusedit.io.mesh_file import Up
from plusedit.io.mesh_import import ImportOptions
from plusedit.views.arithmetic import calculated, written
from plusedit.views.live import quiet

AUTOMATIC = "The one that suits best"
MAPS = {
    "pillow": "Pillow, for closed bodies",
    "filled_pillow": "Pillow, holes filled",
    "height_field": "Height field, seen from above",
    "flat": "Flat sheet, seen from the front",
    "square": "Rectangle, for sheets with corners",
    "circle": "Disk, for sheets with one rim",
    "cylinder": "Cylinder, for tubes",
    "torus": "Torus, for rings",
    "file_uv": "Texture coordinates of the file",
    "rough_cut": "Rough cut, for whatever is left",
}
"""What the maps are called here, in the order in which they are offered."""

UP = {"As its kind has it": None, "z": "z", "y": "y"}

REFINING = (
    "A few large or thin faces would spoil the surface around them. They become several control "
    "planes each, so that S counts in smaller steps there."
)


class MeshOptionsDialog(Question):
    """What a person may choose when a mesh is imported."""

    def __init__(self, parent: QWidget | None, options: ImportOptions, name: str) -> None:
        super().__init__(parent, f"Import {name}", "Import")
        self._options = options
        self.map = QComboBox()
        self.map.addItem(AUTOMATIC, None)
        for key, title in offered_maps().items():
            self.map.addItem(title, key)
        self.up = QComboBox()
        for title, axis in UP.items():
            self.up.addItem(title, axis)
        self.smoothness = QLineEdit(written(options.smoothness, 6))
        self.refine = QCheckBox("Split large and thin faces")
        self.area_weights = QCheckBox("Weigh faces by area")
        self.measure = QCheckBox("Measure how far the surface is from the mesh")
        self.measure.setToolTip(
            "At once, while work goes on; else it is done when the report is opened"
        )
        self.form.addRow("Map", self.map)
        self.form.addRow("Up in the file", self.up)
        self.form.addRow("Smoothness S", self.smoothness)
        self.form.addRow("", self.refine)
        self.form.addRow("", quiet(REFINING))
        self.form.addRow("", self.area_weights)
        self.form.addRow("", self.measure)
        self.fill(options)

    def fill(self, options: ImportOptions) -> None:
        """Show these."""
        self.map.setCurrentIndex(max(self.map.findData(options.map_name), 0))
        self.up.setCurrentIndex(max(self.up.findData(options.up), 0))
        self.smoothness.setText(written(options.smoothness, 6))
        self.refine.setChecked(options.refine)
        self.area_weights.setChecked(options.area_weights)
        self.measure.setChecked(options.measure)

    def read(self) -> ImportOptions:
        smoothness = calculated(self.smoothness.text())
        if not LEAST <= smoothness <= MOST:
            raise ValueError(f"S lies between {LEAST:g} and {MOST:g}.")
        return replace(
            self._options,
            smoothness=smoothness,
            area_weights=self.area_weights.isChecked(),
            refine=self.refine.isChecked(),
            map_name=self.map.currentData(),
            up=self.up.currentData(),
            measure=self.measure.isChecked(),
        )


def offered_maps() -> dict[str, str]:
    """All maps on the shelf with what they are called."""
    from plusedit.geometry.mesh.maps import maps

    known = {name: title for name, title in MAPS.items() if name in maps}
    others = {name: entry.title for name, entry in maps.items() if name not in MAPS}
    return {**known, **others}


def options_of(tree: Mapping[str, object]) -> ImportOptions:
    """What was remembered; as usual wherever that makes no sense."""
    usual = ImportOptions(measure=True)
    smoothness, map_name, up = tree.get("smoothness"), tree.get("map"), tree.get("up")

    def switch(name: str) -> bool:
        value = tree.get(name)
        return value if isinstance(value, bool) else bool(getattr(usual, name))

    return replace(
        usual,
        smoothness=float(smoothness)
        if isinstance(smoothness, int | float) and LEAST <= smoothness <= MOST
        else usual.smoothness,
        map_name=map_name if isinstance(map_name, str) and map_name in offered_maps() else None,
        up=cast(Up, up) if up in get_args(Up) else None,
        area_weights=switch("area_weights"),
        refine=switch("refine"),
        measure=switch("measure"),
    )


def tree_of(options: ImportOptions) -> dict[str, object]:
    """What is remembered of a choice."""
    return {
        "smoothness": options.smoothness,
        "map": options.map_name,
        "up": options.up,
        "area_weights": options.area_weights,
        "refine": options.refine,
        "measure": options.measure,
    }
