"""Second derivatives of the sums over planes near a place, in machine code that numba makes.

With z = dG / G, that is z_u = -2 h_u (u - c_u), 2 h_u = 1 / sigma_u^2, the terms of numerator and
denominator are

    (G L)_uu = G ((z_u^2 - 2 h_u) L + 2 z_u A),    (G L)_uv = G (z_u z_v L + z_u B + z_v A).

Imported on request only. The rows of chunks and sums are those of `full_kernels`.
"""

from plusedit.geometry.arrays import Floats
from plusedit.geometry.mesh.compiling import compiled


@compiled
def add_bends(u: float, v: float, chunk: Floats, count: int, shares: Floats, sums: Floats) -> None:
    """sums[12:15] += the second derivatives of w; sums[15:24] += those of the numerator."""
    uu = uv = vv = 0.0
    for j in range(count):
        zu, zv = -2.0 * (u - chunk[0, j]) * chunk[2, j], -2.0 * (v - chunk[1, j]) * chunk[3, j]
        uu += shares[j] * (zu * zu - 2.0 * chunk[2, j])
        uv += shares[j] * (zu * zv)
        vv += shares[j] * (zv * zv - 2.0 * chunk[3, j])
    sums[12] += uu
    sums[13] += uv
    sums[14] += vv
    for c in range(3):
        uu = uv = vv = 0.0
        for j in range(count):
            du, dv, share = u - chunk[0, j], v - chunk[1, j], shares[j]
            zu, zv = -2.0 * du * chunk[2, j], -2.0 * dv * chunk[3, j]
            a, b = chunk[8 + c, j], chunk[11 + c, j]
            plane = chunk[5 + c, j] + du * a + dv * b
            uu += share * ((zu * zu - 2.0 * chunk[2, j]) * plane + 2.0 * zu * a)
            uv += share * (zu * zv * plane + zu * b + zv * a)
            vv += share * ((zv * zv - 2.0 * chunk[3, j]) * plane + 2.0 * zv * b)
        sums[15 + c] += uu
        sums[18 + c] += uv
        sums[21 + c] += vv


@compiled
def divide_bends(sums: Floats, found: Floats) -> None:
    """S_uu = (N_uu - 2 w_u S_u - w_uu S) / w and its like, where S_u and S_v are found."""
    for p in range(len(found)):
        w, wu, wv = sums[p, 0], sums[p, 4], sums[p, 5]
        for c in range(3):
            at, du, dv = sums[p, 1 + c] / w, found[p, 3 + c], found[p, 6 + c]
            found[p, 9 + c] = (sums[p, 15 + c] - 2.0 * wu * du - sums[p, 12] * at) / w
            found[p, 12 + c] = (sums[p, 18 + c] - wu * dv - wv * du - sums[p, 13] * at) / w
            found[p, 15 + c] = (sums[p, 21 + c] - 2.0 * wv * dv - sums[p, 14] * at) / w
