"""SVG drawings for the tests, and a reader of them that is not ours."""

from io import BytesIO
from pathlib import Path

import numpy as np
import pytest
import svgelements

from plusedit.geometry.bases.bernstein import bernstein

FOLDER = Path(__file__).parents[2].parent / "shared" / "data"
FILES = sorted(FOLDER.glob("curves/*.svg")) if FOLDER.is_dir() else []

every_file = pytest.mark.parametrize(
    "file",
    FILES or [pytest.param(None, marks=pytest.mark.skip(reason="no real drawings here"))],
    ids=lambda file: getattr(file, "stem", "none"),
)


def svg(*lines, attributes='viewBox="0 0 100 100"'):
    """The bytes of a drawing with those elements."""
    space = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'
    return f"<svg {space} {attributes}>{''.join(lines)}</svg>".encode()


def path_svg(data, attributes='stroke="black" fill="none"'):
    """The bytes of a drawing of one path."""
    return svg(f'<path d="{data}" {attributes}/>')


def segments_by_another_reader(data):
    """Every segment that draws something, path by path, in pixels with y down."""
    document = svgelements.SVG.parse(BytesIO(data), parse_display_none=True, reify=False)
    shapes = [e for e in document.elements() if isinstance(e, svgelements.Shape)]
    paths = [[s for s in shape.segments(transformed=True) if draws(s)] for shape in shapes]
    return [path for path in paths if path]


def draws(segment):
    """Whether a segment of svgelements leaves a trace."""
    if isinstance(segment, svgelements.Move):
        return False
    return np.ptp(samples(segment, 9), axis=0).max() > 1e-9


def samples(segment, count=33):
    """(count, 2) points of a segment of svgelements."""
    return np.array([tuple(segment.point(t)) for t in np.linspace(0.0, 1.0, count)])


def cubic(segment):
    """(4, 2) Bezier points of a line, quadratic or cubic of svgelements."""
    names = {"Line": "", "Close": "", "QuadraticBezier": "control", "CubicBezier": "control1"}
    points = [segment.start, segment.end]
    kind = names[type(segment).__name__]
    if kind == "control":
        points.insert(1, segment.control)
    elif kind == "control1":
        points[1:1] = [segment.control1, segment.control2]
    rows = np.array([tuple(p) for p in points])
    while len(rows) < 4:
        n = len(rows)
        share = np.arange(1, n)[:, None] / n
        rows = np.vstack([rows[:1], share * rows[:-1] + (1 - share) * rows[1:], rows[-1:]])
    return rows


def distances(points, cubics):
    """(m,) how far points (m, 2) lie from the nearest of cubics (k, 4, 2)."""
    t = np.linspace(0.0, 1.0, 33)
    near = np.einsum("tk,ckd->ctd", bernstein(t, 3), cubics)
    steps = np.linalg.norm(np.diff(near, axis=1), axis=2)
    reach = np.maximum(np.pad(steps, ((0, 0), (1, 0))), np.pad(steps, ((0, 0), (0, 1))))
    found = np.full(len(points), np.inf)
    for row, point in enumerate(points):
        away = np.linalg.norm(point - near, axis=2)
        piece, number = np.nonzero(away - reach <= away.min())
        piece, start = cubics[piece], t[number]
        at = start
        for _ in range(8):
            gap = point - along(piece, at, 3)
            found[row] = min(found[row], np.linalg.norm(gap, axis=1).min())
            speed = along(3.0 * np.diff(piece, axis=1), at, 2)
            step = (gap * speed).sum(axis=1) / np.maximum((speed * speed).sum(axis=1), 1e-300)
            at = np.clip(at + np.clip(step, -0.02, 0.02), start - 0.032, start + 0.032)
            at = np.clip(at, 0.0, 1.0)
    return found


def along(pieces, at, degree):
    """(m, 2) points of Bezier curves (m, degree + 1, 2), each at its own parameter."""
    return np.einsum("mk,mkd->md", bernstein(at, degree), pieces)


def length(path):
    """The length of all segments of a path, roughly."""
    steps = [np.diff(samples(segment, 17), axis=0) for segment in path]
    return sum(np.linalg.norm(step, axis=1).sum() for step in steps)


def curves_of(design):
    """The curves of a design, in order."""
    return [curve for _, curve in design.curves()]
