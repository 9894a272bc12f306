"""What stands in files of terrains, and what is wrong with some."""

import sys

import numpy as np
import pytest

from plusedit.io import terrain
from plusedit.io.formats import FormatError
from plusedit.io.mesh_reading import read_mesh
from tests.io.meshes.sample_files import (
    HEIGHTS,
    KNOWN_CELLS,
    TERRAINS,
    esri_grid,
    hgt,
    npy,
    npz,
    usgs_dem,
    xyz,
    zip_of,
)
from tests.io.meshes.test_mesh_format_contract import sentence

SPACED = [name for name in TERRAINS if name.endswith(("asc", "xyz", "npz", "dem"))]


def test_unknown_heights_are_holes():
    flat = terrain.Heights(HEIGHTS, (1.0, 1.0))
    mesh = terrain.terrain(flat).mesh
    assert mesh.face_count == KNOWN_CELLS
    assert mesh.vertex_count == 11


def test_heights_without_neighbors_are_left_out():
    values = np.array([[1.0, 1, np.nan, 7], [1, 1, np.nan, np.nan]])
    assert terrain.terrain(terrain.Heights(values, (1.0, 1.0))).mesh.vertex_count == 4


def test_large_grids_are_thinned_from_the_southwest(monkeypatch):
    monkeypatch.setattr(terrain, "MOST", 12)
    values = np.arange(30.0).reshape(5, 6)
    found = terrain.terrain(terrain.Heights(values, (1.0, 10.0)))
    assert found.notes == ("of 5 × 6 heights every 2nd row and column was taken",)
    assert {(x, y, z) for x, y, z in found.mesh.vertices.tolist()} == {
        (x, y, values[4 - round(y / 10), round(x)]) for x in (0, 2, 4) for y in (0, 20, 40)
    }


@pytest.mark.parametrize(
    ("values", "step", "reason"),
    [
        (np.zeros((1, 9)), 1.0, "has 1 × 9 heights; a terrain needs two rows and columns"),
        (np.full((2, 2), np.nan), 1.0, "has no four neighboring heights that are known"),
        (np.full((2, 2), 1e16), 1.0, "has a height of size 1e+16; more than 1e+15 can't"),
        (np.zeros((2, 2)), 0.0, "has steps of 0 and 0"),
        (np.zeros((2, 2)), 1e300, "has steps of 1e"),
    ],
)
def test_grids_that_make_no_terrain_are_refused(values, step, reason):
    with pytest.raises(FormatError) as told:
        terrain.terrain(terrain.Heights(values, (step, step)))
    assert str(told.value).startswith(reason)


@pytest.mark.parametrize("name", SPACED)
def test_distances_in_the_file_are_kept(name):
    vertices = read_mesh(TERRAINS[name], name).mesh.vertices
    assert vertices.max(axis=0).tolist() == [30.0, 20.0, 9.0]


@pytest.mark.parametrize("name", ["a.npy", "a.png"])
def test_without_distances_a_terrain_is_four_times_as_wide_as_high(name):
    read = read_mesh(TERRAINS[name], name)
    low, high = read.mesh.bounds
    step = (high[0] - low[0]) / 3
    assert 4 * step == pytest.approx(4.0 * (high[2] - low[2]))
    assert any("the file says no distances" in note for note in read.notes)


def test_degrees_become_meters():
    cells = "ncols 4\nnrows 3\nxllcenter -84\nyllcenter 59.998\ncellsize 0.001\n"
    read = read_mesh(esri_grid(cells), "a.asc")
    width, depth, _ = read.mesh.bounds[1]
    assert depth == pytest.approx(0.002 * 111_195)
    assert width == pytest.approx(0.5 * 0.003 * 111_195, rel=1e-4)
    assert read.notes[0].startswith("degrees were turned into meters as at latitude 60")


@pytest.mark.parametrize(
    ("header", "reason"),
    [
        ("nrows 3\ncellsize 10\n", "does not begin as ESRI grids do: ncols missing"),
        ("ncols 4\nnrows 3\n", "cellsize: is missing"),
        ("ncols 4\nnrows 3\ncellsize 0\n", "cellsize: is 0"),
        ("ncols 4\nnrows 3\ncellsize ten\n", 'cellsize: "ten" is no number'),
        ("ncols 4\nnrows 3.5\ncellsize 1\n", "nrows: is 3.5"),
        ("ncols 4\nnrows nan\ncellsize 1\n", "nrows: is nan"),
        ("ncols 4\nnrows 4\ncellsize 1\n", "is cut off: promises 4 × 4 heights, but has 12"),
        ("ncols 4000\nnrows 4000\ncellsize 1\n", "is cut off: promises 4000 × 4000 heights, but"),
        ("ncols 99999999\nnrows 99999999\ncellsize 1\n", "has 99999999 × 99999999 heights; up"),
    ],
)  # fmt: skip
def test_what_is_wrong_with_an_esri_grid_is_told(header, reason):
    assert sentence("a.asc", esri_grid(header)).startswith(reason)


@pytest.mark.parametrize("separator", [",", ";", "\t", " , "])
def test_points_are_separated_in_many_ways(separator):
    text = b"x, y, height\n# a comment\n" + xyz(separator)
    assert read_mesh(text, "a.xyz").mesh.face_count == KNOWN_CELLS


def test_points_may_come_in_any_order_and_rounded():
    rng = np.random.default_rng(3)
    x, y = np.meshgrid(np.arange(9) / 3.0, np.arange(7) / 3.0)
    points = rng.permutation(np.round(np.stack([x, y, x + y], axis=2).reshape(-1, 3), 2))
    text = "\n".join(" ".join(map(str, point)) for point in points.tolist())
    assert read_mesh(text.encode(), "a.xyz").mesh.face_count == 8 * 6


@pytest.mark.parametrize(
    ("points", "reason"),
    [
        (np.random.default_rng(1).normal(size=(50, 3)), "lie on no grid in x and y"),
        ([[0, 0, 0], [0, 1, 0], [0, 2, 0]], "in one line, seen from above"),
        ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1e9, 1, 0]], "lie on no grid in x and y"),
        ([[0, 0, 0], [1e300, 0, 0]], "no number that can be worked with"),
        ([[0, 0], [1, 0]], "a point has 2 numbers, expected 3"),
    ],
)
def test_points_on_no_grid_are_refused(points, reason):
    text = "\n".join(" ".join(map(str, point)) for point in np.array(points).tolist())
    assert reason in sentence("a.xyz", text.encode())


@pytest.mark.parametrize("kind", ["<f8", ">f4", "<i2", ">u4", "u1", "?"])
@pytest.mark.parametrize("order", ["C", "F"])
def test_arrays_of_every_kind_of_number_are_read(kind, order):
    array = np.asarray(np.arange(12).reshape(3, 4) % 2, dtype=kind, order=order)
    vertices = read_mesh(npy(array), "a.npy").mesh.vertices
    assert vertices[:, 2].tolist() == array.ravel().tolist()


@pytest.mark.parametrize(
    ("array", "reason"),
    [
        (np.zeros(5), "is an array of 5; heights have rows and columns"),
        (np.zeros((2, 3, 4)), "is an array of 2 × 3 × 4; heights have rows and columns"),
        (np.zeros((3, 3), complex), "is an array of something else than plain numbers"),
        (np.zeros((3, 3), "f8,f8"), "is an array of something else than plain numbers"),
        (np.array([[{}]]), "is an array of something else than plain numbers"),
    ],
)
def test_other_arrays_are_refused(array, reason):
    assert sentence("a.npy", npy(array)) == reason


@pytest.mark.parametrize("shape", ["(9, 4)", "(99999999999999, 4)", "(4, 99999999999999999999)"])
def test_the_shape_of_an_array_is_not_believed(shape):
    data = npy().replace(b"(3, 4)", shape.encode())
    assert sentence("a.npy", data).startswith(("is cut off", "has "))


def test_archives_that_unpack_to_too_much_are_refused(monkeypatch):
    monkeypatch.setattr("plusedit.io.npy_reading.LARGEST", 1 << 20)
    assert "unpacked" in sentence("a.npz", zip_of(**{"a.npy": bytes(2 << 20)}))


def test_an_archive_without_heights_is_refused():
    assert sentence("a.npz", npz(a=np.zeros(3))) == "holds no array of rows and columns"
    assert "is damaged" in sentence("a.npz", npz()[:-30])


def test_a_tile_of_radar_heights_lies_where_its_name_says():
    width, depth, _ = read_mesh(hgt(), "S60E010.hgt").mesh.bounds[1]
    assert depth == pytest.approx(111_195)
    assert width == pytest.approx(111_195 * np.cos(np.radians(59.5)))
    assert "as the name of the file says none" in read_mesh(hgt(), "tile.hgt").notes[0]


def test_bytes_that_make_no_square_are_refused():
    assert sentence("a.hgt", bytes(1001)).startswith("has 1001 bytes, which make no square")


@pytest.mark.parametrize("end", [b"", b"\n", b"\r\n"])
def test_records_may_be_lines(end):
    data = usgs_dem()
    text = b"".join(data[i : i + 1024] + end for i in range(0, len(data), 1024))
    assert read_mesh(text, "a.dem").mesh.face_count == KNOWN_CELLS


def changed_dem(place, text):
    data = usgs_dem()
    return data[:place] + text + data[place + len(text) :]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (usgs_dem()[:-1024], "is cut off: promises 4 profiles, but has 3 records"),
        (usgs_dem()[:800], "is cut off, or no USGS DEM: it has 800 bytes"),
        (changed_dem(528, b"     7"), "is no USGS DEM: its units are 7 and 2"),
        (changed_dem(816, b"       0E+00"), "is no USGS DEM: its steps are 0,"),
        (changed_dem(858, b"999999999999"), "is cut off: promises"),
        (changed_dem(1024 + 12, b"999999"), "is cut off: promises 4 profiles, but ends after 0"),
        (changed_dem(1024 + 144, b"  high"), 'has a height "high", which is no number'),
        (changed_dem(1024 + 24, b"0.1E+14".rjust(24)), "has 11 heights for"),
    ],
)
def test_what_is_wrong_with_a_dem_is_told(data, reason):
    assert sentence("a.dem", data).startswith(reason)


def test_without_the_library_a_sentence_names_the_extra(monkeypatch):
    monkeypatch.setitem(sys.modules, "tifffile", None)
    assert 'needs the extra "geotiff"' in sentence("a.tif", b"II*\0" + bytes(100))


def test_a_tiff_with_its_place_is_read(tmp_path):
    tifffile = pytest.importorskip("tifffile")
    tags = [
        (33550, "d", 3, (10.0, 10.0, 0.0), True),
        (33922, "d", 6, (0.0, 0.0, 0.0, 500.0, 300.0, 0.0), True),
        (34735, "H", 8, (1, 1, 0, 1, 1024, 0, 1, 1), True),
        (42113, "s", 0, "-9999", True),
    ]
    values = np.nan_to_num(HEIGHTS, nan=-9999).astype(np.float32)
    tifffile.imwrite(tmp_path / "a.tif", values, extratags=tags)
    read = read_mesh(tmp_path / "a.tif")
    assert read.mesh.vertices.max(axis=0).tolist() == [30.0, 20.0, 9.0]
    assert read.mesh.face_count == KNOWN_CELLS
    assert read.notes[0] == "x and y are counted from the corner at 505, 275"
