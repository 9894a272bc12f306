import sys

import pytest

from plusedit.geometry import row_products
from plusedit.geometry.mesh import preparation
from plusedit.geometry.mesh.deviation import deviation
from plusedit.geometry.mesh.evaluation import jets, points_and_normals
from plusedit.geometry.mesh.preparation import prepare
from plusedit.geometry.mesh.preview import preview
from tests.geometry.mesh.mesh_surfaces import pillow, torus

KERNELS = "full", "nearest", "preview", "tile"


def compiled_types():
    """For each loop that Python calls the types that it has been compiled for."""
    modules = [sys.modules[f"plusedit.geometry.mesh.{name}_kernels"] for name in KERNELS]
    return {
        loop: tuple(loop.signatures)
        for module in modules
        for loop in vars(module).values()
        if hasattr(loop, "signatures")
    }


def test_no_surface_waits_for_loops_after_it():
    pytest.importorskip("numba")
    prepare()
    before = compiled_types()
    assert any(before.values())
    for surface in (pillow(smoothness=0.3), torus(smoothness=6.0)):
        preview(surface, surface.vertex_places)
        points_and_normals(surface, surface.vertex_places)
        jets(surface, surface.vertex_places, highest=2)
        deviation(surface)
    assert compiled_types() == before


def test_without_numba_there_is_nothing_to_do(monkeypatch):
    monkeypatch.setattr(row_products, "_kernels", None)
    monkeypatch.setitem(sys.modules, "plusedit.geometry.row_kernels", None)
    monkeypatch.setattr(preparation, "preview", None)
    prepare()
