"""What the README shows works as it stands there."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

README = (Path(__file__).parents[1] / "README.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```python\n(.*?)^```$", README, re.MULTILINE | re.DOTALL)
ADDITIONS = [block for block in BLOCKS if block.startswith("# plusedit/")]
LIBRARY = [block for block in BLOCKS if block not in ADDITIONS]

CHECKS = {
    "bases": """
import numpy as np
from plusedit.geometry import ControlLines, Grid, PlusCurve
from plusedit.geometry.bases import families
basis = families["hat"].of_size(3)
curve = PlusCurve(basis, ControlLines.of([[0, 0], [1, 2], [3, 2]]), s=0.0)
assert np.allclose(curve.at([0.0, 0.5, 0.75, 1.0]), [[0, 0], [1, 2], [2, 2], [3, 2]])
assert np.allclose(basis.values(np.linspace(0, 1, 9), derivative=1).sum(axis=1), 0)
""",
    "tools": """
from plusedit.document.design import Design
from plusedit.document.shape import Shape
from plusedit.geometry import Bernstein, ControlLines, PlusCurve
from plusedit.interaction.tool import Pointer, Stage, tools
from plusedit.scene.camera import PlaneCamera
curve = PlusCurve(Bernstein(2), ControlLines.of([[0, 0], [1, 0]]))
design = Design().with_shape("a", Shape(curve, "a"))
stage = Stage(design, PlaneCamera((400, 400)))
assert tools["flip"]().click(Pointer(10, 10), stage) is None
after = tools["flip"]().click(Pointer(300, 200), stage).apply(design)
assert after.curve("a").directions[1].tolist() == [-1, 0]
""",
    "overlays": """
from plusedit.document.shape import Shape
from plusedit.geometry import Bernstein, ControlLines, PlusCurve
from plusedit.scene.camera import PlaneCamera
from plusedit.scene.overlays import Seen, overlays
curve = PlusCurve(Bernstein(2), ControlLines.of([[0, 0], [1, 0]]), s=0.0)
(item,) = overlays["steps"].draw(Shape(curve, "a"), curve, Seen(PlaneCamera((400, 400))))
assert len(item.points) == 21
""",
    "formats": """
from plusedit.io.formats import FormatError, formats
loaded = formats["points"].read(b"0 0\\n1 2\\n3 2\\n", "a.xy")
assert len(formats["points"].read(formats["points"].write(loaded.design), "b.xy").design) == 1
for bad in (b"", b"1\\n", b"1 2\\n", b"1 2\\n3\\n", b"x y\\nz w\\n"):
    try:
        formats["points"].read(bad, "a.xy")
    except FormatError:
        continue
    raise AssertionError(bad)
""",
    "exports": """
import io
import numpy as np
from plusedit.geometry import Bernstein
from plusedit.geometry.planes import ControlPlanes
from plusedit.geometry.surface import PlusSurface
from plusedit.io.exports import exports
from plusedit.io.surface_mesh import meshed
planes = ControlPlanes.of([[[x, y, 0] for y in (0, 1)] for x in (0, 1)])
surface = PlusSurface(Bernstein(2), Bernstein(2), planes)
even, stream = np.linspace(0, 1, 4), io.BytesIO()
exports["cloud"].write(stream, [meshed(surface, even, even)], [])
rows = np.loadtxt(stream.getvalue().decode().splitlines())
assert rows.shape == (16, 6) and (rows[:, 3:] == [0, 0, 1]).all()
""",
}


def run(code):
    """What the code prints, in a process of its own: it may put entries on shelves."""
    command = [sys.executable, "-W", "error", "-c", code]
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("block", LIBRARY, ids=["curves", "surfaces", "meshes"])
def test_the_library_prints_what_the_comments_say(block):
    said = re.findall(r"^print\(.*\) +# (.*)$", block, re.MULTILINE)
    assert len(said) == block.count("print(") > 0
    assert run(block).splitlines() == said


@pytest.mark.parametrize("block", ADDITIONS, ids=lambda block: block.splitlines()[0][2:])
def test_a_new_entry_of_a_shelf_works_as_shown(block):
    shelf = Path(block.splitlines()[0]).parent.name
    run(block + CHECKS[shelf])


def test_every_file_that_is_linked_exists():
    for target in re.findall(r"\]\((?!#)([^)]+)\)", README):
        assert (Path(__file__).parents[1] / target).is_file(), target
