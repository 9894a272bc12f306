"""The menu bar and the context menu, made from the table of actions."""

from collections.abc import Callable, Collection
from pathlib import Path

from PySide6.QtWidgets import QMenu, QMenuBar, QWidget

from plusedit.app.actions import ActionTable

ORDER = (
    "File",
    "Edit",
    "Select",
    "Control lines",
    "Curve",
    "Surface",
    "Mesh",
    "Constraints",
    "Arrange",
    "View",
    "Window",
    "Help",
)
ANY, CURVES, SURFACES, MESHES = "any", "curves", "surfaces", "meshes"
IN_CONTEXT = (
    (ANY, ("cut", "copy", "paste", "edit.duplicate", "edit.delete")),
    (ANY, ("edit.reset_directions", "edit.reverse_directions")),
    (CURVES, ("edit.reverse_curve", "edit.close_curve", "edit.open_curve")),
    (CURVES, ("edit.close_smoothly", "edit.pass_through", "edit.keep_passing")),
    (CURVES, ("edit.extrude", "edit.revolve_upright", "edit.rule", "edit.loft", "edit.fill")),
    (SURFACES, ("edit.select_row", "edit.select_column")),
    (SURFACES, ("edit.insert_row", "edit.insert_column", "edit.transpose")),
    (SURFACES, ("edit.pass_through_surface", "edit.tangent_corners", "edit.balance")),
    (SURFACES, ("edit.extract_boundary", "edit.extract_u", "edit.extract_v")),
    (MESHES, ("edit.sharper", "edit.smoother", "edit.reset_factor")),
    (MESHES, ("edit.reset_planes", "edit.select_edited")),
    (ANY, ("edit.hide", "edit.lock", "edit.to_front", "edit.to_back")),
    (ANY, ("frame_selected", "frame_all")),
)
"""Groups of the context menu, and of what they speak."""


def fill(bar: QMenuBar, table: ActionTable) -> dict[str, QMenu]:
    """Build all menus; those menus by path, such as "File/Open recent"."""
    menus: dict[str, QMenu] = {}
    entries = [entry for entry in table if entry.menu]
    tops = dict.fromkeys([*ORDER, *(entry.menu.split("/")[0] for entry in entries)])
    for top in tops:
        members = [entry for entry in entries if entry.menu.split("/")[0] == top]
        if not members:
            continue
        menus[top] = bar.addMenu(f"&{top}")
        ordered = sorted(members, key=lambda each: each.group)
        last_group = ordered[0].group
        for entry in ordered:
            menu = _menu(menus, entry.menu)
            if entry.group != last_group:
                menus[top].addSeparator()
                last_group = entry.group
            if menu is not menus[top] and menu.menuAction() not in menus[top].actions():
                menus[top].addMenu(menu)
            menu.addAction(table[entry.name])
        names = [entry.name for entry in members]
        menus[top].aboutToShow.connect(lambda names=names: _prepare(table, names))
    return menus


def _prepare(table: ActionTable, names: list[str]) -> None:
    """What a menu needs the moment it opens."""
    table.refresh()
    for name in names:
        table.show_icon(name)


def _menu(menus: dict[str, QMenu], path: str) -> QMenu:
    """The menu of that path, made below its parent if need be."""
    if path not in menus:
        top, _, name = path.partition("/")
        menus[path] = QMenu(name, menus[top])
    return menus[path]


def fill_recent(menu: QMenu, paths: list[Path], open_file: Callable[[Path], object]) -> None:
    """List recent files, with their folders where names alone would be the same."""
    menu.clear()
    names = [path.name for path in paths]
    for path in paths:
        text = path.name if names.count(path.name) == 1 else f"{path.name} – {path.parent}"
        action = menu.addAction(text.replace("&", "&&"))
        action.setToolTip(str(path))
        action.triggered.connect(lambda _=False, path=path: open_file(path))


def context_menu(table: ActionTable, parent: QWidget, kinds: Collection[str] = ()) -> QMenu:
    """The menu of a right click in the view, where shapes of those kinds are selected."""
    menu = QMenu(parent)
    for kind, group in IN_CONTEXT:
        if kind != ANY and kind not in kinds:
            continue
        for name in group:
            if name in table:
                table.show_icon(name)
                menu.addAction(table[name])
        menu.addSeparator()
    return menu
