"""Values of a file's tree, taken only if they are what they should be.

Each function returns the value of the type it is named for, or raises FormatError that begins
with the `key`: what was expected, and what came.
"""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from math import isfinite

from plusedit.document.shape import Json, Tree
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown

DEEPEST = 64  # levels of what is kept without being understood
LARGEST_WHOLE = 2**53  # beyond, doubles skip whole numbers, and other programs with them

Object = Mapping[str, Json]


@contextmanager
def within(where: str) -> Iterator[None]:
    """What goes wrong inside is told with `where` in front, the geometry's complaints too."""
    try:
        yield
    except ValueError as error:
        raise FormatError(f"{where}: {error}") from None


def expected(key: str, what: str, value: object) -> FormatError:
    """The error that says so."""
    return FormatError(f"{key}: expected {what}, got {shown(value)}")


def required(tree: Object, key: str) -> Json:
    """The value of that key."""
    if key not in tree:
        raise FormatError(f"{key}: is missing")
    return tree[key]


def object_of(value: Json, key: str) -> Object:
    """An object, as a mapping."""
    if not isinstance(value, dict):
        raise expected(key, "an object", value)
    return value


def filled(value: Json, key: str) -> list[Json]:
    """A list that is not empty."""
    if not isinstance(value, list):
        raise expected(key, "a list", value)
    if not value:
        raise FormatError(f"{key}: is empty")
    return value


def counted(value: Json, key: str, count: int, others: str) -> list[Json]:
    """A list of as many entries as there are `others`."""
    entries = filled(value, key)
    if len(entries) != count:
        raise FormatError(f"{key}: has {of_number(len(entries), 'entry')} for {count} {others}")
    return entries


def of_number(count: int, noun: str) -> str:
    """Such as "1 number", "2 entries", "3 meshes"."""
    if count == 1:
        return f"1 {noun}"
    if noun.endswith("y"):
        return f"{count} {noun[:-1]}ies"
    return f"{count} {noun}{'es' if noun.endswith('sh') else 's'}"


def text(value: Json, key: str) -> str:
    """A string."""
    if not isinstance(value, str):
        raise expected(key, "a string", value)
    return value


def flag(value: Json, key: str) -> bool:
    """true or false."""
    if not isinstance(value, bool):
        raise expected(key, "true or false", value)
    return value


def is_number(value: object) -> bool:
    """Whether `value` is a finite number; true and false are none."""
    return type(value) is int or (type(value) is float and isfinite(value))


def number(value: Json, key: str) -> float:
    """A finite number."""
    if not is_number(value):
        raise expected(key, "a finite number", value)
    return float(value)  # type: ignore[arg-type]


def positive(value: Json, key: str) -> float:
    """A finite number above zero."""
    if not is_number(value) or value <= 0.0:  # type: ignore[operator]
        raise expected(key, "a positive number", value)
    return float(value)  # type: ignore[arg-type]


def whole(value: Json, key: str) -> int:
    """A whole number, written as one: 4.0 is not."""
    if type(value) is not int or abs(value) > LARGEST_WHOLE:
        raise expected(key, "a whole number", value)
    return value


def numbers(value: Json, key: str) -> list[float]:
    """A list of finite numbers, not empty."""
    entries = filled(value, key)
    if not all(map(is_number, entries)):
        place = next(i for i, entry in enumerate(entries) if not is_number(entry))
        raise expected(key, "finite numbers", entries[place])
    return [float(entry) for entry in entries]  # type: ignore[arg-type]


def rows(value: Json, key: str, widths: tuple[int, ...]) -> list[list[float]]:
    """Rows of finite numbers, all as long as the first, whose length is one of `widths`."""
    entries = filled(value, key)
    found = [row(entry, f"{key}: row {i}") for i, entry in enumerate(entries)]
    width = len(found[0])
    if width not in widths:
        wanted = " or ".join(map(str, widths))
        raise FormatError(f"{key}: row 0 has {of_number(width, 'number')}, expected {wanted}")
    for i, numbers_of_row in enumerate(found):
        if len(numbers_of_row) != width:
            count = of_number(len(numbers_of_row), "number")
            raise FormatError(f"{key}: row {i} has {count}, row 0 has {width}")
    return found


def row(value: Json, key: str) -> list[float]:
    """A list of finite numbers; `key` says which row it is."""
    if not isinstance(value, list):
        raise expected(key, "a list of numbers", value)
    if not all(map(is_number, value)):
        raise expected(key, "finite numbers", next(x for x in value if not is_number(x)))
    return [float(entry) for entry in value]  # type: ignore[arg-type]


def vector(value: Json, key: str, width: int) -> list[float]:
    """A row of `width` finite numbers; `key` says which one it is."""
    found = row(value, key)
    if len(found) != width:
        raise FormatError(f"{key} has {of_number(len(found), 'number')}, expected {width}")
    return found


def nested(tree: Tree, key: str) -> Tree:
    """The object under that key; an empty one where there is none."""
    value = tree.get(key)
    return value if isinstance(value, Mapping) else {}


def kept(tree: Object, known: frozenset[str]) -> Object:
    """What the tree has besides the `known` keys, to be written back as it came.

    FormatError if it can't be written again: numbers that are not finite, endless nesting.
    """
    unknown = {key: value for key, value in tree.items() if key not in known}
    for key, value in unknown.items():
        check_kept(value, shown(key)[1:-1])
    return unknown


def check_kept(value: Json, key: str) -> None:
    """FormatError if `value` holds a number that is not finite, or is nested too deeply."""
    waiting: list[tuple[Json, int]] = [(value, 1)]
    while waiting:
        entry, depth = waiting.pop()
        if depth > DEEPEST:
            raise FormatError(f"{key}: is nested more than {DEEPEST} levels deep")
        if isinstance(entry, dict):
            waiting += [(inner, depth + 1) for inner in entry.values()]
        elif isinstance(entry, list):
            waiting += [(inner, depth + 1) for inner in entry]
        elif isinstance(entry, float) and not isfinite(entry):
            raise expected(key, "finite numbers", entry)
