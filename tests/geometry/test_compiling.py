import ast
import importlib.util

import pytest

compiling = pytest.importorskip("plusedit.geometry.compiling", reason="numba is not installed")

NOT_IN_LOOPS = {"plusedit.geometry", "plusedit.geometry.arrays"}  # types, and the package itself


def sources():
    return {path for pattern in compiling.SOURCES for path in compiling.HERE.glob(pattern)}


def imported_from(path):
    """The modules of the package that a file has something from."""
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module.startswith("plusedit"):
            yield node.module


def test_all_that_loops_are_made_of_decides_where_they_are_kept():
    assert len(sources()) > 10
    for path in sources():
        for module in set(imported_from(path)) - NOT_IN_LOOPS:
            origin = importlib.util.find_spec(module).origin
            assert compiling.HERE / origin in sources(), f"{path.name} imports {module}"


def test_another_number_in_one_file_is_another_folder(tmp_path, monkeypatch):
    constants = tmp_path / "mesh" / "lanes.py"
    constants.parent.mkdir()
    monkeypatch.setattr(compiling, "HERE", tmp_path)
    folders = []
    for text in ("COUNT = 8", "COUNT = 16", "COUNT = 8"):
        constants.write_text(text)
        compiling._folder.cache_clear()
        folders.append(compiling._folder(""))
    compiling._folder.cache_clear()
    assert folders[0] == folders[2] != folders[1]


def test_what_was_kept_of_other_sources_is_gone(tmp_path):
    old, foreign = tmp_path / "plusedit-loops-0123", tmp_path / "others"
    old.mkdir()
    foreign.mkdir()
    compiling._folder.cache_clear()
    found = compiling._folder(str(tmp_path))
    compiling._folder.cache_clear()
    assert found.parent == tmp_path
    assert not old.exists()
    assert foreign.exists()


def test_the_setting_of_others_is_left_as_it_was():
    numba = pytest.importorskip("numba")
    before = numba.config.CACHE_DIR
    compiling.compiled(lambda x: x)
    assert before == numba.config.CACHE_DIR
