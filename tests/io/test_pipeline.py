"""From files of meshes to surfaces, on real and on damaged ones; skipped where there are none."""

import tracemalloc

import numpy as np
import pytest

from plusedit.__main__ import main
from plusedit.io import mesh_import
from plusedit.io.formats import FormatError
from plusedit.io.mesh_import import ImportOptions, import_mesh
from tests.geometry.mesh.bodies import FACTS
from tests.io.meshes.test_real_meshes import LOADED, files

HARDLY_SMOOTH = {"tm_polygonfaces.obj", "tm_no_indices_3storybuilding.glb"}
"""One polygon that is far from plane, and walls that hang together nowhere"""
LARGE = {"fuji_terrain_rgb.png", "jacksboro_fault_dem.npz", "sainthelens.dem"}
TWICE = "sainthelens_nodata.asc"  # sainthelens.dem once more
"""Terrains that are not measured, which takes longer than all else"""
MOST = 64 << 20  # bytes for a small mesh, which is split into thousands of faces
GOOD = [*files("mesh"), *files("dem")]


@pytest.fixture
def smoothed(monkeypatch, tmp_path, capsys):
    """What `plusedit smooth` imports, prints and writes."""
    imported = []

    def kept(*arguments, **options):
        imported.append(import_mesh(*arguments, **options))
        return imported[-1]

    def run(path, *words):
        out = tmp_path / "smooth.ply"
        code = main(["smooth", str(path), str(out), *words])
        printed = capsys.readouterr()
        return code, printed.out, printed.err, out, imported[-1] if imported else None

    monkeypatch.setattr(mesh_import, "import_mesh", kept)
    return run


def triangles(report):
    return sum((size - 2) * count for size, count in report.faces.items())


def assert_facts_agree(parts, facts):
    """The parts are those that are known of the file."""
    assert len(parts) == facts["components"]
    if facts["nonmanifold_edges"] == 0:
        known = sorted(
            (row["triangles"], row["boundary_loops"], row["genus"]) for row in facts["largest"]
        )
        found = sorted((triangles(part), part.holes, part.handles) for part in parts)
        assert found[-len(known) :] == known


def assert_mapped_well(parts):
    assert sum(part.flips for part in parts if part.handles < 2) == 0
    assert all((part.map_name == "rough_cut") == (part.handles > 1) for part in parts)


@pytest.mark.parametrize("path", [path for path in GOOD if path.id not in LARGE | {TWICE}])
def test_good_meshes_and_terrains_become_surfaces_close_to_them(path, smoothed):
    if "error" in FACTS.get(path.name, {}):
        code, told, complaint, out, _ = smoothed(path)
        assert (code, told, out.exists()) == (2, "", False)
        assert complaint == f"{path.name}: has 5 points but no faces\n"
        return
    code, told, complaint, out, imported = smoothed(path, "--subdivide", "0")
    assert (code, complaint) == (0, "")
    assert told.startswith(imported.report.text)
    assert out.stat().st_size > 100
    parts = [part.report for part in imported.parts]
    assert_mapped_well(parts)
    if path.name in FACTS:
        assert_facts_agree(parts, FACTS[path.name])
    else:
        assert [part.map_name for part in parts] == ["height_field"]
    if path.name not in HARDLY_SMOOTH:
        largest = parts[0].deviation
        assert largest.to_surface.rms < 0.025 * largest.diagonal
        assert largest.to_mesh.rms < 0.025 * largest.diagonal


@pytest.mark.parametrize("path", [path for path in GOOD if path.id in LARGE])
def test_large_terrains_become_surfaces(path):
    (part,) = import_mesh(path).parts
    assert (part.report.map_name, part.report.flips) == ("height_field", 0)
    some = np.arange(0, len(part.surface.mesh.corners), 9_973)
    places = part.surface.mesh.vertices[part.surface.mesh.corners[some]]
    found = part.surface.at(part.surface.parameters[some])
    steepest = np.ptp(part.surface.mesh.vertices[:, 2]) / 10.0
    np.testing.assert_allclose(found, places, atol=steepest)


@pytest.mark.parametrize("path", files("broken"))
def test_damaged_files_become_surfaces_or_one_sentence(path, smoothed):
    fine = path.name in LOADED and path.name != "moebius.obj"
    tracemalloc.start()
    try:
        code, told, complaint, out, imported = smoothed(path, "--subdivide", "0")
    finally:
        _, most = tracemalloc.get_traced_memory()
        tracemalloc.stop()
    assert most < MOST
    assert out.exists() == fine
    if not fine:
        assert (code, told) == (2, "")
        assert complaint.startswith(f"{path.name}: ")
        assert complaint.count("\n") == 1
        return
    assert (code, complaint) == (0, "")
    assert all(note in told for note in (*LOADED[path.name], *imported.report.notes))
    assert imported.report.notes[: len(LOADED[path.name])] == LOADED[path.name]
    assert all(part.report.flips == 0 for part in imported.parts)
    worst = max(part.report.deviation.to_surface.rms for part in imported.parts)
    assert worst < 0.02 * max(part.report.deviation.diagonal for part in imported.parts)


class CanceledError(Exception):
    pass


def test_an_import_tells_what_it_does_and_may_be_canceled_at_every_step():
    path = next(iter(files("mesh"))).values[0]
    if path is None:
        pytest.skip("no real meshes here")
    path = path.with_name("spot_tri_uv.obj")
    steps = []
    import_mesh(
        path, ImportOptions(measure=True), lambda share, words: steps.append((share, words))
    )
    shares = [share for share, _ in steps]
    assert shares == sorted(shares)
    assert (shares[0], shares[-1], steps[-1][1]) == (0.0, 1.0, "Done")
    assert all(words[0].isupper() for _, words in steps)
    assert len(steps) > 12

    for last in range(0, len(steps), 3):
        left = [last]

        def cancel(share, words, left=left):
            if not left[0]:
                raise CanceledError
            left[0] -= 1

        with pytest.raises(CanceledError):
            import_mesh(path, ImportOptions(measure=True), cancel)


def test_a_map_that_is_not_there_is_refused_by_name():
    path = files("broken")[0].values[0]
    if path is None:
        pytest.skip("no data here")
    with pytest.raises(FormatError, match="there is no map 'mercator'; there are circle, "):
        import_mesh(path.with_name("ok_grid.obj"), ImportOptions(map_name="mercator"))
