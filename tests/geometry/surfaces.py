"""Surfaces of every family for the tests, random but the same in every run."""

import numpy as np
from hypothesis import strategies as st

from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from tests.geometry.curves import KINDS, bases

PAIRS = tuple(zip(KINDS, KINDS[3:] + KINDS[:3], strict=True))
"""Every kind once by u and once by v: a sheet, tubes both ways and tori are among them."""

CORNERS_MET = ("bezier", "bspline", "polygon", "high order", "kinks")
"""Kinds whose first and last functions are one at the ends."""


def basis(kind, size):
    """The basis of that kind, or the usual one where so few planes have none of the kind."""
    return bases(size).get(kind) or bases(size)["bspline"]


def random_surface(
    kind_u="bspline", kind_v="bezier", *, shape=(6, 5), seed=0, s=None, contrast=None, given=0.5
):
    """A surface of those kinds, wildly folded.

    With `contrast` it has weights from 1 / contrast to contrast; `given` is the share of the
    directions that are not automatic.
    """
    random = np.random.default_rng(seed)
    points = random.uniform(-1.0, 1.0, (*shape, 3))
    vectors = random.normal(size=(2, *shape, 3))
    automatic = random.random((2, *shape)) >= given
    weights = None if contrast is None else contrast ** random.uniform(-1.0, 1.0, shape)
    magnitude = random.uniform(-4.0, 4.0) if s is None else s
    planes = ControlPlanes(points, np.where(automatic[..., None], 0.0, vectors), automatic, weights)
    return PlusSurface(basis(kind_u, shape[0]), basis(kind_v, shape[1]), planes, magnitude)


def a_surface(rows=4, columns=5, s=0.5):
    """A gently waved sheet over [0, 3] x [0, 4], open and cubic, all directions automatic."""
    x, y = np.meshgrid(np.linspace(0.0, 3.0, rows), np.linspace(0.0, 4.0, columns), indexing="ij")
    points = np.stack([x, y, np.sin(1.3 * x) * np.cos(y)], axis=-1)
    order_u, order_v = min(4, rows), min(4, columns)
    return PlusSurface(
        BSpline(rows, order_u), BSpline(columns, order_v), ControlPlanes.of(points), s
    )


@st.composite
def surfaces(draw, kinds=KINDS, least=2, most=7):
    """Any surface: of any families, sheet, tube or torus, weighted or not, of few planes."""
    shape = draw(st.tuples(st.integers(least, most), st.integers(least, most)))
    return random_surface(
        draw(st.sampled_from(kinds)),
        draw(st.sampled_from(kinds)),
        shape=shape,
        seed=draw(st.integers(0, 2**16)),
        s=draw(st.sampled_from([0.0, 1.0, -0.7, 3.5])),
        contrast=draw(st.sampled_from([None, 3.0, 30.0])),
        given=draw(st.sampled_from([0.0, 0.5, 1.0])),
    )
