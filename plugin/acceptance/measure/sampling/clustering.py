"""Pieces along one seam are alike: how much, and what that takes from what they tell."""
from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np

MIN_CLUSTERS = 2


def intraclass_correlation(failed: Sequence[bool], clusters: Sequence[Hashable]) -> float | None:
    """How much alike the pieces of one cluster are, 0 (no more than those of others) to 1.

    The analysis of variance estimator for shares (Ridout, Demetrio and Firth 1999, Biometrics 55, 137-148), not below
    0. None where there are fewer than two clusters, no cluster has two pieces, or all pieces are the same.
    """
    values, members, sizes = _grouped(failed, clusters)
    total, count = len(values), len(sizes)
    if count < MIN_CLUSTERS or total == count or values.min() == values.max():
        return None
    means = np.bincount(members, values) / sizes
    between = float((sizes * (means - values.mean()) ** 2).sum()) / (count - 1)
    within = float(((values - means[members]) ** 2).sum()) / (total - count)
    typical = (total - float((sizes**2).sum()) / total) / (count - 1)
    spread = between + (typical - 1) * within
    return float(np.clip((between - within) / spread, 0.0, 1.0)) if spread > 0 else None


def typical_cluster_size(clusters: Sequence[Hashable]) -> float:
    """The size of the cluster that a piece lies in, on average over pieces: sum m^2 / sum m (Kish 1965, 8.2)."""
    _, _, sizes = _grouped([False] * len(clusters), clusters)
    return float((sizes**2).sum() / sizes.sum())


def _grouped(failed: Sequence[bool], clusters: Sequence[Hashable]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Values, the cluster of each, and the sizes of the clusters."""
    numbers = {name: number for number, name in enumerate(dict.fromkeys(clusters))}
    members = np.array([numbers[name] for name in clusters], np.int64)
    return np.asarray(failed, float), members, np.bincount(members).astype(float)
