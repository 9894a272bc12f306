"""Plus curves as a library: immutable values and pure functions on numpy arrays."""
