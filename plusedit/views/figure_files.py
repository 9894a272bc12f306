"""Figures as files of every kind: the one place that the dialog and the command line both ask."""

from collections.abc import Callable, Mapping
from types import MappingProxyType

from plusedit.scene.figure import Figure
from plusedit.scene.figure_svg import svg_figure
from plusedit.views.figure_picture import pdf_figure, png_figure
from plusedit.views.picture import png_bytes, running_application
from plusedit.views.space_figure import drawn_figure

USUAL_RESOLUTION = 300.0  # pixels to an inch
RESOLUTIONS = (30.0, 2400.0)
MOST_PIXELS = 120_000_000  # half a gigabyte


def figure_file(figure: Figure, suffix: str, resolution: float, title: str = "") -> bytes:
    """The bytes of a file: ".pdf", ".svg" or ".png".

    `resolution` is that of pixels, and of the image of shaded surfaces in the other two. Needs
    neither a display nor a running application. ValueError, in a sentence, for more pixels than
    there may be; OpenGLError where there is no OpenGL for what is in space.
    """
    check_resolution(figure.form.width, resolution, figure.size[1])
    application = running_application(in_space=figure.space is not None)
    data = _WRITERS[suffix](figure, resolution, title)
    # Fonts and pixels belong to the application: it has to live until here.
    del application
    return data


def check_resolution(width: float, resolution: float, height: float = 0.0) -> None:
    """ValueError, in a sentence, for pixels that are too many or make no sense; millimeters."""
    least, most = RESOLUTIONS
    if not least <= resolution <= most:
        raise ValueError(f"A figure has {least:g} to {most:g} pixels to an inch.")
    across, upwards = (round(side / 25.4 * resolution) for side in (width, height))
    if across * upwards > MOST_PIXELS:
        raise ValueError(
            f"At {resolution:g} pixels to an inch the figure would have {across} by {upwards} "
            f"pixels; {MOST_PIXELS // 1_000_000} million are the most."
        )


def _pdf(figure: Figure, resolution: float, title: str) -> bytes:
    drawn = drawn_figure(figure, resolution)
    return pdf_figure(figure, drawn.flat, drawn.shaded, title=title)


def _svg(figure: Figure, resolution: float, title: str) -> bytes:
    drawn = drawn_figure(figure, resolution)
    shaded = None if drawn.shaded is None else png_bytes(drawn.shaded)
    return svg_figure(figure, drawn.flat, shaded)


def _png(figure: Figure, resolution: float, title: str) -> bytes:
    drawn = drawn_figure(figure, resolution, in_pixels=True)
    return png_figure(figure, drawn.flat, resolution, drawn.shaded)


_WRITERS: Mapping[str, Callable[[Figure, float, str], bytes]] = MappingProxyType(
    {".pdf": _pdf, ".svg": _svg, ".png": _png}
)
SUFFIXES = tuple(_WRITERS)
