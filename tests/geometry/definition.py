"""Plus curves and surfaces by the book, in forty digits: the oracle for what is computed fast.

A jet is the list [f, f', f'' / 2] of Taylor coefficients of a function of u.
"""

from mpmath import binomial, exp, mp, mpf

from plusedit.geometry.bases.bernstein import Bernstein
from plusedit.geometry.bases.bspline import BSpline

mp.dps = 40
FAR = 30  # in sigma: exp(-450) is not seen in forty digits
ZERO = [mpf(0)] * 3
ORDERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))


def plus(a, b):
    return [x + y for x, y in zip(a, b, strict=True)]


def times(a, b):
    return [sum(a[j] * b[i - j] for j in range(i + 1)) for i in range(3)]


def over(a, b):
    first = a[0] / b[0]
    second = (a[1] - first * b[1]) / b[0]
    return [first, second, (a[2] - first * b[2] - second * b[1]) / b[0]]


def power(a, slope, exponent):
    """The power of a linear function with value a and that slope."""
    jet = [a**exponent, mpf(0), mpf(0)]
    if exponent >= 1:
        jet[1] = exponent * slope * a ** (exponent - 1)
    if exponent >= 2:
        jet[2] = exponent * (exponent - 1) * slope**2 * a ** (exponent - 2) / 2
    return jet


def line(point, gradient, away):
    """P + (u - x) g, one coordinate, where u - x is `away`."""
    return [mpf(point) + away * mpf(gradient), mpf(gradient), mpf(0)]


def b_spline(t, u):
    """The B-spline of the knots t, right-sided; at the end of the domain the last span counts."""
    if not t[0] <= u <= t[-1] or t[0] == t[-1]:
        return ZERO
    if len(t) == 2:
        holds = t[0] <= u < t[1] or (u == t[1] == 1)
        return [mpf(1), mpf(0), mpf(0)] if holds else ZERO
    total = ZERO
    if t[-2] > t[0]:
        rise = [(u - t[0]) / (t[-2] - t[0]), 1 / (t[-2] - t[0]), mpf(0)]
        total = plus(total, times(rise, b_spline(t[:-1], u)))
    if t[-1] > t[1]:
        fall = [(t[-1] - u) / (t[-1] - t[1]), -1 / (t[-1] - t[1]), mpf(0)]
        total = plus(total, times(fall, b_spline(t[1:], u)))
    return total


def gaussian(away, sigma):
    """exp(-(u - x)^2 / (2 sigma^2))"""
    z, rate = -away / sigma**2, 1 / sigma**2
    return [g * exp(-((away / sigma) ** 2) / 2) for g in (mpf(1), z, (z**2 - rate) / 2)]


def terms(basis, u):
    """For every image of every line its number, u - x_i - m and its function, not normalized."""
    n = basis.size
    if isinstance(basis, Bernstein):
        for i in range(n):
            bump = times(power(u, 1, i), power(1 - u, -1, n - 1 - i))
            yield i, u - mpf(i) / (n - 1), times([binomial(n - 1, i), mpf(0), mpf(0)], bump)
    elif isinstance(basis, BSpline) and basis.closed:
        k = basis.order
        for i in range(-k * n, (k + 1) * n):
            knots = [(mpf(i + r) - mpf(k) / 2) / n for r in range(k + 1)]
            if knots[0] <= u < knots[-1]:
                yield i % n, u - mpf(i) / n, b_spline(knots, u)
    elif isinstance(basis, BSpline):
        t, k = [mpf(float(knot)) for knot in basis.knot_vector], basis.order
        for i in range(n):
            if t[i] <= u <= t[i + k]:
                node = sum(t[i + 1 : i + k]) / (k - 1)
                yield i, u - node, b_spline(t[i : i + k + 1], u)
    else:
        widths = basis.sigma if isinstance(basis.sigma, tuple) else [basis.sigma] * n
        for i, (node, width) in enumerate(zip(basis.nodes, widths, strict=True)):
            for image in range(-12, 13) if basis.closed else (0,):
                away = u - mpf(float(node)) - image
                if basis.closed and abs(away) > FAR * width:
                    continue
                yield i, away, gaussian(away, mpf(float(width)))


def definition(curve, u):
    """C(u), C'(u) and C''(u) as lists of forty-digit numbers."""
    lines, directions, u = curve.lines, curve.directions, mpf(float(u))
    top, below = [ZERO] * curve.dimension, ZERO
    for i, away, function in terms(curve.basis, u):
        weight = mpf(1) if lines.weights is None else mpf(float(lines.weights[i]))
        share = [weight * f for f in function]
        below = plus(below, share)
        for axis in range(curve.dimension):
            gradient = mpf(curve.s) * mpf(float(directions[i, axis]))
            moved = line(float(lines.points[i, axis]), gradient, away)
            top[axis] = plus(top[axis], times(moved, share))
    jets = [over(coordinate, below) for coordinate in top]
    return [jet[0] for jet in jets], [jet[1] for jet in jets], [2 * jet[2] for jet in jets]


def surface_definition(surface, u, v):
    """S, S_u, S_v, S_uu, S_uv and S_vv at one place, as lists of forty-digit numbers."""
    along_u, along_v = surface.gradients
    weights = surface.planes.unit_weights
    top = {order: [mpf(0)] * 3 for order in ORDERS}
    below = dict.fromkeys(ORDERS, mpf(0))
    by_v = [(j, away, _derivatives(c)) for j, away, c in terms(surface.basis_v, mpf(float(v)))]
    for i, away_u, b in terms(surface.basis_u, mpf(float(u))):
        for j, away_v, c in by_v:
            bump = _product(_derivatives(b), c, mpf(float(weights[i, j])))
            below = {order: below[order] + bump[order] for order in ORDERS}
            for axis in range(3):
                g, h = mpf(along_u[i, j, axis]), mpf(along_v[i, j, axis])
                plane = mpf(surface.planes.points[i, j, axis]) + away_u * g + away_v * h
                for order, value in _on_plane(plane, g, h, bump).items():
                    top[order][axis] += value
    return _quotients(top, below)


def _derivatives(jet):
    return jet[0], jet[1], 2 * jet[2]


def _product(b, c, weight):
    """The derivatives of w b(u) c(v)."""
    return {(r, q): weight * b[r] * c[q] for r, q in ORDERS}


def _on_plane(plane, g, h, f):
    """The derivatives of L f, where L has the derivatives g and h and no more."""
    return {
        (0, 0): plane * f[0, 0],
        (1, 0): plane * f[1, 0] + g * f[0, 0],
        (0, 1): plane * f[0, 1] + h * f[0, 0],
        (2, 0): plane * f[2, 0] + 2 * g * f[1, 0],
        (1, 1): plane * f[1, 1] + g * f[0, 1] + h * f[1, 0],
        (0, 2): plane * f[0, 2] + 2 * h * f[0, 1],
    }


def _quotients(a, w):
    """The derivatives of A / w."""
    found = []
    for x in range(3):
        s = a[0, 0][x] / w[0, 0]
        s_u = (a[1, 0][x] - w[1, 0] * s) / w[0, 0]
        s_v = (a[0, 1][x] - w[0, 1] * s) / w[0, 0]
        s_uu = (a[2, 0][x] - 2 * w[1, 0] * s_u - w[2, 0] * s) / w[0, 0]
        s_uv = (a[1, 1][x] - w[1, 0] * s_v - w[0, 1] * s_u - w[1, 1] * s) / w[0, 0]
        s_vv = (a[0, 2][x] - 2 * w[0, 1] * s_v - w[0, 2] * s) / w[0, 0]
        found.append((s, s_u, s_v, s_uu, s_uv, s_vv))
    return [list(column) for column in zip(*found, strict=True)]
