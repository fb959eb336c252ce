"""Windows that lie near each other tell less than as many far apart: they share ground, sources and feathering.

So judged windows are put into neighbourhoods, and resampled neighbourhood by neighbourhood (the cluster bootstrap:
Davison and Hinkley 1997, section 3.8; blocks of a long row: Kuensch 1989, Annals of Statistics 17, 1217-1241)."""
from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from ....imagery.grids import Extent

LINK_SIDES = 2.0  # centres that far apart or less: windows that overlap, touch or leave room for one between them,
# as those of one seam do at the standard spacing
LONGEST_SIDES = 8.0  # of a block: four windows at the standard spacing
MIN_NEIGHBOURHOODS = 1.5  # of either kind: below it there is nothing to resample

RESAMPLES = 2000
"""Draws of the verdicts; Efron and Tibshirani 1993, section 12.5: 1000 and more for an interval's ends."""
_SEED = 20100705  # the same verdicts give the same interval


def find_neighbourhoods(extents: Sequence[Extent | None]) -> list[int]:
    """The number of each window's neighbourhood; a window without an outline is one of its own.

    Windows that come within a side of each other belong together; what reaches far is cut into even blocks.
    """
    placed = [place for place, extent in enumerate(extents) if extent is not None]
    if not placed:
        return list(range(len(extents)))
    left, bottom, right, top = np.array([extents[place] for place in placed], np.float64).T
    sides = np.median([right - left, top - bottom], axis=1)  # so that degrees do as well as metres
    centres = np.column_stack([left + right, bottom + top]) / 2 / np.where(sides > 0, sides, 1)
    pairs = cKDTree(centres).query_pairs(LINK_SIDES, p=np.inf, output_type="ndarray")
    links = coo_matrix((np.ones(len(pairs), bool), (pairs[:, 0], pairs[:, 1])), shape=(len(placed),) * 2)
    count, groups = connected_components(links, directed=False)
    numbers = list(range(len(extents)))
    blocks: dict[tuple[int, tuple[float, ...]], int] = {}
    for group in range(count):
        members = np.flatnonzero(groups == group)
        away = centres[members] - centres[members].min(axis=0)
        length = away.max(axis=0) + 1
        block = away // (length / np.ceil(length / LONGEST_SIDES))
        for member, key in zip(members.tolist(), map(tuple, block.tolist())):
            numbers[placed[member]] = blocks.setdefault((group, key), len(extents) + len(blocks))
    return np.unique(numbers, return_inverse=True)[1].tolist()


def effective_count(places: Sequence[int] | np.ndarray) -> float:
    """How many neighbourhoods of equal size would tell as much."""
    counts = np.bincount(places)
    return float(counts.sum() ** 2 / (counts**2).sum())


class Neighbourhoods:
    """Neighbourhoods of the judged windows of a measure, resampled as wholes."""

    def __init__(self, visible: Sequence[int], invisible: Sequence[int]) -> None:
        """The neighbourhoods' numbers, verdict by verdict."""
        self._places = np.unique(np.array([*visible, *invisible]), return_inverse=True)[1]
        self._visible = len(visible)
        self.count = int(self._places.max()) + 1
        self.fewest = min(effective_count(self._places[: len(visible)]), effective_count(self._places[len(visible) :]))
        """Effective number of those that hold verdicts of a kind, of the kind that has fewer."""

    def resamples(self) -> tuple[np.ndarray, np.ndarray]:
        """How often each visible and each invisible verdict is drawn, (resamples, verdicts).

        Neighbourhoods with visible verdicts alone, with invisible ones alone and with both are drawn among themselves,
        so that both kinds remain, and one fewer than there are, so that resamples spread as much as samples do (Rao and
        Wu 1988, Journal of the American Statistical Association 83, 231-241). A draw lacking two of a kind is left out.
        """
        seen, unseen = (
            np.bincount(kind, minlength=self.count) > 0 for kind in np.split(self._places, [self._visible])
        )
        strata = [np.flatnonzero(kind) for kind in (seen & ~unseen, unseen & ~seen, seen & unseen)]
        if 1 in map(len, strata):  # it would be alone
            strata = [np.arange(self.count)]
        random = np.random.default_rng(_SEED)
        drawn = np.empty((RESAMPLES, self.count), np.int64)
        for stratum in filter(len, strata):
            shares = np.full(len(stratum), 1 / len(stratum))
            drawn[:, stratum] = random.multinomial(len(stratum) - 1, shares, RESAMPLES)
        visible, invisible = np.split(drawn[:, self._places], [self._visible], axis=1)
        usable = (visible.sum(axis=1) >= 2) & (invisible.sum(axis=1) >= 2)
        return visible[usable], invisible[usable]
