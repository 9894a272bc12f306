"""The faces of a mesh in its parameters u and v, to be looked at and selected."""

import numpy as np
from PySide6.QtCore import QEvent, QRectF, Qt
from PySide6.QtGui import QEnterEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from plusedit.document.selection import NOTHING_SELECTED, Selection
from plusedit.document.shape import ShapeId
from plusedit.events import Event
from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.mesh.unfolding import NONE, Unfolding
from plusedit.interaction.parameter_hand import ParameterHand, ParameterStage
from plusedit.interaction.tool import Pointer
from plusedit.scene.graduation import graduation
from plusedit.scene.parameter_colors import Measure
from plusedit.scene.parameter_items import cell_items, circle_items, rim_items
from plusedit.scene.parameter_sheet import ParameterSheet
from plusedit.scene.theme import LIGHT, Theme
from plusedit.views.notices import paint_empty
from plusedit.views.own_keys import OwnKeys
from plusedit.views.painter import ItemPainter, color_of, painting
from plusedit.views.parameter_picture import ParameterPicture
from plusedit.views.plane_view import PlaneView
from plusedit.views.pointer import pointer_of

EMPTY = "Select a mesh to see its faces in the parameters u and v"
WAITING = "Laying out the faces …"
MARGIN = 44.0  # pixels around what is framed
ZOOMING = {  # by one press of a key
    Qt.Key.Key_Plus: 1.4,
    Qt.Key.Key_Equal: 1.4,
    Qt.Key.Key_Minus: 1.0 / 1.4,
}


class ParameterView(PlaneView):
    """Shows the faces of one mesh; what is done to them is told to who listens."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.hand = ParameterHand()
        self.pointed: Event[str, str] = Event()
        """the parameters under the pointer, and what is there; both empty when it has left"""
        self.hinted: Event[str] = Event()
        """what can be done where the pointer is"""
        self.entered: Event[QWidget] = Event()
        """the pointer came in: keys are meant for this view"""
        self.known: Event[()] = Event()
        """more is known of the mesh that is shown"""
        self.measure: Measure = "angles"
        self._theme: Theme = LIGHT
        self._shape_id: ShapeId | None = None
        self._surface: MeshSurface | None = None
        self._selection: Selection = NOTHING_SELECTED
        self._rows: tuple[int, ...] = ()
        self._chosen = np.zeros(0, dtype=np.intp)
        """the same: faces that are selected"""
        self._framed: Unfolding | None = None
        """what was brought into sight last"""
        self._last: Pointer | None = None
        """where the pointer is; None while it is elsewhere"""
        self.picture = ParameterPicture(self)
        self.picture.ready.listen(self._arrived)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(160, 120)
        self._own_keys = OwnKeys(self, {Qt.Key.Key_F, *ZOOMING})
        self.setAccessibleName("Parameters")
        self.setAccessibleDescription("The faces of the selected mesh in its parameters u and v")

    # What it shows

    @property
    def sheet(self) -> ParameterSheet | None:
        """What is known of the mesh that is shown; None while it is being worked out."""
        return self.picture.sheet

    @property
    def stage(self) -> ParameterStage | None:
        """What the pointer acts on; None while there is nothing."""
        if self.sheet is None or self._shape_id is None:
            return None
        selection, seen = self._selection, self.picture.face_at
        return ParameterStage(self._shape_id, self.sheet, self.camera, selection, seen)

    def show_mesh(
        self,
        shape_id: ShapeId | None,
        surface: MeshSurface | None,
        selection: Selection,
        *,
        settled: bool = True,
    ) -> None:
        """Show that mesh, or none, with what is selected of it.

        Unless it is settled, what takes long to work out may stay as it was for another mesh that
        differs from it in space only.
        """
        sheet = self.sheet
        is_alike = sheet is not None and surface is not None and sheet.mapping.lays_out(surface)
        if settled or not is_alike:
            self.picture.show_surface(surface)
        if not is_alike or shape_id != self._shape_id:
            self.hand.cancel()
        self._shape_id, self._surface, self._selection = shape_id, surface, selection
        rows = () if shape_id is None else selection.by_shape().get(shape_id, ())
        if rows is not self._rows:
            self._rows, self._chosen = rows, np.array(rows, dtype=np.intp)
        self._ask()
        self.update()

    def set_theme(self, theme: Theme) -> None:
        """Draw in those colors."""
        self._theme = theme
        self.update()

    def set_measure(self, measure: Measure) -> None:
        """Color the faces by that."""
        self.measure = measure
        self.update()

    def frame_all(self) -> None:
        """See the whole cell."""
        if self.sheet is not None:
            self._frame(np.stack(self.sheet.unfolding.bounds))

    def frame_selected(self) -> None:
        """See the selected faces, or the whole cell where none is."""
        if self.sheet is None or not self._rows:
            self.frame_all()
            return
        unfolding = self.sheet.unfolding
        marks = np.zeros(self.sheet.face_count, dtype=np.bool_)
        marks[self._chosen] = True
        self._frame(unfolding.corners[marks[unfolding.mesh.owners]])

    def reading(self) -> tuple[str, str]:
        """The parameters under the pointer, and the face there with what the map did to it."""
        stage, at = self.stage, self._last
        if stage is None or at is None:
            return "", ""
        marks = graduation(self.camera.pixel)
        u, v = (marks.text(value) for value in stage.place(at).tolist())
        face = self.hand.face(stage)
        if face == NONE:
            return f"u {u}  v {v}", ""
        stretch = stage.sheet.stretch
        turned = "   turned over" if stage.sheet.flipped[face] else ""
        return (
            f"u {u}  v {v}",
            f"face {face + 1}   angles × {stretch.angles[face]:.3g}"
            f"   area × {stretch.areas[face]:.3g}{turned}",
        )

    # How it is drawn

    def paintEvent(self, event: QPaintEvent) -> None:
        view = QRectF(self.rect())
        with painting(self) as painter:
            painter.fillRect(view, color_of(self._theme.color("canvas")))
            if self._surface is None:
                paint_empty(painter, view, self._theme, EMPTY)
            elif self.stage is None:
                paint_empty(painter, view, self._theme, WAITING)
            else:
                self._paint(painter, self.stage)

    def _paint(self, painter: QPainter, stage: ParameterStage) -> None:
        assert self._surface is not None
        sheet, camera, theme = stage.sheet, self.camera, self._theme
        self.picture.paint(painter, camera, self.measure, theme, self._chosen)
        images = sheet.unfolding.images_within(*camera.window)
        draw = ItemPainter(painter, camera, theme)
        draw.paint(cell_items(sheet, images))
        draw.paint(rim_items(sheet, images))
        draw.paint(circle_items(sheet, self._surface.sigmas, self._chosen, camera))
        draw.paint(self.hand.items(stage))

    # What it hears

    def _ask(self) -> None:
        if self.isVisible():
            self.picture.see(self.camera, self.devicePixelRatioF())

    def _arrived(self) -> None:
        sheet = self.sheet
        if sheet is not None and self._framed is not sheet.unfolding:
            before, self._framed = self._framed, sheet.unfolding
            if before is None or not _is_alike(before, sheet.unfolding):
                self.frame_all()
            self.known.emit()
        self._ask()
        self.update()

    def _frame(self, places: Floats) -> None:
        self._navigation.go(self.camera.framing(places, MARGIN))

    def _camera_moved(self) -> None:
        super()._camera_moved()
        self._ask()

    def _look(self) -> None:
        """Tell and show what is under the pointer now."""
        stage = self.stage
        self.pointed.emit(*self.reading())
        self.hinted.emit("" if stage is None or self._last is None else self.hand.hint(stage))
        self.update()

    # What Qt tells

    def may_navigate(self) -> bool:
        return not self.hand.is_dragging

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._ask()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        stage, at = self.stage, pointer_of(event)
        if stage is None or self.is_panned:
            return
        if event.button() == Qt.MouseButton.LeftButton:
            self.hand.press(at, stage)
        elif event.button() == Qt.MouseButton.RightButton:
            self.hand.cancel()
        self._look()

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        super().mouseMoveEvent(event)
        self._last = pointer_of(event)
        if not self.is_panned:
            self.hand.move(self._last)
        self._look()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        was_panned = self.is_panned
        super().mouseReleaseEvent(event)
        stage = self.stage
        if stage is not None and event.button() == Qt.MouseButton.LeftButton and not was_panned:
            self.hand.release(pointer_of(event), stage)
            self._look()

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        self.entered.emit(self)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._last = None
        self.hand.leave()
        self._look()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        key = event.key()
        if key == Qt.Key.Key_Escape and self.hand.cancel():
            self._look()
        elif key == Qt.Key.Key_Home:
            self.frame_all()
        elif key == Qt.Key.Key_F and not event.modifiers():
            self.frame_selected()
        elif key in ZOOMING:
            self.zoom(ZOOMING[Qt.Key(key)])
        else:
            super().keyPressEvent(event)


def _is_alike(one: Unfolding, other: Unfolding) -> bool:
    return one.domain == other.domain and np.array_equal(one.centers, other.centers)
