"""Files on disk: read without trusting what is there, written so that no half file ever is.

A file is written beside its place and moved there once it is whole and on the disk. Whatever
goes wrong, what was there before still is, and one sentence says why.
"""

import errno
import os
import secrets
import stat
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO, Protocol, TypeVar

from plusedit.document.design import Design
from plusedit.io.formats import Format, FormatError, Loaded, formats
from plusedit.io.json_text import LARGEST, shown

REASONS = {
    errno.ENOENT: "there is no such file",
    errno.ENOTDIR: "there is no such folder",
    errno.EISDIR: "is a folder",
    errno.EACCES: "permission denied",
    errno.EPERM: "permission denied",
    errno.EROFS: "permission denied: the disk can only be read",
    errno.ELOOP: "is a link that leads to itself",
    errno.ENAMETOOLONG: "the name is too long",
    errno.ENOSPC: "the disk is full",
    errno.EDQUOT: "your share of the disk is full",
    errno.EFBIG: "too large for the disk",
}
OPEN = os.O_RDONLY | getattr(os, "O_BINARY", 0) | getattr(os, "O_CLOEXEC", 0)
CREATE = os.O_WRONLY | os.O_CREAT | os.O_EXCL | (OPEN & ~os.O_RDONLY)
# Opening a pipe that nobody writes to would wait for ever.
OPEN_AT_ONCE = OPEN | getattr(os, "O_NONBLOCK", 0)


class HasSuffixes(Protocol):
    """A kind of file that is told by the end of its name."""

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Such as (".svg",)."""
        ...


Suffixed = TypeVar("Suffixed", bound=HasSuffixes)


def load(path: str | os.PathLike[str]) -> Loaded:
    """The design in a file, read as its suffix says. FormatError in one sentence."""
    place = Path(path)
    with _opened(place) as descriptor:
        file_format = format_of(place)
        data = _read(descriptor)
    return file_format.read(data, shown_name(place))


def save(design: Design, path: str | os.PathLike[str]) -> None:
    """Write a design as the suffix says, all of it or nothing. FormatError in one sentence."""
    place = Path(path)
    file_format = format_of(place)
    with _told(place):
        data = file_format.write(design)
    write_file(data, place)


def format_of(path: Path) -> Format:
    """The format whose suffix the name ends with. FormatError lists the suffixes there are."""
    return by_suffix(path, formats)


def by_suffix(path: Path, shelf: Mapping[str, Suffixed]) -> Suffixed:
    """The entry of a shelf whose suffix the name ends with. FormatError lists the suffixes."""
    name = path.name.lower()
    suffixes = {suffix: entry for entry in shelf.values() for suffix in entry.suffixes}
    for suffix in sorted(suffixes, key=len, reverse=True):
        if name.endswith(suffix):
            return suffixes[suffix]
    known = ", ".join(sorted(suffixes))
    found = f"suffix {shown(path.suffix)} is not known" if path.suffix else "has no suffix"
    raise FormatError(f"{shown_name(path)}: {found}; known are {known}")


def read_file(path: str | os.PathLike[str]) -> bytes:
    """What is in a plain file. FormatError in one sentence."""
    with _opened(Path(path)) as descriptor:
        return _read(descriptor)


def write_file(data: bytes, path: str | os.PathLike[str]) -> None:
    """Put `data` into a file, all of it or nothing, as `replacing` does."""
    with replacing(path) as file:
        file.write(data)


@contextmanager
def replacing(path: str | os.PathLike[str]) -> Iterator[BinaryIO]:
    """A stream that becomes the file once all is written; permissions and links stay as they are.

    FormatError in one sentence, for what goes wrong inside too; then nothing is changed and
    nothing left behind.
    """
    place = Path(path)
    with _told(place):
        target = _target(place)
        part = target.with_name(f".plusedit-{secrets.token_hex(8)}.part")
        try:
            with _part(part, like=target) as file:
                yield file
            part.replace(target)
        except BaseException:
            with suppress(OSError):
                part.unlink()
            raise
        _settle(target.parent)


def check_apart(path: str | os.PathLike[str], *sources: str | os.PathLike[str]) -> None:
    """FormatError if writing to `path` would replace one of the `sources`, which are there."""
    place = Path(path)
    with _told(place):
        if place.exists() and any(place.samefile(source) for source in sources):
            raise FormatError("is read from and can't be written to")


def shown_name(path: Path) -> str:
    """The name of a file as a sentence can quote it: on one line, fit for every terminal."""
    name = path.name or str(path)
    return name if name.isprintable() else shown(name)[1:-1]


@contextmanager
def _told(path: Path) -> Iterator[None]:
    """Errors of the system inside become a FormatError about `path`."""
    try:
        yield
    except FormatError as error:
        raise FormatError(f"{shown_name(path)}: {error}") from error
    except OSError as error:
        why = REASONS.get(error.errno or 0) or (error.strerror or str(error)).lower()
        raise FormatError(f"{shown_name(path)}: {why}") from error
    except ValueError as error:  # a name with a zero byte in it
        raise FormatError(f"{shown_name(path)}: no file can have that name") from error


@contextmanager
def _opened(path: Path) -> Iterator[int]:
    """A descriptor of a plain file that can be read without waiting."""
    with _told(path):
        if path.is_dir():
            raise FormatError("is a folder")
        descriptor = os.open(path, OPEN_AT_ONCE)
    try:
        with _told(path):
            found = os.fstat(descriptor)
            if not stat.S_ISREG(found.st_mode):
                raise FormatError("is no plain file, but a device or a pipe")
            if found.st_size > LARGEST:
                raise FormatError(f"is too large: more than {LARGEST // 2**20} MB are not read")
        yield descriptor
    finally:
        os.close(descriptor)


def _read(descriptor: int) -> bytes:
    # Room is made for as much as is asked for. One more than there is, and at last one more than
    # may be: the file can grow while it is read.
    with os.fdopen(os.dup(descriptor), "rb") as file:
        size = os.fstat(descriptor).st_size
        data = file.read(size + 1)
        return data + file.read(LARGEST - size) if len(data) > size else data


def _target(path: Path) -> Path:
    """Where the file itself is, or shall be: behind links. FormatError if it can't be replaced."""
    target = Path(os.path.realpath(path))
    if target.is_symlink():
        raise FormatError(REASONS[errno.ELOOP])
    if target.is_dir():
        raise FormatError(REASONS[errno.EISDIR])
    if not target.parent.is_dir():
        raise FormatError(f"there is no folder {shown(str(target.parent))}")
    if target.exists():
        if not target.is_file():
            raise FormatError("is no plain file, but a device or a pipe")
        if not os.access(target, os.W_OK):
            raise FormatError("permission denied: the file is write-protected")
    return target


@contextmanager
def _part(part: Path, *, like: Path) -> Iterator[BinaryIO]:
    """A new file, seen to the disk at the end, with owner and permissions as `like` has them."""
    with os.fdopen(os.open(part, CREATE, 0o666), "wb") as file:
        with suppress(FileNotFoundError):
            before = like.stat()
            with suppress(OSError, AttributeError):
                os.chown(part, before.st_uid, before.st_gid)
            part.chmod(stat.S_IMODE(before.st_mode))
        yield file
        file.flush()
        os.fsync(file.fileno())


def _settle(folder: Path) -> None:
    """See a renaming to the disk, where folders can be synced."""
    with suppress(OSError):
        descriptor = os.open(folder, OPEN)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
