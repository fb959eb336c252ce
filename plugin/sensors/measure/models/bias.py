"""A vendor's RPC, corrected in the image by a few control points."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from .least_squares import Scaling, least_squares
from .rational import Rational
from .sensor_model import Fit

SHIFT, DRIFT, AFFINE = "shift", "shift_drift", "affine"
FEWEST = {SHIFT: 1, DRIFT: 2, AFFINE: 3}
UNKNOWNS = {SHIFT: 2, DRIFT: 3, AFFINE: 6}
_Used = tuple[int, ...]
_TRIALS: dict[str, tuple[tuple[_Used, _Used], ...]] = {
    SHIFT: (((0,), (0,)),),
    DRIFT: (((0, 2), (0,)), ((0,), (0, 2))),
    AFFINE: (((0, 1, 2), (0, 1, 2)),),
}
"""Which of constant, column and row the corrections of column and row use; of several the one that fits best."""


@dataclass(frozen=True)
class BiasedRpc:
    """An RPC plus a correction in the image, linear in its column and row.

    Source: J. Grodecki and G. Dial, Block adjustment of high-resolution satellite images described by rational
    polynomials, 2003.
    """

    GEOGRAPHIC: ClassVar[bool] = True

    rpc: Rational
    correction: np.ndarray
    """(3, 2) px: constant, per scaled column, per scaled row; of column and row."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        seen = self.rpc.project(ground)
        return seen + _linear(self.rpc.image, seen) @ self.correction


def fit_bias(rpc: Rational, ground: np.ndarray, image: np.ndarray, weights: np.ndarray, kind: str) -> Fit:
    """Fit the correction: ``ground`` (n, 3) longitude, latitude, ellipsoidal height; ``image`` (n, 2) px.

    ``shift_drift`` adds to the shift what grows with the line, as a drift of the attitude does: of the column or of
    the row, whichever leaves the smaller residuals.
    """
    seen = rpc.project(ground)
    linear = _linear(rpc.image, seen)
    missing = image - seen
    trials = _TRIALS[kind]
    best: tuple[float, Fit] | None = None
    for used in trials:
        correction, condition = np.zeros((3, 2)), 1.0
        for axis in (0, 1):
            solution = least_squares(linear[:, used[axis]] * weights[:, None], missing[:, axis] * weights)
            correction[list(used[axis]), axis] = solution.values
            condition = max(condition, solution.condition)
        misfit = float(np.sum(((missing - linear @ correction) * weights[:, None]) ** 2))
        if best is None or misfit < best[0]:
            best = misfit, Fit(BiasedRpc(rpc, correction), condition, 1, True, sum(map(len, used)))
    assert best is not None
    return best[1]


def _linear(scaling: Scaling, image: np.ndarray) -> np.ndarray:
    return np.column_stack([np.ones(len(image)), scaling.to(image)])
