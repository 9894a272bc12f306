"""GeoTIFF, by the library tifffile, which comes with the extra "geotiff"."""

import logging
from dataclasses import dataclass
from io import BytesIO
from typing import Any

import numpy as np

from plusedit.geometry.arrays import Floats
from plusedit.io.fields import within
from plusedit.io.formats import FormatError
from plusedit.io.mesh_cleaning import doubles
from plusedit.io.mesh_file import MeshFile
from plusedit.io.mesh_text import check_content
from plusedit.io.meshes import register
from plusedit.io.terrain import Heights, check_shape, of_unknown_distances, terrain

MARKS = (b"II*\0", b"MM\0*", b"II+\0", b"MM\0+")
GEOGRAPHIC = 2  # of GTModelTypeGeoKey: steps are degrees
FOOT_UNITS = {9002: 0.3048, 9003: 1200 / 3937}
"""Of ProjLinearUnitsGeoKey: the international and the American foot, in meters"""
LARGEST_TILE = 1 << 28  # bytes
BEST_RATIO = 1032  # what packing can save at most, but for pictures of nothing


class GeoTiff:
    """Terrains of one band; places without data are left open."""

    title = "GeoTIFF"
    suffixes = (".tif", ".tiff")

    def read(self, data: bytes, name: str) -> MeshFile:
        """The heights as a mesh of quads; degrees become meters."""
        with within(name):
            if not data.startswith(MARKS):
                check_content(data, "a TIFF picture")
                raise FormatError("is no TIFF picture")
            found = _read(data, _library())
            return terrain(_heights(found))


register("geotiff")(GeoTiff())


@dataclass(frozen=True, eq=False)
class _Band:
    values: Floats
    tags: dict[str, Any]
    """by the names that GeoTIFF has for them"""
    void: float | None


def _library() -> Any:
    try:
        import tifffile
    except ImportError:
        raise FormatError(
            'is a GeoTIFF, which needs the extra "geotiff": pip install "plusedit[geotiff]"'
        ) from None
    # What it finds wrong ends in one sentence here, not in many on the terminal.
    logging.getLogger("tifffile").setLevel(logging.CRITICAL)
    return tifffile


def _read(data: bytes, tifffile: Any) -> _Band:
    try:
        with tifffile.TiffFile(BytesIO(data)) as file:
            page = file.pages[0]
            _check_page(page, len(data))
            values = doubles(np.asarray(page.asarray()))
            void = page.tags.get("GDAL_NODATA")
            tags = dict(page.geotiff_tags) if "GeoKeyDirectoryTag" in page.tags else {}
            return _Band(values, tags, None if void is None else _void(void.value))
    except FormatError:
        raise
    except Exception as error:  # a library's: it promises nothing of damaged files
        raise FormatError("is damaged, or a TIFF of a kind that is not read") from error


def _check_page(page: Any, size: int) -> None:
    """FormatError if a page is no grid of numbers, or larger than its bytes explain."""
    if len(page.shape) != 2 or page.dtype is None or page.dtype.kind not in "iuf":
        shape = " × ".join(map(str, page.shape)) or "no"
        raise FormatError(f"has {shape} values; heights are one number for each place")
    check_shape(*page.shape)
    if page.nbytes > BEST_RATIO * size:
        raise FormatError(f"is cut off: promises {page.nbytes} bytes of heights")
    tile = [max(1, number or 1) for number in (page.tilewidth, page.tilelength, page.rowsperstrip)]
    rows = min(tile[2], page.shape[0])
    if max(tile[0] * tile[1], rows * page.shape[1]) * page.dtype.itemsize > LARGEST_TILE:
        raise FormatError("is laid out in tiles that are too large")


def _void(value: Any) -> float | None:
    try:
        return float(value)
    except (TypeError, ValueError):
        return None


def _heights(band: _Band) -> Heights:
    values = band.values
    if band.void is not None:
        values = np.where(np.isclose(values, band.void, rtol=1e-6, atol=0.0), np.nan, values)
    scale = _numbers(band.tags.get("ModelPixelScale"), 2)
    if scale is None or min(scale[:2]) <= 0.0:
        return of_unknown_distances(values)
    unit = FOOT_UNITS.get(_code(band, "ProjLinearUnitsGeoKey"), 1.0)
    rows = len(values)
    tie = _numbers(band.tags.get("ModelTiepoint"), 6) or [0.0] * 6
    west, north = tie[3] - tie[0] * scale[0], tie[4] + tie[1] * scale[1]
    corner = west + 0.5 * scale[0], north - (rows - 0.5) * scale[1]
    if _code(band, "GTModelTypeGeoKey") == GEOGRAPHIC:
        heights = Heights(values, (scale[0], scale[1]))
        return heights.in_meters(float(np.clip(north - 0.5 * rows * scale[1], -90.0, 90.0)))
    step = scale[0] * unit, scale[1] * unit
    return Heights(values, step, (corner[0] * unit, corner[1] * unit))


def _code(band: _Band, key: str) -> int:
    value = band.tags.get(key)
    return int(value) if isinstance(value, int) else 0


def _numbers(value: Any, least: int) -> list[float] | None:
    """At least so many finite numbers, if they are there."""
    try:
        found = np.asarray(value, dtype=np.float64).ravel()
    except (TypeError, ValueError):
        return None
    if len(found) < least or not np.isfinite(found).all():
        return None
    listed: list[float] = found.tolist()
    return listed
