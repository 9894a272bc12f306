"""HGT tiles of the Shuttle Radar Topography Mission: one degree of heights in two bytes each."""

import re
from math import isqrt

import numpy as np

from plusedit.io.fields import within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content
from plusedit.io.meshes import register
from plusedit.io.terrain import Heights, check_shape, terrain

PLACE = re.compile(r"(?i)([NS])(\d{1,2})[EW]\d{1,3}")
VOID = -32768
FEWEST = 100  # heights of a side; squares of few bytes are something else
OF_RECTANGLES = {2 * 3601 * 1801: (3601, 1801)}  # beyond 50 degrees north


class SrtmTile:
    """Terrains; voids are left open. The name says where the tile lies, such as N46W123.hgt."""

    title = "SRTM tile"
    suffixes = (".hgt",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads, in meters."""
        with within(name):
            check_content(data, "an HGT tile")
            rows, columns = _shape(len(data))
            check_shape(rows, columns)
            raw = np.frombuffer(data, dtype=">i2").reshape(rows, columns)
            values = np.where(raw == VOID, np.nan, raw.astype(np.float64))
            heights = Heights(values, (1.0 / (columns - 1), 1.0 / (rows - 1)))
            found = PLACE.search(name)
            if not found:
                return terrain(heights.in_meters(0.0, ", as the name of the file says none"))
            south = int(found[2]) * (-1 if found[1] in "sS" else 1)
            return terrain(heights.in_meters(south + 0.5))


register("srtm_tile")(SrtmTile())


def _shape(size: int) -> tuple[int, int]:
    if size in OF_RECTANGLES:
        return OF_RECTANGLES[size]
    side = isqrt(size // 2)
    if 2 * side * side != size or side < FEWEST:
        raise FormatError(
            f"has {size} bytes, which make no square of heights; tiles have 1201 or 3601 a side"
        )
    return side, side
