"""How loops are compiled: one thread, no lock of Python. Imported on request only: loads numba."""

import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import cache
from hashlib import blake2b
from pathlib import Path
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
Flags = frozenset[str]

ANY_ORDER: Flags = frozenset({"contract", "reassoc", "arcp", "nsz"})
"""Sums may be taken in any order; but nothing may be assumed of zeros over zeros."""

HERE = Path(__file__).parent
SOURCES = (
    "compiling.py",
    "row_kernels.py",
    "mesh/compiling.py",
    "mesh/*_kernels.py",
    "mesh/lanes.py",
    "mesh/interpolation.py",
    "mesh/spreading.py",
)
"""The files that the loops, and the numbers in them, are in."""


def compiled(function: Kernel, fastmath: Flags = ANY_ORDER) -> Kernel:
    """The function as machine code, kept from one process to the next where that is possible."""
    options = _options(fastmath)
    try:
        with _kept_in_folder():
            kernel: Kernel = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # there is no folder that can be written to
        kernel = numba.njit(**options)(function)
    return kernel


def inlined(function: Kernel, fastmath: Flags = ANY_ORDER) -> Kernel:
    """The function as a part of those that call it."""
    kernel: Kernel = numba.njit(inline="always", **_options(fastmath))(function)
    return kernel


@contextmanager
def _kept_in_folder() -> Iterator[None]:
    """What is compiled meanwhile is kept in the folder of these very sources.

    Whether a function's own file has changed is looked at anyhow. But a function called may be in
    another, and would be kept as it was.
    """
    settings: Any = numba.config
    usual = settings.CACHE_DIR
    settings.CACHE_DIR = str(_folder(usual))
    try:
        yield
    finally:
        settings.CACHE_DIR = usual


@cache
def _folder(parent: str) -> Path:
    """The one for the sources as they are, in the parent or else beside them; others are gone."""
    digest = blake2b(digest_size=8)
    for path in sorted(path for pattern in SOURCES for path in HERE.glob(pattern)):
        digest.update(path.read_bytes())
    above = Path(parent or HERE / "__pycache__")
    found = above / f"plusedit-loops-{digest.hexdigest()}"
    if not found.exists():
        for old in above.glob("plusedit-loops-*"):
            shutil.rmtree(old, ignore_errors=True)
    return found


def _options(fastmath: Flags) -> dict[str, Any]:
    return {"nogil": True, "fastmath": set(fastmath), "error_model": "numpy"}
