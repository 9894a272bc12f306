"""Which four vertices of a closed sheet make the best corners of a pillow, before it is laid out.

A layout on any pillow knows how the sheet lies on a sphere when angles are kept: with parameters z
in a plane of periods 1 and tau,

    x(z) = sum_n 1 / sin(pi (z + n tau))^2

takes it there two to one, Weierstrass' function but for constants (DLMF, 23.8). Every four points
of that sphere are the corners of a pillow; with their cross-ratio r its periods are 1 and

    tau = i M(1, sqrt(1 - r)) / M(1, sqrt(r)),    M the arithmetic-geometric mean,

and areas grow from the sphere to it by c / prod_k |x - a_k|, a_k the corners (the metric of the
quadratic differential dx^2 / prod_k (x - a_k)). So thousands of choices are compared with few
calculations, and one more layout is made. A choice is good where

    the deviation of the logarithm of what areas grow by
        is small: faces that are small in the map next to large ones leave a surface little hold,
        and limbs without a corner at their tips come to nothing,
    the periods are nearly at a right angle
        for a pillow is a rectangle, and has all angles changed where they are not.

Points of the sphere are x = p / q as pairs (p, q) of length one, differences determinants of pairs.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.flattening.distortion import angle_ratios, doubled_areas, turned_over
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet

Complexes = NDArray[np.complex128]

IMAGES = 4  # of a pole on both sides; the next is less than 1e-9 of the sum
HALVINGS = 10  # of the mean's logarithm, then its digits are doubled: enough for all numbers
STEPS = 60  # of reduction
DIGITS = 6  # of costs: what differs less is the same, whatever the rounding
SAMPLES = 600  # triangles that stand for all, each for the same area
CANDIDATES = 160  # vertices, besides the corners there are
STARTS = 6
SWEEPS = 8  # over the four corners, each time for the best candidate
SKEW = 2.0  # what a stretch of e counts, in deviations of the logarithm
SMALLEST = 1e-30  # of areas in a plane with the period one: less is rounding
NEAREST = 1e-14  # of the sphere: closer points are not told apart


class Conformal(NamedTuple):
    """A sheet as it lies on the sphere."""

    candidates: Indices
    """(k,) vertices that may be corners; the first four are those of the layout"""
    pairs: Complexes
    """(k, 2) of these"""
    covariance: Floats
    """(k + 1, k + 1) over the sheet's area, of the logarithms of the distances to each of these,
    and last of what areas grow by from space to the sphere's pairs"""


def conformal(sheet: Sheet, places: Floats, tau: complex, corners: list[int]) -> Conformal:
    """What a layout with these four corners tells, its parameters (t, 3, 2) of periods one.

    It keeps angles where the second period lies at tau, if the first is one.
    """
    some = _samples(sheet)
    z = places[..., 0] + tau * places[..., 1]
    candidates, seen = _candidates(sheet, corners)
    pairs = _on_sphere(z.reshape(-1)[seen], tau)
    around = z[some]
    areas = np.abs(((around[:, 1] - around[:, 0]).conj() * (around[:, 2] - around[:, 0])).imag)
    samples = _on_sphere(around.mean(axis=1), tau)
    before = np.maximum(sheet.doubled_areas[some], np.finfo(np.float64).tiny)
    growth = np.log(np.maximum(areas, SMALLEST)) - np.log(before)
    growth += _logarithms(samples, pairs[:4]).sum(axis=1)
    logarithms = np.column_stack([_logarithms(samples, pairs), growth])
    return Conformal(candidates, pairs, np.cov(logarithms, rowvar=False, ddof=0))


def best_corners(known: Conformal) -> tuple[list[int], float, float]:
    """Four candidates, their cost, and the cost of the corners there are."""
    random = np.random.default_rng(0)
    count = len(known.candidates)
    starts = [np.arange(4), *(random.choice(count, 4, replace=False) for _ in range(STARTS))]
    found = [_descended(known, start) for start in starts]
    best, cost = found[int(np.argmin(np.round([cost for _, cost in found], DIGITS)))]
    return known.candidates[best].tolist(), cost, _cost(known, starts[0])


def measured_cost(sheet: Sheet, places: Floats) -> float:
    """The same of a layout with parameters (own, 3, 2), of which it is the stretch in the middle
    and at the worst twentieth; infinite where triangles are turned over."""
    if turned_over(places).any():
        return np.inf
    some = _samples(sheet)
    around, inside = sheet.points[sheet.triangles[some]], places[some]
    ratios, doubled, usable = angle_ratios(around, inside)
    areas = doubled_areas(inside)
    usable &= areas > 0.0
    if not usable.any():
        return np.inf
    growth = np.log(areas[usable] / doubled[usable])
    middle, worst = np.percentile(ratios[usable], (50.0, 95.0), method="nearest")
    return float(growth.std() + 0.5 * SKEW * np.log(middle * worst))


def _samples(sheet: Sheet) -> Indices:
    """(m,) triangles of the mesh, evenly by area."""
    total = np.cumsum(sheet.doubled_areas[: sheet.own])
    steps = (np.arange(SAMPLES) + 0.5) / SAMPLES * total[-1]
    found: Indices = np.minimum(np.searchsorted(total, steps), sheet.own - 1)
    return found


def _candidates(sheet: Sheet, first: list[int]) -> tuple[Indices, Indices]:
    """(k,) vertices, those that are given first, and a corner (k,) of the sheet at each."""
    some = np.random.default_rng(0).integers(0, 3 * sheet.own, CANDIDATES)
    vertices = np.array(list(dict.fromkeys([*first, *sheet.tails[some].tolist()])))
    corner_of = np.zeros(len(sheet.points), dtype=np.intp)
    corner_of[sheet.tails] = np.arange(len(sheet.tails))
    return vertices, corner_of[vertices]


def _on_sphere(z: Complexes, tau: complex) -> Complexes:
    """(k, 2) pairs of length one for x(z)."""
    z = z - tau * np.round(z.imag / tau.imag)
    w = np.where(z.imag < 0.0, -z, z)
    # 1 / sin(pi w)^2 = -4 e / (1 - e)^2 with e = exp(2 pi i w), which only gets small above.
    e = np.exp(2j * np.pi * w)
    others = np.zeros_like(e)
    for n in range(1, IMAGES + 1):
        for far in (np.exp(2j * np.pi * (n * tau + w)), np.exp(2j * np.pi * (n * tau - w))):
            others += -4.0 * far / (1.0 - far) ** 2
    below = (1.0 - e) ** 2
    pairs = np.stack([-4.0 * e + below * others, below], axis=-1)
    lengths: Complexes = pairs / np.linalg.norm(pairs, axis=-1, keepdims=True)
    return lengths


def _determinants(first: Complexes, second: Complexes) -> Complexes:
    found: Complexes = first[..., 0] * second[..., 1] - first[..., 1] * second[..., 0]
    return found


def _logarithms(samples: Complexes, pairs: Complexes) -> Floats:
    """(m, k) of the distances of samples and corners."""
    away = np.abs(_determinants(samples[:, None], pairs[None]))
    logarithms: Floats = np.log(np.maximum(away, NEAREST))
    return logarithms


def _descended(known: Conformal, start: Indices) -> tuple[Indices, float]:
    """Corners of which none can be exchanged for a better one, and their cost."""
    corners, cost = start.copy(), _cost(known, start)
    for _ in range(SWEEPS):
        before = cost
        for place in range(4):
            others = np.delete(corners, place)
            deviations = _deviations(known, others)
            deviations[others] = np.inf
            hopeful = np.flatnonzero(deviations < cost)
            if not len(hopeful):
                continue
            choices = np.column_stack([np.tile(others, (len(hopeful), 1)), hopeful])
            slanted = stretches(known.pairs[choices])
            costs = np.round(deviations[hopeful] + SKEW * np.log(slanted), DIGITS)
            best = int(costs.argmin())
            if costs[best] < cost:
                corners[place], cost = hopeful[best], float(costs[best])
        if cost == before:
            break
    return corners, cost


def _cost(known: Conformal, corners: Indices) -> float:
    deviation = _deviations(known, corners[:3])[corners[3]]
    stretch = stretches(known.pairs[corners][None])[0]
    return float(np.round(deviation + SKEW * np.log(stretch), DIGITS))


def _deviations(known: Conformal, others: Indices) -> Floats:
    """(k,) of the logarithms of what areas grow by, with three corners and each as the fourth."""
    covariance, last = known.covariance, len(known.candidates)
    signs = np.array([-1.0, -1.0, -1.0, 1.0])
    fixed = np.array([*others, last])
    between = signs @ covariance[np.ix_(fixed, fixed)] @ signs
    across = covariance[:last, fixed] @ signs
    variances = between - 2.0 * across + covariance.diagonal()[:last]
    deviations: Floats = np.sqrt(np.maximum(variances, 0.0))
    return deviations


def stretches(corners: Complexes) -> Floats:
    """(k,) what the angles of pillows with corners (k, 4, 2) are stretched by."""
    a, b, c, d = corners.transpose(1, 0, 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        ratio = _determinants(a, b) * _determinants(c, d)
        ratio = ratio / (_determinants(a, c) * _determinants(b, d))
        tau = 1j * _mean(np.sqrt(1.0 - ratio)) / _mean(np.sqrt(ratio))
        for _ in range(STEPS):
            tau = tau - np.round(tau.real)
            inside = np.abs(tau) < 1.0 - 1e-12
            if not inside.any():
                break
            tau = np.where(inside, -1.0 / tau, tau)
        slant = np.abs(tau.real) / np.abs(tau)
    # Corners so close that the mean has no digits left give no number.
    slant = np.where(np.isfinite(slant), np.minimum(slant, 0.5), 0.5)
    found: Floats = np.sqrt((1.0 + slant) / (1.0 - slant))
    return found


def _mean(second: Complexes) -> Complexes:
    """(k,) arithmetic-geometric means of one and these, each time of the nearer root."""
    first = np.ones_like(second)
    for _ in range(HALVINGS):
        root = np.sqrt(first * second)
        first, second = 0.5 * (first + second), root
        second = np.where((second / first).real < 0.0, -second, second)
    return first
