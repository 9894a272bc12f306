"""Opening and saving: which file the design is in, and what is asked before anything is lost."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeVar

from PySide6.QtWidgets import QWidget

from plusedit.app.background import CancelledError, Progress, in_background
from plusedit.app.dialogs import DESIGN_SUFFIX, Dialogs
from plusedit.app.mesh_opening import MeshReading, is_mesh, opened, told
from plusedit.app.settings import Settings
from plusedit.document.design import Design
from plusedit.events import Event
from plusedit.io.formats import FormatError, Loaded
from plusedit.resources import is_shipped
from plusedit.views.desk import Desk

if TYPE_CHECKING:
    from plusedit.io.mesh_import import ImportOptions

UNTITLED = "Untitled"

T = TypeVar("T")


class DesignView(Protocol):
    """What a design keeps of the view, asked for when it is saved and given when it is opened."""

    def kept_with(self, design: Design) -> Design:
        """The design with the view as it is now."""
        ...

    def show_design(self, design: Design, *, whole: bool = False) -> None:
        """Set the view up as the design says, or as usual; `whole`: so that all of it is seen."""
        ...


class Files:
    """The file of the design in the window."""

    def __init__(self, desk: Desk, settings: Settings, parent: QWidget, view: DesignView) -> None:
        self.dialogs = Dialogs(parent)
        self.path: Path | None = None
        """where the design was read from or saved to; None: nowhere yet"""
        self.named: Event[()] = Event()
        """emitted when the path, or the list of recent files, changed"""
        self.shown: Event[()] = Event()
        """emitted when another design was put into the window"""
        self.notes: Event[str, tuple[str, ...]] = Event()
        """the name of a file, and what was repaired, left out or changed in reading it"""
        self.reported: Event[MeshReading] = Event()
        """a file of a mesh whose parts are in the design now"""
        self._desk, self.settings = desk, settings
        self._parent, self._view = parent, view

    @property
    def name(self) -> str:
        """What the title calls the design."""
        return UNTITLED if self.path is None else self.path.name

    def may_discard(self) -> bool:
        """Whether the design in the window may go: it is saved, is to be, or is not wanted."""
        self._desk.gestures.cancel()
        if self._desk.session.is_saved:
            return True
        answer = self.dialogs.unsaved(self.name)
        return answer == "discard" or (answer == "save" and self.save())

    def new(self) -> bool:
        """Start over with an empty design; false if the person would rather not."""
        if not self.may_discard():
            return False
        self.show(Design(), None)
        return True

    def open(self, path: Path | None = None) -> bool:
        """Open that file, or the one that the person names; false if none was opened."""
        path = path or self.dialogs.open_path(self.folder)
        if path is None:
            return False
        if is_mesh(path):
            return self._open_mesh(path)
        loaded = self._loaded(path)
        # Asked once the file is known to be readable: an error leaves everything as it is.
        if loaded is None or not self.may_discard():
            return False
        self.show(loaded.design, path)
        self._remember(path)
        self.notes.emit(path.name, (*about(loaded.design, path), *loaded.notes))
        return True

    def _open_mesh(self, path: Path) -> bool:
        found = self.read_mesh(path)
        if found is None:
            self._forget_if_gone(path)
            return False
        if not self.may_discard():
            return False
        found.draw_at_once()
        self.show(found.design, path)
        self._remember(path)
        self.tell_of_mesh(found.placed(tuple(found.design)))
        return True

    def read_mesh(self, path: Path, options: "ImportOptions | None" = None) -> MeshReading | None:
        """The shapes in the file of a mesh, without the window standing still; errors are told."""
        progress = Progress()
        return self.read(path, lambda: opened(path, progress.tell, options), progress)

    def tell_of_mesh(self, found: MeshReading) -> None:
        """Say what there is to say of a mesh whose parts are in the design now."""
        self.notes.emit(found.path.name, told(found.report))
        self.reported.emit(found)

    def show(self, design: Design, path: Path | None, *, saved: bool = True) -> None:
        """Put a design into the window."""
        self._desk.gestures.cancel()
        self.path = path
        self._desk.session.open(design, saved=saved)
        # Examples are made for a view of a usual shape, which this one may not have.
        self._view.show_design(design, whole=path is not None and is_shipped(path))
        self.named.emit()
        self.shown.emit()

    def save(self) -> bool:
        """Save where it was saved before, asking for a name if need be; whether it was saved.

        A shipped example stays as it is: the design that was made of it gets a name of its own.
        """
        if self.path is None or is_shipped(self.path) or not keeps_all(self.path):
            return self.save_as()
        return self._write(self.path)

    def save_as(self) -> bool:
        """Save under another name; whether it was saved."""
        self._desk.gestures.cancel()
        path = self.dialogs.save_path(self._suggested(DESIGN_SUFFIX))
        if path is None:
            return False
        if not keeps_all(path) and not is_mesh(path):
            if self.dialogs.wants_export(path):
                self.export(path)
            return False
        return self._write(path)

    def export(self, path: Path) -> bool:
        """Write a copy in the format that the suffix of `path` stands for."""
        from plusedit.io.files import save

        design = self._desk.session.committed
        return self._tried(lambda: save(design, path), path)

    def export_svg(self) -> None:
        """Ask for a name and write an SVG drawing."""
        self._desk.gestures.cancel()
        suggested = self._suggested(".svg")
        path = self.dialogs.export_path(suggested, "Export SVG", "SVG drawing (*.svg)")
        if path is not None and self.export(path):
            self._desk.say(f"Exported {path.name}.")

    def export_with(
        self,
        suffix: str,
        title: str,
        write: Callable[[Path], object],
        kind: str = "",
        progress: Progress | None = None,
    ) -> Path | None:
        """Ask for a name with that suffix and let `write` make the file; where it is now.

        With `progress`, which `write` tells, the person may give up.
        """
        self._desk.gestures.cancel()
        pattern = f"{kind or f'{suffix[1:].upper()} picture'} (*{suffix})"
        path = self.dialogs.export_path(self._suggested(suffix), title, pattern)
        if path is None or not self._tried(lambda: write(path), path, progress):
            return None
        self._desk.say(f"Exported {path.name}.")
        return path

    def seen(self) -> Design:
        """The design with the view as it is now."""
        return self._view.kept_with(self._desk.session.committed)

    def read(self, path: Path, read: Callable[[], T], progress: Progress | None = None) -> T | None:
        """What `read` gives, without the window standing still; errors are told."""
        try:
            text = f"Reading {path.name} …"
            return in_background(self._parent, text, read, progress=progress)
        except CancelledError:
            self._desk.say(f"Reading {path.name} was cancelled.")
        except (FormatError, OSError) as error:
            self.dialogs.error(said(error, path))
        return None

    def _loaded(self, path: Path) -> Loaded | None:
        from plusedit.io.files import load

        loaded = self.read(path, lambda: load(path))
        if loaded is None:
            self._forget_if_gone(path)
        return loaded

    def _write(self, path: Path) -> bool:
        from plusedit.io.files import save

        self._desk.gestures.cancel()
        committed = self._desk.session.committed
        design = self._view.kept_with(committed)
        if not self._tried(lambda: save(design, path), path):
            return False
        self.path = path
        if self._desk.session.committed is committed:
            self._desk.session.mark_saved()
        self._remember(path)
        self._desk.say(f"Saved {path.name}.")
        return True

    def _tried(
        self, act: Callable[[], object], path: Path, progress: Progress | None = None
    ) -> bool:
        text, can_cancel = f"Writing {path.name} …", progress is not None
        try:
            in_background(self._parent, text, act, can_cancel=can_cancel, progress=progress)
        except CancelledError:
            self._desk.say(f"Writing {path.name} was cancelled.")
            return False
        except (FormatError, OSError) as error:
            self.dialogs.error(said(error, path))
            return False
        return True

    def _remember(self, path: Path) -> None:
        if not is_shipped(path):
            self.settings.remember_file(path)
        self.named.emit()

    def _forget_if_gone(self, path: Path) -> None:
        if not path.exists():
            gone = path.absolute()
            self.settings.recent = [other for other in self.settings.recent if other != gone]
            self.named.emit()

    @property
    def folder(self) -> Path:
        """Where files are looked for first."""
        if self.path is not None and not is_shipped(self.path):
            return self.path.parent
        recent = [path.parent for path in self.settings.recent if path.parent.is_dir()]
        return recent[0] if recent else Path.home()

    def _suggested(self, suffix: str) -> Path:
        path = self.folder / f"{stem_of(self.name)}{suffix}"
        # What a mesh was read from is not what its surface is meant to be written over.
        return path.with_stem(f"{path.stem} smooth") if path == self.path else path


def about(design: Design, path: Path) -> tuple[str, ...]:
    """What a shipped design shows, where it says so."""
    words = design.extra.get("about")
    return (words,) if is_shipped(path) and isinstance(words, str) else ()


def keeps_all(path: Path) -> bool:
    """Whether a design loses nothing in a file of that name."""
    from plusedit.io.files import format_of

    if is_mesh(path):
        return False
    try:
        return format_of(path).keeps_all
    except FormatError:
        return True  # no format at all: saving says so


def stem_of(name: str) -> str:
    """The name of a file without the suffix of a design, drawing or picture."""
    for suffix in (DESIGN_SUFFIX, ".json", ".svg", ".png"):
        if name.lower().endswith(suffix):
            return name[: -len(suffix)]
    return Path(name).stem if is_mesh(Path(name)) else name


def said(error: Exception, path: Path) -> str:
    """An error as a sentence with the name of the file."""
    if isinstance(error, OSError):
        return f"{path.name}: {error.strerror or error}."
    text = str(error)
    return text if text.endswith(".") else f"{text}."
