"""A design to be looked at: surfaces of meshes as smooth as asked for, shapes for several s."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Literal, TypeAlias

from plusedit.commands.multiples import Magnitude, Multiply
from plusedit.document.design import Design
from plusedit.scene.camera import Camera
from plusedit.scene.options import options_of, view_tree

Level: TypeAlias = float | Literal["mesh"]
"""The smoothness S, or the mesh itself in place of its surface."""


def at_level(design: Design, level: Level) -> Design:
    """The design with all surfaces of meshes at that level."""
    if level == "mesh":
        options = replace(options_of(design.view), facets=True)
        return replace(design, view=view_tree(options, old=design.view))
    for shape_id, surface in design.meshes():
        shape = replace(design.shapes[shape_id], geometry=surface.with_smoothness(level))
        design = design.with_shape(shape_id, shape)
    return design


def in_multiples(
    design: Design,
    magnitudes: Iterable[Magnitude],
    camera: Camera,
    aspect: float,
) -> Design:
    """Copies of all visible shapes in place of them, one for each s, with its s for a name.

    In rows as the camera sees them, as many as suit a picture that is so many times as wide as it
    is high.
    """
    ids = tuple(i for i, shape in design.shapes.items() if shape.visible and not shape.locked)
    if not ids:
        return design
    across, up, _ = camera.axes_of_view
    made = Multiply(ids, tuple(magnitudes), aspect, across, -up, in_place=True).apply(design)
    return with_overlays(made, ["names"])


def with_overlays(design: Design, names: Iterable[str], without: Iterable[str] = ()) -> Design:
    """The design with these overlays switched on beside its own, and others switched off."""
    options = options_of(design.view)
    for name in without:
        options = options.with_overlay(name, False)
    for name in names:
        options = options.with_overlay(name, True)
    return replace(design, view=view_tree(options, old=design.view))
