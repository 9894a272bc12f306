"""What holds for every mesh format on the shelf."""

import tracemalloc

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plusedit.io.formats import FormatError
from plusedit.io.mesh_reading import read_mesh
from plusedit.io.meshes import meshes
from tests.io.meshes import sample_files

every_format = pytest.mark.parametrize("entry", meshes.values(), ids=list(meshes))
every_sample = pytest.mark.parametrize("name", sample_files.ALL)
PLENTY = 100  # times its size that reading a file may take: a face for every two bytes
FLOOR = 3 << 20  # bytes that reading takes whatever the size
STRANGE = [b"", b"x", b"-1", b"0", b"1e999", b"nan", b"9" * 20, b"\xff\xff\xff\xff", bytes(4)]
OTHERS = {
    "a PNG picture": sample_files.png(np.zeros((2, 2, 1), np.uint8)),
    "a PDF document": b"%PDF-1.7\n",
    "a web page": b"<!DOCTYPE html><html></html>",
    "compressed by gzip": b"\x1f\x8b\x08\0\0\0\0\0",
}


def sentence(name, data):
    """Why the bytes are refused: one line that begins with the name."""
    with pytest.raises(FormatError) as told:
        read_mesh(data, name)
    text = str(told.value)
    assert text.startswith(f"{name}: ")
    assert text.isprintable()
    return text.removeprefix(f"{name}: ")


def read_or_refused(name, data):
    try:
        read_mesh(data, name)
    except FormatError as error:
        assert str(error).startswith(f"{name}: ")
        assert str(error).isprintable()


def test_no_two_formats_share_a_suffix():
    suffixes = [suffix for entry in meshes.values() for suffix in entry.suffixes]
    assert sorted(suffixes) == sorted(set(suffixes))


@every_format
def test_suffixes_are_lower_case_and_begin_with_a_dot(entry):
    assert entry.suffixes
    assert all(suffix[0] == "." and suffix == suffix.lower() for suffix in entry.suffixes)


@every_format
def test_it_has_a_title(entry):
    assert entry.title


@every_format
@pytest.mark.parametrize("data", [b"", b" ", b"\n\n \r\n"])
def test_nothing_is_refused(entry, data):
    assert sentence(f"a{entry.suffixes[0]}", data)


@every_format
@pytest.mark.parametrize("content", OTHERS)
def test_other_kinds_of_files_are_named(entry, content):
    name = f"a{entry.suffixes[0]}"
    if content == "a PNG picture" and ".png" in entry.suffixes:
        pytest.skip("is what it should be")
    assert sentence(name, OTHERS[content]).startswith(f"is {content}, not a")


@every_format
@given(noise=st.binary(max_size=200))
def test_noise_is_refused(entry, noise):
    assert sentence(f"a{entry.suffixes[0]}", noise)


@pytest.mark.parametrize("name", sample_files.MESHES)
def test_the_pyramid_is_read(name):
    read = read_mesh(sample_files.MESHES[name], name)
    faces = [[tuple(read.mesh.vertices[n]) for n in face] for face in read.mesh.faces]
    wanted = [[sample_files.POINTS[n] for n in face] for face in sample_files.FACES]
    only_triangles = name.endswith(("stl", "glb", "gltf"))
    assert faces == (
        [list(map(tuple, t)) for t in sample_files.triangles()] if only_triangles else wanted
    )
    assert read.mesh.vertex_count == 5
    assert read.notes == ()
    assert not read.is_height_field


@pytest.mark.parametrize("name", sample_files.TERRAINS)
def test_the_terrain_is_read(name):
    read = read_mesh(sample_files.TERRAINS[name], name)
    x, y, z = read.mesh.vertices.T
    assert read.is_height_field
    assert x.min() == y.min() == 0.0
    assert (read.mesh.sizes == 4).all()
    assert (read.mesh.area_vectors[:, 2] > 0.0).all()
    north = y == y.max()
    assert z[north][np.argsort(x[north])][:4] * 9.0 / z.max() == pytest.approx([9, 8, 7, 6])
    assert any("no height and" in note for note in read.notes)


@every_sample
def test_reading_twice_gives_the_same(name):
    first, second = (read_mesh(sample_files.ALL[name], name) for _ in range(2))
    np.testing.assert_array_equal(first.mesh.vertices, second.mesh.vertices)
    np.testing.assert_array_equal(first.mesh.corners, second.mesh.corners)
    assert first.notes == second.notes


@every_sample
def test_a_file_is_read_by_its_path(name, tmp_path):
    path = tmp_path / name
    path.write_bytes(sample_files.ALL[name])
    assert read_mesh(path).mesh.face_count == read_mesh(path.read_bytes(), name).mesh.face_count


def test_an_unknown_suffix_is_refused_with_those_that_are_known():
    assert "known are .agr, .asc," in sentence("a.doc", b"abc")


@every_sample
@given(st.data())
def test_truncated_files_are_read_or_refused(name, data):
    whole = sample_files.ALL[name]
    read_or_refused(name, whole[: data.draw(st.integers(0, len(whole) - 1))])


@every_sample
@given(st.data())
def test_flipped_bits_are_read_or_refused(name, data):
    harmed = bytearray(sample_files.ALL[name])
    last = min(len(harmed), 3000) - 1  # what follows in large ones is more of the same
    for _ in range(data.draw(st.integers(1, 3))):
        harmed[data.draw(st.integers(0, last))] ^= 1 << data.draw(st.integers(0, 7))
    read_or_refused(name, bytes(harmed))


@every_sample
@given(st.data())
def test_words_in_place_of_others_are_read_or_refused(name, data):
    whole = sample_files.ALL[name]
    place = data.draw(st.integers(0, min(len(whole), 3000)))
    length = data.draw(st.integers(0, 8))
    word = data.draw(st.sampled_from(STRANGE))
    read_or_refused(name, whole[:place] + word + whole[place + length :])


@every_sample
def test_memory_stays_within_what_the_size_explains(name):
    data = sample_files.ALL[name]
    read_mesh(data, name)  # what is imported is not counted
    tracemalloc.start()
    try:
        read_mesh(data, name)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert most < FLOOR + PLENTY * len(data)
