"""The set-up scripts and the program agree on what the system must have."""

import re
from pathlib import Path

from plusedit import machine

SETUP = (Path(__file__).parents[1] / "assets/setup.sh").read_text(encoding="utf-8")


def test_the_scripts_install_every_library_that_the_doctor_looks_for():
    looked_for = {
        library: package
        for value in vars(machine).values()
        if isinstance(value, dict)
        for library, package in value.items()
        if str(library).startswith("lib")
    }
    listed = re.findall(r"^  (lib\S+\.so\.\d+) +(\S+)$", SETUP, re.MULTILINE)
    installed = {library: packages.split(",") for library, packages in listed}
    assert len(looked_for) > 20
    for library, package in looked_for.items():
        assert package in installed[library]


def test_all_tests_that_need_a_screen_are_where_they_are_looked_for():
    here = Path(__file__).parent
    marked = [p for p in here.rglob("test_*.py") if "mark.gl\n" in p.read_text(encoding="utf-8")]
    assert len(marked) > 5
    assert all(path.parent == here / "gl" for path in marked)
