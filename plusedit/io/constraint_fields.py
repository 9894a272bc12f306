"""Constraints of a shape as a file says them.

    "constraints": [{"kind": "tangent_start"}, {"kind": "passing", "elements": [0, 4]}]

Entries that this program does not know are kept and written back.
"""

from collections.abc import Mapping

from plusedit.document.shape import Json, Tree
from plusedit.geometry.constraints import Constrained, Wish, constraints
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.io.fields import check_kept, expected

KEY = "constraints"
CORNERS = 4


def read_constraints(
    value: Json, geometry: Constrained | MeshSurface
) -> tuple[tuple[Wish, ...], Json]:
    """The constraints that a file gives a shape, and what there means nothing to this program.

    FormatError where a known constraint has numbers of what the shape does not have.
    """
    check_kept(value, KEY)
    if not isinstance(value, list):
        return (), value
    found: list[Wish] = []
    unknown: list[Json] = []
    for entry in value:
        kind = entry.get("kind") if isinstance(entry, Mapping) else None
        if isinstance(entry, Mapping) and isinstance(kind, str) and _is_known(kind, geometry):
            found.append(Wish(kind, _numbers(entry, kind, geometry)))
        else:
            unknown.append(entry)
    return tuple(found), unknown


def constraint_trees(wishes: tuple[Wish, ...], unknown: Json) -> Json:
    """What a file says of these, and what meant nothing; None where there is nothing to say."""
    trees: list[Json] = []
    for wish in wishes:
        counts = constraints[wish.kind].counts
        numbers: dict[str, Json] = {} if counts == "none" else {counts: list(wish.numbers)}
        trees.append({"kind": wish.kind, **numbers})
    if not isinstance(unknown, list):
        return trees or unknown
    return [*trees, *unknown] or None


def _is_known(kind: str, geometry: Constrained | MeshSurface) -> bool:
    return (
        kind in constraints
        and not isinstance(geometry, MeshSurface)
        and constraints[kind].takes(geometry)
    )


def _numbers(tree: Tree, kind: str, geometry: Constrained | MeshSurface) -> tuple[int, ...]:
    counts = constraints[kind].counts
    if counts == "none":
        return ()
    where = f"{KEY}: {kind}: {counts}"
    numbers = tree.get(counts)
    most = CORNERS if counts == "corners" else len(geometry.net)
    if not isinstance(numbers, list) or not numbers:
        raise expected(where, "a list of numbers", numbers)
    for number in numbers:
        if type(number) is not int or not 0 <= number < most:
            raise expected(where, f"whole numbers from 0 to {most - 1}", number)
    return tuple(number for number in numbers if isinstance(number, int))
