"""Native DEM files of the USGS: profiles from south to north, in records of 1024 bytes.

Numbers stand in columns of fixed width. Record A has the units, the steps and how many profiles
there are; each record B is a profile: six numbers of its place, then heights, as many as fit into
this record and the next ones. U. S. Geological Survey, Standards for Digital Elevation Models,
part 2.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import of_number, within
from plusedit.io.formats import FormatError
from plusedit.io.json_text import shown
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content, name_of
from plusedit.io.meshes import register
from plusedit.io.terrain import Heights, terrain

RECORD = 1024
USED = 1020  # bytes of a record that hold numbers
PROFILE_HEAD = 144
WIDTH = 6  # of a height
VOIDS = (-32766, -32767, -32768)
FOOT = 0.3048
UNITS = {0: 1.0, 1: FOOT, 2: 1.0, 3: 1.0 / 3600.0}
"""Of x and y: degrees, feet, meters, seconds of arc"""
GEOGRAPHIC = (0, 3)
SPARSEST = 8  # places of the grid for each height that is there


class UsgsDem:
    """Terrains; what lies between the profiles and the edge of the sheet is left open."""

    title = "USGS DEM"
    suffixes = (".dem",)

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads, in meters."""
        with within(name):
            check_content(data, "a USGS DEM")
            data = data.replace(b"\r", b"").replace(b"\n", b"")
            sheet = _sheet(data)
            profiles = list(_profiles(data, sheet))
            return terrain(_heights(sheet, profiles))


register("usgs_dem")(UsgsDem())


@dataclass(frozen=True)
class _Sheet:
    """What record A says."""

    unit: int
    height_unit: float
    """meters of one unit of height"""
    steps: tuple[float, float, float]
    profiles: int


@dataclass(frozen=True, eq=False)
class _Profile:
    """A row of heights to the north, from its first point."""

    x: float
    y: float
    heights: Floats


def _sheet(data: bytes) -> _Sheet:
    if len(data) < RECORD:
        raise FormatError(f"is cut off, or no USGS DEM: it has {of_number(len(data), 'byte')}")
    unit, height_unit = _whole(data[528:534]), _whole(data[534:540])
    if unit not in UNITS or height_unit not in (1, 2):
        raise FormatError(f"is no USGS DEM: its units are {unit} and {height_unit}")
    steps = tuple(_number(data[816 + 12 * i : 828 + 12 * i]) for i in range(3))
    if not all(0.0 < step < 1e9 for step in steps):
        raise FormatError(f"is no USGS DEM: its steps are {', '.join(f'{s:g}' for s in steps)}")
    profiles = _whole(data[858:864])
    there = len(data) // RECORD - 1
    if not 1 <= profiles <= there:
        raise FormatError(
            f"is cut off: promises {of_number(profiles, 'profile')},"
            f" but has {of_number(there, 'record')}"
        )
    x, y, z = steps
    return _Sheet(unit, FOOT if height_unit == 1 else 1.0, (x, y, z), profiles)


def _profiles(data: bytes, sheet: _Sheet) -> list[_Profile]:
    found, at = [], RECORD
    for number in range(sheet.profiles):
        head = data[at : at + PROFILE_HEAD]
        if len(head) < PROFILE_HEAD:
            raise _cut_off(number, sheet)
        count = _whole(head[12:18])
        first = (USED - PROFILE_HEAD) // WIDTH
        records = 1 + max(0, -(-(count - first) // (USED // WIDTH)))
        if count < 0 or at + PROFILE_HEAD + WIDTH * count > len(data):
            raise _cut_off(number, sheet)
        x, y, datum = (_number(head[24 + 24 * i : 48 + 24 * i]) for i in range(3))
        raw = _raw_heights(data[at : at + records * RECORD], count)
        heights = (raw * sheet.steps[2] + datum) * sheet.height_unit
        found.append(_Profile(x, y, np.where(np.isin(raw, VOIDS), np.nan, heights)))
        at += records * RECORD
    return found


def _raw_heights(records: bytes, count: int) -> NDArray[np.int64]:
    """(count,) the heights of a profile as they are written."""
    text = bytearray()
    for at in range(0, len(records), RECORD):
        text += records[at + (PROFILE_HEAD if at == 0 else 0) : at + USED]
    fields = [bytes(text[i : i + WIDTH]) for i in range(0, WIDTH * count, WIDTH)]
    try:
        return np.array([int(entry) for entry in fields], dtype=np.int64)
    except ValueError:
        wrong = next(entry for entry in fields if not _is_whole(entry))
        raise FormatError(f"has a height {shown(name_of(wrong))}, which is no number") from None


def _heights(sheet: _Sheet, profiles: list[_Profile]) -> Heights:
    step_x, step_y, _ = sheet.steps
    filled = [profile for profile in profiles if len(profile.heights)]
    if not filled:
        raise FormatError("has no heights")
    west, south = min(p.x for p in filled), min(p.y for p in filled)
    columns = np.rint([(p.x - west) / step_x for p in filled])
    rows = np.rint([(p.y - south) / step_y for p in filled])
    count = sum(len(p.heights) for p in filled)
    width = columns.max() + 1
    height = max(row + len(p.heights) for row, p in zip(rows, filled, strict=True))
    if not width * height <= SPARSEST * count:
        raise FormatError(f"has {of_number(count, 'height')} for {width:.0f} × {height:.0f} places")
    values = np.full((int(height), int(width)), np.nan)
    for column, row, profile in zip(columns.astype(int), rows.astype(int), filled, strict=True):
        values[row : row + len(profile.heights), column] = profile.heights
    unit = UNITS[sheet.unit]
    step, corner = (step_x * unit, step_y * unit), (west * unit, south * unit)
    heights = Heights(values[::-1], step, corner)
    if sheet.unit in GEOGRAPHIC:
        return heights.in_meters(corner[1] + 0.5 * len(values) * step[1])
    return heights


def _cut_off(there: int, sheet: _Sheet) -> FormatError:
    return FormatError(
        f"is cut off: promises {of_number(sheet.profiles, 'profile')}, but ends after {there}"
    )


def _is_whole(entry: bytes) -> bool:
    try:
        int(entry)
    except ValueError:
        return False
    return b"_" not in entry


def _whole(entry: bytes) -> int:
    if not _is_whole(entry):
        raise FormatError(f"is no USGS DEM: {shown(name_of(entry))} is no whole number")
    return int(entry)


def _number(entry: bytes) -> float:
    """A number as Fortran writes it, with D before the exponent."""
    try:
        value = float(entry.replace(b"D", b"E").replace(b"d", b"e"))
    except ValueError:
        value = float("nan")
    if not abs(value) < 1e15:
        raise FormatError(f"is no USGS DEM: {shown(name_of(entry))} is no number")
    return value
