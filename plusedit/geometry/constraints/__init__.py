"""The shelf of constraints: each module here is something that a shape can keep while it is edited.

A constraint is solved in closed form by changing gradients, for these the shape is linear in, and
as little as does.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, Protocol, TypeAlias

from plusedit.geometry.arrays import Floats
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.surface import PlusSurface
from plusedit.registry import Registry

Constrained: TypeAlias = PlusCurve | PlusSurface

Element: TypeAlias = tuple[int, int]
"""A direction: k, 0 on curves and by u, 1 by v, and the number of its line or plane."""

Settled: TypeAlias = Mapping[Element, Floats]
"""For directions that are not free any more, the unit vectors (r, dim) along which their gradients
may still change: none, r = 0, where they are settled altogether."""

Numbers: TypeAlias = Literal["none", "elements", "corners"]
"""What the numbers of a constraint count: nothing, control lines and planes, or corners."""


@dataclass(frozen=True)
class Wish:
    """A constraint of one shape, as data: equal by value."""

    kind: str
    """the name on the shelf"""
    numbers: tuple[int, ...] = ()
    """rising; of control lines or planes, or of corners: u + 2 v with 0 or 1 for each"""

    def __post_init__(self) -> None:
        object.__setattr__(self, "numbers", tuple(sorted(set(self.numbers))))


class Constraint(Protocol):
    """Something that a shape can keep."""

    @property
    def title(self) -> str:
        """Such as "Tangent at the start"."""
        ...

    @property
    def order(self) -> int:
        """The lowest is solved first."""
        ...

    @property
    def counts(self) -> Numbers:
        """What its numbers are."""
        ...

    @property
    def conflict(self) -> str:
        """The sentence where other constraints leave no solution, with what would make one."""
        ...

    def takes(self, geometry: Constrained) -> bool:
        """Whether shapes of that kind can have it at all."""
        ...

    def objection(self, geometry: Constrained, numbers: tuple[int, ...]) -> str:
        """Why the shape can't keep it, and what would make that possible; empty where it can."""
        ...

    def miss(self, geometry: Constrained, numbers: tuple[int, ...]) -> float:
        """How far it is from being kept, relative to the size of what is compared."""
        ...

    def solved(
        self,
        geometry: Constrained,
        numbers: tuple[int, ...],
        settled: Settled,
        before: Constrained | None,
    ) -> Constrained:
        """The shape that keeps it, with the least change; what is settled stays.

        ValueError, in a sentence for people, where there is none.
        """
        ...

    def settles(self, geometry: Constrained, numbers: tuple[int, ...]) -> Settled:
        """The directions that it depends on, and what of them it leaves free."""
        ...

    def places(self, geometry: Constrained, numbers: tuple[int, ...]) -> Floats:
        """(k, dim) points of the shape where it is at work, for badges."""
        ...


constraints: Registry[Constraint] = Registry("plusedit.geometry.constraints")
register = constraints.register
