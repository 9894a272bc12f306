"""Plots side by side with a line of numbers below, or a sentence while there are none."""

from collections.abc import Iterable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QSizePolicy, QStackedLayout, QVBoxLayout, QWidget

from plusedit.views.live import quiet
from plusedit.views.look import tabular
from plusedit.views.plot import PlotView


def stacked_plots(
    parent: QWidget, plots: Iterable[PlotView], numbers: QLabel, empty: str
) -> QStackedLayout:
    """Lay out a panel: its page 0 has the plots, its page 1 the sentence."""
    numbers.setProperty("quiet", True)
    numbers.setFont(tabular(numbers.font()))
    row = QHBoxLayout()
    row.setSpacing(8)
    for plot in plots:
        row.addWidget(plot, 1)
    inside, sentence = QWidget(), quiet(empty)
    column = QVBoxLayout(inside)
    column.setContentsMargins(8, 4, 8, 4)
    column.setSpacing(2)
    column.addLayout(row, 1)
    column.addWidget(numbers)
    sentence.setAlignment(Qt.AlignmentFlag.AlignCenter)
    # Numbers that find no room in a line take another: they must not make the panel wider.
    numbers.setWordWrap(True)
    numbers.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)
    sentence.setMinimumWidth(1)
    stack = QStackedLayout(parent)
    for page in (inside, sentence):
        page.setProperty("panel", True)
        page.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        stack.addWidget(page)
    return stack
