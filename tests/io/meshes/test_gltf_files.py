"""What stands in glTF documents, and what is wrong with some."""

import json
import os

import numpy as np
import pytest

from plusedit.io.formats import FormatError
from plusedit.io.mesh_reading import read_mesh
from tests.io.meshes.sample_files import FACES, POINTS, UV, glb, gltf, gltf_parts
from tests.io.meshes.test_mesh_format_contract import sentence


def read(**changes):
    return read_mesh(gltf(**changes), "a.gltf")


def why(data=None, **changes):
    return sentence("a.gltf", gltf(**changes) if data is None else data)


def with_accessor(number, **changes):
    accessors = gltf_parts()[0]["accessors"]
    accessors[number] |= changes
    return accessors


def with_primitive(**changes):
    primitive = {"attributes": {"POSITION": 0}, "indices": 2, **changes}
    return [{"primitives": [primitive]}]


def nodes(*found, roots=(0,)):
    return {"nodes": list(found), "scenes": [{"nodes": list(roots)}]}


def test_texture_coordinates_point_upwards():
    fan = [(f[0], f[i], f[i + 1]) for f in FACES for i in range(1, len(f) - 1)]
    expected = [(UV[n][0], 1.0 - UV[n][1]) for corners in fan for n in corners]
    np.testing.assert_array_equal(read().uv, expected)


def test_meshes_with_names_are_groups():
    assert {name: len(faces) for name, faces in read().groups.items()} == {"Pyramid": 6}


@pytest.mark.parametrize(
    ("node", "moved"),
    [
        ({"translation": [1, 2, 3]}, lambda p: p + np.array([1, 2, 3])),
        ({"scale": [1, 2, 3]}, lambda p: p * [1, 2, 3]),
        ({"rotation": [0, 0, 1, 0]}, lambda p: p * [-1, -1, 1]),
        ({"matrix": [0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1]},
         lambda p: p[:, [1, 0, 2]] * [-1, 1, 1] + [5, 0, 0]),
    ],
)  # fmt: skip
def test_nodes_put_meshes_in_place(node, moved):
    outer = {"children": [1], "translation": [0, 0, 10]}
    found = read(**nodes(outer, {"mesh": 0, **node})).mesh.vertices
    np.testing.assert_allclose(found, moved(np.array(POINTS)) + np.array([0, 0, 10]), atol=1e-12)


def test_a_mirror_turns_faces_around():
    plain, mirrored = read().mesh, read(**nodes({"mesh": 0, "scale": [-1, 1, 1]})).mesh
    np.testing.assert_allclose(mirrored.area_vectors, plain.area_vectors * [-1, 1, 1])


def test_a_mesh_may_stand_in_two_places():
    found = read(**nodes({"mesh": 0}, {"mesh": 0, "translation": [9, 0, 0]}, roots=(0, 1)))
    assert found.mesh.face_count == 12


def test_without_nodes_all_meshes_are_read():
    assert read(nodes=[], scenes=[]).mesh.face_count == 6


@pytest.mark.parametrize(
    ("mode", "faces"),
    [(5, [(0, 1, 2), (1, 3, 2), (2, 3, 4)]), (6, [(0, 1, 2), (0, 2, 3), (0, 3, 4)])],
)
def test_strips_and_fans_are_triangles(mode, faces):
    meshes = [{"primitives": [{"attributes": {"POSITION": 0}, "mode": mode}]}]
    assert read(meshes=meshes).mesh.faces == faces


def test_parts_of_lines_are_left_out():
    attributes = {"attributes": {"POSITION": 0}}
    meshes = [{"primitives": [{**attributes, "mode": 1}, {**attributes, "indices": 2}]}]
    assert read(meshes=meshes).notes == ("1 part of points or lines was left out",)


def test_whole_numbers_may_stand_for_shares():
    accessors = with_accessor(1, componentType=5123, normalized=True)
    uv = read(accessors=accessors).uv
    assert uv.min() >= 0.0
    assert uv.max() <= 1.0


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"asset": {"version": "1.0"}}, 'is glTF of version "1.0"; version 2 is read'),
        ({"asset": []}, "asset: expected an object, got a list of 0"),
        ({"meshes": []}, "meshes: there is no entry 0"),
        ({"scene": 7}, "scenes: there is no entry 7"),
        (nodes({"children": [1]}, {"children": [0]}), "nodes 0: stands in more than one place"),
        (nodes({"mesh": 0, "rotation": [0, 0, 0, 0]}), "nodes 0: rotation has not length one"),
        (nodes({"mesh": 0, "matrix": [1]}), "nodes 0: matrix has 1 number, expected 16"),
        ({"accessors": with_accessor(0, count=4_000_000_000)},
         "accessors 0: promises 4000000000 entries, more than its 60 bytes hold"),
        ({"accessors": with_accessor(0, count=-1)}, "accessors 0: count is -1, below zero"),
        ({"accessors": with_accessor(0, type="VEC9")}, 'accessors 0: expected VEC3, got "VEC9"'),
        ({"accessors": with_accessor(0, componentType=1)}, "accessors 0: componentType 1 is none"),
        ({"accessors": with_accessor(0, sparse={})}, "accessors 0: is sparse, which is not read"),
        ({"accessors": with_accessor(0, count=4)},
         "meshes 0: primitives 0: names vertex 4, but there are 4, numbered from 0"),
        ({"accessors": with_accessor(2, count=17)},
         "meshes 0: primitives 0: 17 corners make no whole triangles"),
        ({"meshes": with_primitive(attributes={})}, "meshes 0: primitives 0: has no positions"),
        ({"meshes": with_primitive(extensions={"KHR_draco_mesh_compression": {}})},
         "meshes 0: primitives 0: is compressed (KHR_draco_mesh_compression), which is not read"),
        ({"bufferViews": [{"buffer": 0, "byteLength": 10**9}]},
         "bufferViews 0: ends at byte 1000000000 of a buffer of 136 bytes"),
        ({"buffers": [{"byteLength": 1, "uri": "data:;base64,!"}]},
         "buffers 0: its base64 is damaged"),
        ({"buffers": [{"byteLength": 99, "uri": "data:;base64,AAAA"}]},
         "buffers 0: promises 99 bytes, but 3 are there"),
        ({"buffers": [{"byteLength": 1}]}, "buffers 0: has no data"),
        ({"meshes": with_primitive(mode=1)},
         "has neither points nor faces"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_told(changes, reason):
    assert why(**changes) == reason


@pytest.mark.parametrize(
    "uri",
    ["../a.bin", "%2e%2e/a.bin", "/etc/passwd", "sub/a.bin", "..\\a.bin", "C:a.bin", "..", "",
     "http://example.com/a.bin", "file:///etc/passwd", "a%00.bin"],
)  # fmt: skip
def test_files_elsewhere_are_not_opened(uri, tmp_path):
    folder = tmp_path / "sub"
    folder.mkdir()
    path = folder / "a.gltf"
    path.write_bytes(gltf(buffers=[{"byteLength": 136, "uri": uri}]))
    (tmp_path / "a.bin").write_bytes(gltf_parts()[1])
    with pytest.raises(FormatError, match="only files beside it are read"):
        read_mesh(path)


def test_a_file_beside_the_document_is_read(tmp_path):
    path = tmp_path / "a.gltf"
    path.write_bytes(gltf(buffers=[{"byteLength": 136, "uri": "side%20by%20side.bin"}]))
    with pytest.raises(FormatError, match="there is no such file"):
        read_mesh(path)
    (tmp_path / "side by side.bin").write_bytes(gltf_parts()[1])
    assert read_mesh(path).mesh.face_count == 6


@pytest.mark.skipif(os.name == "nt", reason="links need rights there")
def test_a_link_that_leads_elsewhere_is_not_followed(tmp_path):
    folder = tmp_path / "sub"
    folder.mkdir()
    (tmp_path / "a.bin").write_bytes(gltf_parts()[1])
    (folder / "a.bin").symlink_to(tmp_path / "a.bin")
    (folder / "a.gltf").write_bytes(gltf(buffers=[{"byteLength": 136, "uri": "a.bin"}]))
    with pytest.raises(FormatError, match="is a link that leads elsewhere"):
        read_mesh(folder / "a.gltf")


def test_from_memory_no_other_file_is_read():
    changes = {"buffers": [{"byteLength": 136, "uri": "a.bin"}]}
    assert why(**changes) == 'its data are in another file, "a.bin", which was not given'


def test_copies_without_end_are_refused():
    many = 100_000
    found = nodes(*[{"mesh": 0}] * many, roots=tuple(range(many)))
    assert why(**found) == "repeats its meshes so often that they can't be read"


@pytest.mark.parametrize(
    ("place", "value", "reason"),
    [
        (4, 1, "is glTF of version 1; version 2 is read"),
        (8, 10**6, "is cut off: promises 1000000 bytes"),
        (12, 10**6, "promises a part of 1000000 bytes"),
        (16, 0, "has no document within"),
    ],
)
def test_a_wrong_head_of_a_glb_file_is_told(place, value, reason):
    data = bytearray(glb())
    data[place : place + 4] = value.to_bytes(4, "little")
    assert sentence("a.glb", bytes(data)).startswith(reason)


def test_json_that_means_harm_is_refused():
    assert why(b'{"asset": ' + b"[" * 100_000) == "is nested too deeply"
    document, raw = gltf_parts()
    text = json.dumps(document).replace('"count": 5', '"count": 1e999')
    assert "count" in sentence("a.glb", glb(json.loads(text), raw))
