"""What points up in the file of a mesh points up here."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.io.mesh_import import ImportOptions, import_mesh, smoothed
from plusedit.io.mesh_reading import read_mesh

ROOF = b"v 0 0 0\nv 2 0 0\nv 2 5 1\nv 0 5 1\nf 1 2 3 4\n"
"""A quad that is 2 wide, 5 high and 1 deep where y points up."""


def extents(imported):
    low, high = imported.parts[0].surface.mesh.bounds
    return (high - low).tolist()


@pytest.mark.parametrize(("up", "wanted"), [(None, [2, 5, 1]), ("z", [2, 5, 1]), ("y", [2, 1, 5])])
def test_a_mesh_is_turned_only_where_that_is_asked_for(up, wanted):
    read = read_mesh(ROOF, "roof.obj")
    assert extents(smoothed(read, "roof.obj", ImportOptions(up=up))) == wanted


def test_a_turned_mesh_is_not_mirrored():
    read = read_mesh(ROOF, "roof.obj")
    before, after = (each.mesh.area_vectors[0] for each in (read, read.upright("y")))
    assert_allclose(after, [before[0], -before[2], before[1]])
    assert read.upright("y").upright() is not read
    assert read.upright() is read


def test_a_design_that_is_exported_as_glb_comes_back_as_it_stood(tmp_path):
    from plusedit.io.exporting import export_design

    path, out = tmp_path / "roof.obj", tmp_path / "roof.glb"
    path.write_bytes(ROOF)
    imported = import_mesh(path, ImportOptions(smoothness=0.25))
    export_design(imported.design, out)
    again = extents(import_mesh(out))
    assert_allclose(again, extents(imported), rtol=1e-5, atol=1e-5)
    lying = extents(import_mesh(out, ImportOptions(up="z")))
    assert_allclose(lying, np.array(again)[[0, 2, 1]], atol=1e-12)
