"""Shapes brought back to what they are to keep, after anything else about them was edited.

Constraints are solved one after the other, in closed form and with the least change. What one has
settled the next leaves alone: tangency leaves the gradients at an end and beside it only the way
along the end line, and passing through points takes what is left.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.geometry.constraints import Constrained, Element, Wish, constraints

HOLDS = 1e-9  # relative: a miss below is rounding


@dataclass(frozen=True, eq=False)
class Keeping:
    """A shape that keeps its constraints, as far as it can."""

    geometry: Constrained
    problems: Mapping[Wish, str] = field(default_factory=dict)
    """why some can't be kept, a sentence each with what would make it possible"""


def kept(
    geometry: Constrained, wishes: tuple[Wish, ...], before: Constrained | None = None
) -> Keeping:
    """The shape with its constraints kept; the very same one where they hold already.

    `before` is the shape as it was before it was edited: what was moved there stays where it was
    put, and what has to follow follows.
    """
    settled: dict[Element, Floats] = {}
    problems: dict[Wish, str] = {}
    for wish in sorted(wishes, key=lambda wish: (constraints[wish.kind].order, wish.numbers)):
        constraint = constraints[wish.kind]
        try:
            if problem := constraint.objection(geometry, wish.numbers):
                problems[wish] = problem
                continue
            if not holds(geometry, wish):
                geometry = constraint.solved(geometry, wish.numbers, settled, before)
            for element, ways in constraint.settles(geometry, wish.numbers).items():
                # Of two constraints on one direction the stricter one counts.
                if element not in settled or len(ways) < len(settled[element]):
                    settled[element] = ways
        except ValueError as error:
            problems[wish] = str(error)
    for wish in wishes:
        if wish not in problems and not holds(geometry, wish):
            problems[wish] = constraints[wish.kind].conflict
    return Keeping(geometry, problems)


def holds(geometry: Constrained, wish: Wish) -> bool:
    """Whether a shape keeps a constraint, but for rounding. ValueError where it makes no sense."""
    miss = constraints[wish.kind].miss(geometry, wish.numbers)
    return bool(np.isfinite(miss) and miss <= HOLDS)
