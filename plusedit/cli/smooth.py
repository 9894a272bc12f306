"""`plusedit smooth`: a polygon mesh or a terrain made into smooth surfaces, without a window."""

import argparse
import sys
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING

from plusedit.cli.export import add_fineness, fineness_of

if TYPE_CHECKING:
    from plusedit.document.design import Design
    from plusedit.io.exporting import Report
    from plusedit.io.mesh_import import Imported

NAME = "smooth"
HELP = "make a polygon mesh or a terrain into smooth surfaces"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("mesh", metavar="MESH", help="a mesh or a terrain")
    parser.add_argument(
        "out",
        metavar="OUT.obj|.ply|.stl|.glb|.json",
        help="the file; its suffix says the kind. A .json is a design, with the faces as control "
        "planes",
    )
    parser.add_argument(
        "--smoothness",
        metavar="S",
        type=_positive,
        default=0.7,
        help="how much detail is smoothed away, in sizes of faces (default 0.7)",
    )
    parser.add_argument(
        "--magnitude",
        metavar="s",
        type=_finite,
        default=1.0,
        help="how much of the faces' planes is used: 0 their middles alone (default 1)",
    )
    parser.add_argument(
        "--area-weights", action="store_true", help="let faces count by area over squared radius"
    )
    parser.add_argument(
        "--map",
        metavar="NAME",
        help="how parts get parameters, where that suits them (default: what suits best)",
    )
    parser.add_argument(
        "--up",
        metavar="AXIS",
        choices=("y", "z"),
        help="what points up in the file of a mesh, y or z (default: as its kind has it)",
    )
    parser.add_argument(
        "--as-it-is",
        action="store_true",
        help="don't split large and thin faces before",
    )
    add_fineness(parser, "coarse meshes so often that there are some thousand faces")


def run(arguments: argparse.Namespace) -> int:
    """Prints the report; nothing is written before all is worked out."""
    from plusedit.io.files import check_apart, shown_name
    from plusedit.io.mesh_import import ImportOptions, import_mesh

    _check_out(arguments)
    options = ImportOptions(
        smoothness=arguments.smoothness,
        s=arguments.magnitude,
        area_weights=arguments.area_weights,
        refine=not arguments.as_it_is,
        map_name=arguments.map,
        up=arguments.up,
        measure=True,
    )
    imported = import_mesh(arguments.mesh, options)
    check_apart(arguments.out, arguments.mesh)
    written = _write(imported, arguments)
    print(imported.report.text)
    print(f"{shown_name(Path(arguments.out))}: {written}")
    return 0


def _check_out(arguments: argparse.Namespace) -> None:
    """FormatError if no such file can be written."""
    from plusedit.io.exports import exports
    from plusedit.io.files import HasSuffixes, by_suffix, shown_name
    from plusedit.io.formats import FormatError
    from plusedit.io.formats.json_document import JsonDocument

    place = Path(arguments.out)
    shelf: dict[str, HasSuffixes] = {**exports, "json": JsonDocument()}
    is_design = isinstance(by_suffix(place, shelf), JsonDocument)
    for name in ("subdivide", "grid"):
        if is_design and getattr(arguments, name) is not None:
            raise FormatError(f"{shown_name(place)}: a design keeps faces as they are: no --{name}")


def _write(imported: "Imported", arguments: argparse.Namespace) -> str:
    """Write the file, and what there is to say of it."""
    from plusedit.io.files import save

    design = imported.design
    if arguments.out.lower().endswith(".json"):
        save(design, arguments.out)
        return f"a design of {imported.report.summary}"
    report = _export(design, arguments)
    for sentence in report.left_out:
        print(sentence, file=sys.stderr)
    return str(report)


def _export(design: "Design", arguments: argparse.Namespace) -> "Report":
    from plusedit.geometry.mesh.deviation import times_for
    from plusedit.io.export_pieces import Fineness
    from plusedit.io.exporting import export_design

    said = fineness_of(arguments)
    fineness = said if said.is_given else Fineness(times=times_for)
    return export_design(design, arguments.out, fineness=fineness)


def _number(word: str) -> float:
    try:
        return float(word)
    except ValueError:
        return float("nan")


def _positive(word: str) -> float:
    number = _number(word)
    if not (isfinite(number) and number > 0.0):
        raise argparse.ArgumentTypeError(f"expected a number above 0, got {word!r}")
    return number


def _finite(word: str) -> float:
    number = _number(word)
    if not isfinite(number):
        raise argparse.ArgumentTypeError(f"expected a number, got {word!r}")
    return number
