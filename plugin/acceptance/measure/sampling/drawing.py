"""Drawing a sample: at random with a seed, in proportion from every stratum.

ISO 2859-1:1999, 8.1 and 8.2: items are drawn at random, and where a lot has parts, from each in proportion to its size.
"""
from __future__ import annotations

from collections.abc import Hashable, Sequence

import numpy as np


def stratified_sample(strata: Sequence[Hashable], count: int, seed: int) -> list[int]:
    """Places of ``count`` items, all of them where there are no more, in the order in which they were drawn.

    ``strata``: that of each item. The same items, count and seed give the same sample. The first part of a sample of
    one stratum is a sample, too.
    """
    random = np.random.default_rng(seed)
    members: dict[Hashable, list[int]] = {}
    for place, stratum in enumerate(strata):
        members.setdefault(stratum, []).append(place)
    shares = proportional_counts([len(places) for places in members.values()], min(count, len(strata)), random)
    drawn = [
        int(place)
        for places, share in zip(members.values(), shares)
        for place in random.permutation(places)[:share]
    ]
    return [drawn[place] for place in random.permutation(len(drawn))]


def proportional_counts(sizes: Sequence[int], count: int, random: np.random.Generator) -> list[int]:
    """How many items each stratum gives.

    What is left of whole numbers goes to strata at random, a stratum with probability of its remainder (systematic
    sampling of the remainders in random order), so that each item is as likely to be drawn as any other.
    """
    exact = np.asarray(sizes, float) * count / max(sum(sizes), 1)
    counts = np.floor(exact + 1e-9).astype(int)
    missing = count - int(counts.sum())
    if missing > 0:
        order = random.permutation(len(sizes))
        reach = np.cumsum(np.clip(exact - counts, 0, None)[order])
        reach *= missing / reach[-1]
        hits = np.searchsorted(reach, random.random() + np.arange(missing), side="right")
        np.add.at(counts, order[np.minimum(hits, len(sizes) - 1)], 1)
    return counts.tolist()
