"""What observers say of a window; values with their confidence intervals."""
from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    import numpy as np

VISIBLE, INVISIBLE, UNSURE = "visible", "invisible", "unsure"
DECIDED = (VISIBLE, INVISIBLE)
"""The words that are a verdict; whoever is not sure has looked and not judged."""


class Operator(NamedTuple):
    """One of two who judge the same windows: the fields of the window layer that are his, records' too."""

    observer: str
    """His word."""
    confidence: str
    """How sure he is of it, 0 to 100."""
    remark: str


FIRST = Operator("observer", "confidence", "remark")
SECOND = Operator("observer_2", "confidence_2", "remark_2")
OPERATORS = (FIRST, SECOND)
JUDGING_FIELDS = {field: kind for operator in OPERATORS for field, kind in zip(operator, ("text", "integer", "text"))}
"""The fields of both and their kinds. A window layer has those that were used, the first one's word always."""

NORMAL_95 = 1.959964  # standard errors either side of a normal value that hold 95 %
_SIGMA_OF_MEDIAN = 1.4826  # standard deviation over the median of absolute values, of a normal distribution
_MOST_FREEDOM = 1e7  # degrees of freedom: beyond, Student's t is normal to 2e-7


def robust_sigma(residuals: np.ndarray) -> float:
    """Standard deviation of what is normal in residuals, by the median of their absolute values."""
    import numpy as np  # not when QGIS starts

    return _SIGMA_OF_MEDIAN * float(np.median(np.abs(residuals)))


def critical_t(confidence: float, freedom: np.ndarray | float) -> np.ndarray:
    """Two-sided critical values of Student's t: an interval of that confidence is so many standard errors either way.

    ``scipy.special.stdtrit`` of scipy 1.10, as in Debian 12, computes in memory that all threads share: two that call
    it at once get wrong values or never end. t^2 / (n + t^2) has a beta distribution, whose quantiles are safe.
    """
    import numpy as np  # not when QGIS starts
    from scipy.special import betaincinv

    n = np.minimum(freedom, _MOST_FREEDOM)
    share = betaincinv(0.5, n / 2, confidence)
    return np.asarray(np.sqrt(n * share / (1 - share)))


@dataclass(frozen=True)
class Interval:
    """A value with its 95 % confidence interval."""

    value: float
    low: float
    high: float
