"""The element tree of an SVG file, read with limits.

XML lets a short file stand for an endless one: entities that double twenty times over, elements
nested a million deep, references to other files. None of that is needed to draw, so nothing of it
is followed.
"""

from dataclasses import dataclass, field
from xml.parsers import expat

from plusedit.io.formats import FormatError

NAMESPACE = "http://www.w3.org/2000/svg"
XLINK = "http://www.w3.org/1999/xlink"
INKSCAPE = "http://www.inkscape.org/namespaces/inkscape"

DEEPEST = 200  # elements inside one another; drawings have up to some thirty
MOST_ELEMENTS = 500_000
LONGEST_ENTITY = 2000  # characters; real ones are addresses of namespaces
MOST_ENTITIES = 100


@dataclass(eq=False)
class Element:
    """One element: attributes and text as they stand, children in order."""

    tag: str
    """local name of an SVG element; "" for one of another language"""
    attributes: dict[str, str]
    """by local name; those of xlink and inkscape with "xlink:" and "inkscape:" in front"""
    children: "list[Element]" = field(default_factory=list)
    text: str = ""

    def get(self, name: str, default: str = "") -> str:
        """The attribute of that name without blanks around it, or `default`."""
        return self.attributes.get(name, default).strip()

    @property
    def title(self) -> str:
        """What a <title> inside says, "" if there is none."""
        for child in self.children:
            if child.tag == "title":
                return " ".join(child.text.split())
        return ""


def parse_tree(data: bytes) -> Element:
    """The outermost <svg> of a file. FormatError says what is wrong and in which line."""
    parser = expat.ParserCreate(namespace_separator=" ")
    builder = _Builder()
    parser.buffer_text = True
    parser.StartElementHandler = builder.start
    parser.EndElementHandler = builder.end
    parser.CharacterDataHandler = builder.characters
    parser.EntityDeclHandler = builder.entity
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        reason = expat.ErrorString(error.code)
        raise FormatError(f"is not whole XML: {reason} in line {error.lineno}") from error
    except (ValueError, LookupError) as error:  # an encoding that Python does not know
        raise FormatError(f"is not readable as XML: {error}") from error
    root = builder.root
    if root is None or root.tag != "svg":
        raise FormatError("is XML, but not an SVG drawing: the outermost element is not <svg>")
    return root


class _Builder:
    """Receives what expat finds; ends it with a FormatError where a limit is passed."""

    def __init__(self) -> None:
        self.root: Element | None = None
        self._open: list[Element] = []
        self._count = 0
        self._entities: set[str] = set()

    def start(self, name: str, attributes: dict[str, str]) -> None:
        self._count += 1
        if len(self._open) >= DEEPEST:
            raise FormatError(f"has elements nested deeper than {DEEPEST}")
        if self._count > MOST_ELEMENTS:
            raise FormatError(f"has more than {MOST_ELEMENTS:,} elements")
        element = Element(_local(name), {_attribute(k): v for k, v in attributes.items()})
        if self._open:
            self._open[-1].children.append(element)
        elif self.root is None:
            self.root = element
        self._open.append(element)

    def end(self, name: str) -> None:
        self._open.pop()

    def characters(self, text: str) -> None:
        element = self._open[-1]
        if element.tag in ("style", "title"):
            element.text += text

    def entity(
        self,
        name: str,
        is_parameter: bool,
        value: str | None,
        base: str | None,
        system: str | None,
        public: str | None,
        notation: str | None,
    ) -> None:
        """Allow short plain entities, as drawing programs write them for namespaces."""
        if value is None:
            return  # in another file: never opened, and an error only where it is used
        if "&" in value or "<" in value or len(value) > LONGEST_ENTITY:
            raise FormatError(f"declares the entity {name!r} in a way that is not followed here")
        self._entities.add(name)
        if len(self._entities) > MOST_ENTITIES:
            raise FormatError(f"declares more than {MOST_ENTITIES} entities")


def _local(name: str) -> str:
    space, _, local = name.rpartition(" ")
    # Without a namespace it is not quite SVG, but meant as such.
    return local if space in ("", NAMESPACE) else ""


def _attribute(name: str) -> str:
    space, _, local = name.rpartition(" ")
    if not space:
        return local
    prefix = {XLINK: "xlink", INKSCAPE: "inkscape"}.get(space, space)
    return f"{prefix}:{local}"
