"""The second-degree surface around the best pixel and its extremum (Mikrut and Chwastek 2007, formula 2)."""
from __future__ import annotations

import numpy as np

from ...imagery.errors import SeamInspectorError
from . import messages

MIN_CURVATURE = 1e-4  # of a correlation: per px squared; true peaks have 0.005 and more
SURFACE_REACH_PX = 1  # 3 x 3 correlations for six coefficients; wider ones follow grain and scratches more


class SurfaceError(SeamInspectorError):
    """A surface without a usable extremum."""


def fit_surface(values: np.ndarray) -> np.ndarray:
    """a0..a5 of a0 + a1 x + a2 y + a3 x2 + a4 xy + a5 y2 by least squares.

    ``values`` is (2 n + 1, 2 n + 1); x runs to the right and y downwards from its middle, px.
    """
    n = values.shape[0] // 2
    y, x = np.mgrid[-n : n + 1, -n : n + 1].astype(np.float64)
    x, y = x.ravel(), y.ravel()
    terms = np.stack([np.ones_like(x), x, y, x * x, x * y, y * y], axis=1)
    return np.asarray(np.linalg.lstsq(terms, values.ravel().astype(np.float64), rcond=None)[0])


def surface_extremum(coefficients: np.ndarray, reach: float, contrast: float = 1.0) -> tuple[float, float, bool]:
    """x and y where both derivatives vanish, and whether it is a maximum.

    Raises SurfaceError for a saddle, for a surface flatter than ``MIN_CURVATURE`` of the contrast, and for an
    extremum further than ``reach`` from the middle along an axis.
    """
    _, a1, a2, a3, a4, a5 = coefficients
    determinant = 4 * a3 * a5 - a4 * a4
    small, _ = sorted(np.abs(np.linalg.eigvalsh([[2 * a3, a4], [a4, 2 * a5]])))
    if not np.isfinite(small) or small <= MIN_CURVATURE * contrast:
        raise SurfaceError(messages.SURFACE_FLAT())
    if determinant < 0:
        raise SurfaceError(messages.SURFACE_SADDLE())
    x, y = (a4 * a2 - 2 * a5 * a1) / determinant, (a4 * a1 - 2 * a3 * a2) / determinant
    if max(abs(x), abs(y)) > reach:
        raise SurfaceError(messages.SURFACE_OUTSIDE())
    return float(x), float(y), bool(a3 < 0)


def subpixel_maximum(values: np.ndarray, row: int, column: int, reach: int = SURFACE_REACH_PX) -> tuple[float, float]:
    """Column and row of the maximum near a pixel of a field, sub-pixel; the field's pixel (r, c) lies at (c, r).

    Raises SurfaceError where there is none.
    """
    rows, columns = values.shape
    reach = min(reach, row, column, rows - 1 - row, columns - 1 - column)
    if reach < 1:
        raise SurfaceError(messages.SURFACE_OUTSIDE())
    around = values[row - reach : row + reach + 1, column - reach : column + reach + 1]
    x, y, is_maximum = surface_extremum(fit_surface(around), reach)
    if not is_maximum:
        raise SurfaceError(messages.SURFACE_SADDLE())
    return column + x, row + y
