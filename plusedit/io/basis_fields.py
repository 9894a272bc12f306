"""A basis as a file says it: the family's name and the fields of its dataclass.

Read from the families themselves, so that a new family is a file format too. Every field but
`size`, which is the number of control lines, stands under its name, or under the "key" of its
metadata; its annotation says what is allowed there. A field whose default is None or False may
be missing. (Other defaults are for programmers: a file has to say its order.)
"""

from collections.abc import Callable
from dataclasses import MISSING, Field, dataclass, fields
from functools import cache
from types import NoneType
from typing import Any, cast, get_args, get_origin, get_type_hints

from plusedit.document.shape import Json, Tree
from plusedit.geometry.bases import Basis, families
from plusedit.io.fields import (
    Object,
    expected,
    flag,
    is_number,
    kept,
    number,
    numbers,
    object_of,
    required,
    text,
    whole,
    within,
)
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown


@dataclass(frozen=True)
class Said:
    """A field of a family as files have it."""

    name: str
    key: str
    optional: bool
    kinds: tuple[Any, ...]
    """the types that its annotation allows, without None"""


@cache
def said_of(family: type[Basis]) -> tuple[Said, ...]:
    """What a file says of a basis of that family, besides the family's name."""
    hints = get_type_hints(family)
    listed = fields(cast(Any, family))
    return tuple(_said(field, hints[field.name]) for field in listed if field.name != "size")


def read_basis(value: Json, key: str, size: int) -> tuple[Basis, Object]:
    """The basis of `size` functions that `value` says, and what else it holds."""
    tree = object_of(value, key)
    with within(key):
        name = text(required(tree, "family"), "family")
        if name not in families:
            known = ", ".join(map(shown, families))
            raise FormatError(f"family: expected one of {known}, got {shown(name)}")
        family = families[name]
        arguments: dict[str, Any] = {"size": size}
        for said in said_of(family):
            if said.key in tree or not said.optional:
                arguments[said.name] = _typed(required(tree, said.key), said)
        basis = family(**arguments)
        unknown = kept(tree, _known(family))
    return basis, unknown


def basis_tree(basis: Basis, extra: Tree) -> Tree:
    """What a file says of `basis`, and the unknown keys that were read with it.

    Those that mean something in its family are left out: they came with another family.
    """
    family = type(basis)
    tree: dict[str, Json] = {"family": family_name(basis)}
    for said in said_of(family):
        value = getattr(basis, said.name)
        if value is None or (said.optional and value is False):
            continue
        tree[said.key] = list(value) if isinstance(value, tuple) else value
    return {**tree, **{key: value for key, value in extra.items() if key not in _known(family)}}


def family_name(basis: Basis) -> str:
    """The name of its family on the shelf. KeyError if it is on none."""
    for name, family in families.items():
        if type(basis) is family:
            return name
    raise KeyError(f"{type(basis).__name__} is not on the shelf of families")


def _said(field: "Field[Any]", hint: Any) -> Said:
    kinds = (hint,) if isinstance(hint, type) or get_origin(hint) is tuple else get_args(hint)
    no_default = field.default is MISSING
    return Said(
        field.name,
        field.metadata.get("key", field.name),
        not no_default and (field.default is None or field.default is False),
        tuple(kind for kind in kinds if kind is not NoneType),
    )


def _known(family: type[Basis]) -> frozenset[str]:
    return frozenset({"family", *(said.key for said in said_of(family))})


def _typed(value: Json, said: Said) -> object:
    """`value` as the first of the allowed kinds that it is."""
    lists = [kind for kind in said.kinds if get_origin(kind) is tuple]
    if lists and (isinstance(value, list) or len(said.kinds) == 1):
        return tuple(numbers(value, said.key))
    single = [kind for kind in said.kinds if get_origin(kind) is not tuple]
    if lists and not is_number(value):
        raise expected(said.key, "a finite number or a list of them", value)
    return READERS[single[0]](value, said.key)


READERS: dict[type, Callable[[Json, str], object]] = {
    bool: flag,
    int: whole,
    float: number,
    str: text,
}
