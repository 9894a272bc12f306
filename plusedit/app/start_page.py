"""The start page: what a plus curve is, examples with pictures, recent files."""

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSize, Qt, QTimer
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPixmap, QResizeEvent, QShowEvent
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QScrollArea,
    QVBoxLayout,
    QWidget,
)

from plusedit.resources import example_files
from plusedit.scene.theme import Theme
from plusedit.views.live import quiet, title

if TYPE_CHECKING:
    from plusedit.app.figure import Figure

PICTURE = QSize(208, 132)
MARGIN, GAP = 32, 16
MOST_ACROSS = 4  # examples side by side
CARD = PICTURE.width() + 2  # logical pixels, with its border
WIDEST = MOST_ACROSS * (CARD + GAP) - GAP  # of the page, wherever the window is wider
IDEA = (
    "A plus curve blends straight lines, where other curves blend points. "
    "Each control line has a point that pulls the curve and a direction that steers it. "
    "The magnitude s says how much the directions count: at 0 it is the classical Bézier or "
    "B-spline curve, near ½ L it comes closest to its points. "
    "A plus surface blends planes in the same way, also those of the faces of a polygon mesh."
)


class Card(QFrame):
    """A picture with a name below it that can be clicked, or chosen with Enter."""

    def __init__(self, path: Path, open_file: Callable[[Path], object]) -> None:
        super().__init__()
        self.path, self._open = path, open_file
        self.setProperty("card", True)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.PointingHandCursor)
        self.setAccessibleName(f"Open {words_of(path)}")
        self.setToolTip(str(path))
        self.picture = QLabel()
        self.picture.setFixedSize(PICTURE)
        self.picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        name = QLabel(words_of(path))
        name.setContentsMargins(8, 0, 8, 0)
        column = QVBoxLayout(self)
        column.setContentsMargins(1, 1, 1, 8)
        column.setSpacing(4)
        column.addWidget(self.picture)
        column.addWidget(name)
        self.setFixedWidth(CARD)

    def show_picture(self, theme: Theme) -> None:
        """Draw the picture of the file."""
        from plusedit.app.thumbnails import picture_of_file  # not before the first frame

        ratio = self.devicePixelRatioF()
        picture = picture_of_file(self.path, PICTURE, theme, ratio)
        self.picture.setPixmap(picture or QPixmap())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton and self.rect().contains(
            event.position().toPoint()
        ):
            self._open(self.path)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self._open(self.path)
        else:
            super().keyPressEvent(event)


def words_of(path: Path) -> str:
    """The name of a shipped file as words."""
    stem = path.name.split(".")[0].removeprefix(FACT).replace("_", " ").replace("-", " ")
    return stem[:1].upper() + stem[1:]


FACT = "fact_"  # before the names of designs that prove what the paper has not quite right
SURFACE, MESH = b'"kind": "surface"', b'"kind": "mesh"'  # in a file that has one


def sections() -> Iterator[tuple[str, list[Path]]]:
    """The shipped designs by what they are made of, and the figures of the paper."""
    found: dict[str, list[Path]] = {
        name: [] for name in ("Surfaces", "Meshes", "Curves", "Figures of the paper", "Facts")
    }
    for path in example_files():
        found[_section(path)].append(path)
    yield from ((name, paths) for name, paths in found.items() if paths)


def _section(path: Path) -> str:
    if path.name.startswith("figure"):
        return "Figures of the paper"
    if path.name.startswith(FACT):
        return "Facts"
    data = path.read_bytes()
    if MESH in data:
        return "Meshes"
    return "Surfaces" if SURFACE in data else "Curves"


class StartPage(QScrollArea):
    """What stands in the window while no design is open."""

    def __init__(
        self,
        open_file: Callable[[Path], object],
        new_curve: Callable[[], object],
        ask: Callable[[], object],
    ) -> None:
        super().__init__()
        self._open = open_file
        self._theme: Theme | None = None
        self._waiting: list[Card] = []
        self._sections = [
            (name, [Card(path, open_file) for path in paths]) for name, paths in sections()
        ]
        self._cards = [card for _, cards in self._sections for card in cards]
        self._one_by_one = QTimer(self)
        self._one_by_one.timeout.connect(self._draw_next)
        self._recent = QVBoxLayout()
        self._recent.setSpacing(4)
        self.figure: Figure | None = None
        self._figure_place = QVBoxLayout()
        self._across = 0
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAsNeeded)
        self._whole = self._page(new_curve, ask)
        self.setWidget(self._whole)

    def set_theme(self, theme: Theme) -> None:
        """Draw pictures in those colors, once they can be seen."""
        self._theme = theme
        self._waiting = list(self._cards)
        if self.figure is not None:
            self.figure.set_theme(theme)
        if self.isVisible():
            self._one_by_one.start(0)

    def set_blank(self, is_blank: bool) -> None:
        """Show nothing, as long as a file that was asked for is on its way."""
        self._whole.setHidden(is_blank)

    def show_recent(self, paths: list[Path]) -> None:
        """List these files as recent ones."""
        while (item := self._recent.takeAt(0)) is not None:
            if (widget := item.widget()) is not None:
                widget.deleteLater()
        for path in paths[:6]:
            button = QPushButton(path.name)
            button.setProperty("link", True)
            button.setToolTip(str(path))
            button.setCursor(Qt.CursorShape.PointingHandCursor)
            button.clicked.connect(lambda _=False, path=path: self._open(path))
            self._recent.addWidget(button, 0, Qt.AlignmentFlag.AlignLeft)
        if not paths:
            self._recent.addWidget(quiet("Files that you open or save are listed here."))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        # Pictures come after the first frame: the window is there at once.
        self._one_by_one.start(30)

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Hide:
            self._one_by_one.stop()
        return super().event(event)

    def _draw_next(self) -> None:
        if self._theme is None or not self.isVisible():
            self._one_by_one.stop()
            return
        if self.figure is None:
            from plusedit.app.figure import Figure  # not before the first frame

            self.figure = Figure()
            self.figure.set_theme(self._theme)
            self._figure_place.addWidget(self.figure)
        elif self._waiting:
            self._waiting.pop(0).show_picture(self._theme)
        else:
            self._one_by_one.stop()
        self._one_by_one.setInterval(0)

    def _page(self, new_curve: Callable[[], object], ask: Callable[[], object]) -> QWidget:
        column = QVBoxLayout()
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(24)
        column.addLayout(self._top(new_curve, ask))
        self._grids = []
        for name, _ in self._sections:
            column.addWidget(title(name))
            self._grids.append(self._grid())
            column.addLayout(self._grids[-1])
        column.addStretch(1)
        inside = QWidget()
        inside.setMaximumWidth(WIDEST)
        inside.setLayout(column)
        page = QWidget()
        row = QHBoxLayout(page)
        row.setContentsMargins(MARGIN, MARGIN, MARGIN, MARGIN)
        row.addStretch(1)
        row.addWidget(inside, 100)
        row.addStretch(1)
        return page

    def _top(self, new_curve: Callable[[], object], ask: Callable[[], object]) -> QHBoxLayout:
        head = QLabel("PlusEdit")
        font = head.font()
        font.setPointSizeF(font.pointSizeF() * 2.2)
        font.setWeight(font.Weight.DemiBold)
        head.setFont(font)
        draw, open_ = QPushButton("New curve"), QPushButton("Open…")
        draw.setProperty("primary", True)
        draw.setToolTip("Take the pen and draw on an empty canvas")
        draw.clicked.connect(lambda: new_curve())
        open_.clicked.connect(lambda: ask())
        buttons = QHBoxLayout()
        buttons.setSpacing(8)
        buttons.addWidget(draw)
        buttons.addWidget(open_)
        buttons.addStretch(1)
        left = QVBoxLayout()
        left.setSpacing(16)
        left.addWidget(head)
        left.addWidget(quiet(IDEA))
        left.addLayout(buttons)
        left.addSpacing(8)
        left.addWidget(title("Recent"))
        left.addLayout(self._recent)
        left.addStretch(1)
        row = QHBoxLayout()
        row.setSpacing(32)
        row.addLayout(left, 4)
        row.addLayout(self._figure_place, 5)
        return row

    def _grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(GAP)
        grid.setColumnStretch(MOST_ACROSS, 1)
        return grid

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        room = min(WIDEST, self.viewport().width() - 2 * MARGIN)
        across = max(1, min(MOST_ACROSS, (room + GAP) // (CARD + GAP)))
        if across != self._across:
            self._across = across
            for grid, (_, cards) in zip(self._grids, self._sections, strict=True):
                for number, card in enumerate(cards):
                    grid.addWidget(card, number // across, number % across)
