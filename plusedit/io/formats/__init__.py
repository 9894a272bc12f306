"""The shelf of file formats."""

from dataclasses import dataclass
from typing import Protocol

from plusedit.document.design import Design
from plusedit.registry import Registry


class FormatError(ValueError):
    """A file that can't be read or written, in one sentence for the person who tried."""


@dataclass(frozen=True, eq=False)
class Loaded:
    """A design read from a file."""

    design: Design
    notes: tuple[str, ...] = ()
    """what was repaired, left out or changed in reading: one sentence a kind"""


class Format(Protocol):
    """One kind of file."""

    @property
    def title(self) -> str:
        """Such as "Scalable Vector Graphics"."""
        ...

    @property
    def suffixes(self) -> tuple[str, ...]:
        """Such as (".svg",); no other format has them."""
        ...

    @property
    def keeps_all(self) -> bool:
        """Whether everything of a design can be written, so that saving in it loses nothing."""
        ...

    def read(self, data: bytes, name: str) -> Loaded:
        """The design in a file of that name. FormatError says what is wrong and where."""
        ...

    def write(self, design: Design) -> bytes:
        """The file of a design. FormatError if the format can't hold it."""
        ...


formats: Registry[Format] = Registry("plusedit.io.formats")
register = formats.register
