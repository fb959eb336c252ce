"""A vendor's RPC, corrected in the image by a few control points."""
from __future__ import annotations

from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from ....imagery.errors import SettingsError
from .. import messages
from .least_squares import Scaling, least_squares
from .rational import Rational
from .sensor_model import FittedModel, SensorModel

_Used = tuple[int, ...]
_TRIALS: dict[str, tuple[tuple[_Used, _Used], ...]] = {
    "shift": (((0,), (0,)),),
    "shift_drift": (((0, 2), (0,)), ((0,), (0, 2))),
    "affine": (((0, 1, 2), (0, 1, 2)),),
}
"""Which of constant, column and row the corrections of column and row use; of several the one that fits best."""


@dataclass(frozen=True)
class BiasedRpc(SensorModel):
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
        return seen + self.bias(seen)

    def bias(self, image: np.ndarray) -> np.ndarray:
        """(n, 2) px: how far off the RPC is at the places (n, 2) where it sees points; what is measured minus that."""
        return _linear(self.rpc.image, image) @ self.correction

    def as_rational(self) -> Rational | None:
        if self.correction[1:].any():
            return None
        scaling = Scaling(self.rpc.image.offset + self.correction[0], self.rpc.image.scale)
        return replace(self.rpc, image=scaling)


def fit_bias(
    ground: np.ndarray, image: np.ndarray, weights: np.ndarray, form: str, rpc: Rational | None
) -> FittedModel:
    """Fit the correction: ``ground`` (n, 3) longitude, latitude, ellipsoidal height; ``image`` (n, 2) px.

    ``shift_drift`` adds to the shift what grows with the line, as a drift of the attitude does: of the column or of
    the row, whichever leaves the smaller residuals. Raises SettingsError without an RPC.
    """
    if rpc is None:
        raise SettingsError(messages.NO_RPC())
    seen = rpc.project(ground)
    linear = _linear(rpc.image, seen)
    missing = image - seen
    best: tuple[float, FittedModel] | None = None
    for used in _TRIALS[form]:
        correction, condition = np.zeros((3, 2)), 1.0
        for axis in (0, 1):
            solution = least_squares(linear[:, used[axis]] * weights[:, None], missing[:, axis] * weights)
            correction[list(used[axis]), axis] = solution.values
            condition = max(condition, solution.condition)
        misfit = float(np.sum(((missing - linear @ correction) * weights[:, None]) ** 2))
        if best is None or misfit < best[0]:
            best = misfit, FittedModel(BiasedRpc(rpc, correction), condition, 1, True, sum(map(len, used)))
    assert best is not None
    return best[1]


def _linear(scaling: Scaling, image: np.ndarray) -> np.ndarray:
    return np.column_stack([np.ones(len(image)), scaling.to(image)])
