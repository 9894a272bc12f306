"""The elimination by blocks against numpy's solution of the whole."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from plusedit.geometry.local_squares import LocalMatrix, normal_solver

WIDTH = 8


def a_matrix(count, *, cyclic, rows=3):
    """Random entries, `rows` rows from every second column on."""
    random = np.random.default_rng(count)
    starts = np.repeat(np.arange(0, count if cyclic else count - WIDTH + 1, 2), rows)
    columns = (starts[:, None] + np.arange(WIDTH)) % count
    return LocalMatrix(columns, random.normal(size=columns.shape), count, cyclic)


def dense(matrix):
    whole = np.zeros((len(matrix.columns), matrix.count))
    for row, (columns, entries) in enumerate(zip(matrix.columns, matrix.entries, strict=True)):
        for column, entry in zip(columns, entries, strict=True):
            whole[row, column] += entry
    return whole


sizes = pytest.mark.parametrize("count", [6, 40, 98, 128, 130, 222])
ways = pytest.mark.parametrize("cyclic", [False, True], ids=["open", "cyclic"])


@sizes
@ways
def test_products_are_those_of_the_dense_matrix(count, cyclic):
    if count < WIDTH and not cyclic:
        return
    matrix, random = a_matrix(count, cyclic=cyclic), np.random.default_rng(0)
    x, y = random.normal(size=(count, 2)), random.normal(size=(len(matrix.columns), 2))
    assert_allclose(matrix @ x, dense(matrix) @ x, atol=1e-12)
    assert_allclose(matrix.transposed_times(y), dense(matrix).T @ y, atol=1e-12)


@sizes
@ways
def test_the_solution_is_that_of_the_dense_matrix(count, cyclic):
    if count < WIDTH and not cyclic:
        return
    matrix = a_matrix(count, cyclic=cyclic)
    expected = np.random.default_rng(1).normal(size=(count, 3))
    normal = dense(matrix).T @ dense(matrix)
    assert_allclose(normal_solver(matrix)(normal @ expected), expected, atol=1e-6)


@ways
def test_unknowns_that_no_row_has_stay_zero(cyclic):
    matrix = a_matrix(150, cyclic=cyclic)
    unused = (matrix.columns >= 60) & (matrix.columns < 64)
    entries = np.where(unused, 0.0, matrix.entries)
    lacking = LocalMatrix(matrix.columns, entries, 150, cyclic)
    solved = normal_solver(lacking)(lacking.transposed_times(np.ones((len(entries), 2))))
    assert_allclose(solved[60:64], 0.0, atol=1e-9)
    assert np.isfinite(solved).all()
