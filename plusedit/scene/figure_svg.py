"""Figures as SVG files: as wide as in print, text stays text, shaded surfaces are one image."""

from base64 import b64encode
from collections.abc import Iterable, Sequence

from plusedit.scene.figure import Figure
from plusedit.scene.items import Item, Legend
from plusedit.scene.legends import placed
from plusedit.scene.svg_picture import Drawing, svg_file


def svg_figure(figure: Figure, flat: Sequence[Item], shaded: bytes | None = None) -> bytes:
    """The file of a figure in which these items lie over a PNG image of the whole figure; UTF-8."""
    theme, (left, top, width, height) = figure.form.colors, figure.frame
    extent = f'width="{_number(width)}" height="{_number(height)}"'
    lines: list[str] = []
    draw = Drawing(figure.camera, theme)
    if not figure.form.transparent:
        lines.append(f"<rect {extent} {draw.fill('canvas')}/>")
    if shaded is not None:
        data = b64encode(shaded).decode("ascii")
        across, upwards = (_number(side) for side in figure.shaded_size)
        extent = f'width="{across}" height="{upwards}" preserveAspectRatio="none"'
        lines.append(f'<image {extent} href="data:image/png;base64,{data}"/>')
    moved = f"translate({_number(-left)} {_number(-top)})"
    lines += _group(moved, (part for item in flat for part in draw.elements(item)))
    enlarged = f"scale({figure.form.words:.6f})"
    words = Drawing(figure.label_camera, theme)
    labels = (part for item in figure.labels for part in words.elements(item))
    lines += _group(f"{moved} {enlarged}", labels)
    lines += _group(enlarged, _corners(figure))
    across, upwards = (_number(side) for side in figure.size)
    box = f"0 0 {_number(width)} {_number(height)}"
    return svg_file(f'width="{across}mm" height="{upwards}mm" viewBox="{box}"', lines)


def _corners(figure: Figure) -> Iterable[str]:
    draw = Drawing(figure.corner_camera, figure.form.colors)
    for item in figure.corners:
        if isinstance(item, Legend):
            legend = placed(item, figure.corner_size, 0.0)
            yield from () if legend is None else draw.legend(legend)
        else:
            yield from draw.elements(item)


def _group(transform: str, parts: Iterable[str]) -> Iterable[str]:
    found = list(parts)
    return [f'<g transform="{transform}">', *found, "</g>"] if found else ()


def _number(value: float) -> str:
    text = f"{value:.4f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
