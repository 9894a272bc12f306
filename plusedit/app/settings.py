"""What is remembered between runs. Whatever the file holds, reading it never fails."""

import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QByteArray, QSettings, QStandardPaths

from plusedit.interaction.tool import NewCurves
from plusedit.machine import log_file

MOST_RECENT = 10  # files in File > Open recent
LOOKS = ("system", "light", "dark")


def state_folder() -> Path:
    """Where autosaved designs and the log lie; made if need be."""
    folder = log_file().parent
    folder.mkdir(parents=True, exist_ok=True)
    return folder


class Settings:
    """Typed access to one file of settings."""

    def __init__(self, path: Path | None = None) -> None:
        if path is None:
            kind = QStandardPaths.StandardLocation.GenericConfigLocation
            path = Path(QStandardPaths.writableLocation(kind)) / "plusedit" / "plusedit.ini"
        self._stored = QSettings(str(path), QSettings.Format.IniFormat)

    @property
    def look(self) -> str:
        """ "system", "light" or "dark"."""
        value = self._stored.value("look")
        return value if value in LOOKS else "system"

    @look.setter
    def look(self, value: str) -> None:
        self._stored.setValue("look", value)

    @property
    def animated(self) -> bool:
        """Whether cameras glide from one view to the next."""
        return str(self._stored.value("animated")).lower() != "false"

    @animated.setter
    def animated(self, value: bool) -> None:
        self._stored.setValue("animated", value)

    @property
    def grid_step(self) -> float | None:
        """What points snap to and arrow keys move by; None: the grid that is seen."""
        try:
            value = float(str(self._stored.value("grid_step")))
        except ValueError:
            return None
        return value if 0.0 < value < 1e100 else None

    @grid_step.setter
    def grid_step(self, value: float | None) -> None:
        self._stored.setValue("grid_step", 0.0 if value is None else value)

    @property
    def new_curves(self) -> NewCurves:
        """What kind of curve the pen draws."""
        tree = self._tree("new_curves")
        usual = NewCurves()
        family, order, closed = tree.get("family"), tree.get("order"), tree.get("closed")
        return replace(
            usual,
            family=family if family in ("bezier", "bspline", "rag") else usual.family,
            order=order if isinstance(order, int) and 2 <= order <= 20 else usual.order,
            closed=closed if isinstance(closed, bool) else usual.closed,
        )

    @new_curves.setter
    def new_curves(self, value: NewCurves) -> None:
        tree = {"family": value.family, "order": value.order, "closed": value.closed}
        self._stored.setValue("new_curves", json.dumps(tree))

    @property
    def recent(self) -> list[Path]:
        """Files opened or saved, the last first; some may have gone since."""
        tree = self._tree("recent")
        paths = tree.get("paths")
        names = paths if isinstance(paths, list) else []
        return [Path(name) for name in names if isinstance(name, str) and name][:MOST_RECENT]

    @recent.setter
    def recent(self, paths: list[Path]) -> None:
        names = [str(path) for path in paths[:MOST_RECENT]]
        self._stored.setValue("recent", json.dumps({"paths": names}))

    def remember_file(self, path: Path) -> None:
        """Put `path` first among the recent files."""
        path = path.absolute()
        self.recent = [path, *(other for other in self.recent if other != path)]

    @property
    def shortcuts(self) -> dict[str, list[str]]:
        """The shortcuts that the user chose, by name of the action."""
        found = {}
        for name, keys in self._tree("shortcuts").items():
            if isinstance(keys, list):
                found[name] = [key for key in keys if isinstance(key, str)]
        return found

    @shortcuts.setter
    def shortcuts(self, chosen: Mapping[str, list[str]]) -> None:
        self._stored.setValue("shortcuts", json.dumps(dict(chosen)))

    @property
    def view(self) -> dict[str, object]:
        """How the view of a new design is set up, as the design file would say it."""
        return self._tree("view")

    @view.setter
    def view(self, tree: Mapping[str, object]) -> None:
        self._stored.setValue("view", json.dumps(dict(tree)))

    @property
    def mesh_options(self) -> dict[str, object]:
        """How the last mesh was imported."""
        return self._tree("mesh_options")

    @mesh_options.setter
    def mesh_options(self, tree: Mapping[str, object]) -> None:
        self._stored.setValue("mesh_options", json.dumps(dict(tree)))

    @property
    def figure(self) -> dict[str, object]:
        """How the last figure was exported."""
        return self._tree("figure")

    @figure.setter
    def figure(self, tree: Mapping[str, object]) -> None:
        self._stored.setValue("figure", json.dumps(dict(tree)))

    def bytes_of(self, name: str) -> QByteArray:
        """Bytes that Qt gave to keep, such as the places of docks; empty if there are none."""
        value = self._stored.value(name)
        return value if isinstance(value, QByteArray) else QByteArray()

    def keep_bytes(self, name: str, value: QByteArray) -> None:
        """Keep bytes that Qt gave."""
        self._stored.setValue(name, value)

    def sync(self) -> None:
        """Write to disk now."""
        self._stored.sync()

    def _tree(self, name: str) -> dict[str, object]:
        try:
            tree = json.loads(str(self._stored.value(name)))
        except (ValueError, RecursionError):
            return {}
        return tree if isinstance(tree, dict) else {}
