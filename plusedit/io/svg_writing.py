"""Designs as SVG drawings of true Bezier curves, seen from above.

Curves whose standard form has degree 3 at most come out exactly; others as cubics within 1e-7 of
their size. Curves that were read from one path are put together again as long as they stand one
after the other in the design and look alike, and filled as long as all of them are there.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from plusedit.document.design import Design
from plusedit.document.shape import Json, Shape, ShapeId, Tree
from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number
from plusedit.io.svg_cubics import chain_of
from plusedit.io.svg_frames import Frame, frame_in
from plusedit.io.svg_reading import BETWEEN
from plusedit.io.svg_styles import CURRENT
from plusedit.io.svg_text import Names, element, number, path_data

TOUCHES = 1e-9  # of the size: ends nearer to each other than that are one point
USUAL_WIDTH = 2.0  # pixels of a stroke whose style says nothing


def write_svg(design: Design) -> bytes:
    """The drawing of a design, UTF-8. Shapes without a curve are left out, and it says so."""
    drawn = [_Drawn(i, shape, chain) for i, shape, chain in _chains(design)]
    frame = frame_in(design.extra) or _frame_around(drawn)
    names = Names()
    lines = [_description(design), *(_path(run, frame, names) for run in _runs(drawn))]
    body = "".join(f"  {line}\n" for line in lines if line)
    attributes = {"xmlns": "http://www.w3.org/2000/svg", "version": "1.1"}
    for key, value in frame.tree().items():
        texts = map(number, value) if isinstance(value, list) else [str(value)]  # type: ignore[arg-type]
        attributes[key] = " ".join(texts)
    root = element("svg", attributes, f"\n{body}")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{root}\n'.encode()


def left_out(design: Design) -> tuple[str, ...]:
    """What of a design a drawing can't show, one sentence a kind."""
    kinds = [("surface", len(list(design.surfaces()))), ("mesh", len(list(design.meshes())))]
    counted = " and ".join(of_number(count, kind) for kind, count in kinds if count)
    space = sum(curve.dimension == 3 for _, curve in design.curves())
    sentences = []
    if counted:
        sentences.append(f"Left out: {counted}, as a drawing has curves alone.")
    if space:
        sentences.append(f"Seen from above: {space} of the curves, which lie in space.")
    return tuple(sentences)


@dataclass(frozen=True, eq=False)
class _Drawn:
    """A shape and its curve as Bezier pieces of the world."""

    shape_id: ShapeId
    shape: Shape
    chain: list[Floats]

    @property
    def source(self) -> Tree:
        """What the shape remembers of the path that it comes from."""
        tree = self.shape.extra.get("svg")
        return tree if isinstance(tree, Mapping) else {}

    @property
    def details(self) -> Tree:
        """What the shape remembers of how it was painted."""
        tree = self.shape.extra.get("style")
        return tree if isinstance(tree, Mapping) else {}

    @cached_property
    def size(self) -> float:
        """The larger side of the box about it."""
        points = np.concatenate(self.chain)
        return float(np.ptp(points, axis=0).max())

    @property
    def ends(self) -> tuple[Floats, Floats]:
        """Its first and last point."""
        return self.chain[0][0], self.chain[-1][-1]

    def follows(self, other: "_Drawn") -> bool:
        """Whether both come from one path, this right behind the other, and look alike."""
        mine, theirs = self.source, other.source
        number, before = mine.get("at"), theirs.get("at")
        return (
            isinstance(number, int)
            and isinstance(before, int)
            and number == before + 1
            and mine.get("path") == theirs.get("path") is not None
            and self.shape.style == other.shape.style
            and self.shape.visible == other.shape.visible
            and dict(self.details) == dict(other.details)
        )


def _chains(design: Design) -> Iterator[tuple[ShapeId, Shape, list[Floats]]]:
    for shape_id, shape in design.shapes.items():
        if shape.curve is not None:
            yield shape_id, shape, chain_of(shape.curve)


def _frame_around(drawn: list[_Drawn]) -> Frame:
    """A frame for what is drawn, hidden shapes among it."""
    if not drawn:
        return Frame.around(np.zeros(2), np.ones(2))
    points = np.concatenate([points for one in drawn for points in one.chain])
    return Frame.around(points.min(axis=0), points.max(axis=0))


def _runs(drawn: list[_Drawn]) -> Iterator[list[_Drawn]]:
    """Neighbors that belong to one path, together."""
    run: list[_Drawn] = []
    for one in drawn:
        if run and not one.follows(run[-1]):
            yield run
            run = []
        run.append(one)
    if run:
        yield run


def _description(design: Design) -> str:
    sentences = left_out(design)
    return element("desc", {}, text=" ".join(sentences)) if sentences else ""


def _path(run: list[_Drawn], frame: Frame, names: Names) -> str:
    """The <path> of shapes that belong together."""
    first = run[0]
    complete = len(run) == first.source.get("of", 1) and first.source.get("at", 0) == 0
    parts = _parts(run)
    whole = complete and all(_is_whole(part) for part in parts)
    label = first.shape.name
    identity: str = first.shape_id
    if len(run) > 1:
        identity = str(first.source["path"]) if complete else identity
        for between in BETWEEN.values():
            label = label.rpartition(between)[0] or label
    attributes = {"id": names.unused(identity)}
    attributes["d"] = " ".join(
        path_data([piece for one in part for piece in one.chain], closed=_is_closed(part))
        for part in parts
    )
    attributes |= _paint(first, frame, filled=whole)
    if not first.shape.visible:
        attributes["display"] = "none"
    title = element("title", {}, text=label) if label != attributes["id"] else ""
    return element("path", attributes, title)


def _parts(run: list[_Drawn]) -> list[list[_Drawn]]:
    """The run, cut where one curve does not begin at the end of the one before."""
    parts = [[run[0]]]
    for before, after in pairwise(run):
        same = before.source.get("part") == after.source.get("part")
        if same and _touch(before.ends[1], after.ends[0], max(before.size, after.size)):
            parts[-1].append(after)
        else:
            parts.append([after])
    return parts


def _touch(end: Floats, start: Floats, size: float) -> bool:
    return bool(np.abs(end - start).max() <= TOUCHES * size)


def _reaches_start(part: list[_Drawn]) -> bool:
    size = max(one.size for one in part)
    return _touch(part[-1].ends[1], part[0].ends[0], size)


def _is_closed(part: list[_Drawn]) -> bool:
    """Whether to end with Z."""
    curve = part[0].shape.curve
    if len(part) == 1 and curve is not None and curve.closed:
        return True
    return part[0].source.get("closed") is True and _reaches_start(part)


def _is_whole(part: list[_Drawn]) -> bool:
    """Whether a part is what it was when it was read, as far as its ends tell."""
    return part[0].source.get("closed") is not True or _is_closed(part)


def _paint(drawn: _Drawn, frame: Frame, *, filled: bool) -> dict[str, str]:
    """The attributes that say how a path looks."""
    style, details = drawn.shape.style, drawn.details
    fill = details.get("fill")
    paint = {"fill": fill if filled and isinstance(fill, str) else "none"}
    is_bare = style.color is None and details.get("stroke") == "none"
    if is_bare and (paint["fill"] != "none" or not drawn.shape.visible):
        return paint | _texts(details, ("fill-rule", "fill-opacity", "opacity"))
    width = USUAL_WIDTH if style.width is None else style.width
    own = width / frame.pixels
    paint["stroke"] = style.color or CURRENT
    paint["stroke-width"] = number(own)
    dashes = details.get("dashes")
    if isinstance(dashes, list):
        lengths = [dash * own for dash in dashes if isinstance(dash, int | float)]
        paint["stroke-dasharray"] = " ".join(map(number, lengths))
    return paint | _texts(details, KEPT)


KEPT = (
    "fill-rule",
    "fill-opacity",
    "stroke-opacity",
    "opacity",
    "stroke-linecap",
    "stroke-linejoin",
)


def _texts(details: Tree, names: Iterable[str]) -> dict[str, str]:
    return {name: _text(details[name]) for name in names if name in details}


def _text(value: Json) -> str:
    return number(value) if isinstance(value, int | float) else str(value)
