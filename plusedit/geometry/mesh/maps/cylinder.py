"""The map of tubes: parts with two rims."""

import numpy as np

from plusedit.geometry.mesh.domains import CylinderDomain
from plusedit.geometry.mesh.flattening.equations import Chart, Pins, solution
from plusedit.geometry.mesh.flattening.paths import (
    corners_left_of_ends,
    distance_between,
    edge_graph,
    half_edges_along,
    left_corners,
    path_between,
)
from plusedit.geometry.mesh.flattening.sheet import Indices, Sheet
from plusedit.geometry.mesh.flattening.weights import conformal_weights, energies
from plusedit.geometry.mesh.maps import Layout, Subject, holes, register, share_of
from plusedit.geometry.mesh.topology import BoundaryLoop

LONG = 0.25  # of the mean girth: a shorter rim is a hole
SLIT = 0.02  # of a circle as long: a rim around less than that is a hole that was not sewn up
LONGEST = 1e4  # of the girths


class Cylinder:
    """v is 0 and constant along the two longest rims, on which u slides; other holes are filled.

    A path from rim to rim is crossed with a jump of u by the period; it leaves no trace. Weights
    are symmetric, since otherwise nothing of period one may be in balance everywhere.
    """

    title = "cylinder"

    def objection(self, subject: Subject) -> str:
        if subject.handles:
            return "it has handles"
        return "" if subject.boundaries > 1 else "it hasn't two rims"

    def drawback(self, subject: Subject) -> str:
        sheet, (first, second, *_) = subject.sheet, subject.topology.loops
        if _is_slit(subject, first) or _is_slit(subject, second):
            return "one rim is that of a slit"
        rims = (sheet.tails[sheet.ring(loop)] for loop in (first, second))
        apart = distance_between(edge_graph(sheet), *rims)
        # The area over the length is the girth of a tube.
        long = LONG * float(subject.mesh.areas.sum()) <= apart * second.length
        return "" if long else "one rim is short, like that of a hole"

    def layout(self, subject: Subject) -> Layout:
        subject.progress(0.1, "laying out the cylinder")
        sheet, (first, second, *others) = subject.sheet, subject.topology.loops
        rings = [sheet.ring(first), sheet.ring(second)]
        sheet = sheet.filled([sheet.ring(loop) for loop in others])
        if len(sheet.chords):
            sheet, rings[0] = sheet.collared(rings[0])
            sheet, rings[1] = sheet.collared(rings[1])
        low, high = (sheet.tails[ring] for ring in rings)
        chart, weights = _chart(sheet, low, high), conformal_weights(sheet)
        ends = np.repeat([[0.0], [1.0]], (len(low), len(high)), axis=0)
        told = share_of(subject.progress, 0.1, 0.5)
        v = solution(sheet, weights, Pins(np.concatenate([low, high]), ends), progress=told)
        subject.progress(0.5, "going around the cylinder")
        told, pin = share_of(subject.progress, 0.5, 0.9), Pins(low[:1], np.zeros((1, 1)))
        u = solution(sheet, weights, pin, chart, column=0, progress=told)
        places = chart.places(sheet, np.concatenate([u, v], axis=1))
        energy = energies(sheet, places)
        height = np.sqrt(energy[0, 0] / energy[1, 1])
        places[..., 1] *= np.clip(height, 1.0 / LONGEST, LONGEST)
        notes = (f"{holes(len(others))} filled for the map",) if others else ()
        return Layout(CylinderDomain(), places[: sheet.own], notes)


def _is_slit(subject: Subject, loop: BoundaryLoop) -> bool:
    """Whether hardly any area lies inside of a loop."""
    points = subject.mesh.vertices[loop.vertices] - subject.mesh.vertices[loop.vertices[0]]
    spanned = 0.5 * np.cross(points, np.roll(points, -1, axis=0)).sum(axis=0)
    return float(np.linalg.norm(spanned)) < SLIT * loop.length**2 / (4.0 * np.pi)


def _chart(sheet: Sheet, low: Indices, high: Indices) -> Chart:
    """The images beyond a path from rim to rim: on its left, u is larger by one."""
    half_edges = half_edges_along(sheet, path_between(edge_graph(sheet), low, high))
    first, last = corners_left_of_ends(sheet, half_edges)
    inner = [corner for row in left_corners(sheet, half_edges) for corner in row]
    chart = Chart.trivial(sheet)
    chart.move(np.array([*first, *inner, *last]), 1.0, (1.0, 0.0))
    return chart


register("cylinder")(Cylinder())
