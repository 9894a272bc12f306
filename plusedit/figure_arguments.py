"""What `plusedit render` is told of figures for print, and what it makes of that."""

import argparse
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plusedit.document.design import Design
    from plusedit.scene.camera import Projection

SIZES = ("width_mm", "height_mm", "text_pt", "line_pt", "dpi")
ONE_ONLY = "a figure shows one smoothness; a PNG picture by --size shows several side by side"


def add_figure_arguments(parser: argparse.ArgumentParser) -> None:
    """What makes a picture a figure, and how large it is."""
    form = parser.add_argument_group(
        "figures", "a PDF, or a picture with a width in millimeters, fitted to what it shows"
    )
    for name, words in (
        ("width-mm", "width in millimeters (default 85)"),
        ("height-mm", "height in millimeters (default: what is needed)"),
        ("text-pt", "size of words in points (default 8)"),
        ("line-pt", "width of curves in points (default 1)"),
        ("dpi", "pixels to an inch, of PNG and of shaded surfaces (default 300)"),
    ):
        form.add_argument(f"--{name}", metavar="N", type=_number, help=words)


def is_figure(arguments: argparse.Namespace) -> bool:
    """Whether it is a figure that was asked for."""
    asked = any(getattr(arguments, name) is not None for name in SIZES)
    return asked or Path(arguments.out).suffix.lower() == ".pdf"


def figure_bytes(
    design: "Design", arguments: argparse.Namespace, *, in_space: bool, side: "Projection | None"
) -> bytes:
    """The file of the figure. FormatError where it can't be made."""
    from plusedit.io.formats import FormatError
    from plusedit.scene.figure import FigureForm
    from plusedit.scene.figure_composition import plane_figure, space_figure
    from plusedit.scene.figure_svg import svg_figure

    names = {"width": "width_mm", "height": "height_mm", "text": "text_pt", "line": "line_pt"}
    given = {key: getattr(arguments, name) for key, name in names.items()}
    sizes = {key: value for key, value in given.items() if value is not None}
    try:
        form = FigureForm(theme=arguments.theme, transparent=arguments.transparent, **sizes)
        if in_space:
            view = None if arguments.view == "design" else arguments.view
            figure = space_figure(design, form, view=view)
        else:
            figure = plane_figure(design, form, projection=side)
        out = Path(arguments.out)
        if out.suffix.lower() == ".svg" and figure.space is None:
            return svg_figure(figure, figure.flat)
        # Not before: figures in SVG files do without Qt.
        from plusedit.views.figure_files import USUAL_RESOLUTION, figure_file

        resolution = arguments.dpi or USUAL_RESOLUTION
        return figure_file(figure, out.suffix.lower(), resolution, out.stem)
    except ImportError as error:
        raise FormatError(
            f"figures need Qt, which can't be loaded ({error}); plusedit doctor says more"
        ) from error
    except ValueError as error:
        raise FormatError(str(error).rstrip(".")) from error


def _number(word: str) -> float:
    try:
        value = float(word)
    except ValueError:
        value = 0.0
    if not (isfinite(value) and value > 0.0):
        raise argparse.ArgumentTypeError(f"expected a number above 0, got {word!r}")
    return value
