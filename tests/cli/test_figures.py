"""`plusedit render` of figures: sizes in millimeters and points, and what is refused."""

import re

import pytest

from plusedit.__main__ import main
from plusedit.resources import assets
from tests.cli.test_render import rendered

FIGURE = assets() / "examples" / "figure_4.json"


def test_a_pdf_is_made_without_a_display(tmp_path):
    out = tmp_path / "hulls.pdf"
    run = rendered(FIGURE, out, "--width-mm", 120, "--overlay", "nodes")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    data = out.read_bytes()
    (width,) = re.findall(rb"/MediaBox \[0 0 ([0-9.]+)", data)
    assert float(width) * 25.4 / 72.0 == pytest.approx(120.0, abs=0.1)


def test_a_pdf_in_space_is_made_without_a_display(tmp_path):
    out = tmp_path / "nets.pdf"
    run = rendered(assets() / "examples" / "fact_four_nets_of_a_surface.json", out)
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    assert out.read_bytes().count(b"/Subtype /Image") >= 1


def test_svg_and_png_become_figures_by_a_width(qapp, tmp_path):
    out = tmp_path / "hulls.svg"
    assert main(["render", str(FIGURE), str(out), "--width-mm", "85"]) == 0
    assert b'width="85mm"' in out.read_bytes()
    out = tmp_path / "hulls.png"
    assert main(["render", str(FIGURE), str(out), "--width-mm", "85", "--dpi", "600"]) == 0
    assert int.from_bytes(out.read_bytes()[16:20]) == round(85 / 25.4 * 600)


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (["--width-mm", "3"], "The width of a figure is 10 to 2000 mm, not 3"),
        (["--dpi", "9"], "A figure has 30 to 2400 pixels to an inch"),
        (["--smoothness", "1,2"], "a figure shows one smoothness"),
        (["--text-pt", "none"], "expected a number above 0, got 'none'"),
    ],
)
def test_what_can_not_be_is_said_in_a_sentence(qapp, tmp_path, capsys, words, said):
    out = tmp_path / "hulls.pdf"
    assert main(["render", str(FIGURE), str(out), *words]) == 2
    assert said in capsys.readouterr().err
    assert not out.exists()
