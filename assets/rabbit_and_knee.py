"""A sitting rabbit and the bones of a right knee, of ellipsoids and round cones."""

from dataclasses import dataclass

import numpy as np
from bodies import Body, below, both, cone, ellipsoid, mirrored, turned, union, without
from surface_nets import Box


def rabbit() -> Body:
    """A rabbit that sits and looks along x."""
    body = union(
        0.3,
        ellipsoid((-0.30, 0.0, 0.64), (0.68, 0.47, 0.60), turned(1, 14.0)),
        ellipsoid((0.26, 0.0, 0.58), (0.42, 0.37, 0.50), turned(1, -15.0)),
        ellipsoid((-0.06, 0.0, 0.27), (0.62, 0.42, 0.30)),
        cone((0.28, 0.0, 0.84), (0.50, 0.0, 1.12), 0.34, 0.26),
    )
    whole = union(0.12, body, head())
    for part, soft in (
        (haunch(), 0.06), (hind_foot(), 0.12), (front_leg(), 0.08), (ear(), 0.07), (eye(), 0.03),
    ):  # fmt: skip
        whole = union(soft, whole, part, mirrored(part))
    whole = union(0.06, whole, ellipsoid((-0.98, 0.0, 0.42), (0.19, 0.19, 0.20)))
    return both(0.05, whole, below((0.0, 0.0, 0.0), (0.0, 0.0, -1.0)))


def head() -> Body:
    """Skull, muzzle and cheeks."""
    cheek = ellipsoid((0.70, 0.16, 1.20), (0.19, 0.11, 0.15))
    lip = ellipsoid((0.92, 0.075, 1.12), (0.115, 0.085, 0.09))
    return union(
        0.15,
        ellipsoid((0.65, 0.0, 1.29), (0.34, 0.25, 0.27), turned(1, 22.0)),
        ellipsoid((0.90, 0.0, 1.17), (0.17, 0.14, 0.13)),
        lip, mirrored(lip), cheek, mirrored(cheek),
    )  # fmt: skip


def haunch() -> Body:
    """The left thigh."""
    return ellipsoid((-0.32, 0.38, 0.45), (0.43, 0.21, 0.42), turned(1, -25.0))


def hind_foot() -> Body:
    """The left one."""
    return cone((-0.40, 0.40, 0.09), (0.24, 0.44, 0.085), 0.12, 0.115)


def front_leg() -> Body:
    """The left one, with its paw."""
    return union(
        0.08,
        cone((0.36, 0.21, 0.60), (0.50, 0.20, 0.14), 0.18, 0.105),
        ellipsoid((0.60, 0.20, 0.085), (0.18, 0.11, 0.10)),
    )


def ear() -> Body:
    """The left one, hollow in front."""
    turn = turned(1, -36.0) @ turned(0, -16.0)
    middle = np.array([0.28, 0.25, 1.86])
    shell = ellipsoid(middle, (0.12, 0.2, 0.50), turn)
    hollow = ellipsoid(middle + 0.14 * turn[0], (0.09, 0.12, 0.38), turn)
    return without(0.05, shell, hollow)


def eye() -> Body:
    """The left one."""
    return ellipsoid((0.80, 0.20, 1.335), (0.075, 0.07, 0.075))


def femur() -> Body:
    """The lower end of a right thigh bone: x to the front, y to the middle, in centimeters."""
    bone = union(
        1.6,
        cone((0.5, 0.0, 18.0), (0.1, 0.0, 7.0), 1.45, 1.75),
        ellipsoid((-0.1, 0.0, 4.8), (2.2, 3.2, 2.9)),
        ellipsoid((1.3, -0.2, 3.3), (1.7, 2.9, 2.7)),
    )
    for side, size in ((1.0, 1.0), (-1.0, 0.94)):
        condyle = union(
            0.9,
            ellipsoid((-0.3, 2.35 * side, 2.4), (3.2 * size, 1.5, 2.4)),
            ellipsoid((-2.2, 2.5 * side, 2.5), (2.1 * size, 1.45, 2.2 * size)),
            ellipsoid((-0.6, 3.3 * side, 3.3), (1.0, 1.0, 1.0)),
        )
        bone = union(0.8, bone, condyle)
    notch = cone((-5.0, 0.0, 1.7), (0.4, 0.0, -0.3), 1.25, 0.9)
    groove = cone((4.3, -0.2, 7.0), (3.6, 0.0, -0.8), 1.2, 1.5)
    bone = without(0.6, bone, notch, groove)
    return both(0.3, bone, below((0.0, 0.0, 15.0), (0.0, 0.0, 1.0)))


def patella() -> Body:
    """The kneecap, with the ridge that runs in the groove."""
    return union(
        0.9,
        ellipsoid((4.4, -0.1, 3.9), (0.85, 2.05, 1.9)),
        cone((4.35, -0.1, 3.2), (4.2, -0.1, 2.1), 0.9, 0.6),
        ellipsoid((3.85, -0.1, 3.9), (0.55, 0.6, 1.3)),
    )


def tibia() -> Body:
    """The upper end of the shin bone."""
    bone = union(
        1.9,
        ellipsoid((-0.5, 2.0, -1.75), (2.8, 2.2, 1.35)),
        ellipsoid((-0.5, -2.0, -1.75), (2.6, 2.15, 1.35)),
        cone((-0.3, 0.0, -2.6), (0.0, 0.2, -8.5), 2.9, 1.3),
        cone((0.0, 0.2, -7.0), (0.0, 0.2, -18.0), 1.45, 1.2),
        cone((1.6, 0.0, -5.0), (0.8, 0.2, -18.0), 0.5, 0.5),
        ellipsoid((1.9, 0.0, -4.7), (0.75, 0.9, 1.5)),
    )
    for side in (1.0, -1.0):
        hollow = ellipsoid((-0.6, 2.25 * side, 2.15), (3.3, 1.75, 2.75))
        spine = cone((-0.5, 0.45 * side, -1.2), (-0.5, 0.42 * side, -0.05), 0.55, 0.22)
        bone = union(0.4, without(0.4, bone, hollow), spine)
    return both(0.3, bone, below((0.0, 0.0, -14.0), (0.0, 0.0, -1.0)))


def fibula() -> Body:
    """The upper end of the calf bone."""
    bone = union(
        0.8,
        ellipsoid((-2.3, -3.7, -3.6), (1.0, 0.9, 1.2)),
        cone((-2.1, -3.5, -4.0), (-1.5, -2.9, -18.0), 0.6, 0.55),
    )
    return both(0.2, bone, below((0.0, 0.0, -14.0), (0.0, 0.0, -1.0)))


@dataclass(frozen=True)
class Part:
    """A body, where it is, and how wide the faces of its mesh are."""

    body: Body
    box: Box
    step: float


RABBIT = Part(rabbit(), Box((-1.4, -0.8, -0.2), (1.4, 0.8, 2.6)), 0.053)
KNEE = {
    "femur": Part(femur(), Box((-5.0, -5.0, -0.6), (4.6, 5.0, 15.6)), 0.38),
    "tibia": Part(tibia(), Box((-4.4, -5.0, -14.6), (4.0, 5.0, 0.8)), 0.38),
    "fibula": Part(fibula(), Box((-4.0, -5.2, -14.6), (-0.4, -1.8, -1.8)), 0.3),
    "patella": Part(patella(), Box((2.8, -3.0, 0.4), (6.0, 3.0, 6.4)), 0.28),
}
