"""What is drawn over the faces in a view of the parameters: the cell, rims, circles, handles."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.domains import Images, PillowDomain
from plusedit.geometry.mesh.unfolding import Unfolding
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.items import Item, Label, Markers, Polygon, Polyline, Segments
from plusedit.scene.parameter_sheet import ParameterSheet

FEW = 400  # circles, up to which those of all faces in sight are drawn
AROUND = 40  # chords of a circle
CELL, RIM, THIN = 1.5, 2.0, 1.0  # pixels
DOT, HANDLE, IMAGE = 5.0, 13.0, 9.0  # pixels
FAINT = "@35"
NAMES = "ABCD"  # of the cone points, in their order
BELOW, ABOVE = (0.0, 22.0), (0.0, -12.0)  # pixels
BESIDE = (BELOW, ABOVE, ABOVE, BELOW)  # their names, out of the cell


class Spot(NamedTuple):
    """A cone point of a pillow, or an image of it."""

    number: int
    """which of the four"""
    place: Floats
    """(2,)"""
    is_own: bool
    """whether it is the cone point itself"""


def cell_items(sheet: ParameterSheet, images: Images) -> Iterator[Item]:
    """The rim of the cell: sides that are sewn together in the color of the parameter in which
    they lie apart; those of the images faint."""
    unfolding = sheet.unfolding
    low, high = unfolding.bounds
    corners = np.array([low, [high[0], low[1]], high, [low[0], high[1]]])
    for shift, sign in zip(images.shifts[1:], images.signs[1:], strict=True):
        there = sign * corners + shift
        yield Polyline(np.vstack([there, there[:1]]), f"line{FAINT}", THIN, "dash")
    colors = _side_colors(unfolding)
    for side, color in enumerate(colors):
        ends = corners[[side, (side + 1) % 4]]
        yield Polyline(ends, color, CELL, "solid" if color == "line" else "dash")
    yield Label(corners[[0, 1]].mean(axis=0), "u", "u", (24.0, 18.0))
    yield Label(corners[[0, 3]].mean(axis=0), "v", "v", (-10.0, 4.0), "right")


def rim_items(sheet: ParameterSheet, images: Images) -> Iterator[Item]:
    """The border of the mesh, and where the map is torn; at the images of the cell faint."""
    starts, ends = sheet.rims
    for k in reversed(range(len(images.shifts))):
        sign, shift = images.signs[k], images.shifts[k]
        color = "text" if k == 0 else f"text{FAINT}"
        yield Segments(sign * starts + shift, sign * ends + shift, color, RIM if k == 0 else THIN)


def circle_items(
    sheet: ParameterSheet, sigmas: Floats, chosen: NDArray[np.intp], camera: PlaneCamera
) -> Iterator[Item]:
    """Circles of radius sigma around the centers of the chosen faces, dots in their middle.

    Of all faces in sight where none is chosen, if they are few; those of chosen ones likewise.
    """
    centers, is_chosen = sheet.unfolding.centers, len(chosen) > 0
    (left, lower), (right, upper) = camera.window
    faces = chosen if is_chosen else np.arange(len(centers))
    (u, v), reach = centers[faces].T, sigmas[faces]
    # By columns: to look at rows of two numbers takes ten times as long.
    in_sight = (u + reach >= left) & (u - reach <= right)
    in_sight &= (v + reach >= lower) & (v - reach <= upper)
    faces = faces[in_sight]
    if not len(faces) or len(faces) > FEW:
        return
    color = "selected" if is_chosen else "line@60"
    angles = np.linspace(0.0, 2.0 * np.pi, AROUND + 1)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    rings = centers[faces, None] + sigmas[faces, None, None] * circle
    yield Segments(rings[:, :-1].reshape(-1, 2), rings[:, 1:].reshape(-1, 2), color, CELL)
    if is_chosen:
        yield Markers(centers[faces], "circle", DOT, color, color)


def hover_items(sheet: ParameterSheet, face: int, place: Floats) -> Iterator[Item]:
    """The outline of a face at the image of it that is nearest to a place (2,)."""
    mesh, unfolding = sheet.unfolding.mesh, sheet.unfolding
    corners = unfolding.corners[mesh.starts[face] : mesh.starts[face + 1]]
    images = unfolding.images
    centers = images.signs[:, None] * unfolding.centers[face] + images.shifts
    k = int(((centers - place) ** 2).sum(axis=1).argmin())
    around = images.signs[k] * corners + images.shifts[k]
    yield Polygon(around, "hover@30", "hover", RIM)


def cone_spots(sheet: ParameterSheet, images: Images) -> tuple[Spot, ...]:
    """The cone points of a pillow and their images at the corners of the cells; else none."""
    domain = sheet.unfolding.domain
    if not isinstance(domain, PillowDomain):
        return ()
    found: dict[tuple[float, float], Spot] = {}
    for k, (shift, sign) in enumerate(zip(images.shifts, images.signs, strict=True)):
        for number, place in enumerate(sign * domain.cone_points + shift):
            key = tuple(np.round(place, 9).tolist())
            found.setdefault(key, Spot(number, place, k == 0))
    return tuple(found.values())


def cone_items(spots: tuple[Spot, ...], held: int | None) -> Iterator[Item]:
    """Handles of cone points with their names; the images of them smaller."""
    for spot in spots:
        color = "hover" if spot.number == held else "accent"
        size = HANDLE if spot.is_own else IMAGE
        yield Markers(spot.place[None], "diamond", size, color if spot.is_own else None, color)
        yield Label(spot.place, NAMES[spot.number], "text", BESIDE[spot.number], "center")


def landing_items(spot: Spot, place: Floats) -> Iterator[Item]:
    """Where a cone point that is dragged would come to lie."""
    yield Polyline(np.stack([spot.place, place]), "hover", CELL, "dash")
    yield Markers(place[None], "ring", HANDLE, None, "hover", RIM)


def _side_colors(unfolding: Unfolding) -> tuple[str, str, str, str]:
    """Of the lower, right, upper and left side of the cell."""
    by_u, by_v = np.isfinite(unfolding.domain.cell)
    # The lower and the upper side of a pillow are each folded, about the cone point in its middle.
    level = "v" if by_v else "line@60"
    upright = "u" if by_u else "line@60"
    return level, upright, level, upright
