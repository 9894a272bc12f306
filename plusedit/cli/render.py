"""`plusedit render`: a design as a picture, without a window."""

import argparse
import sys
from collections.abc import Mapping, Sequence
from functools import partial
from math import isfinite
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from plusedit.figure_arguments import ONE_ONLY as ONE_FIGURE
from plusedit.figure_arguments import add_figure_arguments, figure_bytes, is_figure

if TYPE_CHECKING:
    from plusedit.commands.multiples import Magnitude
    from plusedit.document.design import Design
    from plusedit.scene.camera import Projection
    from plusedit.scene.levels import Level

NAME = "render"
HELP = "make a picture of a design: PNG or SVG, or a figure for print: PDF, SVG or PNG"

MOST = 20_000  # pixels to a side
MOST_PIXELS = 120_000_000  # half a gigabyte
VIEWS = ("design", "2d", "top", "front", "right", "back", "left", "bottom", "iso")
PLANE: "Mapping[str, Projection]" = MappingProxyType(
    {"top": "top", "front": "front", "right": "right"}
)
"""Views that the plane view has, too: it draws designs that lie in a plane."""

LINES_ONLY = "surfaces are drawn as lines in SVG pictures; a PNG picture shows them shaded"
ONE_ONLY = "SVG pictures show one smoothness; a PNG picture shows several side by side"
WITHOUT_OPENGL = (
    "pictures of designs in space need OpenGL 3.3, and {}; bash assets/run.sh installs it, "
    "--view 2d and SVG pictures do without"
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "design", metavar="DESIGN", help="a design, or another file that opens, such as a mesh"
    )
    parser.add_argument(
        "out", metavar="OUT.png|.svg|.pdf", help="the picture; its suffix says the kind"
    )
    parser.add_argument(
        "--view",
        metavar="NAME",
        choices=VIEWS,
        default="design",
        help=f"where to look from: {', '.join(VIEWS)}; by default from where the design says, and "
        "at designs in space in three dimensions",
    )
    parser.add_argument(
        "--size",
        metavar="WxH",
        type=_size,
        default=(1200, 800),
        help="width and height in pixels (default 1200x800)",
    )
    parser.add_argument("--transparent", action="store_true", help="leave out the ground")
    parser.add_argument(
        "--theme", choices=("light", "dark"), default="light", help="colors (default light)"
    )
    parser.add_argument(
        "--overlay",
        metavar="NAME",
        action="append",
        default=[],
        help="what else to show, such as comb; may be given more than once",
    )
    parser.add_argument(
        "--no-overlay",
        metavar="NAME",
        action="append",
        default=[],
        help="what not to show of what the design asks for; may be given more than once",
    )
    parser.add_argument(
        "--up",
        metavar="AXIS",
        choices=("y", "z"),
        help="what points up in the file of a mesh, y or z (default: as its kind has it)",
    )
    parser.add_argument(
        "--smoothness",
        metavar="S[,S...]",
        type=_levels,
        default=(),
        help="of surfaces of meshes; several stand side by side in a PNG picture, such as "
        "mesh,0.7,4, where mesh is the mesh itself",
    )
    add_figure_arguments(parser)

    parser.add_argument(
        "--multiples",
        metavar="S[,S...]",
        type=_magnitudes,
        default=(),
        help="copies side by side that differ in s, such as 0,0.5L,L,1.5L, where L is the length "
        "of the control polygon of each shape",
    )


def run(arguments: argparse.Namespace) -> int:
    """Nothing is written before the whole picture is there."""
    from plusedit.io.files import check_apart, shown_name, write_file
    from plusedit.io.formats import FormatError
    from plusedit.io.opening import opened_design

    out = Path(arguments.out)
    kind = out.suffix.lower()
    if kind not in (".png", ".svg", ".pdf"):
        raise FormatError(f"{shown_name(out)}: a picture's name ends with .png, .svg or .pdf")
    figured = is_figure(arguments)
    if (kind == ".svg" or figured) and len(arguments.smoothness) > 1:
        raise FormatError(f"{shown_name(out)}: {ONE_FIGURE if figured else ONE_ONLY}")
    _check_overlays([*arguments.overlay, *arguments.no_overlay])
    design = opened_design(arguments.design, arguments.up)
    check_apart(out, arguments.design)
    designs = _at_levels(design, arguments)
    try:
        if figured:
            data = _figure(designs[0], arguments)
        else:
            data = _svg(designs[0], arguments) if kind == ".svg" else _png(designs, arguments)
    except MemoryError as error:
        source = shown_name(Path(arguments.design))
        raise FormatError(f"{source}: its picture takes more memory than there is") from error
    write_file(data, out)
    if kind == ".svg" and not figured and any(True for _ in design.surfaces()):
        print(f"{shown_name(out)}: {LINES_ONLY}", file=sys.stderr)
    return 0


def _check_overlays(names: list[str]) -> None:
    from plusedit.io.formats import FormatError
    from plusedit.scene.overlays import overlays

    for name in names:
        if name not in overlays:
            raise FormatError(f"there is no overlay {name!r}; there are {', '.join(overlays)}")


def _at_levels(design: "Design", arguments: argparse.Namespace) -> "Sequence[Design]":
    """What stands side by side: the design with what is asked for shown, once for each level."""
    from plusedit.scene.levels import at_level, with_overlays

    shown = with_overlays(design, arguments.overlay, arguments.no_overlay)
    shown = _in_multiples(shown, arguments)
    return [at_level(shown, level) for level in arguments.smoothness] or [shown]


def _in_multiples(design: "Design", arguments: argparse.Namespace) -> "Design":
    """The design with copies for every s that is asked for."""
    from plusedit.scene.camera import PlaneCamera
    from plusedit.scene.levels import in_multiples
    from plusedit.scene.options import space_camera_of
    from plusedit.scene.space_camera import SpaceCamera

    if not arguments.multiples:
        return design
    width, height = size = arguments.size
    camera: PlaneCamera | SpaceCamera
    if _is_in_space(design, arguments.view):
        named = _named(arguments.view)
        kept = space_camera_of(design.view, size) if named is None else None
        camera = kept or SpaceCamera.standard(named or "iso", size)
    else:
        camera = PlaneCamera(size, projection=PLANE.get(arguments.view, "top"))
    return in_multiples(design, arguments.multiples, camera, width / height)


def _is_in_space(design: "Design", view: str) -> bool:
    """Whether the picture is one of the 3D view."""
    from plusedit.scene.options import panes_of

    if view == "design":
        return design.is_spatial and panes_of(design.view) != "2d"
    return view != "2d" and (design.is_spatial or view not in PLANE)


def _svg(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.scene.composition import composed
    from plusedit.scene.items import Legend, Mesh, Patch
    from plusedit.scene.space_composition import composed_in_space
    from plusedit.scene.svg_picture import svg_of
    from plusedit.scene.theme import THEMES

    theme, view = THEMES[arguments.theme], arguments.view
    if not _is_in_space(design, view):
        picture = composed(design, arguments.size, PLANE.get(view))
        return svg_of(picture, picture.camera, theme, transparent=arguments.transparent)
    drawing = composed_in_space(design, arguments.size, _named(view))
    # Without the surfaces there is nothing that a legend would speak of.
    flat = [item for item in drawing.layers if not isinstance(item, Patch | Mesh | Legend)]
    return svg_of(flat, drawing.camera, theme, transparent=arguments.transparent)


def _figure(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError

    in_space, side = _is_in_space(design, arguments.view), PLANE.get(arguments.view)
    if not in_space:
        return figure_bytes(design, arguments, in_space=in_space, side=side)
    from plusedit.views.gl.functions import OpenGLError

    try:
        return figure_bytes(design, arguments, in_space=in_space, side=side)
    except OpenGLError as error:
        raise FormatError(WITHOUT_OPENGL.format(error)) from error


def _png(designs: "Sequence[Design]", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError

    draw = _space_png if _is_in_space(designs[0], arguments.view) else _plane_png
    try:
        return draw(designs, arguments)
    except ImportError as error:
        raise FormatError(
            f"PNG pictures need Qt, which can't be loaded ({error}); plusedit doctor says more"
        ) from error


def _plane_png(designs: "Sequence[Design]", arguments: argparse.Namespace) -> bytes:
    from plusedit.scene.theme import THEMES
    from plusedit.views.picture import image_of
    from plusedit.views.side_by_side import row_png

    look = {"transparent": arguments.transparent, "projection": PLANE.get(arguments.view)}
    draw = partial(image_of, theme=THEMES[arguments.theme], **look)
    return row_png(designs, arguments.size, draw, in_space=False)


def _space_png(designs: "Sequence[Design]", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError
    from plusedit.scene.theme import THEMES
    from plusedit.views.gl.functions import OpenGLError
    from plusedit.views.side_by_side import row_png
    from plusedit.views.space_picture import space_image_of

    look = {"transparent": arguments.transparent, "view": _named(arguments.view)}
    draw = partial(space_image_of, theme=THEMES[arguments.theme], **look)
    try:
        return row_png(designs, arguments.size, draw, in_space=True)
    except OpenGLError as error:
        raise FormatError(WITHOUT_OPENGL.format(error)) from error


def _named(view: str) -> str | None:
    return None if view == "design" else view


def _size(word: str) -> tuple[int, int]:
    try:
        width, height = (int(part) for part in word.lower().split("x"))
    except ValueError:
        width = height = 0
    if not (1 <= width <= MOST and 1 <= height <= MOST and width * height <= MOST_PIXELS):
        raise argparse.ArgumentTypeError(
            f"expected WIDTHxHEIGHT such as 1200x800, up to {MOST} to a side and "
            f"{MOST_PIXELS // 1_000_000} million pixels, got {word!r}"
        )
    return width, height


def _levels(words: str) -> "tuple[Level, ...]":
    return tuple(_level(word.strip()) for word in words.split(","))


def _magnitudes(words: str) -> "tuple[Magnitude, ...]":
    from plusedit.commands.multiples import Magnitude

    try:
        return tuple(Magnitude.read(word.strip()) for word in words.removeprefix("s=").split(","))
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from error


def _level(word: str) -> "Level":
    if word == "mesh":
        return "mesh"
    try:
        smoothness = float(word)
    except ValueError:
        smoothness = 0.0
    if not (isfinite(smoothness) and smoothness > 0.0):
        raise argparse.ArgumentTypeError(f"expected numbers above 0 or mesh, got {word!r}")
    return smoothness
