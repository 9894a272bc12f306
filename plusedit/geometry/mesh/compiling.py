"""How the loops over control planes of a mesh are compiled. Imported on request only: loads numba.

Here no number is ever undefined, and the compiler may count on that: the least of a row is then
found for many numbers at once.
"""

from plusedit.geometry import compiling
from plusedit.geometry.compiling import ANY_ORDER, Kernel

DEFINED = ANY_ORDER | {"nnan"}


def compiled(function: Kernel) -> Kernel:
    """The function as machine code, kept from one process to the next where that is possible."""
    return compiling.compiled(function, DEFINED)


def inlined(function: Kernel) -> Kernel:
    """The function as a part of those that call it."""
    return compiling.inlined(function, DEFINED)
