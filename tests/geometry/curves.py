"""Curves of every family for the tests, random but the same in every run."""

import numpy as np

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines


def bases(size):
    """One basis of every kind for that many control lines."""
    order = min(4, size)
    kinds = {
        "bezier": Bernstein(size),
        "bspline": BSpline(size, order),
        "polygon": BSpline(size, 2),
        "high order": BSpline(size, min(7, size)),
        "closed": BSpline(size, 4, closed=True),
        "closed, odd order": BSpline(size, 3, closed=True),
        "rag": RationalGaussian.of_size(size),
        "closed rag": RationalGaussian(size, 0.6 / size, closed=True),
        "staircase": RationalGaussian(size, 0.01 / size),
        "uneven rag": RationalGaussian(size, tuple(np.linspace(0.2, 1.5, size) / size)),
    }
    if size >= 6:
        inner = (0.25, 0.5, 0.5, 0.5, 0.8, 0.8, 0.81)[: size - 4]
        kinds["kinks"] = BSpline(
            size, 4, knots=(0.0,) * 4 + inner + (1.0,) * 4 if size <= 11 else None
        )
    return kinds


KINDS = tuple(bases(8))


def random_curve(kind, *, size=8, seed=0, dimension=2, s=None, contrast=None):
    """A curve of that kind; with `contrast`, weights from 1 / contrast to contrast."""
    random = np.random.default_rng(seed)
    points = random.uniform(-1.0, 1.0, (size, dimension))
    directions = [
        None if random.random() < 0.5 else row for row in random.normal(size=points.shape)
    ]
    weights = None
    if contrast is not None:
        weights = contrast ** random.uniform(-1.0, 1.0, size)
    lines = ControlLines.of(points, directions, weights)
    return PlusCurve(bases(size)[kind], lines, random.uniform(-4.0, 4.0) if s is None else s)
