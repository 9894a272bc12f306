"""What stands in place of the 3D view where there is no OpenGL."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QVBoxLayout, QWidget

from plusedit.views.live import quiet, title

WHAT_WORKS = (
    "Curves and surfaces can be edited in the 2D view, which shows them from the top, the front "
    "and the right (View > Look from). Everything else works as well."
)


class MissingSpace(QWidget):
    """Says why there is no 3D view, and what works without it."""

    def __init__(self, problem: str) -> None:
        super().__init__()
        self.setAccessibleName("3D view")
        self.setAccessibleDescription(problem)
        column = QVBoxLayout(self)
        column.setContentsMargins(40, 40, 40, 40)
        column.setSpacing(8)
        column.addStretch(1)
        for label in (title("No 3D view"), quiet(problem), quiet(WHAT_WORKS)):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
            label.setWordWrap(True)
            column.addWidget(label)
        column.addStretch(1)
