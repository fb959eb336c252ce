"""The share of failed metres with its 95 % interval, pieces of one seam being alike."""
from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np
from scipy import stats

from ...imagery.statistics import Interval

CONFIDENCE = 0.95


def failed_share_interval(
    lengths: Sequence[float], failed: Sequence[float], clusters: Sequence[Hashable]
) -> Interval | None:
    """Of a ratio of metres, pieces being drawn seam by seam (``clusters``); ``failed``: the share of each that did.

    The interval of Korn and Graubard 1998 (Survey Methodology 24, 193-201), made for small shares of clustered data:
    that of Clopper and Pearson for the effective number of pieces, which is what the linearised variance over clusters
    says, smaller by the t-distribution for what that variance itself rests on: the fewer clusters make it up, and
    failures on a few long seams are few, the fewer its degrees of freedom (Satterthwaite 1946, Biometrics Bulletin 2,
    110-114). It is never smaller than the effective number of clusters, each of them as good as one piece, and that
    where they do not vary at all.
    With a single cluster nothing is known of others: the interval is 0 to 1. None where nothing was measured.
    """
    weights, values = np.asarray(lengths, float), np.asarray(failed, float)
    total = float(weights.sum())
    if total <= 0:
        return None
    share = min(float((weights * values).sum() / total), 1.0)  # rounding
    numbers = {name: number for number, name in enumerate(dict.fromkeys(clusters))}
    members = np.array([numbers[name] for name in clusters], np.int64)
    count = len(numbers)
    if count < 2:
        return Interval(share, 0.0, 1.0)
    effective = _effective_count(weights, values, share, members, count)
    low, high = _clopper_pearson(share * effective, effective)
    return Interval(share, min(low, share), max(high, share))


def _effective_count(
    weights: np.ndarray, values: np.ndarray, share: float, members: np.ndarray, count: int
) -> float:
    """Of independent pieces that would tell as much."""
    sizes = np.bincount(members, weights)
    clusters, pieces = float(sizes.sum() ** 2 / (sizes**2).sum()), float(weights.sum() ** 2 / (weights**2).sum())
    squares = (np.bincount(members, weights * (values - share)) / weights.sum()) ** 2
    variance = float(squares.sum()) * count / (count - 1)  # of the ratio, linearised
    if share in (0.0, 1.0) or variance <= 0:
        return clusters
    freedom = float(np.clip(squares.sum() ** 2 / (squares**2).sum(), 1.0, count - 1))
    fewer = (stats.norm.ppf((1 + CONFIDENCE) / 2) / stats.t.ppf((1 + CONFIDENCE) / 2, freedom)) ** 2
    return float(np.clip(share * (1 - share) / variance * fewer, clusters, pieces))


def _clopper_pearson(found: float, count: float) -> tuple[float, float]:
    tail = (1 - CONFIDENCE) / 2
    low = float(stats.beta.ppf(tail, found, count - found + 1)) if found > 0 else 0.0
    high = float(stats.beta.ppf(1 - tail, found + 1, count - found)) if found < count else 1.0
    return low, high
