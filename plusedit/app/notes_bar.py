"""A bar above the view with what a file had that was repaired, left out or changed."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QToolButton, QWidget

from plusedit.views.icons import set_icon

MANY = 3  # notes shown in the bar; all of them are in its tooltip


class NotesBar(QWidget):
    """Hidden until there is something to say; the cross at its end hides it again."""

    def __init__(self) -> None:
        super().__init__()
        self.setProperty("note", True)
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.text = QLabel()
        self.text.setWordWrap(True)
        self.text.setTextFormat(Qt.TextFormat.PlainText)
        self.text.setAccessibleName("notes on the file")
        self.more = QPushButton()
        self.more.setAccessibleName("more on the file")
        self.more.hide()
        self._act: Callable[[], object] = self.hide
        self.more.clicked.connect(lambda: self._act())
        self.close_button = QToolButton()
        self.close_button.setText("×")
        self.close_button.setToolTip("Hide these notes")
        self.close_button.setAccessibleName("hide notes")
        set_icon(self.close_button, "cross")
        self.close_button.clicked.connect(self.hide)
        row = QHBoxLayout(self)
        row.setContentsMargins(12, 4, 8, 4)
        row.addWidget(self.text, 1)
        row.addWidget(self.more, 0, Qt.AlignmentFlag.AlignTop)
        row.addWidget(self.close_button, 0, Qt.AlignmentFlag.AlignTop)
        self.hide()

    def tell(self, name: str, notes: tuple[str, ...]) -> None:
        """Show the notes on a file; none hide the bar."""
        shown = [*notes[:MANY]]
        if len(notes) > MANY:
            shown.append(f"… and {len(notes) - MANY} more")
        sentences = " ".join(note if note.endswith((".", "…")) else f"{note}." for note in shown)
        self.text.setText(f"{name}: {sentences}")
        self.setToolTip("\n".join(notes))
        self.more.hide()
        self.setVisible(bool(notes))

    def offer(self, words: str, act: Callable[[], object]) -> None:
        """Add a button to the notes that are shown now."""
        self.more.setText(words)
        self._act = act
        self.more.show()
