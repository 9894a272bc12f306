"""Everything the window can do, in one table: menus, tool bar, palette, shortcuts and help read it.

Letters and other signs act in the whole window: fields that are typed into take them first, and
widgets that need one for themselves say so (`OwnKeys`). Keys that every list and field has a use
for, such as arrows, Tab and Delete, belong to the view: their shortcuts work where it has the focus
and nowhere else.
"""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QKeyCombination, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtWidgets import QWidget

from plusedit.resources import icon_file
from plusedit.views.icons import set_icon

SECOND_BACKTAB = QKeySequence("Backtab")  # another name of Shift+Tab
ARROWS = {Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down}
COMMANDING = (
    Qt.KeyboardModifier.ControlModifier
    | Qt.KeyboardModifier.AltModifier
    | Qt.KeyboardModifier.MetaModifier
)


@dataclass(frozen=True)
class Entry:
    """One thing the window can do."""

    name: str
    """unique; shortcuts are remembered by it"""
    title: str
    menu: str
    """where it stands, such as "File" or "File/Export"; "" for nowhere but the palette"""
    run: Callable[[], object]
    shortcuts: tuple[str, ...] = ()
    group: int = 0
    """entries of a menu that belong together; a line separates one number from the next"""
    icon: str = ""
    hint: str = ""
    """what it does, in a sentence"""
    checked: Callable[[], bool] | None = None
    """for a switch: whether it is on"""
    enabled: Callable[[], bool] | None = None
    role: QAction.MenuRole = QAction.MenuRole.NoRole


class ActionTable:
    """A QAction for every entry, with the shortcuts that the user chose or the usual ones."""

    def __init__(self, window: QWidget, view: QWidget) -> None:
        self._window, self._view = window, view
        self._entries: dict[str, Entry] = {}
        self._actions: dict[str, QAction] = {}

    def __getitem__(self, name: str) -> QAction:
        return self._actions[name]

    def __contains__(self, name: object) -> bool:
        return name in self._actions

    def __iter__(self) -> Iterator[Entry]:
        return iter(self._entries.values())

    def add(self, entries: Iterable[Entry]) -> None:
        """Make an action of each entry. ValueError if a name is taken."""
        for entry in entries:
            if entry.name in self._entries:
                raise ValueError(f"there is an action {entry.name!r} already")
            action = QAction(entry.title, self._window)
            action.setObjectName(entry.name)
            action.setMenuRole(entry.role)
            action.setCheckable(entry.checked is not None)
            action.triggered.connect(lambda _=False, run=entry.run: run())
            self._entries[entry.name], self._actions[entry.name] = entry, action
        self.refresh()

    def show_icon(self, name: str) -> None:
        """Draw the icon of an action that is about to be seen; drawing all would cost a start."""
        entry, action = self._entries[name], self._actions[name]
        # A switch shows its tick in menus: a colored icon alone would not say that it is on.
        action.setIconVisibleInMenu(entry.checked is None)
        if entry.icon and action.icon().isNull() and icon_file(entry.icon).exists():
            set_icon(action, entry.icon)

    def refresh(self) -> None:
        """Check and enable the actions as the window is now."""
        for name, entry in self._entries.items():
            if entry.checked is not None:
                self._actions[name].setChecked(entry.checked())
            if entry.enabled is not None:
                self._actions[name].setEnabled(entry.enabled())

    def set_shortcuts(self, chosen: Mapping[str, list[str]]) -> None:
        """Give every action the shortcuts in `chosen`, or else its usual ones."""
        for name, entry in self._entries.items():
            keys = [QKeySequence(key) for key in chosen.get(name, entry.shortcuts)]
            action = self._actions[name]
            action.setShortcuts(keys)
            is_of_view = any(belongs_to_view(key) for key in keys)
            self._window.removeAction(action)
            self._view.removeAction(action)
            kind = Qt.ShortcutContext
            action.setShortcutContext(
                kind.WidgetWithChildrenShortcut if is_of_view else kind.WindowShortcut
            )
            (self._view if is_of_view else self._window).addAction(action)
            action.setToolTip(self.tip(name))
            action.setStatusTip(entry.hint)

    def shortcuts(self) -> dict[str, list[str]]:
        """The shortcuts now, in portable form, by name."""
        return {
            name: [key.toString() for key in action.shortcuts()]
            for name, action in self._actions.items()
        }

    def keys_text(self, name: str) -> str:
        """The shortcuts of an action as they stand on the keys of this machine."""
        native = QKeySequence.SequenceFormat.NativeText
        keys = [key for key in self._actions[name].shortcuts() if key != SECOND_BACKTAB]
        return ", ".join(key.toString(native) for key in keys)

    def tip(self, name: str) -> str:
        """The tooltip of an action: title, keys, and what it does."""
        entry, keys = self._entries[name], self.keys_text(name)
        head = f"{entry.title.rstrip('…')}  ({keys})" if keys else entry.title.rstrip("…")
        return f"{head}\n{entry.hint}" if entry.hint else head


def belongs_to_view(keys: QKeySequence) -> bool:
    """Whether lists and fields have a use of their own for a key: a cursor goes by it, say."""
    if keys.isEmpty():
        return False
    first: QKeyCombination = keys[0]  # type: ignore[index]
    key = first.key()
    if key in ARROWS:
        return True
    is_function_key = Qt.Key.Key_F1 <= key <= Qt.Key.Key_F35
    return not (is_function_key or is_sign(key) or first.keyboardModifiers() & COMMANDING)


def is_sign(key: int) -> bool:
    """Whether a key writes a letter, a digit or another sign that is seen."""
    return Qt.Key.Key_Space < key < Qt.Key.Key_Escape


def conflicts(shortcuts: Mapping[str, Iterable[str]]) -> dict[str, list[str]]:
    """Keys that stand for more than one action, with the names of those."""
    users: dict[str, list[str]] = {}
    for name, keys in shortcuts.items():
        for key in keys:
            users.setdefault(QKeySequence(key).toString(), []).append(name)
    return {key: names for key, names in users.items() if key and len(names) > 1}
