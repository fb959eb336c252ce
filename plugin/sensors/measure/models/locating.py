"""The inverse of a model: where a place of the image lies on the ground, at a given height."""
from __future__ import annotations

from typing import Callable

import numpy as np

from ....imagery.errors import SensorModelError
from .. import limits, messages

Map = Callable[[np.ndarray], np.ndarray]


def newton(function: Map, wanted: np.ndarray, start: np.ndarray, step: float = 1e-4, steps: int = 0) -> np.ndarray:
    """Solve ``function(x) = wanted`` for (n, 2) x near ``start``; NaN where it does not converge.

    ``step`` is the difference, in units of x, that derivatives are taken with. With ``steps`` only so many are taken,
    and what they reach is the answer.
    """
    found = np.array(start, float)
    last = np.full(len(found), np.inf)
    for _ in range(steps or limits.MAX_NEWTON_ITERATIONS):
        misfit = wanted - function(found)
        jacobian = np.empty((len(found), 2, 2))
        for axis in (0, 1):
            shift = np.zeros(2)
            shift[axis] = step
            jacobian[:, :, axis] = (function(found + shift) - function(found - shift)) / (2 * step)
        determinant = jacobian[:, 0, 0] * jacobian[:, 1, 1] - jacobian[:, 0, 1] * jacobian[:, 1, 0]
        with np.errstate(all="ignore"):
            change = np.column_stack([
                jacobian[:, 1, 1] * misfit[:, 0] - jacobian[:, 0, 1] * misfit[:, 1],
                jacobian[:, 0, 0] * misfit[:, 1] - jacobian[:, 1, 0] * misfit[:, 0],
            ]) / determinant[:, None]
        found = found + change
        last = np.abs(change).max(axis=1)
        if not np.any(last > step * 1e-6):
            break
    if not steps:
        found[~(last <= step)] = np.nan
    return found


def locate(
    project: Map,
    image: np.ndarray,
    heights: np.ndarray,
    start: np.ndarray,
    metres: tuple[float, float],
    partly: bool = False,
    steps: int = 0,
) -> np.ndarray:
    """Ground coordinates (n, 2) of image points (n, 2) at heights (n,), by Newton's method from ``start`` (n or 1, 2).

    ``project`` takes (n, 3) ground to (n, 2) image; ``metres`` are about those in a unit of x and y. Raises
    SensorModelError where the model can't be inverted; with ``partly`` those places are NaN instead. ``steps`` as in
    ``newton``.
    """
    scale = 1 / np.asarray(metres)

    def seen(units: np.ndarray) -> np.ndarray:
        return project(np.column_stack([start + units * scale, heights]))

    units = newton(seen, image, np.zeros((len(image), 2)), 1.0, steps)
    if not partly and not np.isfinite(units).all():
        raise SensorModelError(messages.NOT_INVERTED())
    return start + units * scale
