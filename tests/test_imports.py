"""Everything below the views works in a process without Qt, and starts without what it can spare.

Each claim is tried in a process of its own, in which what must not be imported can't be.
"""

import subprocess
import sys

import pytest

BLOCK = """
import sys
for name in {blocked!r}:
    sys.modules[name] = None
"""
EVERY_MODULE = """
import importlib, pkgutil
for package in {packages!r}:
    found = importlib.import_module(f"plusedit.{{package}}")
    for module in pkgutil.walk_packages(found.__path__, f"{{found.__name__}}."):
        importlib.import_module(module.name)
"""
BELOW_THE_VIEWS = ("geometry", "document", "commands", "scene", "interaction", "tools", "io")
QT = ("PySide6", "shiboken6", "pyqtgraph", "OpenGL")


def python(program, *arguments):
    """Run a program; it must succeed."""
    done = subprocess.run(
        [sys.executable, "-W", "error", "-c", program, *arguments], capture_output=True, text=True
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def without(*names):
    return BLOCK.format(blocked=names)


def test_below_the_views_nobody_needs_qt():
    python(without(*QT) + EVERY_MODULE.format(packages=BELOW_THE_VIEWS))


def test_geometry_needs_numpy_alone():
    python(without(*QT, "scipy", "svgelements") + EVERY_MODULE.format(packages=["geometry"]))


def test_nobody_needs_scipy_to_run():
    packages = (*BELOW_THE_VIEWS, "cli")
    python(without("scipy", "hypothesis", "pytest") + EVERY_MODULE.format(packages=packages))


@pytest.mark.parametrize("words", [["--version"], ["--help"], ["sample", "--help"], ["schema"]])
def test_help_needs_neither_numpy_nor_qt(words):
    run = "from plusedit.__main__ import main; sys.exit(main(sys.argv[1:]))"
    python(without(*QT, "numpy", "svgelements") + run, *words)


def test_sampling_a_design_needs_neither_qt_nor_svg(document):
    run = "from plusedit.__main__ import main; sys.exit(main(sys.argv[1:]))"
    assert python(without(*QT, "svgelements") + run, "sample", str(document))
