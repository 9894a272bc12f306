"""`plusedit doctor`: what is there, what is missing, and the command that installs it."""

import argparse

NAME = "doctor"
HELP = "say what the program needs, what is missing and how to install it"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """It takes none."""


def run(arguments: argparse.Namespace) -> int:
    """0 if all is well, 1 if something is missing."""
    from plusedit import __version__
    from plusedit.checkup import findings

    print(f"PlusEdit {__version__}", flush=True)
    count = 0
    for finding in findings():
        mark = "  " if finding.remedy is None else "! "
        print(f"{mark}{finding.title:<12}{finding.text}", flush=True)
        if finding.remedy is not None:
            count += 1
            print(f"{'':<14}{finding.remedy}", flush=True)
    print("All is well." if not count else f"{count} to be seen to: the lines marked with !")
    return 1 if count else 0
