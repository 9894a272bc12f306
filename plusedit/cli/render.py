"""`plusedit render`: a design as a picture, without a window."""

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plusedit.document.design import Design

NAME = "render"
HELP = "make a PNG or SVG picture of a design"

MOST = 20_000  # pixels to a side
MOST_PIXELS = 120_000_000  # half a gigabyte


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("design", metavar="DESIGN", help="a design, or another file that opens")
    parser.add_argument("out", metavar="OUT.png|.svg", help="the picture; its suffix says the kind")
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
    return 0


def _svg(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.scene.composition import composed
    from plusedit.scene.svg_picture import svg_of
    from plusedit.scene.theme import THEMES

    picture, theme = composed(design, arguments.size), THEMES[arguments.theme]
    return svg_of(picture, picture.camera, theme, transparent=arguments.transparent)


def _png(design: "Design", arguments: argparse.Namespace) -> bytes:
    from plusedit.io.formats import FormatError
    from plusedit.scene.theme import THEMES

    try:
        from plusedit.views.picture import png_of
    except ImportError as error:
        raise FormatError(
            f"PNG pictures need Qt, which can't be loaded ({error}); plusedit doctor says more"
        ) from error
    theme = THEMES[arguments.theme]
    return png_of(design, arguments.size, theme, transparent=arguments.transparent)


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
