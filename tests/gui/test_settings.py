"""What is remembered between runs."""

from pathlib import Path

import pytest

from plusedit.app.settings import MOST_RECENT, Settings
from plusedit.interaction.tool import NewCurves

pytestmark = pytest.mark.gui


@pytest.fixture
def path(tmp_path):
    return tmp_path / "settings.ini"


def test_what_is_set_is_there_in_the_next_run(path):
    first = Settings(path)
    first.look, first.grid_step = "dark", 0.25
    first.new_curves = NewCurves("rag", 3, True)
    first.shortcuts = {"save": ["F5"]}
    first.remember_file(Path("/tmp/a.json"))
    first.sync()
    again = Settings(path)
    assert (again.look, again.grid_step) == ("dark", 0.25)
    assert again.new_curves == NewCurves("rag", 3, True)
    assert again.shortcuts == {"save": ["F5"]}
    assert again.recent == [Path("/tmp/a.json")]


GARBAGE = [
    "\x00\xff not ini at all [",
    "[General]\nlook=pink\ngrid_step=-3\nnew_curves={\nrecent=[1,2]\nshortcuts=7\nview=null\n",
    '[General]\ngrid_step=nan\nnew_curves={"family": 3, "order": "x"}\nrecent={"paths": [1, ""]}\n'
    'shortcuts={"save": "F5"}\ngeometry=12\n',
]


@pytest.mark.parametrize("garbage", GARBAGE, ids=["noise", "wrong", "nearly"])
def test_garbage_reads_as_if_nothing_was_set(path, garbage):
    path.write_text(garbage, encoding="utf-8", errors="surrogateescape")
    settings, usual = Settings(path), Settings(path.with_name("none.ini"))
    assert settings.look == usual.look == "system"
    assert settings.grid_step is usual.grid_step is None
    assert settings.new_curves == usual.new_curves == NewCurves()
    assert settings.recent == usual.recent == []
    assert settings.shortcuts == usual.shortcuts == {}
    assert settings.view == usual.view == {}
    assert settings.bytes_of("geometry").isEmpty()


def test_the_file_used_last_comes_first_and_the_oldest_goes(path):
    settings = Settings(path)
    for number in range(MOST_RECENT + 2):
        settings.remember_file(Path(f"/tmp/{number}.json"))
    settings.remember_file(Path("/tmp/5.json"))
    names = [path.stem for path in settings.recent]
    assert names[:2] == ["5", "11"]
    assert len(names) == len(set(names)) == MOST_RECENT
