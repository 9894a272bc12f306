"""What lies over the view of space: words, and what the tool shows.

A sheet of its own, for two reasons: it is drawn smoothly whatever OpenGL can do, and the view
below need not be drawn again when only the pointer moves.
"""

from dataclasses import dataclass

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QPaintEvent
from PySide6.QtWidgets import QWidget

from plusedit.interaction.tool import Feedback, Pointer
from plusedit.scene.items import Caption, Item
from plusedit.scene.space_camera import SpaceCamera
from plusedit.scene.space_scene import SpaceLayers
from plusedit.scene.theme import Theme
from plusedit.views.notices import paint_empty, paint_note, paint_readout
from plusedit.views.painter import ItemPainter, painting


@dataclass(frozen=True, eq=False)
class Sheet:
    """What the overlay shows."""

    camera: SpaceCamera
    theme: Theme
    layers: SpaceLayers
    """of which the words are drawn here"""
    spotted: tuple[Item, ...]
    """what overlays show at the point under the pointer"""
    feedback: Feedback
    pointer: Pointer | None
    note: str
    """a sentence in the corner"""
    is_empty: bool
    """whether to say what to do"""


class SpaceOverlay(QWidget):
    """Lies over a view and lets the mouse through."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setAttribute(Qt.WidgetAttribute.WA_NoSystemBackground)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.sheet: Sheet | None = None
        """what is shown at the next update"""

    def paintEvent(self, event: QPaintEvent) -> None:
        sheet, view = self.sheet, self.rect().toRectF()
        if sheet is None:
            return
        with painting(self) as painter:
            items = ItemPainter(painter, sheet.camera, sheet.theme)
            captions = [item for item in sheet.spotted if isinstance(item, Caption)]
            items.paint(item for item in sheet.spotted if not isinstance(item, Caption))
            items.paint(sheet.layers.words(captions))
            items.paint(sheet.feedback.items)
            if sheet.is_empty:
                paint_empty(painter, view, sheet.theme)
            if sheet.note:
                paint_note(painter, view, sheet.note, sheet.theme)
            if sheet.pointer is not None and sheet.feedback.readout:
                at = QPointF(sheet.pointer.x, sheet.pointer.y)
                paint_readout(painter, view, at, sheet.feedback.readout, sheet.theme)
