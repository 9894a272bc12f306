"""`plusedit sample`: points and derivatives as numbers, for scripts and tests."""

import argparse
import sys
from pathlib import Path

NAME = "sample"
HELP = "write points and derivatives of a design as numbers"

USUAL_COUNT, MOST = 101, 1_000_000


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("design", metavar="DESIGN", help="a design, or another file that opens")
    parser.add_argument(
        "--at",
        metavar="PARAMETERS.json",
        help='where, by shape: {"wing": {"u": [0, 0.5, 1]}, "sail": {"u": [0, 1], "v": [0.5]}, '
        '"knee": {"uv": [[0, 0.5]]}}; of a surface every pair; shapes not named are left out',
    )
    parser.add_argument(
        "--count",
        metavar="N",
        type=_count,
        default=USUAL_COUNT,
        help="without --at: how many evenly spaced parameters, on a surface each way "
        f"(default {USUAL_COUNT}); meshes are sampled at their vertices",
    )
    parser.add_argument(
        "--derivatives",
        metavar="0|1|2",
        type=int,
        choices=(0, 1, 2),
        default=2,
        help="the highest order of derivatives to write (default 2)",
    )
    parser.add_argument("-o", metavar="OUT.json", dest="out", help="instead of standard output")


def run(arguments: argparse.Namespace) -> int:
    """Everything is worked out before the first byte is written."""
    from plusedit.io.files import check_apart, load, read_file, shown_name, write_file
    from plusedit.io.json_text import encode, to_bytes
    from plusedit.io.samples import everywhere, places_in, samples

    design = load(arguments.design).design
    if arguments.at is None:
        places = everywhere(design, arguments.count)
    else:
        at = Path(arguments.at)
        places = places_in(read_file(at), shown_name(at), design)
    tree = samples(design, shown_name(Path(arguments.design)), places, arguments.derivatives)
    data = to_bytes(encode(tree) + "\n")
    if arguments.out is None:
        sys.stdout.buffer.write(data)
    else:
        check_apart(arguments.out, arguments.design, *([arguments.at] if arguments.at else []))
        write_file(data, arguments.out)
    return 0


def _count(word: str) -> int:
    try:
        count = int(word)
    except ValueError:
        count = 0
    if not 1 <= count <= MOST:
        raise argparse.ArgumentTypeError(f"expected a whole number from 1 to {MOST}, got {word!r}")
    return count
