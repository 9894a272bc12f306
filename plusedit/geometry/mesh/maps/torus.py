"""The map of closed parts with one handle."""

import numpy as np

from plusedit.geometry.mesh.domains import TorusDomain
from plusedit.geometry.mesh.flattening.equations import Chart, Pins, solution
from plusedit.geometry.mesh.flattening.lattices import leading_around, reduced_basis
from plusedit.geometry.mesh.flattening.sheet import Sheet
from plusedit.geometry.mesh.flattening.weights import conformal_weights, energies
from plusedit.geometry.mesh.maps import Layout, Subject, all_filled, register, share_of

LONGEST = 1e4  # of the periods to each other


class Torus:
    """Two harmonic one-forms, which have no zeros on a torus if the weights are symmetric and
    positive (Gortler, Gotsman and Thurston, Discrete one-forms on meshes, 2006)."""

    title = "torus"

    def objection(self, subject: Subject) -> str:
        return "" if subject.handles == 1 else f"it has {subject.handles or 'no'} handles, not one"

    def drawback(self, subject: Subject) -> str:
        return ""

    def layout(self, subject: Subject) -> Layout:
        sheet, notes = all_filled(subject)
        subject.progress(0.1, "finding the ways around")
        chart = _chart(sheet)
        subject.progress(0.3, "laying out the torus")
        pin = Pins(sheet.tails[:1], np.zeros((1, 2)))
        told = share_of(subject.progress, 0.3, 0.9)
        found = solution(sheet, conformal_weights(sheet), pin, chart, progress=told)
        places = chart.places(sheet, found)
        subject.progress(0.9, "fitting the periods")
        energy = energies(sheet, places)
        change = reduced_basis(energy)
        energy, places = change @ energy @ change.T, places @ change.T
        height = float(np.sqrt(energy[0, 0] / energy[1, 1]))
        height = float(np.clip(height, 1.0 / LONGEST, LONGEST))
        places[..., 1] *= height
        return Layout(TorusDomain(height), places[: sheet.own], notes)


def _chart(sheet: Sheet) -> Chart:
    """Around every triangle the sums of the one-forms, of which the first goes around before the
    second as seen from the front."""
    first, second = leading_around(sheet).T
    forms = np.stack([first, second], axis=1).reshape(-1, 3, 2)
    shifts = np.zeros((len(sheet.triangles), 3, 2))
    shifts[:, 1] = forms[:, 0]
    shifts[:, 2] = forms[:, 0] + forms[:, 1]
    (a, b), (c, d) = shifts[:, 1].T, shifts[:, 2].T
    # The area of the torus in periods, 1 or -1.
    if (a * d - b * c).sum() < 0.0:
        shifts = shifts[..., ::-1].copy()
    return Chart(np.ones((len(shifts), 3)), shifts)


register("torus")(Torus())
