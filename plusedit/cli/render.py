"""`plusedit render`: a design as a picture, without a window."""

import argparse
import sys
from collections.abc import Mapping
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plusedit.document.design import Design
    from plusedit.scene.camera import Projection

NAME = "render"
HELP = "make a PNG or SVG picture of a design"

MOST = 20_000  # pixels to a side
MOST_PIXELS = 120_000_000  # half a gigabyte
VIEWS = ("design", "2d", "top", "front", "right", "back", "left", "bottom", "iso")
PLANE: "Mapping[str, Projection]" = MappingProxyType(
    {"top": "top", "front": "front", "right": "right"}
)
"""Views that the plane view has, too: it draws designs that lie in a plane."""

LINES_ONLY = "surfaces are drawn as lines in SVG pictures; a PNG picture shows them shaded"
WITHOUT_OPENGL = (
    "pictures of designs in space need OpenGL 3.3, and {}; bash assets/run.sh installs it, "
    "--view 2d and SVG pictures do without"
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("design", metavar="DESIGN", help="a design, or another file that opens")
    parser.add_argument("out", metavar="OUT.png|.svg", help="the picture; its suffix says the kind")
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


def run(arguments: argparse.Namespace) -> int:
    """Nothing is written before the whole picture is there."""
    from plusedit.io.files import check_apart, load, shown_name, write_file
    from plusedit.io.formats import FormatError

    out = Path(arguments.out)
    kind = out.suffix.lower()
    if kind not in (".png", ".svg"):
        raise FormatError(f"{shown_name(out)}: a picture's name ends with .png or .svg")
    design = load(arguments.design).design
    check_apart(out, arguments.design)
    try:
        data = _svg(design, arguments) if kind == ".svg" else _png(design, arguments)
    except MemoryError as error:
        source = shown_name(Path(arguments.design))
        raise FormatError(f"{source}: its picture takes more memory than there is") from error
    write_file(data, out)
    if kind == ".svg" and any(True for _ in design.surfaces()):
        print(f"{shown_name(out)}: {LINES_ONLY}", file=sys.stderr)
    return 0


def _is_in_space(design: "Design", view: str) -> bool:
    """Whether the picture is one of the 3D view."""
    from plusedit.scene.options import panes_of

    if view == "design":
        return design.is_spatial and panes_of(design.view) != "2d"
    return view != "2d" and (design.is_spatial or view not in PLANE)


def _svg(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.scene.composition import composed
    from plusedit.scene.items import Mesh, Patch
    from plusedit.scene.space_composition import composed_in_space
    from plusedit.scene.svg_picture import svg_of
    from plusedit.scene.theme import THEMES

    theme, view = THEMES[arguments.theme], arguments.view
    if not _is_in_space(design, view):
        picture = composed(design, arguments.size, PLANE.get(view))
        return svg_of(picture, picture.camera, theme, transparent=arguments.transparent)
    drawing = composed_in_space(design, arguments.size, _named(view))
    flat = [item for item in drawing.layers if not isinstance(item, Patch | Mesh)]
    return svg_of(flat, drawing.camera, theme, transparent=arguments.transparent)


def _png(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError

    draw = _space_png if _is_in_space(design, arguments.view) else _plane_png
    try:
        return draw(design, arguments)
    except ImportError as error:
        raise FormatError(
            f"PNG pictures need Qt, which can't be loaded ({error}); plusedit doctor says more"
        ) from error


def _plane_png(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.scene.theme import THEMES
    from plusedit.views.picture import png_of

    return png_of(
        design,
        arguments.size,
        THEMES[arguments.theme],
        transparent=arguments.transparent,
        projection=PLANE.get(arguments.view),
    )


def _space_png(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError
    from plusedit.scene.theme import THEMES
    from plusedit.views.gl.functions import OpenGLError
    from plusedit.views.space_picture import space_png

    theme = THEMES[arguments.theme]
    try:
        return space_png(
            design, arguments.size, theme, arguments.transparent, _named(arguments.view)
        )
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
