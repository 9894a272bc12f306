"""Heights in pictures, and the pictures themselves."""

import numpy as np
import pytest

from plusedit.io.mesh_reading import read_mesh
from plusedit.io.png_reading import read_png
from tests.io.meshes.sample_files import height_picture, png, png_part
from tests.io.meshes.test_mesh_format_contract import sentence


@pytest.mark.parametrize("filters", [(0,), (1,), (2,), (3,), (4,), (4, 3, 2, 1, 0), (1, 4)])
@pytest.mark.parametrize("channels", [1, 2, 3, 4])
@pytest.mark.parametrize("kind", [np.uint8, np.uint16])
def test_pictures_come_out_as_they_went_in(filters, channels, kind):
    rng = np.random.default_rng(channels)
    pixels = rng.integers(0, np.iinfo(kind).max, (7, 5, channels), dtype=kind)
    found = read_png(png(pixels, filters=filters))
    np.testing.assert_array_equal(found.pixels, pixels)
    assert found.has_alpha == (channels in (2, 4))


@pytest.mark.parametrize("shape", [(1, 1), (1, 6), (6, 1)])
def test_pictures_may_be_thin(shape):
    pixels = np.random.default_rng(4).integers(0, 255, (*shape, 1), dtype=np.uint8)
    np.testing.assert_array_equal(read_png(png(pixels, filters=(4, 3))).pixels, pixels)


def test_colors_may_be_heights():
    meters = np.array([[0.0, 100.5], [3776.2, -20.0]])
    code = np.rint((meters + 10000.0) * 10.0).astype(int)
    pixels = np.stack([code >> 16, code >> 8 & 255, code & 255], axis=2).astype(np.uint8)
    found = read_mesh(png(pixels), "a.png").mesh.vertices[:, 2]
    assert sorted(found) == pytest.approx(sorted(meters.ravel()))


def test_colors_of_terrarium_are_heights():
    x, y = np.meshgrid(np.linspace(0.0, 900.0, 20), np.linspace(0.0, 300.0, 20))
    code = np.rint((x + y + 32768.0) * 256.0).astype(int)
    pixels = np.stack([code >> 16, code >> 8 & 255, code & 255], axis=2).astype(np.uint8)
    read = read_mesh(png(pixels), "a.png")
    assert read.mesh.bounds[1][2] == pytest.approx(1200.0)


def test_photographs_are_refused():
    pixels = np.random.default_rng(5).integers(0, 255, (30, 30, 3), dtype=np.uint8)
    assert "is a picture in color" in sentence("a.png", png(pixels))


def test_eight_bits_of_gray_are_coarse():
    pixels = np.arange(12, dtype=np.uint8).reshape(3, 4, 1)
    assert any("8 bits" in note for note in read_mesh(png(pixels), "a.png").notes)


def changed_header(**changes):
    names = ("width", "height", "bits", "color", "packing", "filter", "interlaced")
    values = dict(zip(names, (4, 3, 16, 4, 0, 0, 0), strict=True)) | changes
    head = b"".join(values[name].to_bytes(4 if name in names[:2] else 1, "big") for name in names)
    data = height_picture()
    return data[:8] + png_part(b"IHDR", head) + data[33:]


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (changed_header(width=0), "has 0 × 3 pixels"),
        (changed_header(width=40_000, height=40_000), "has 40000 × 40000 pixels; that"),
        (changed_header(width=8000, height=8000), "is cut off: promises 8000 × 8000 pixels"),
        (changed_header(width=5), "is cut off: promises 5 × 3 pixels, but has 51 bytes of them"),
        (changed_header(bits=4), "has 4 bits a color; heights need 16, or 8"),
        (changed_header(color=3), "has colors of a palette"),
        (changed_header(interlaced=1), "is interlaced"),
        (height_picture()[:-12], "is cut off: its end is missing"),
        (height_picture()[:-20], "is cut off: its last part is not whole"),
        (height_picture().replace(b"IDAT", b"IDAU"), "is damaged: a check sum is wrong"),
    ],
)
def test_what_is_wrong_with_a_picture_is_told(data, reason):
    assert sentence("a.png", data).startswith(reason)
