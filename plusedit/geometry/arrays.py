"""Arrays that can be shared: checked once, where data comes in, and read-only from then on."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

SAFE = 1e-200  # squares from here to 1 / SAFE have lost nothing to the limits of a double
ONE_THREAD = 8192  # numbers up to which BLAS starts no threads; waiting for them takes longer
LARGEST = 1e100  # squares and cubes of coordinates, as in curvature, still fit a double


def frozen(values: ArrayLike, *, shape: tuple[int | None, ...], name: str) -> Floats:
    """A read-only float64 copy of `values`.

    `shape` gives the required length of every axis, None where any length will do.
    Raises ValueError, naming `name`, what was expected and what came, on a mismatch, an entry
    that is not finite, or one beyond 1e100.
    """
    array = np.array(values, dtype=np.float64)
    if array.shape != shape and (
        array.ndim != len(shape)
        or any(want not in (None, have) for want, have in zip(shape, array.shape, strict=True))
    ):
        raise ValueError(f"{name}: expected shape {shape}, got {array.shape}")
    # Not a number is not less than anything: one comparison finds whatever may be wrong.
    if not _bound(array) <= LARGEST:
        _check_entries(array, name)
    array.flags.writeable = False
    return array


def _bound(array: Floats) -> float:
    """No entry is larger, as long as this is not too large itself."""
    if array.size <= ONE_THREAD:
        return float(np.vdot(array, array))
    return float(max(array.max(), -array.min()))


def _check_entries(array: Floats, name: str) -> None:
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: has a value that is not finite")
    if array.size and np.abs(array).max() > LARGEST:
        raise ValueError(f"{name}: has a value beyond {LARGEST:g}, which can't be calculated with")


def unit(vectors: Floats) -> Floats:
    """The vectors (..., dim) divided by their lengths; a zero vector stays zero."""
    squares = np.einsum("...d,...d->...", vectors, vectors)
    if squares.size and squares.min() >= SAFE and squares.max() <= 1.0 / SAFE:
        plain: Floats = vectors / np.sqrt(squares)[..., None]
        return plain
    largest = np.abs(vectors).max(axis=-1, keepdims=True)
    # Divided by the largest component first: the square of 1e-200 would be zero.
    scaled = np.divide(vectors, largest, out=np.zeros_like(vectors), where=largest > 0.0)
    length = np.linalg.norm(scaled, axis=-1, keepdims=True)
    directions: Floats = np.divide(scaled, length, out=np.zeros_like(scaled), where=length > 0.0)
    return directions
