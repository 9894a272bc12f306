"""Names and ids for shapes that are made of others."""

from plusedit.document.design import Design
from plusedit.document.shape import ShapeId


def stem_of(shape_id: ShapeId) -> str:
    """The id without a number at its end: "curve" of "curve-3"."""
    stem, dash, number = shape_id.rpartition("-")
    return stem if dash and stem and number.isdigit() else shape_id


def free_name(design: Design, name: str) -> str:
    """The name with the first number that makes it new: "Bow 2" where there is "Bow"."""
    names = {shape.name for shape in design.shapes.values()}
    if name not in names:
        return name
    stem, space, number = name.rpartition(" ")
    if not (space and stem and number.isdigit()):
        stem = name
    counter = 2
    while f"{stem} {counter}" in names:
        counter += 1
    return f"{stem} {counter}"
