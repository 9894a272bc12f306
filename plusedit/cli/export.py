"""`plusedit export`: a design as triangles and lines, for programs that know no plus shapes."""

import argparse
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plusedit.io.exporting import Tolerance

NAME = "export"
HELP = "write curves, surfaces and meshes as OBJ, PLY, STL or GLB"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("design", metavar="DESIGN", help="a design, or another file that opens")
    parser.add_argument(
        "out", metavar="OUT.obj|.ply|.stl|.glb", help="the file; its suffix says the kind"
    )
    parser.add_argument(
        "--shape",
        metavar="ID",
        action="append",
        dest="shapes",
        help="only the shape of that id; can be given several times (without: all but hidden ones)",
    )
    parser.add_argument(
        "--tolerance",
        metavar="T",
        type=_tolerance,
        help="how far faces may be from the surface: a length such as 0.01, or a share of the "
        "size such as 0.1%% (default 0.05%%)",
    )


def run(arguments: argparse.Namespace) -> int:
    """Says what it has written, and what it had to leave out."""
    from pathlib import Path

    from plusedit.io.exporting import USUAL, export_design, export_of
    from plusedit.io.files import check_apart, load, shown_name

    export_of(arguments.out)
    design = load(arguments.design).design
    check_apart(arguments.out, arguments.design)
    tolerance = arguments.tolerance or USUAL
    report = export_design(design, arguments.out, arguments.shapes, tolerance)
    print(f"{shown_name(Path(arguments.out))}: {report}")
    for sentence in report.left_out:
        print(sentence, file=sys.stderr)
    return 0


def _tolerance(words: str) -> "Tolerance":
    from plusedit.io.exporting import Tolerance

    try:
        return Tolerance.of(words)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None
