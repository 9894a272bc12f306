"""The command palette: everything the window can do, found by typing a few letters of it."""

from PySide6.QtCore import QEvent, QModelIndex, QObject, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QAction, QColor, QFont, QKeyEvent, QPainter
from PySide6.QtWidgets import (
    QDialog,
    QLineEdit,
    QListWidget,
    QListWidgetItem,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QVBoxLayout,
    QWidget,
)

from plusedit.app.actions import ActionTable, Entry

Index = QModelIndex | QPersistentModelIndex

WIDTH, ROWS, ROW = 520, 10, 32  # logical pixels, but for ROWS
FOREIGN, SPREAD = 6.0, 7.0  # scores: lost by a fit of the menu's name; from the best to the last
NAVIGATING = (Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_PageDown)
NAME = Qt.ItemDataRole.UserRole
KEYS = Qt.ItemDataRole.UserRole + 1
WHERE = Qt.ItemDataRole.UserRole + 2


def title_of(entry: Entry) -> str:
    """What the palette calls an action: with its submenu, which says what the title is about."""
    title, submenu = entry.title.rstrip("…"), entry.menu.partition("/")[2]
    return f"{submenu}: {title}" if submenu else title


def score(typed: str, title: str) -> float | None:
    """How well `title` fits what was typed, the higher the better; None if it does not.

    The letters must come in order. Those that begin a word, and those that follow each other
    directly, count most.
    """
    words, text = typed.lower().split(), title.lower()
    total = 0.0
    for word in words:
        best = _best(word, text)
        if best is None:
            return None
        total += best
    return total - 0.01 * len(text)


def _best(word: str, text: str) -> float | None:
    """The best score of one word over all places where it may begin."""
    scores = []
    for start, letter in enumerate(text):
        if letter == word[0]:
            points = _from(word, text, start)
            if points is not None:
                scores.append(points)
    return max(scores, default=None)


def _from(word: str, text: str, start: int) -> float | None:
    points, last = 0.0, start - 1
    for letter in word:
        at = text.find(letter, last + 1)
        if at < 0:
            return None
        begins_word = at == 0 or not text[at - 1].isalnum()
        points += 3.0 if at == last + 1 and at != start else 2.0 if begins_word else 0.5
        last = at
    return points - 0.1 * (last - start)


class PaletteRow(QStyledItemDelegate):
    """Title left, menu and shortcut right."""

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return QSize(WIDTH - 32, ROW)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        painter.save()
        widget: QWidget = option.widget
        element = QStyle.PrimitiveElement.PE_PanelItemViewItem
        widget.style().drawPrimitive(element, option, painter, widget)
        place: QRect = option.rect.adjusted(12, 0, -12, 0)
        is_enabled = bool(option.state & QStyle.StateFlag.State_Enabled)
        palette = widget.palette()
        quiet = palette.color(palette.ColorRole.PlaceholderText)
        text = palette.color(palette.ColorRole.Text) if is_enabled else quiet
        self._write(painter, place, index.data(), text, Qt.AlignmentFlag.AlignLeft)
        right = " · ".join(filter(None, (index.data(WHERE), index.data(KEYS))))
        font = QFont(painter.font())
        font.setPointSizeF(font.pointSizeF() * 0.9)
        painter.setFont(font)
        self._write(painter, place, right, quiet, Qt.AlignmentFlag.AlignRight)
        painter.restore()

    def _write(
        self, painter: QPainter, place: QRect, text: str, color: QColor, align: Qt.AlignmentFlag
    ) -> None:
        painter.setPen(color)
        painter.drawText(place, int(align | Qt.AlignmentFlag.AlignVCenter), text)


class Palette(QDialog):
    """Type, choose with the arrow keys, Enter does it; Escape goes away."""

    def __init__(self, table: ActionTable, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup | Qt.WindowType.FramelessWindowHint)
        self._table = table
        self.typed = QLineEdit()
        self.typed.setPlaceholderText("What would you like to do?")
        self.typed.setAccessibleName("command")
        self.typed.installEventFilter(self)
        self.list = QListWidget()
        self.list.setAccessibleName("commands found")
        self.list.setItemDelegate(PaletteRow(self.list))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setUniformItemSizes(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 8, 8, 8)
        column.setSpacing(8)
        column.addWidget(self.typed)
        column.addWidget(self.list)
        self.typed.textChanged.connect(self.look_for)
        self.list.itemClicked.connect(lambda _: self.accept())
        self.accepted.connect(self._run)
        self.setFixedWidth(WIDTH)
        self.setFixedHeight(ROWS * ROW + 64)
        self.look_for("")
        self.move(
            parent.mapToGlobal(parent.rect().topLeft()).x() + (parent.width() - WIDTH) // 2,
            parent.mapToGlobal(parent.rect().topLeft()).y() + parent.height() // 6,
        )

    def look_for(self, typed: str) -> None:
        """List what fits, the best first."""
        self.list.clear()
        found = []
        for place, entry in enumerate(self._table):
            title = title_of(entry)
            points = score(typed, title) if typed.strip() else -float(place)
            if points is None and (inside := score(typed, f"{entry.menu} {title}")) is not None:
                points = inside - FOREIGN
            if points is not None:
                found.append((points, entry.name, title, entry.menu.split("/")[0]))
        best = max((points for points, *_ in found), default=0.0)
        for points, name, title, menu in sorted(found, key=lambda each: -each[0]):
            if typed.strip() and points < best - SPREAD:
                break  # letters that happen to be somewhere in it
            item = QListWidgetItem(title)
            item.setData(NAME, name)
            item.setData(KEYS, self._table.keys_text(name))
            item.setData(WHERE, menu)
            if not self._table[name].isEnabled():
                item.setFlags(Qt.ItemFlag.NoItemFlags)
            self.list.addItem(item)
        self.list.setCurrentRow(0)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            if event.key() in NAVIGATING:
                self.list.keyPressEvent(event)
                return True
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self.accept()
                return True
        return super().eventFilter(watched, event)

    def chosen(self) -> QAction | None:
        """The action that Enter would do."""
        item = self.list.currentItem()
        return None if item is None else self._table[str(item.data(NAME))]

    def _run(self) -> None:
        action = self.chosen()
        if action is not None:
            action.trigger()
