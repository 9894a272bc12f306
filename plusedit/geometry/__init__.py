"""Plus curves as a library: immutable values and pure functions on numpy arrays.

A curve is a `PlusCurve`: a basis, control lines and the magnitude s. What can be asked of it and
done to it lies in a module for each matter: `elevation`, `hulls`, `insertion`, `magnitude`,
`nearest`, `tangency`, `transforms` and so on.
"""

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.bases.rag import RationalGaussian
from plusedit.geometry.blend import Grid
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.lines import ControlLines

__all__ = ["BSpline", "Bernstein", "ControlLines", "Grid", "PlusCurve", "RationalGaussian"]
