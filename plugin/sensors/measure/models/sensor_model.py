"""What every sensor model can do, and what every fit of one to points gives back."""
from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np


class SensorModel:
    """From the ground to the image. A model file holds the fields of the class, which is a dataclass."""

    GEOGRAPHIC: ClassVar[bool] = False
    """Whether the ground is longitude and latitude (WGS 84) instead of the points' own reference system."""
    SPATIAL: ClassVar[bool] = True
    """Whether heights play a part; without them there is no RPC."""

    def project(self, ground: np.ndarray) -> np.ndarray:
        """(n, 3) x, y, ellipsoidal height -> (n, 2) column, row in px."""
        raise NotImplementedError

    def as_rational(self) -> SensorModel | None:
        """The very same function as ``Rational``, which is an RPC's form; None where it has not that form."""
        return None


@dataclass(frozen=True)
class FittedModel:
    """A model as fitted."""

    model: SensorModel
    condition: float
    """Condition number of the last design matrix, its columns scaled to length 1."""
    iterations: int
    """How many it took; 1 for a linear model."""
    converged: bool
    """Whether the last iteration changed the image coordinates by less than the limit."""
    unknowns: float
    """How many the points have determined: all of a free model, less where priors hold some."""
