"""The docks around the view, one for each panel on the shelf."""

from itertools import pairwise

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtWidgets import QDockWidget, QLabel, QMainWindow, QTabWidget, QWidget

from plusedit.views.desk import Desk
from plusedit.views.panels import panels

AREAS = {
    "left": Qt.DockWidgetArea.LeftDockWidgetArea,
    "right": Qt.DockWidgetArea.RightDockWidgetArea,
    "beside": Qt.DockWidgetArea.RightDockWidgetArea,
    "below": Qt.DockWidgetArea.BottomDockWidgetArea,
}
WIDTHS = {"left": 296, "right": 264, "beside": 440}  # logical pixels at the first start
HEIGHTS = {"outliner": 300, "lines_table": 300}
HEIGHT_BELOW = 232
STATE = 2  # version of the kept places of docks


class Docks:
    """Makes the docks; puts them away while the start page is shown."""

    def __init__(self, window: QMainWindow, desk: Desk) -> None:
        self._window = window
        self.by_name: dict[str, QDockWidget] = {}
        self._put_away: list[QDockWidget] = []
        # What is below the views is as wide as they are: the sides keep their height.
        window.setCorner(Qt.Corner.BottomLeftCorner, AREAS["left"])
        window.setCorner(Qt.Corner.BottomRightCorner, AREAS["right"])
        window.setTabPosition(AREAS["below"], QTabWidget.TabPosition.North)
        window.setDocumentMode(True)
        self._state: QByteArray | None = None
        self._widths: dict[str, int] = {}
        """of docks beside the views when they were hidden"""
        self._heads: dict[str, tuple[QWidget, QWidget]] = {}
        """of docks below the views: the title, and what takes its place where a tab has it"""
        for name in sorted(panels, key=lambda name: panels[name].order):
            panel = panels[name]
            dock = QDockWidget(panel.title, window)
            dock.setObjectName(name)
            dock.setFeatures(QDockWidget.DockWidgetFeature.DockWidgetMovable)
            head = head_of(panel.title)
            dock.setTitleBarWidget(head)
            if panel.area == "below":
                self._heads[name] = head, QWidget()
            dock.setWidget(panel.make(desk))
            window.addDockWidget(AREAS[panel.area], dock)
            self.by_name[name] = dock
        self._put_beside()
        for name, dock in self.by_name.items():
            dock.setVisible(panels[name].is_shown)
        self._size()
        for dock in (self.by_name[name] for name in self._heads):
            dock.visibilityChanged.connect(self._show_heads)
            dock.dockLocationChanged.connect(self._show_heads)

    def widget(self, name: str) -> QWidget:
        """What is in a dock."""
        return self.by_name[name].widget()

    def toggle(self, name: str) -> None:
        """Show a dock, or hide it."""
        dock = self.by_name[name]
        if panels[name].area == "below":
            self._toggle_below(dock)
            return
        if panels[name].area != "beside":
            dock.setVisible(dock.isHidden())
            return
        others = [self.by_name[n] for n in self._of("right") if not self.by_name[n].isHidden()]
        widths = [other.width() for other in others]
        if dock.isHidden():
            self._make_room_below(self._widths.get(name, WIDTHS["beside"]))
        else:
            self._widths[name] = dock.width()
        dock.setVisible(dock.isHidden())
        # Else what it takes or gives back would be the neighbors' and not the views'.
        if not dock.isHidden():
            others.append(dock)
            widths.append(self._widths.get(name, WIDTHS["beside"]))
        self._window.resizeDocks(others, widths, Qt.Orientation.Horizontal)

    def _toggle_below(self, dock: QDockWidget) -> None:
        if not dock.isHidden() and self._is_covered(dock):
            dock.raise_()
            return
        if not dock.isHidden():
            dock.hide()
            return
        seen = self._seen_below()
        room = sum(other.width() for other in seen) // (len(seen) + 1)
        is_tab = any(room < _least(each) for each in (*seen, dock)) and bool(seen)
        if is_tab:
            self._window.tabifyDockWidget(seen[-1], dock)
        dock.show()
        dock.raise_()
        if not seen:
            self._window.resizeDocks([dock], [HEIGHT_BELOW], Qt.Orientation.Vertical)
        elif not is_tab:
            row = [*seen, dock]
            self._window.resizeDocks(row, [room] * len(row), Qt.Orientation.Horizontal)
        # How wide they can be is known once the window is laid out.
        QTimer.singleShot(0, self._window, self._make_room_below)

    def _seen_below(self) -> list[QDockWidget]:
        """Those that are not hidden, nor behind a tab; from left to right."""
        below = [self.by_name[name] for name in self._of("below")]
        seen = [dock for dock in below if not dock.isHidden() and not self._is_covered(dock)]
        return sorted(seen, key=lambda dock: dock.x())

    def _make_room_below(self, taken: int = 0) -> None:
        """Where panels below are too narrow side by side, or will be, make tabs of them."""
        seen = self._seen_below()
        is_crowded = any(dock.width() - taken / len(seen) < _least(dock) for dock in seen)
        if len(seen) > 1 and is_crowded:
            below = [self.by_name[name] for name in self._of("below")]
            for dock in below:
                if dock is not seen[0] and not dock.isHidden():
                    self._window.tabifyDockWidget(seen[0], dock)
            seen[-1].raise_()
            self._show_heads()

    def _show_heads(self) -> None:
        """Titles of the docks below the views, where no tab has them."""
        for name, (head, nothing) in self._heads.items():
            dock = self.by_name[name]
            is_tab = any(not other.isHidden() for other in self._window.tabifiedDockWidgets(dock))
            wanted = nothing if is_tab else head
            if dock.titleBarWidget() is not wanted:
                dock.setTitleBarWidget(wanted)

    def _is_covered(self, dock: QDockWidget) -> bool:
        """Whether another tab lies in front."""
        beside = self._window.tabifiedDockWidgets(dock)
        return any(not other.isHidden() for other in beside) and dock.visibleRegion().isEmpty()

    def state(self) -> QByteArray:
        """Where docks and tool bars are, to be kept."""
        return self._window.saveState(STATE) if self._state is None else self._state

    def restore(self, state: QByteArray) -> None:
        """Put docks and tool bars where they were; nonsense leaves them where they are."""
        if not state.isEmpty():
            self._window.restoreState(state, STATE)

    def put_away(self) -> None:
        """Hide all docks, remembering which were there."""
        if self._state is None:
            self._state = self._window.saveState(STATE)
            self._put_away = [dock for dock in self.by_name.values() if not dock.isHidden()]
            for dock in self._put_away:
                dock.hide()

    def bring_back(self) -> None:
        """Show what was put away."""
        if self._state is not None:
            self._state = None
            for dock in self._put_away:
                dock.show()

    def _of(self, area: str) -> list[str]:
        """The panels there, in their order."""
        return [name for name in self.by_name if panels[name].area == area]

    def _put_beside(self) -> None:
        """Those on the right below each other, on the right of those beside the views."""
        inner, outer = ([self.by_name[n] for n in self._of(area)] for area in ("beside", "right"))
        if inner and outer:
            self._window.splitDockWidget(inner[0], outer[0], Qt.Orientation.Horizontal)
            for above, below in pairwise(outer):
                self._window.splitDockWidget(above, below, Qt.Orientation.Vertical)

    def _size(self) -> None:
        for side, width in WIDTHS.items():
            docks = [self.by_name[n] for n in self._of(side) if panels[n].is_shown]
            self._window.resizeDocks(docks, [width] * len(docks), Qt.Orientation.Horizontal)
        tall = [name for name in HEIGHTS if name in self.by_name]
        self._window.resizeDocks(
            [self.by_name[n] for n in tall], [HEIGHTS[n] for n in tall], Qt.Orientation.Vertical
        )


def _least(dock: QDockWidget) -> int:
    return panels[dock.objectName()].least_width


def head_of(title: str) -> QLabel:
    """The title of a dock: quiet, without buttons; the Window menu hides and shows docks."""
    label = QLabel(title)
    label.setProperty("dock", True)
    label.setIndent(0)
    return label
