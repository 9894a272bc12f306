"""`plusedit schema`: what a design file may hold, for other programs."""

import argparse
import sys

NAME = "schema"
HELP = "print the JSON Schema of design files"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none."""


def run(arguments: argparse.Namespace) -> int:
    from plusedit.io.schema import schema_text

    sys.stdout.write(schema_text())
    return 0
