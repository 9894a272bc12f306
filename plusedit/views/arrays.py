"""Arrays handed to Qt without a loop over their points."""

from ctypes import memmove

import numpy as np
from PySide6.QtGui import QPolygonF
from shiboken6 import Shiboken

from plusedit.geometry.arrays import Floats


def polygon_of(points: Floats) -> QPolygonF:
    """The points (m, 2) as a QPolygonF; copied once, as memory: a QPointF is two doubles."""
    polygon = QPolygonF()
    if len(points):
        polygon.resize(len(points))
        rows = np.ascontiguousarray(points, dtype=np.float64)
        memmove(Shiboken.getCppPointer(polygon.data())[0], rows.ctypes.data, rows.nbytes)
    return polygon
