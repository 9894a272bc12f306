"""Meshes and terrains from elsewhere, and files damaged on purpose; skipped where none are."""

import json
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

from plusedit.io.formats import FormatError
from plusedit.io.mesh_reading import read_mesh

FOLDER = Path(__file__).parents[4] / "shared" / "data"
FACTS = FOLDER / "expected_mesh_facts.json"
FACTS_BY_NAME = json.loads(FACTS.read_text()) if FACTS.exists() else {}
FLOOR, PLENTY = 3 << 20, 100

LOADED = {
    "bowtie_vertex.obj": (),
    "duplicate_faces.obj": (),
    "inconsistent_winding.obj": (),
    "inf_vertex.obj": ("3 faces with a vertex that is no finite number were left out",),
    "inf_vertex_bin.ply": ("3 faces with a vertex that is no finite number were left out",),
    "isolated_vertices.obj": ("2 vertices belong to no face",),
    "latin1_name.obj": (),
    "lying_count_small.stl": ("says it has 3 triangles, but 242 were found",),
    "moebius.obj": (),
    "nan_vertex.obj": ("3 faces with a vertex that is no finite number were left out",),
    "nan_vertex.off": ("3 faces with a vertex that is no finite number were left out",),
    "nan_vertex.stl": ("3 faces with a vertex that is no finite number were left out",),
    "nan_vertex_bin.ply": ("3 faces with a vertex that is no finite number were left out",),
    "ngon_concave_star.obj": (),
    "nonmanifold_edge_3faces.obj": (),
    "ok_grid.glb": (),
    "ok_grid.obj": (),
    "ok_grid.off": (),
    "ok_grid.stl": (),
    "ok_grid_ascii.ply": (),
    "ok_grid_bin.ply": (),
    "repeated_vertex_face.obj": ("2 faces with fewer than three different corners were left out",),
    "single_triangle.obj": (),
    "truncated_mid_token.obj": (
        "the last line is not ended: the file may be cut off",
        "1 face with fewer than three different corners was left out",
        "102 vertices belong to no face",
    ),
    "two_components.obj": (),
    "two_vertex_face.obj": ("1 face with fewer than three different corners was left out",),
    "unwelded_soup.obj": (),
    "utf16.obj": (),
    "utf8_bom_crlf.obj": (),
    "uv_index_bad.obj": (
        "all texture coordinates were ignored: 3 corners name some that are not there",
    ),
    "uv_outside_unit.obj": (),
    "uv_partial.obj": ("all texture coordinates were ignored: 3 corners have none",),
}
"""Files among the damaged ones that can be read, with what is said of them"""


def files(folder):
    found = sorted((FOLDER / folder).glob("*")) if FOLDER.exists() else []
    paths = [path for path in found if path.suffix != ".svg"]
    skip = pytest.param(None, marks=pytest.mark.skip(reason="no data here"))
    return [pytest.param(path, id=path.name) for path in paths] or [skip]


@pytest.mark.parametrize("path", files("mesh"))
def test_the_facts_agree(path):
    facts = FACTS_BY_NAME[path.name]
    if "error" in facts:
        with pytest.raises(FormatError, match="has 5 points but no faces"):
            read_mesh(path)
        return
    read = read_mesh(path)
    mesh = read.mesh
    degrees, counts = np.unique(mesh.sizes, return_counts=True)
    assert mesh.vertex_count == facts["vertices"]
    assert int((~mesh.used).sum()) == facts["unreferenced"]
    assert mesh.face_count == facts["polygons"]
    assert dict(zip(map(str, degrees), counts, strict=True)) == facts["by_degree"]
    assert (read.uv is not None) == facts["has_uv"]
    assert len(np.unique(mesh.vertices + 0.0, axis=0)) == facts["distinct_positions"]
    np.testing.assert_allclose(mesh.bounds, facts["bbox"], rtol=1e-6, atol=1e-9)


@pytest.mark.parametrize("path", files("dem"))
def test_terrains_are_read(path):
    read = read_mesh(path)
    assert read.is_height_field
    assert (read.mesh.area_vectors[:, 2] > 0.0).all()


@pytest.mark.skipif(not FOLDER.exists(), reason="no data here")
def test_two_files_of_one_mountain_agree():
    sheet, grid = (
        read_mesh(FOLDER / "dem" / f"sainthelens{end}").mesh for end in (".dem", "_nodata.asc")
    )
    assert sheet.faces == grid.faces
    np.testing.assert_allclose(sheet.vertices, grid.vertices, atol=0.5)


@pytest.mark.parametrize("path", files("broken"))
def test_damaged_files_are_read_or_refused_in_one_sentence(path):
    data = path.read_bytes()
    tracemalloc.start()
    try:
        notes = read_mesh(path).notes
    except FormatError as error:
        assert path.name not in LOADED
        assert str(error).startswith(f"{path.name}: ")
        assert str(error).isprintable()
        assert len(str(error)) < 200
    else:
        assert notes == LOADED[path.name]
    finally:
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert most < FLOOR + PLENTY * len(data)
