"""How loops are compiled: one thread, no lock of Python. Imported on request only: loads numba."""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])
Flags = frozenset[str]

ANY_ORDER: Flags = frozenset({"contract", "reassoc", "arcp", "nsz"})
"""Sums may be taken in any order; but nothing may be assumed of zeros over zeros."""


def compiled(function: Kernel, fastmath: Flags = ANY_ORDER) -> Kernel:
    """The function as machine code, kept from one process to the next where that is possible."""
    options = _options(fastmath)
    try:
        kernel: Kernel = numba.njit(cache=True, **options)(function)
    except RuntimeError:  # there is no folder that can be written to
        kernel = numba.njit(**options)(function)
    return kernel


def inlined(function: Kernel, fastmath: Flags = ANY_ORDER) -> Kernel:
    """The function as a part of those that call it."""
    kernel: Kernel = numba.njit(inline="always", **_options(fastmath))(function)
    return kernel


def _options(fastmath: Flags) -> dict[str, Any]:
    return {"nogil": True, "fastmath": set(fastmath), "error_model": "numpy"}
