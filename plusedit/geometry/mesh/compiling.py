"""How the loops over control planes of a mesh are compiled. Imported on request only: loads numba.

As in `row_kernels`, one thread, without Python's lock; here no number is ever undefined, and the
compiler may count on that: the least of a row is then found for many numbers at once.
"""

from collections.abc import Callable
from typing import Any, TypeVar

import numba

Kernel = TypeVar("Kernel", bound=Callable[..., Any])

OPTIONS: dict[str, Any] = {
    "nogil": True,
    "fastmath": {"contract", "reassoc", "arcp", "nsz", "nnan"},
    "error_model": "numpy",
}


def compiled(function: Kernel) -> Kernel:
    """The function as machine code, kept from one process to the next where that is possible."""
    try:
        kernel: Kernel = numba.njit(cache=True, **OPTIONS)(function)
    except RuntimeError:  # there is no folder that can be written to
        kernel = numba.njit(**OPTIONS)(function)
    return kernel


def inlined(function: Kernel) -> Kernel:
    """The function as a part of those that call it."""
    kernel: Kernel = numba.njit(inline="always", **OPTIONS)(function)
    return kernel
