"""What observers say of a window and how well they agree (Cohen's kappa); values with their confidence intervals."""
from __future__ import annotations

import math
from collections.abc import Sequence
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
JUDGING_FIELDS = {
    field: kind
    for operator in OPERATORS
    for field, kind in zip(operator, ("text", "integer", "text"))
}
"""The fields of both and their kinds. A window layer has those that were used, the first one's word always."""

NORMAL_95 = 1.959964  # standard errors either side of a normal value that hold 95 %
_SIGMA_OF_MEDIAN = 1.4826  # standard deviation over the median of absolute values, of a normal distribution
_MOST_FREEDOM = 1e7  # degrees of freedom: beyond, Student's t is normal to 2e-7


def robust_sigma(residuals: np.ndarray) -> float:
    """Standard deviation of what is normal in residuals, by the median of their absolute values."""
    import numpy as np  # not when QGIS starts

    return _SIGMA_OF_MEDIAN * float(np.median(np.abs(residuals)))


def critical_t(confidence: float, freedom: np.ndarray | float) -> np.ndarray:
    """Two-sided critical values of Student's t: an interval of that confidence reaches so many standard errors to
    either side.

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


@dataclass(frozen=True)
class Agreement:
    """What two operators said of the windows that both judged."""

    both_visible: int
    both_invisible: int
    first_alone: int
    """Where the first one alone saw a loss."""
    second_alone: int
    kappa: Interval | None
    """1: always agreed, 0: as often as by chance. None where one of them said one word only."""

    @property
    def count(self) -> int:
        """Windows that both judged."""
        return self.both_visible + self.both_invisible + self.first_alone + self.second_alone

    @property
    def agreed(self) -> int:
        """Windows of which both said the same."""
        return self.both_visible + self.both_invisible


def agreement(words: Sequence[tuple[str, str]]) -> Agreement:
    """Agreement of pairs of words; where one of the two did not judge, or was not sure, a pair does not count."""
    import numpy as np  # not when QGIS starts

    table = np.zeros((2, 2), np.int64)
    for first, second in words:
        if first in DECIDED and second in DECIDED:
            table[DECIDED.index(first), DECIDED.index(second)] += 1
    (both, first_alone), (second_alone, neither) = table.tolist()
    return Agreement(both, neither, first_alone, second_alone, cohen_kappa(table))


def cohen_kappa(table: np.ndarray) -> Interval | None:
    """Cohen's kappa of a square table of counts (first's word, second's word), with its 95 % interval.

    Cohen 1960 (Educational and Psychological Measurement 20, 37-46); the standard error is that of Fleiss, Cohen and
    Everitt 1969 (Psychological Bulletin 72, 323-327). It is zero where all agree or none, however few they are; the
    other end is then the kappa of as many exceptions as the score interval of none in n allows (Wilson 1927). None for
    an empty table, and where one observer used one word only: kappa is 0 then whatever the other one said.
    """
    import numpy as np  # not when QGIS starts

    count = float(table.sum())
    if count == 0:
        return None
    shares = table / count
    rows, columns = shares.sum(axis=1), shares.sum(axis=0)
    if rows.max() == 1 or columns.max() == 1:
        return None
    by_chance = float(rows @ columns)
    agreed = float(shares.trace())
    kappa = (agreed - by_chance) / (1 - by_chance)
    exceptions = NORMAL_95**2 / (count + NORMAL_95**2)
    if agreed == 1:
        return Interval(1.0, (1 - exceptions - by_chance) / (1 - by_chance), 1.0)
    if agreed == 0:
        return Interval(kappa, kappa, (exceptions - by_chance) / (1 - by_chance))
    same, rest = shares.diagonal(), 1 - kappa
    marginals = (columns[:, np.newaxis] + rows) ** 2
    agreeing = float((same * (1 - (rows + columns) * rest) ** 2).sum())
    apart = rest**2 * float((shares * marginals).sum() - (same * marginals.diagonal()).sum())
    spread = agreeing + apart - (kappa - by_chance * rest) ** 2  # Fleiss, Cohen and Everitt 1969, equation 13
    reach = NORMAL_95 * math.sqrt(max(spread, 0.0) / count) / (1 - by_chance)
    return Interval(kappa, max(kappa - reach, -1.0), min(kappa + reach, 1.0))
