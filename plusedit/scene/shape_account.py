"""What shapes are made of, in words: family, degree, control elements, numbers stored."""

from weakref import WeakKeyDictionary

from plusedit.document.shape import Geometry, PlusGeometry
from plusedit.geometry.bases import Basis
from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline
from plusedit.geometry.curve import PlusCurve
from plusedit.geometry.inflections import inflections
from plusedit.geometry.mesh.mesh_surface import MeshSurface
from plusedit.geometry.storage import storage

HEADS = (
    "Family",
    "Degree, classical",
    "Control elements",
    "Numbers stored",
    "Exactly the same",
    "its degree",
    "its points",
    "its numbers",
    "Inflections",
    "classical ones",
)
HINTS = (
    "By u and by v where both differ",
    "Of the classical shape of the same control points",
    "Control lines, control planes, or faces of a mesh",
    "Coordinates of points and of directions that are given, weights, knots and s",
    "The exact standard form: a classical shape of one degree more",
    "Of the standard form",
    "Of the standard form",
    "Points, weights and knots of the standard form",
    "Where the curve changes from turning left to turning right, or back",
    "Where the curve of the same control points does, s = 0",
)
NONE = "\N{EN DASH}"

_KNOWN: "WeakKeyDictionary[Geometry, tuple[str, ...]]" = WeakKeyDictionary()


def account_of(geometry: Geometry) -> tuple[str, ...]:
    """What a shape is made of, a text for each of the heads; kept for as long as it lives."""
    known = _KNOWN.get(geometry)
    if known is None:
        known = _KNOWN[geometry] = (*_stored(geometry), *_inflections(geometry))
    return known


def family_title(geometry: Geometry) -> str:
    """Such as "B-spline+", "NURBS+" where it has weights, or "B-spline+ × Bézier+"."""
    if isinstance(geometry, MeshSurface):
        return "RaG+ of a mesh"
    is_rational = geometry.net.weight_row is not None
    bases = (geometry.basis,) if isinstance(geometry, PlusCurve) else geometry.bases
    plus = "+" if geometry.s != 0.0 else ""
    titles = [_title(basis, is_rational) + plus for basis in bases]
    return " \N{MULTIPLICATION SIGN} ".join(dict.fromkeys(titles))


def _title(basis: Basis, is_rational: bool) -> str:
    if isinstance(basis, BSpline):
        name = "NURBS" if is_rational else "B-spline"
    elif isinstance(basis, Bernstein):
        name = "rational Bézier" if is_rational else "Bézier"
    else:
        name = "weighted RaG" if is_rational else "RaG"
    return f"closed {name}" if basis.closed else name


def _stored(geometry: Geometry) -> tuple[str, ...]:
    found = storage(geometry)
    form, is_rational = found.form, False
    if not isinstance(geometry, MeshSurface):
        is_rational = geometry.net.weight_row is not None
    same = NONE
    if form is not None and not isinstance(geometry, MeshSurface):
        same = _standard_title(geometry, is_rational)
    elif found.degrees is not None:
        same = "itself"
    return (
        family_title(geometry),
        _degrees(found.degrees),
        f"{found.elements:,}",
        f"{found.numbers:,}",
        same,
        _degrees(None if form is None else form.degrees),
        NONE if form is None else f"{form.points:,}",
        NONE if form is None else f"{form.numbers:,}",
    )


def _standard_title(geometry: PlusGeometry, is_rational: bool) -> str:
    bases = (geometry.basis,) if isinstance(geometry, PlusCurve) else geometry.bases
    if all(isinstance(basis, Bernstein) for basis in bases):
        return "rational Bézier" if is_rational else "Bézier"
    return "NURBS" if is_rational else "B-spline"


def _degrees(degrees: tuple[int, ...] | None) -> str:
    if degrees is None:
        return NONE
    return " \N{MULTIPLICATION SIGN} ".join(map(str, degrees))


def _inflections(geometry: Geometry) -> tuple[str, str]:
    if not isinstance(geometry, PlusCurve) or geometry.dimension != 2:
        return NONE, NONE
    return str(len(inflections(geometry))), str(len(inflections(geometry.classical)))
