"""What the window can do: the entries of its table of actions.

Edits of the design come from `plusedit.interaction.actions`, tools and overlays from their
shelves; here is what needs a window.
"""

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from PySide6.QtGui import QAction

from plusedit.app.actions import Entry
from plusedit.app.facts import TITLE
from plusedit.app.toolbar import tools_in_order
from plusedit.interaction.actions import EditAction, edit_actions
from plusedit.interaction.gesture import FIRST_TOOL
from plusedit.interaction.making_actions import FROM_CURVES, NEW
from plusedit.interaction.tool import tools
from plusedit.scene.options import Handles, Shading, ShownPanes
from plusedit.scene.overlays import GROUPS, in_order

if TYPE_CHECKING:
    from plusedit.app.window import MainWindow

ICONS = {
    "delete": "delete",
    "duplicate": "duplicate",
    "reverse_curve": "reverse",
    "reverse_directions": "reverse-line",
    "reset_directions": "reset",
    "close_curve": "close",
    "pass_through": "pass-through",
    "make_tangent": "tangent",
}
SWITCHES = {
    "grid": ("Grid", "Ctrl+'"),
    "rulers": ("Rulers", "Ctrl+R"),
    "snap": ("Snap to grid", "Shift+S"),
    "ground": ("Ground of the 3D view", ""),
    "isolines": ("Lines of constant u and v", "Shift+I"),
    "wire": ("Mesh of the 3D view", "Shift+W"),
    "facets": ("Meshes as they are", ""),
    "front_only": ("Pick in front only", ""),
}
HANDLES: dict[Handles, str] = {
    "auto": "Automatic",
    "selected": "Of selected shapes",
    "all": "Of all shapes",
    "none": "None",
}
PANES: dict[ShownPanes, tuple[str, str]] = {
    "2d": ("2D view", "Ctrl+1"),
    "3d": ("3D view", "Ctrl+2"),
    "both": ("Both views", "Ctrl+3"),
}
SIDES = (
    ("top", "Top", "Num+7"),
    ("front", "Front", "Num+1"),
    ("right", "Right", "Num+3"),
    ("bottom", "Bottom", "Ctrl+Num+7"),
    ("back", "Back", "Ctrl+Num+1"),
    ("left", "Left", "Ctrl+Num+3"),
    ("iso", "Isometric", "Num+0"),
)
SHADINGS: dict[Shading, str] = {"studio": "Studio light", "matcap": "Matte clay"}
THEMES = {"system": "As the desktop", "light": "Light", "dark": "Dark"}
MODAL = (("move", "Move", "G"), ("turn", "Rotate", "R"), ("scale", "Scale", "S"))
ZOOM = 1.4  # for one press of a key


def all_entries(window: "MainWindow") -> list[Entry]:
    """Every entry, in the order of the menus and the palette."""
    return [
        *file_entries(window),
        *edit_entries(window),
        *tool_entries(window),
        *design_entries(window),
        *view_entries(window),
        *help_entries(window),
    ]


def file_entries(window: "MainWindow") -> Iterator[Entry]:
    """New, Open, Save and their kin."""
    files, flows = window.files, window.flows
    yield Entry("new", "New", "File", flows.new, ("Ctrl+N",), 0, "new", "An empty design")
    yield Entry("open", "Open…", "File", lambda: files.open(), ("Ctrl+O",), 0, "open")
    yield Entry("save", "Save", "File", files.save, ("Ctrl+S",), 1, "save")
    yield Entry("save_as", "Save as…", "File", files.save_as, ("Ctrl+Shift+S",), 1, "save-as")
    yield Entry("import_svg", "Import SVG…", "File", flows.import_svg, (), 2, "import",
                "Add the paths of a drawing to the design")  # fmt: skip
    yield Entry("import_mesh", "Import mesh…", "File", flows.import_mesh, (), 2, "import",
                "Add a polygon mesh or a terrain as smooth surfaces")  # fmt: skip
    yield Entry("export_svg", "Export SVG…", "File", files.export_svg, ("Ctrl+E",), 2, "export")
    yield Entry(
        "export_png", "Export PNG…", "File", flows.export_png, ("Ctrl+Shift+E",), 2, "export"
    )
    yield Entry("export_figure", "Export figure…", "File", window.figures.export,
                ("Ctrl+Alt+E",), 2, "export",
                "PDF, SVG or PNG at a width in millimeters, for print")  # fmt: skip
    yield Entry("export_mesh", "Export mesh…", "File", flows.export_mesh, (), 2, "export",
                "Curves and surfaces as OBJ, PLY, STL or GLB for other programs")  # fmt: skip
    yield Entry("mesh_report", "Mesh report…", "File", window.side.show_mesh_report, (), 2,
                enabled=lambda: window.side.mesh_report is not None,
                hint="What was found in the mesh read last, and what was done to it")  # fmt: skip
    yield Entry("recover", "Recover unsaved designs…", "File", flows.recover, (), 3, "history",
                "What other runs left behind when they ended without saving")  # fmt: skip
    yield Entry("quit", "Quit", "File", window.close, ("Ctrl+Q",), 4,
                role=QAction.MenuRole.QuitRole)  # fmt: skip


def edit_entries(window: "MainWindow") -> Iterator[Entry]:
    """Undo, clipboard, what is done by moving the pointer, preferences."""
    session, clipboard = window.session, window.clipboard
    yield Entry("undo", "Undo", "Edit", window.undo, ("Ctrl+Z",), 0, "undo",
                enabled=lambda: session.undo_label is not None)  # fmt: skip
    yield Entry("redo", "Redo", "Edit", window.redo, ("Ctrl+Shift+Z", "Ctrl+Y"), 0, "redo",
                enabled=lambda: session.redo_label is not None)  # fmt: skip
    yield Entry("cut", "Cut", "Edit", clipboard.cut, ("Ctrl+X",), 1, "cut")
    yield Entry("copy", "Copy", "Edit", clipboard.copy, ("Ctrl+C",), 1, "copy")
    yield Entry("paste", "Paste", "Edit", clipboard.paste, ("Ctrl+V",), 1, "paste")
    for drag, name, key in MODAL:
        yield Entry(
            f"begin.{drag}", name, "Edit", _begins(window, drag), (key,), 3,
            hint="Follows the pointer; type numbers, X or Y for an axis, Enter accepts",
        )  # fmt: skip
    yield Entry("palette", "Command palette…", "Edit", window.side.show_palette,
                ("Ctrl+Shift+P",), 9, "search")  # fmt: skip
    yield Entry("preferences", "Preferences…", "Edit", window.side.show_preferences, ("Ctrl+,",), 9,
                "settings", role=QAction.MenuRole.PreferencesRole)  # fmt: skip


def tool_entries(window: "MainWindow") -> Iterator[Entry]:
    """One entry for each tool on the shelf."""
    gestures = window.gestures
    for name in tools_in_order():
        tool = tools[name]
        yield Entry(
            f"tool.{name}",
            tool.title,
            "Edit/Tool",
            lambda name=name: window.choose_tool(name),  # type: ignore[misc]
            (tool.shortcut,),
            4,
            name,
            checked=lambda name=name: gestures.tool_name == name,  # type: ignore[misc]
        )


def design_entries(window: "MainWindow") -> Iterator[Entry]:
    """What can be done to the design."""
    for action in edit_actions():
        yield Entry(
            f"edit.{action.name}",
            action.title,
            action.menu,
            _performs(window, action),
            action.shortcuts,
            _group_of(action),
            ICONS.get(action.name, ""),
        )


def _group_of(action: EditAction) -> int:
    """In the menu: what makes surfaces comes before what changes them."""
    if action.menu in (NEW, FROM_CURVES):
        return 0
    first = {"Surface": 1, "Edit": 2}.get(action.menu.split("/")[0], 0)
    return first + ("/" in action.menu)


def view_entries(window: "MainWindow") -> Iterator[Entry]:
    """What is seen, and from where."""
    view, panes = window.view, window.panes
    for shown, (title, key) in PANES.items():
        yield Entry(
            f"panes.{shown}", title, "View",
            lambda shown=shown: view.show_panes(shown), (key,), 0,  # type: ignore[misc]
            checked=lambda shown=shown: view.panes == shown,  # type: ignore[misc]
        )  # fmt: skip
    for overlay in sorted(in_order(), key=lambda entry: GROUPS.index(entry.group)):
        yield Entry(
            f"overlay.{overlay.name}", overlay.title, _menu_of(overlay.group),
            lambda name=overlay.name: view.toggle_overlay(name),  # type: ignore[misc]
            (overlay.shortcut,) if overlay.shortcut else (), 1,
            checked=lambda name=overlay.name: name in view.options.overlays,  # type: ignore[misc]
        )  # fmt: skip
    for handles, title in HANDLES.items():
        yield Entry(
            f"handles.{handles}", title, "View/Control lines",
            lambda handles=handles: view.set_handles(handles), (), 2,  # type: ignore[misc]
            checked=lambda handles=handles: view.options.handles == handles,  # type: ignore[misc]
        )  # fmt: skip
    for name, (title, key) in SWITCHES.items():
        yield Entry(
            f"view.{name}", title, "View",
            lambda name=name: view.toggle(name), (key,) if key else (), 3, name,  # type: ignore[misc]
            checked=lambda name=name: bool(getattr(view.options, name)),  # type: ignore[misc]
        )  # fmt: skip
    for shading, title in SHADINGS.items():
        yield Entry(
            f"shading.{shading}", title, "View/Shading",
            lambda value=shading: view.set_option("shading", value), (), 4,  # type: ignore[misc]
            checked=lambda value=shading: view.options.shading == value,  # type: ignore[misc]
        )  # fmt: skip
    for side, title, key in SIDES:
        yield Entry(
            f"projection.{side}", title, "View/Look from",
            lambda which=side: view.look_from(which), (key,), 5,  # type: ignore[misc]
            checked=lambda which=side: view.looks_from == which,  # type: ignore[misc]
        )  # fmt: skip
    yield Entry("perspective", "Perspective", "View/Look from", view.toggle_perspective,
                ("Num+5",), 5, checked=lambda: view.is_perspective,
                hint="In the 3D view, far things are smaller")  # fmt: skip
    yield Entry("play_s", "Play s", "View", window.sweep.toggle, ("F12",), 4,
                checked=lambda: window.sweep.is_running,
                hint="The selected shapes from s = 0 to the end of their family and back; any key "
                "or click ends it, and all is as before")  # fmt: skip
    yield Entry("frame_all", "Frame all", "View", lambda: panes.active.frame_all(),
                ("Home",), 6, "frame-all")  # fmt: skip
    yield Entry("frame_selected", "Frame selected", "View", lambda: panes.active.frame_selected(),
                ("F",), 6, "frame")  # fmt: skip
    yield Entry("zoom_in", "Zoom in", "View", lambda: panes.active.zoom(ZOOM),
                ("Ctrl++", "Ctrl+="), 6, "zoom-in")  # fmt: skip
    yield Entry("zoom_out", "Zoom out", "View", lambda: panes.active.zoom(1.0 / ZOOM),
                ("Ctrl+-",), 6, "zoom-out")  # fmt: skip
    for look, title in THEMES.items():
        yield Entry(
            f"look.{look}", title, "View/Theme",
            lambda look=look: view.set_look(look), (), 7,  # type: ignore[misc]
            checked=lambda look=look: window.settings.look == look,  # type: ignore[misc]
        )  # fmt: skip
    yield Entry("full_screen", "Full screen", "View", window.toggle_full_screen, ("F11",), 8,
                checked=window.isFullScreen)  # fmt: skip


def _menu_of(group: str) -> str:
    return f"View/{group}" if group else "View"


def help_entries(window: "MainWindow") -> Iterator[Entry]:
    """Help and the start page."""
    yield Entry("help", "Keys and mouse", "Help", window.side.show_help, ("F1",), 0, "help")
    yield Entry("facts", TITLE, "Help", window.side.show_facts, (), 0,
                hint="Each with a design that proves it")  # fmt: skip
    yield Entry("start_page", "Start page", "Help", window.show_start_page, (), 0, "home")
    yield Entry("about", "About PlusEdit", "Help", window.side.show_about, (), 1,
                role=QAction.MenuRole.AboutRole)  # fmt: skip


def _begins(window: "MainWindow", drag: str) -> Callable[[], None]:
    def begin() -> None:
        # The keys that follow, such as digits and Enter, are for the drag.
        window.panes.focus()
        window.gestures.begin(drag, window.panes.active.pointer)

    return begin


def _performs(window: "MainWindow", action: EditAction) -> Callable[[], None]:
    gestures, session = window.gestures, window.session

    def perform() -> None:
        window.magnitude.finish()
        before = session.committed
        gestures.perform_by(lambda: action.make(gestures.stage()))
        # The next click is meant for what was made: the pen would begin a curve upon it.
        if action.menu in (NEW, FROM_CURVES) and session.committed is not before:
            window.choose_tool(FIRST_TOOL)

    return perform
