"""What takes a question or two: a new design, importing, pictures, recovery."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QProcess
from PySide6.QtWidgets import QWidget

from plusedit.app.autosave import Autosave, Left, left_behind
from plusedit.app.background import Progress, in_background
from plusedit.app.clipboard import counted, fresh
from plusedit.app.files import Files
from plusedit.app.mesh_opening import read_again
from plusedit.commands.base import Together
from plusedit.commands.shapes import AddShapes
from plusedit.events import Event
from plusedit.io.formats import Loaded
from plusedit.scene.theme import THEMES
from plusedit.views.desk import Desk

if TYPE_CHECKING:
    from plusedit.app.export_dialogs import Picture, Reading
    from plusedit.app.mesh_export import MeshExport
    from plusedit.app.mesh_opening import MeshReading
    from plusedit.app.recovery import Choice
    from plusedit.io.mesh_import import ImportOptions

USUAL_PICTURE = (1600, 1200)  # pixels


class Flows:
    """The longer stories of the File menu."""

    def __init__(self, desk: Desk, files: Files, autosave: Autosave, parent: QWidget) -> None:
        self._desk, self._files, self._autosave = desk, files, autosave
        self._parent = parent
        self.ask_version: Callable[[Left], Choice] = self._ask_version
        """which version of a recovered design to go on with"""
        self.ask_options: Callable[[Path, ImportOptions], ImportOptions | None] = self._ask_options
        """how a mesh is to be read"""
        self.imported: Event[()] = Event()
        """emitted when shapes from a drawing, now selected, were added to the design"""

    def new(self) -> None:
        """An empty design, with the pen in hand."""
        if self._files.new():
            self._desk.gestures.choose("pen")

    def import_svg(self, path: Path | None = None) -> None:
        """Add the paths of an SVG drawing to the design, in one step."""
        from plusedit.app.export_dialogs import ReadingDialog

        self._desk.gestures.cancel()
        path = path or self._files.dialogs.import_path(self._files.folder)
        if path is None:
            return
        dialog = ReadingDialog(self._parent)
        if dialog.exec():
            self.add_drawing(path, dialog.read())

    def add_drawing(self, path: Path, reading: "Reading") -> None:
        """Add the curves of an SVG file, read in that way."""
        loaded = self._files.read(path, lambda: read_drawing(path, reading))
        if loaded is None:
            return
        import numpy as np

        session = self._desk.session
        shapes = fresh(session.committed, loaded.design.shapes.items(), np.zeros(2))
        if not self._desk.commit(AddShapes(shapes, name=f"Import {path.name}")):
            self._desk.say(f"Imported {counted(len(shapes))} from {path.name}.")
            self._files.notes.emit(path.name, loaded.notes)
            self.imported.emit()

    def import_mesh(self, path: Path | None = None) -> None:
        """Add the parts of a mesh or terrain to the design, in one step, read as is asked first."""
        from plusedit.app.mesh_options import options_of

        self._desk.gestures.cancel()
        path = path or self._files.dialogs.mesh_path(self._files.folder)
        if path is None:
            return
        options = self._asked(path, options_of(self._files.settings.mesh_options))
        found = None if options is None else self._files.read_mesh(path, options)
        if found is None:
            return
        import numpy as np

        shapes = fresh(self._desk.session.committed, found.imported.shapes, np.zeros(2))
        self._place(found, AddShapes(shapes, name=f"Import {path.name}"))

    def import_again(self, before: "MeshReading") -> None:
        """Read the file of a mesh in another way, and put its parts in place of those before."""
        self._desk.gestures.cancel()
        options = self._asked(before.path, before.options)
        found = None if options is None else self._files.read_mesh(before.path, options)
        if found is not None:
            self._place(found, read_again(self._desk.session.committed, before, found))

    def _asked(self, path: Path, options: "ImportOptions") -> "ImportOptions | None":
        """What the person chooses, which is remembered; None if nothing is to be read."""
        from plusedit.app.mesh_options import tree_of

        chosen = self.ask_options(path, options)
        if chosen is not None:
            self._files.settings.mesh_options = tree_of(chosen)
        return chosen

    def _ask_options(self, path: Path, options: "ImportOptions") -> "ImportOptions | None":
        from plusedit.app.mesh_options import MeshOptionsDialog

        dialog = MeshOptionsDialog(self._parent, options, path.name)
        return dialog.read() if dialog.exec() else None

    def _place(self, found: "MeshReading", edit: AddShapes | Together) -> None:
        """Put the parts of a mesh into the design, and tell of them."""
        found.draw_at_once()
        before = self._desk.session.committed
        if self._desk.commit(edit):
            return
        design = self._desk.session.committed
        ids = tuple(i for i in design if design[i] is not before.shapes.get(i))
        self._desk.say(f"Imported {counted(len(ids))} from {found.path.name}.")
        self._files.tell_of_mesh(found.placed(ids))
        self.imported.emit()

    def export_png(self) -> None:
        """Write a picture of the design."""
        from plusedit.app.export_dialogs import PictureDialog

        views = ("3d", "2d", "iso", "top", "front", "right") if self._has_space() else ("2d",)
        dialog = PictureDialog(self._parent, USUAL_PICTURE, self._desk.theme.name, views)
        if not dialog.exec():
            return
        picture = dialog.read()
        # Drawn here and not in the background: OpenGL wants the thread of the window.
        data = self._in_space(picture) if picture.view != "2d" else None
        if data is None and picture.view != "2d":
            return
        self._files.export_with(
            ".png", "Export picture", lambda path: self.write_picture(path, picture, data)
        )

    def _has_space(self) -> bool:
        from plusedit.views.opengl import opengl_problem

        return self._desk.session.committed.is_spatial and not opengl_problem()

    def _in_space(self, picture: "Picture") -> bytes | None:
        """The bytes of a picture by the 3D view; None where it can't be drawn, which is told."""
        from plusedit.views.gl.functions import OpenGLError
        from plusedit.views.space_picture import space_png

        try:
            return space_png(
                self._files.seen(),
                picture.size,
                THEMES[picture.theme],
                transparent=picture.transparent,
                view=None if picture.view == "3d" else picture.view,
            )
        except (OpenGLError, MemoryError) as error:
            self._files.dialogs.error(str(error))
            return None

    def export_mesh(self) -> None:
        """Write curves and surfaces as a mesh for other programs."""
        from plusedit.app.mesh_export import MeshDialog

        self._desk.gestures.cancel()
        session = self._desk.session
        ids = tuple(i for i in session.committed if i in session.selection.shapes)
        dialog = MeshDialog(self._parent, session.committed, ids)
        if dialog.exec():
            self.write_mesh(dialog.read())

    def write_mesh(self, kind: "MeshExport") -> None:
        """Ask for a name and write what is selected, or all that is visible."""
        from plusedit.io.exporting import Report, export_design
        from plusedit.io.exports import exports

        session, entry = self._desk.session, exports[kind.kind]
        design, progress = session.committed, Progress()
        ids = [i for i in design if i in session.selection.shapes] if kind.only_selected else None
        reports: list[Report] = []

        def write(path: Path) -> None:
            reports.append(
                export_design(
                    design, path, ids, kind.tolerance, fineness=kind.fineness, tell=progress.tell
                )
            )

        suffix = entry.suffixes[0]
        path = self._files.export_with(suffix, "Export mesh", write, entry.title, progress)
        if path is not None and reports:
            self._desk.say(f"Exported {path.name}: {reports[0]}.")
            self._files.notes.emit(path.name, reports[0].left_out)

    def write_picture(self, path: Path, picture: "Picture", data: bytes | None = None) -> None:
        """Write a picture that has been drawn, or draw the 2D view of the design into a file."""
        from plusedit.io.files import write_file
        from plusedit.views.picture import png_of

        if data is None:
            data = png_of(
                self._desk.session.committed,
                picture.size,
                THEMES[picture.theme],
                transparent=picture.transparent,
            )
        write_file(data, path)

    def recover(self, place: Path | None = None) -> bool:
        """Offer what crashed runs left; whether a design of theirs is in the window now."""
        found = in_background(
            self._parent,
            "Looking for unsaved designs …",
            lambda: left_behind(place),
            can_cancel=False,
        )
        opened = False
        for left in found:
            if opened:
                left.leave()
                continue
            opened = self._offer(left)
        if not found:
            self._desk.say("No design was left behind unsaved.")
        return opened

    def _ask_version(self, left: Left) -> "Choice":
        from plusedit.app.recovery import ask

        return ask(left, self._desk.theme, self._parent)

    def _offer(self, left: Left) -> bool:
        choice = self.ask_version(left)
        if choice == "later" or not self._files.may_discard():
            left.leave()
            return False
        if choice == "recovered":
            self._files.show(left.design, left.path, saved=False)
            # Kept under our own name before theirs goes: it is safe at every moment.
            self._autosave.keep()
            left.remove()
            return True
        left.remove()
        return left.path is not None and left.path.exists() and self._files.open(left.path)


def read_drawing(path: Path, reading: "Reading") -> Loaded:
    """The curves of an SVG file. FormatError or OSError as in `io.files`."""
    from plusedit.io.files import read_file
    from plusedit.io.svg_reading import read_svg

    return read_svg(read_file(path), path.name, reading.how, tolerance=reading.tolerance)


def open_elsewhere(path: Path) -> None:
    """Open a file in a window of its own, which is a program of its own."""
    QProcess.startDetached(sys.executable, ["-m", "plusedit", "open", str(path.absolute())])
