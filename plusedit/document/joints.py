"""Curves that were one path in a drawing: which belong together, and where they touch.

A path read from SVG becomes one curve a segment, and every shape remembers its path. Where two
segments touch, their end lines are one joint to a person, who would not want to tear it by a drag.
"""

from plusedit.document.design import Design
from plusedit.document.selection import LineId
from plusedit.document.shape import Json, Shape, ShapeId
from plusedit.geometry.curve import PlusCurve


def path_of(shape: Shape) -> Json:
    """The name of the path that a shape is a part of, or None."""
    source = shape.extra.get("svg")
    return source.get("path") if isinstance(source, dict) else None


def whole_path(design: Design, shape_id: ShapeId) -> tuple[ShapeId, ...]:
    """The shapes of the same path, back to front; the shape alone if it has none."""
    path = path_of(design[shape_id])
    if path is None:
        return (shape_id,)
    return tuple(i for i, shape in design.shapes.items() if path_of(shape) == path)


def joined(design: Design, line: LineId) -> frozenset[LineId]:
    """`line` and the lines it is joined to: ends of its path, at the very same point.

    Only those that can be edited count. A control plane is joined to nothing.
    """
    found = {line}
    curve = design[line.shape].curve
    if curve is None or path_of(design[line.shape]) is None or line not in _ends(line.shape, curve):
        return frozenset(found)
    point = curve.lines.points[line.number]
    for shape_id in whole_path(design, line.shape):
        other = design[shape_id].curve
        if other is not None and design[shape_id].editable:
            points = other.lines.points
            found |= {
                end
                for end in _ends(shape_id, other)
                if points.shape[1] == len(point) and (points[end.number] == point).all()
            }
    return frozenset(found)


def _ends(shape_id: ShapeId, curve: PlusCurve) -> tuple[LineId, ...]:
    """The first and the last line of an open curve."""
    if curve.closed:
        return ()
    return LineId(shape_id, 0), LineId(shape_id, len(curve.lines) - 1)
