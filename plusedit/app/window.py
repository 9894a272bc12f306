"""The main window: the view in the middle, panels around it, s along the bottom."""

from pathlib import Path

from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtGui import (
    QCloseEvent,
    QDragEnterEvent,
    QDropEvent,
    QGuiApplication,
    QKeyEvent,
)
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QApplication,
    QKeySequenceEdit,
    QLineEdit,
    QMainWindow,
    QMenu,
    QStackedWidget,
    QTextEdit,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from plusedit.app import menus
from plusedit.app.actions import ActionTable, Entry
from plusedit.app.autosave import Autosave
from plusedit.app.clipboard import Clipboard
from plusedit.app.constraint_notices import ConstraintNotices
from plusedit.app.docks import Docks
from plusedit.app.entries import all_entries
from plusedit.app.figure_export import FigureExport
from plusedit.app.files import Files
from plusedit.app.flows import Flows, open_elsewhere
from plusedit.app.notes_bar import NotesBar
from plusedit.app.passing_notices import PassingNotices
from plusedit.app.remapping import Remapping
from plusedit.app.settings import Settings
from plusedit.app.side_windows import SideWindows
from plusedit.app.start_page import StartPage
from plusedit.app.status import Status
from plusedit.app.sweep import Sweep
from plusedit.app.toolbar import make_toolbar
from plusedit.app.view_keys import ViewKeys
from plusedit.app.view_state import ViewState, look_of_program
from plusedit.document.session import Session
from plusedit.geometry.surface import PlusSurface
from plusedit.views.canvas import PlaneCanvas
from plusedit.views.desk import Desk
from plusedit.views.fields import Field
from plusedit.views.icons import refresh_icons
from plusedit.views.magnitude_bar import MagnitudeBar
from plusedit.views.panels import panels
from plusedit.views.panes import Panes
from plusedit.views.pointer_link import PointerLink

LONGEST = 48  # characters of what a menu says would be undone
TYPED_INTO = (QLineEdit, QAbstractSpinBox, QTextEdit, QKeySequenceEdit)
USUAL_SIZE, LEAST_SIZE = QSize(1280, 820), QSize(900, 600)  # logical pixels
FRAME = QSize(16, 48)  # what a desktop puts around a window, at most


class MainWindow(QMainWindow):
    """Puts the parts together; what they do is theirs."""

    def __init__(self, settings: Settings, autosave_folder: Path | None = None) -> None:
        super().__init__()
        self.settings = settings
        # Before anything is made: what is made in one look and then gets another is made twice.
        look_of_program(settings.look)
        self.session = Session()
        self.panes = Panes(self.session)
        self.gestures = self.panes.hands
        self.gestures.new_curves = settings.new_curves
        self.desk = Desk(self.session, self.gestures)
        self.view = ViewState(self.desk, self.panes, settings)
        self.files = Files(self.desk, settings, self, self.view)
        self.autosave = Autosave(self.session, lambda: self.files.path, autosave_folder)
        self.flows = Flows(self.desk, self.files, self.autosave, self)
        self.figures = FigureExport(self.desk, self.panes, self.files, settings, self)
        self.clipboard = Clipboard(self.desk, self)
        self.remapping = Remapping(self.desk, self)
        self.magnitude = MagnitudeBar(self.desk)
        self.link = PointerLink(self.desk, self.panes)
        self.sweep = Sweep(self.desk, self.magnitude.targets, lambda: self.panes.options, self)
        self.side = SideWindows(self)
        self.notes, self.status = NotesBar(), Status(self.desk, self.panes)
        self.notices = ConstraintNotices(self.desk, self.view)
        self.passing = PassingNotices(self.desk)
        self.start_page = StartPage(self.files.open, self.flows.new, self.files.open)
        self.stack = QStackedWidget()
        self._lay_out()
        self.docks = Docks(self, self.desk)
        self._add_actions()
        self._listen()
        self._restore()

    @property
    def canvas(self) -> PlaneCanvas:
        """The 2D view."""
        return self.panes.plane

    # How it is put together

    def _lay_out(self) -> None:
        self.setMinimumSize(LEAST_SIZE)
        self.resize(USUAL_SIZE.boundedTo(self.screen().availableSize() - FRAME))
        self.setAcceptDrops(True)
        self.stack.addWidget(self.panes)
        self.stack.addWidget(self.start_page)
        middle = QWidget()
        column = QVBoxLayout(middle)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addWidget(self.notes)
        column.addWidget(self.stack, 1)
        self.setCentralWidget(middle)
        self.setStatusBar(self.status)
        bottom = QToolBar("Magnitude s")
        bottom.setObjectName("magnitude")
        bottom.setMovable(False)
        bottom.setContextMenuPolicy(Qt.ContextMenuPolicy.PreventContextMenu)
        bottom.addWidget(self.magnitude)
        self.addToolBar(Qt.ToolBarArea.BottomToolBarArea, bottom)

    def _add_actions(self) -> None:
        self.actions_table = ActionTable(self, self.panes)
        self._view_keys = ViewKeys(self, self.panes)
        self.actions_table.add(all_entries(self))
        self.actions_table.add(
            Entry(
                f"panel.{name}",
                dock.windowTitle(),
                panels[name].menu,
                lambda name=name: self._toggle_panel(name),  # type: ignore[misc]
                (panels[name].shortcut,) if panels[name].shortcut else (),
                checked=lambda dock=dock: not dock.isHidden(),  # type: ignore[misc]
            )
            for name, dock in self.docks.by_name.items()
        )
        self.actions_table.set_shortcuts(self.settings.shortcuts)
        self.tool_bar = make_toolbar(self.actions_table, self.gestures)
        self.addToolBar(self.tool_bar)
        self._menus = menus.fill(self.menuBar(), self.actions_table)
        self._recent = QMenu("Open recent", self)
        # Filled when it opens: an entry that rebuilt its own menu would go while it acts.
        self._recent.aboutToShow.connect(
            lambda: menus.fill_recent(self._recent, self.settings.recent, self.files.open)
        )
        self._menus["File"].insertMenu(self.actions_table["save"], self._recent)

    def _listen(self) -> None:
        self.session.stepped.listen(self._stepped)
        self.session.changed.listen(lambda old, new: self._leave_start_page(len(new)))
        self.files.named.listen(self._named)
        self.files.shown.listen(self._shown)
        self.files.notes.listen(self.notes.tell)
        self.files.reported.listen(self.side.keep_mesh_report)
        self.flows.imported.listen(self.panes.frame_selected)
        self.view.changed.listen(self.actions_table.refresh)
        self.gestures.tool_changed.listen(lambda _: self.actions_table.refresh())
        self.desk.theme_changed.listen(lambda theme: self._show_theme())
        self.panes.pointer_moved.connect(self.status.point_at)
        self.panes.pointer_left.connect(self.status.point_nowhere)
        self.panes.context_menu_requested.connect(self._show_context_menu)
        self.panes.entered.listen(lambda: self._give_keys(self.panes.active))
        self.desk.entered.listen(self._give_keys)
        self.panes.measuring.ready.listen(self.magnitude.smoothness.numbers.refresh)
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._desktop_changed)

    def _restore(self) -> None:
        self.restoreGeometry(self.settings.bytes_of("geometry"))
        self.docks.restore(self.settings.bytes_of("state"))
        self.view.set_look(self.settings.look)
        self._named()
        self._stepped()
        self.show_start_page()

    # What menus ask for

    def undo(self) -> None:
        """One step back, once nothing is under way."""
        self.magnitude.finish()
        if not self.gestures.cancel():
            self.session.undo()

    def redo(self) -> None:
        """One step on, once nothing is under way."""
        self.magnitude.finish()
        self.gestures.cancel()
        self.session.redo()

    def choose_tool(self, name: str) -> None:
        """Take a tool in hand."""
        self.show_view()
        self.gestures.choose(name)
        self.panes.focus()

    def _toggle_panel(self, name: str) -> None:
        """Show or hide a panel; the view has the keys that a hidden one had."""
        dock, focused = self.docks.by_name[name], self.focusWidget()
        had_keys = focused is not None and dock.isAncestorOf(focused)
        self.docks.toggle(name)
        if had_keys and dock.isHidden():
            self.panes.focus()

    def show_view(self) -> None:
        """Show the view, with the panels around it."""
        if self.stack.currentWidget() is not self.panes:
            self.stack.setCurrentWidget(self.panes)
            self.docks.bring_back()
        self.panes.focus()

    def show_start_page(self) -> None:
        """Show the start page in place of the view."""
        self.gestures.cancel()
        self.docks.put_away()
        self.start_page.show_recent([path for path in self.settings.recent if path.exists()])
        self.stack.setCurrentWidget(self.start_page)

    def take_settings(self) -> None:
        """Do as the settings say now."""
        self.view.set_look(self.settings.look)
        self.view.set_animated(self.settings.animated)
        self.gestures.new_curves = self.settings.new_curves
        self.tool_bar.kinds.show_kind(self.gestures.new_curves)  # type: ignore[attr-defined]
        self.gestures.grid_step = self.settings.grid_step or self.panes.active.grid_step
        self.actions_table.set_shortcuts(self.settings.shortcuts)

    def toggle_full_screen(self) -> None:
        """The whole screen, or a window again."""
        self.setWindowState(self.windowState() ^ Qt.WindowState.WindowFullScreen)

    # What it hears

    def _stepped(self) -> None:
        for name, label in (("undo", self.session.undo_label), ("redo", self.session.redo_label)):
            action = self.actions_table[name]
            word = name.capitalize()
            action.setText(f"{word} {shortened(label)}" if label else word)
            action.setEnabled(label is not None)
            action.setToolTip(f"{action.text()}  ({self.actions_table.keys_text(name)})")
        self.setWindowModified(not self.session.is_saved)

    def _named(self) -> None:
        self.setWindowFilePath("" if self.files.path is None else str(self.files.path))
        self.setWindowTitle(f"{self.files.name}[*] — PlusEdit")
        self._recent.setEnabled(bool(self.settings.recent))

    def _shown(self) -> None:
        self.notes.hide()
        self.magnitude.forget()
        self.show_view()

    def _leave_start_page(self, shapes: int) -> None:
        is_there = self.stack.currentWidget() is self.start_page
        if shapes and is_there and not self.session.is_previewing:
            self.show_view()

    def _show_theme(self) -> None:
        self.start_page.set_theme(self.desk.theme)
        if self.isVisible():
            refresh_icons(self)
        self.magnitude.refresh()

    def _desktop_changed(self) -> None:
        if self.settings.look == "system":
            self.view.set_look("system")

    def _show_context_menu(self, at: QPoint) -> None:
        self.actions_table.refresh()
        menu = menus.context_menu(self.actions_table, self, self._selected_kinds())
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        menu.popup(at)

    def _give_keys(self, view: QWidget) -> None:
        """Keys go where the pointer is, unless something is being typed elsewhere."""
        focus = QApplication.focusWidget()
        is_done = isinstance(focus, Field) and focus.is_done
        is_typing = isinstance(focus, TYPED_INTO) and not is_done
        if focus is not None and focus.window() is self and not is_typing:
            view.setFocus(Qt.FocusReason.MouseFocusReason)

    def _selected_kinds(self) -> list[str]:
        """What the context menu is to speak of; of curves where nothing is selected."""
        chosen = self.desk.selected_shapes().values()
        has_surfaces = any(isinstance(geometry, PlusSurface) for geometry in chosen)
        has_curves = len(self.desk.selected_curves()) > 0
        selected = self.session.selection.shapes
        has_meshes = any(i in selected for i, _ in self.session.design.meshes())
        is_nothing = not (has_surfaces or has_curves or has_meshes)
        kinds = {menus.SURFACES: has_surfaces, menus.MESHES: has_meshes, menus.CURVES: has_curves}
        return [menus.CURVES] if is_nothing else [kind for kind, has in kinds.items() if has]

    # What Qt tells

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.show_view() if len(self.session.design) else self.panes.focus()
            return
        super().keyPressEvent(event)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if any(url.isLocalFile() for url in event.mimeData().urls()):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        paths = [Path(url.toLocalFile()) for url in event.mimeData().urls() if url.isLocalFile()]
        if paths:
            event.acceptProposedAction()
            self.files.open(paths[0])
        for path in paths[1:]:
            open_elsewhere(path)

    def closeEvent(self, event: QCloseEvent) -> None:
        self.magnitude.finish()
        if not self.files.may_discard():
            event.ignore()
            return
        self.settings.keep_bytes("geometry", self.saveGeometry())
        self.settings.keep_bytes("state", self.docks.state())
        self.settings.sync()
        self.autosave.close()
        self.clipboard.leave()
        event.accept()


def shortened(label: str) -> str:
    """A label that leaves a menu its width, whatever names stand in it."""
    return label if len(label) <= LONGEST else f"{label[: LONGEST - 1].rstrip()}…"
