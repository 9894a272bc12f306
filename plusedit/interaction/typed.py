"""Numbers typed during a drag."""

from dataclasses import dataclass, replace

FIELDS = 2
"""dx and dy, in a view of a plane; a drag with one number looks at the first"""

LONGEST = 24  # characters of one number: more says nothing to a double


@dataclass(frozen=True)
class Typed:
    """What has been typed so far, field by field, and which field is next."""

    fields: tuple[str, ...] = ("",) * FIELDS
    at: int = 0

    def __bool__(self) -> bool:
        return any(self.fields)

    @property
    def values(self) -> tuple[float | None, ...]:
        """The numbers by field, None where there is none yet; empty if there is none at all."""
        values = tuple(_number(text) for text in self.fields)
        return values if any(value is not None for value in values) else ()

    def after(self, key: str) -> "Typed | None":
        """What stands there after a key: a digit, ".", "-", "Tab" or "Backspace"; else None."""
        text = self.fields[self.at]
        if key == "Tab":
            return replace(self, at=(self.at + 1) % len(self.fields))
        if key == "Backspace":
            return self._with(text[:-1])
        if key == "-":
            return self._with(text[1:] if text.startswith("-") else "-" + text)
        if key in (".", ","):
            return self._with(text if "." in text else text + ".")
        if len(key) == 1 and key in "0123456789":
            return self._with((text + key)[:LONGEST])
        return None

    def of_fields(self, count: int) -> "Typed":
        """With that many fields, the first ones as they are."""
        fields = (*self.fields, *[""] * count)[:count]
        return Typed(fields, min(self.at, count - 1))

    def _with(self, text: str) -> "Typed":
        fields = list(self.fields)
        fields[self.at] = text
        return replace(self, fields=tuple(fields))


NOTHING_TYPED = Typed()


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None  # "", "-" or "." on the way to a number
