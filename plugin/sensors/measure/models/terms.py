"""The terms of the models' polynomials, in the order of RPC00B."""
from __future__ import annotations

import numpy as np

EXPONENTS_3D = (
    (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1),
    (1, 1, 0), (1, 0, 1), (0, 1, 1), (2, 0, 0), (0, 2, 0), (0, 0, 2),
    (1, 1, 1), (3, 0, 0), (1, 2, 0), (1, 0, 2), (2, 1, 0), (0, 3, 0), (0, 1, 2), (2, 0, 1), (0, 2, 1), (0, 0, 3),
)  # fmt: skip
"""Powers of x (longitude), y (latitude), z (height): 4, 10 and 20 terms make orders 1, 2 and 3."""
EXPONENTS_2D = tuple(powers for powers in EXPONENTS_3D if powers[2] == 0)
COUNT_3D = {1: 4, 2: 10, 3: 20}
COUNT_2D = {1: 3, 2: 6, 3: 10}


def terms_3d(scaled: np.ndarray, order: int) -> np.ndarray:
    """(n, 3) -> (n, 4 | 10 | 20), the constant first."""
    return _terms(scaled, EXPONENTS_3D[: COUNT_3D[order]])


def terms_2d(scaled: np.ndarray, order: int) -> np.ndarray:
    """(n, 2 or more) -> (n, 3 | 6 | 10), the constant first; only x and y count."""
    return _terms(scaled, EXPONENTS_2D[: COUNT_2D[order]])


def _terms(scaled: np.ndarray, exponents: tuple[tuple[int, int, int], ...]) -> np.ndarray:
    columns = []
    for powers in exponents:
        column = np.ones(len(scaled))
        for axis, power in enumerate(powers):
            for _ in range(power):
                column = column * scaled[:, axis]
        columns.append(column)
    return np.column_stack(columns)
