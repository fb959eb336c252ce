"""How well two observers agree on the windows that both judged (Cohen's kappa)."""
from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ....imagery.statistics import DECIDED, NORMAL_95, Interval


@dataclass(frozen=True)
class Agreement:
    """How often two operators said the same."""

    count: int
    """Windows that both judged."""
    agreed: int
    """Windows of which both said the same."""
    kappa: Interval | None
    """1: always agreed, 0: as often as by chance. None where one of them said one word only."""


def agreement(words: Sequence[tuple[str, str]]) -> Agreement:
    """Agreement of pairs of words; where one of the two did not judge, or was not sure, a pair does not count."""
    table = np.zeros((2, 2), np.int64)
    for first, second in words:
        if first in DECIDED and second in DECIDED:
            table[DECIDED.index(first), DECIDED.index(second)] += 1
    return Agreement(int(table.sum()), int(table.trace()), cohen_kappa(table))


def cohen_kappa(table: np.ndarray) -> Interval | None:
    """Cohen's kappa of a square table of counts (first's word, second's word), with its 95 % interval.

    Cohen 1960 (Educational and Psychological Measurement 20, 37-46); the standard error is that of Fleiss, Cohen and
    Everitt 1969 (Psychological Bulletin 72, 323-327). It is zero where all agree or none, however few they are; the
    other end is then the kappa of as many exceptions as the score interval of none in n allows (Wilson 1927). None for
    an empty table, and where one observer used one word only: kappa is 0 then whatever the other one said.
    """
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
