"""`plusedit export`: a design as triangles and lines, for programs that know no plus shapes."""

import argparse
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from plusedit.io.export_pieces import Fineness
    from plusedit.io.exporting import Tolerance

NAME = "export"
HELP = "write curves, surfaces and meshes as OBJ, PLY, STL or GLB"

MOST_TIMES = 8
MOST_CELLS = 100_000  # along one side
EVEN = "even"


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
    add_fineness(parser, "as the tolerance asks")


def add_fineness(parser: argparse.ArgumentParser, usual: str) -> None:
    """What says how fine surfaces of meshes are written."""
    either = parser.add_mutually_exclusive_group()
    either.add_argument(
        "--subdivide",
        metavar="N",
        type=_times,
        help=f"how often every face of a mesh is split for the file, 0 to {MOST_TIMES} "
        f"(default: {usual})",
    )
    either.add_argument(
        "--grid",
        metavar="UxV",
        type=_cells,
        help="write surfaces of meshes whose parameters fill a rectangle, as those of terrains, "
        "cylinders and tori do, on an even grid of so many cells, such as 200x100; even: about as "
        "many as the mesh has faces",
    )


def fineness_of(arguments: argparse.Namespace) -> "Fineness":
    """What was said of it."""
    from plusedit.io.export_pieces import Fineness, even_cells

    times, cells = arguments.subdivide, arguments.grid
    if times is not None:
        return Fineness(times=lambda mesh: times)
    if cells is None:
        return Fineness()
    return Fineness(cells=even_cells if cells == EVEN else lambda surface, over: cells)


def run(arguments: argparse.Namespace) -> int:
    """Says what it has written, and what it had to leave out."""
    from pathlib import Path

    from plusedit.io.exporting import USUAL, export_design, export_of
    from plusedit.io.files import check_apart, load, shown_name

    export_of(arguments.out)
    design = load(arguments.design).design
    check_apart(arguments.out, arguments.design)
    tolerance = arguments.tolerance or USUAL
    fineness = fineness_of(arguments)
    report = export_design(design, arguments.out, arguments.shapes, tolerance, fineness=fineness)
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


def _times(word: str) -> int:
    if not (word.isascii() and word.isdecimal() and len(word) == 1 and int(word) <= MOST_TIMES):
        raise argparse.ArgumentTypeError(
            f"expected a whole number from 0 to {MOST_TIMES}, got {word!r}"
        )
    return int(word)


def _cells(word: str) -> tuple[int, int] | str:
    if word == EVEN:
        return EVEN
    numbers = word.split("x")
    are_whole = all(n.isascii() and n.isdecimal() and len(n) <= 6 for n in numbers)
    if len(numbers) == 2 and are_whole and all(2 <= int(n) <= MOST_CELLS for n in numbers):
        return int(numbers[0]), int(numbers[1])
    raise argparse.ArgumentTypeError(
        f"expected two numbers of cells from 2 to {MOST_CELLS}, such as 200x100, or {EVEN}, "
        f"got {word!r}"
    )
