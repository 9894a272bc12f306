"""How a figure is to be made: what of the design, how large, which kind of file; with a preview."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace

from PySide6.QtCore import QSize, Qt, QTimer
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QLineEdit, QWidget

from plusedit.app.export_dialogs import Question
from plusedit.scene.figure import Figure, FigureForm
from plusedit.scene.theme import THEMES
from plusedit.views.arithmetic import calculated
from plusedit.views.figure_files import SUFFIXES, USUAL_RESOLUTION, check_resolution
from plusedit.views.figure_picture import figure_image
from plusedit.views.gl.functions import OpenGLError
from plusedit.views.live import quiet
from plusedit.views.space_figure import drawn_figure

PREVIEW = QSize(380, 260)  # logical pixels
PAUSE = 200  # milliseconds from the last change to the preview of it
PARTS = {
    "seen": "What the view in use shows",
    "plane": "All of the design, 2D",
    "space": "All of the design, 3D",
}
KINDS = {".pdf": "PDF, vectors", ".svg": "SVG, vectors", ".png": "PNG, pixels"}


@dataclass(frozen=True)
class FigureWish:
    """What was filled in."""

    part: str = "seen"
    """a key of PARTS"""
    suffix: str = ".pdf"
    resolution: float = USUAL_RESOLUTION
    """pixels to an inch"""
    form: FigureForm = field(default_factory=FigureForm)

    def tree(self) -> dict[str, object]:
        """As settings keep it."""
        form = self.form
        return {
            "part": self.part,
            "suffix": self.suffix,
            "resolution": self.resolution,
            "width": form.width,
            "height": form.height,
            "text": form.text,
            "line": form.line,
            "theme": form.theme,
            "transparent": form.transparent,
        }

    @classmethod
    def of(cls, tree: Mapping[str, object]) -> "FigureWish":
        """What settings kept; what makes no sense is as usual."""
        wish = cls()
        for name, known in (("part", tuple(PARTS)), ("suffix", tuple(KINDS))):
            if (value := tree.get(name)) in known:
                wish = replace(wish, **{name: value})  # type: ignore[arg-type]
        if isinstance(tree.get("resolution"), float):
            wish = replace(wish, resolution=tree["resolution"])  # type: ignore[arg-type]
        for name in ("width", "height", "text", "line"):
            if isinstance(value := tree.get(name), float):
                wish = wish.with_form(**{name: value})
        if tree.get("theme") in tuple(THEMES):
            wish = wish.with_form(theme=tree["theme"])
        return wish.with_form(transparent=tree.get("transparent") is True)

    def with_form(self, **changes: object) -> "FigureWish":
        """With other sizes or looks, unless there is no such figure."""
        try:
            return replace(self, form=replace(self.form, **changes))  # type: ignore[arg-type]
        except ValueError:
            return self


class FigureDialog(Question):
    """A form, and below it the figure as it will be."""

    def __init__(
        self,
        parent: QWidget | None,
        wish: FigureWish,
        compose: Callable[[FigureWish], Figure],
        *,
        has_space: bool,
    ) -> None:
        """`compose` makes the figure that is wished for."""
        super().__init__(parent, "Export figure", "Export…")
        self._compose = compose
        self._make_fields(wish, has_space=has_space)
        self.preview = QLabel()
        self.preview.setFixedSize(PREVIEW)
        self.preview.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.preview.setAccessibleName("preview")
        self.size_of_figure = quiet()
        self.size_of_figure.setAccessibleName("size of the figure")
        self.form.addRow(self.preview)
        self.form.addRow(self.size_of_figure)
        self._soon = QTimer(self, interval=PAUSE, singleShot=True)
        self._soon.timeout.connect(self.show_preview)
        self._listen()
        self._kind_changed()
        self._soon.start(0)

    def _make_fields(self, wish: FigureWish, *, has_space: bool) -> None:
        self.part, self.kind, self.theme = QComboBox(), QComboBox(), QComboBox()
        for name, words in PARTS.items():
            if has_space or name != "space":
                self.part.addItem(words, name)
        for suffix in SUFFIXES:
            self.kind.addItem(KINDS[suffix], suffix)
        for name in THEMES:
            self.theme.addItem(name.capitalize(), name)
        form = wish.form
        for box, chosen in (
            (self.part, wish.part), (self.kind, wish.suffix), (self.theme, form.theme)
        ):  # fmt: skip
            box.setCurrentIndex(max(0, box.findData(chosen)))
        self.width_field = QLineEdit(f"{form.width:g}")
        self.height_field = QLineEdit("" if form.height is None else f"{form.height:g}")
        self.height_field.setPlaceholderText("as needed")
        self.text_field, self.line_field = QLineEdit(f"{form.text:g}"), QLineEdit(f"{form.line:g}")
        self.resolution = QLineEdit(f"{wish.resolution:g}")
        self.transparent = QCheckBox("Transparent background")
        self.transparent.setChecked(form.transparent)
        for words, row in (
            ("Figure of", self.part),
            ("File", self.kind),
            ("Width, mm", self.width_field),
            ("Height, mm", self.height_field),
            ("Words, pt", self.text_field),
            ("Curves, pt", self.line_field),
            ("Pixels per inch", self.resolution),
            ("Colors", self.theme),
            ("", self.transparent),
        ):
            self.form.addRow(words, row)

    def _listen(self) -> None:
        for box in (self.part, self.kind, self.theme):
            box.currentIndexChanged.connect(lambda _: self._changed())
        for number in self._numbers():
            number.textChanged.connect(lambda _: self._changed())
        self.transparent.toggled.connect(lambda _: self._changed())
        self.kind.currentIndexChanged.connect(lambda _: self._kind_changed())

    def _numbers(self) -> tuple[QLineEdit, ...]:
        fields = self.width_field, self.height_field, self.text_field, self.line_field
        return (*fields, self.resolution)

    def read(self) -> FigureWish:
        height = self.height_field.text().strip()
        form = FigureForm(
            calculated(self.width_field.text()),
            calculated(height) if height else None,
            calculated(self.text_field.text()),
            calculated(self.line_field.text()),
            str(self.theme.currentData()),
            self.transparent.isChecked(),
        )
        resolution = calculated(self.resolution.text())
        check_resolution(form.width, resolution)
        return FigureWish(
            str(self.part.currentData()), str(self.kind.currentData()), resolution, form
        )

    def show_preview(self) -> None:
        """Show the figure that is wished for now, or say why there is none."""
        try:
            figure = self._compose(self.read())
            self.preview.setPixmap(self._picture(figure))
        except (ValueError, OpenGLError, MemoryError) as error:
            self.preview.setPixmap(QPixmap())
            self.size_of_figure.setText(str(error))
            return
        width, height = figure.size
        self.size_of_figure.setText(f"{width:.4g} × {height:.4g} mm")

    def _picture(self, figure: Figure) -> QPixmap:
        """The figure as large as there is room for, whatever its size in print."""
        ratio = self.devicePixelRatioF()
        width, height = (side / 25.4 for side in figure.size)
        room = PREVIEW * ratio
        resolution = min(room.width() / width, room.height() / height)
        drawn = drawn_figure(figure, resolution, in_pixels=True)
        picture = QPixmap.fromImage(figure_image(figure, drawn.flat, resolution, drawn.shaded))
        picture.setDevicePixelRatio(ratio)
        return picture

    def _changed(self) -> None:
        self._soon.start()

    def _kind_changed(self) -> None:
        label = "Pixels per inch" if self.kind.currentData() == ".png" else "Shading, pixels/inch"
        self.form.labelForField(self.resolution).setText(label)  # type: ignore[attr-defined]
