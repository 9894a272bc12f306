"""What the paper on plus curves has not quite right: what is true, and a design that proves it."""

from collections.abc import Callable
from dataclasses import dataclass
from html import escape
from pathlib import Path

from plusedit.resources import assets

ANCHOR = "facts"
TITLE = "What the paper says, and what is true"


@dataclass(frozen=True)
class Fact:
    """A claim of the paper beside the truth."""

    claim: str
    truth: str
    design: str
    """the stem of a shipped file"""

    @property
    def path(self) -> Path:
        """The design that proves it."""
        return assets() / "examples" / f"{self.design}.json"


FACTS = (
    Fact(
        "The convex hull of a Bézier+ curve is the union of the hulls of the two Bézier curves "
        "that it is made of.",
        "It lies in the convex hull of the union of their control points, and may be outside of "
        "both hulls nearly everywhere.",
        "fact_hull_of_the_union",
    ),
    Fact(
        "A curve closes smoothly when its end control lines coincide and have opposite directions.",
        "Equal directions close it smoothly; opposite ones make a cusp. The same goes for B-spline+"
        " curves that repeat their first lines.",
        "fact_equal_ends_close_smoothly",
    ),
    Fact(
        "A Bézier+ surface is made of two Bézier surfaces and lies in the hull of their nets.",
        "It takes four, one for each corner of the parameters; two nets may be the same flat "
        "square while the surface is not flat.",
        "fact_four_nets_of_a_surface",
    ),
    Fact(
        "A Bézier+ curve may have one inflection more than the Bézier curve of its points.",
        "It may have two more, even where the control polygon is convex. A plane curve of degree d "
        "has up to 2 d − 4, and going from Bézier to Bézier+ raises d by one.",
        "fact_two_inflections_more",
    ),
)


def facts_page() -> str:
    """All of them as HTML, with a link to each design."""
    rows = "".join(
        f"<p><i>The paper:</i> {escape(fact.claim)}<br><b>{escape(fact.truth)}</b><br>"
        f'<a href="{fact.design}">Open the design that shows it</a></p>'
        for fact in FACTS
    )
    opening = (
        "<p>A. A. Goshtasby, <i>Plus Curves and Surfaces</i>, introduced what this program draws. "
        "Four of its remarks are not quite so; everything here does what is true.</p>"
    )
    return f'<h2><a name="{ANCHOR}"></a>{TITLE}</h2>{opening}{rows}'


def follow(link: str, open_file: Callable[[Path], object]) -> None:
    """Open the design that a link on the page names; no other links lead anywhere."""
    for fact in FACTS:
        if link == fact.design:
            open_file(fact.path)
