"""The list of shortcuts: every one can be changed, and no two actions may share a key."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QHBoxLayout,
    QHeaderView,
    QKeySequenceEdit,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from plusedit.app.actions import ActionTable
from plusedit.views.live import quiet

NAME = Qt.ItemDataRole.UserRole


class ShortcutEditor(QWidget):
    """Shows the shortcuts of a table and holds the ones being chosen until they are taken."""

    def __init__(self, table: ActionTable) -> None:
        super().__init__()
        self._table = table
        self.chosen = table.shortcuts()
        """portable keys by name of the action"""
        self.search = QLineEdit()
        self.search.setPlaceholderText("Find an action or a key")
        self.search.setClearButtonEnabled(True)
        self.search.textChanged.connect(self._filter)
        self.list = QTreeWidget()
        self.list.setColumnCount(2)
        self.list.setHeaderLabels(["Action", "Shortcut"])
        self.list.setRootIsDecorated(False)
        self.list.setAccessibleName("shortcuts")
        self.list.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        self.list.header().setStretchLastSection(False)
        self.list.setColumnWidth(1, 160)
        self.list.currentItemChanged.connect(lambda *_: self._show_current())
        self.keys = QKeySequenceEdit()
        self.keys.setMaximumSequenceLength(1)
        self.keys.setClearButtonEnabled(True)
        self.keys.setAccessibleName("new shortcut")
        self.keys.keySequenceChanged.connect(self._warn)
        self._set = QPushButton("Set")
        self._set.clicked.connect(lambda: self.assign(self.keys.keySequence()))
        usual, all_usual = QPushButton("Reset"), QPushButton("Reset all")
        usual.clicked.connect(self._reset_one)
        all_usual.clicked.connect(self.reset)
        self.remark = quiet("Choose an action, then press the new keys.")
        self._lay_out(usual, all_usual)
        self._fill()

    def _lay_out(self, usual: QPushButton, all_usual: QPushButton) -> None:
        row = QHBoxLayout()
        row.setSpacing(8)
        for widget in (self.keys, self._set, usual):
            row.addWidget(widget)
        row.addStretch(1)
        row.addWidget(all_usual)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 8, 0, 0)
        column.setSpacing(8)
        for part in (self.search, self.list):
            column.addWidget(part)
        column.addLayout(row)
        column.addWidget(self.remark)

    def assign(self, keys: QKeySequence) -> None:
        """Give the chosen action these keys alone; whoever had them loses them."""
        name = self.current()
        if name is None:
            return
        text = keys.toString()
        for other in self.users(text):
            self.chosen[other] = [key for key in self.chosen[other] if key != text]
        self.chosen[name] = [text] if text else []
        self._fill_keys()
        self._show_current()

    def settle(self) -> None:
        """Take keys that were pressed and not set yet: whoever pressed them means them."""
        name, keys = self.current(), self.keys.keySequence()
        if name is not None and keys.toString() != next(iter(self.chosen[name]), ""):
            self.assign(keys)

    def reset(self) -> None:
        """Every action has its usual shortcuts again."""
        self.chosen = {entry.name: _portable(entry.shortcuts) for entry in self._table}
        self._fill_keys()
        self._show_current()

    def changed(self) -> dict[str, list[str]]:
        """The shortcuts that are not the usual ones, to be remembered."""
        usual = {entry.name: _portable(entry.shortcuts) for entry in self._table}
        return {name: keys for name, keys in self.chosen.items() if keys != usual[name]}

    def users(self, key: str) -> list[str]:
        """The other actions that have this key now."""
        return [n for n, keys in self.chosen.items() if key and key in keys and n != self.current()]

    def current(self) -> str | None:
        """The name of the action that is being changed."""
        item = self.list.currentItem()
        return None if item is None else str(item.data(0, NAME))

    def _fill(self) -> None:
        for entry in self._table:
            menu = entry.menu.replace("/", " › ")
            title = entry.title.rstrip("…")
            item = QTreeWidgetItem([f"{menu}: {title}" if menu else title, ""])
            item.setData(0, NAME, entry.name)
            self.list.addTopLevelItem(item)
        self._fill_keys()

    def _items(self) -> list[QTreeWidgetItem]:
        rows = range(self.list.topLevelItemCount())
        return [item for row in rows if (item := self.list.topLevelItem(row)) is not None]

    def _fill_keys(self) -> None:
        for item in self._items():
            keys = self.chosen[str(item.data(0, NAME))]
            native = QKeySequence.SequenceFormat.NativeText
            item.setText(1, ", ".join(QKeySequence(key).toString(native) for key in keys))

    def _filter(self, typed: str) -> None:
        wanted = typed.lower()
        for item in self._items():
            text = f"{item.text(0)} {item.text(1)}".lower()
            item.setHidden(wanted not in text)

    def _show_current(self) -> None:
        name = self.current()
        keys = self.chosen.get(name, []) if name is not None else []
        self.keys.setKeySequence(QKeySequence(keys[0]) if keys else QKeySequence())

    def _warn(self, keys: QKeySequence) -> None:
        users = [self._table[name].text().rstrip("…") for name in self.users(keys.toString())]
        if users:
            self.remark.setText(f"“{users[0]}” has these keys now; it would lose them.")
        else:
            self.remark.setText("Choose an action, then press the new keys.")

    def _reset_one(self) -> None:
        name = self.current()
        usual = next((entry.shortcuts for entry in self._table if entry.name == name), None)
        if name is not None and usual is not None:
            for key in _portable(usual):
                for other in self.users(key):
                    self.chosen[other] = [mine for mine in self.chosen[other] if mine != key]
            self.chosen[name] = _portable(usual)
            self._fill_keys()
            self._show_current()


def _portable(keys: tuple[str, ...]) -> list[str]:
    return [QKeySequence(key).toString() for key in keys]
