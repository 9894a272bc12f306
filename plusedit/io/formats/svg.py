"""Scalable Vector Graphics: drawings of Bezier curves."""

from plusedit.document.design import Design
from plusedit.io.formats import Loaded, register


class Svg:
    """Designs as SVG drawings: curves, colors and widths, but no control lines."""

    title = "Scalable Vector Graphics"
    suffixes = (".svg",)
    keeps_all = False

    def read(self, data: bytes, name: str) -> Loaded:
        """Every segment of every path as one curve, exactly. FormatError if it is no drawing."""
        # Not above: a third of a second that whoever opens a design can do without.
        from plusedit.io.svg_reading import read_svg

        return read_svg(data, name)

    def write(self, design: Design) -> bytes:
        """Its curves seen from above, cubics at most; what has no curve is left out."""
        from plusedit.io.svg_writing import write_svg

        return write_svg(design)


register("svg")(Svg())
