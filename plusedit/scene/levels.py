"""A design with surfaces of meshes as smooth as asked for, to be looked at."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Literal, TypeAlias

from plusedit.document.design import Design
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


def with_overlays(design: Design, names: Iterable[str], without: Iterable[str] = ()) -> Design:
    """The design with these overlays switched on beside its own, and others switched off."""
    options = options_of(design.view)
    for name in without:
        options = options.with_overlay(name, False)
    for name in names:
        options = options.with_overlay(name, True)
    return replace(design, view=view_tree(options, old=design.view))
