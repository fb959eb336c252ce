"""Which of very many sources meet a rectangle."""
from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ...imagery.grids import Extent
from .source_images import Source

_LEAF = 128  # footprints that are compared together: some root of 100,000, below which numpy's calls cost more


class SourceTree:
    """Footprints packed into leaves of neighbours of like size, so that a query looks at few of them."""

    def __init__(self, sources: Iterable[Source]) -> None:
        self.sources = tuple(sources)
        """In the order given; the place in it is a source's number."""
        count = len(self.sources)
        extents = np.array([source.extent for source in self.sources], float).reshape(count, 4)
        order = _packed(extents)
        self._numbers = order.reshape(-1, _LEAF)
        """(leaves, members); -1 where a leaf has fewer."""
        members = np.full((*self._numbers.shape, 4), np.nan)  # what is compared with it meets nothing
        there = self._numbers >= 0
        members[there] = extents[self._numbers[there]]
        self._members = members
        # A leaf of nothing but footprints that are no numbers, or of none at all, meets nothing either.
        low, high = members[:, :, :2], members[:, :, 2:]
        self._boxes = np.concatenate([np.fmin.reduce(low, axis=1), np.fmax.reduce(high, axis=1)], axis=1)

    def __len__(self) -> int:
        return len(self.sources)

    def meeting(self, extent: Extent) -> tuple[Source, ...]:
        """Those whose footprint shares more than a border with a rectangle, in the order given."""
        return tuple(self.sources[number] for number in self.numbers_meeting(extent))

    def numbers_meeting(self, extent: Extent) -> list[int]:
        """The numbers of those, ascending."""
        leaves = np.flatnonzero(_meet(self._boxes, extent))
        found = self._numbers[leaves][_meet(self._members[leaves], extent)]
        found.sort()
        return found.tolist()


def _meet(rectangles: np.ndarray, extent: Extent) -> np.ndarray:
    """As ``extents_meet``, for rectangles (..., 4)."""
    xmin, ymin, xmax, ymax = extent
    return (
        (rectangles[..., 0] < xmax) & (rectangles[..., 2] > xmin)
        & (rectangles[..., 1] < ymax) & (rectangles[..., 3] > ymin)
    )


def _packed(extents: np.ndarray) -> np.ndarray:
    """The numbers of rectangles (n, 4), ``_LEAF`` neighbours of like size one after the other, -1 where some lack.

    Sizes apart by factors of four do not share a leaf, since one that covers the whole mosaic would make its leaf meet
    everything. In each size they are cut into columns of the map, and those into leaves (sort-tile-recursive packing).
    """
    if not len(extents):
        return np.empty(0, np.int64)
    with np.errstate(all="ignore"):
        centres = np.nan_to_num((extents[:, :2] + extents[:, 2:]) / 2)
        sides = np.maximum(extents[:, 2] - extents[:, 0], extents[:, 3] - extents[:, 1])
        sizes = np.nan_to_num(np.floor(np.log2(sides) / 2), nan=0.0, posinf=1e3, neginf=-1e3)
    packed = []
    for size in np.unique(sizes):
        members = np.flatnonzero(sizes == size)
        leaves = -(-len(members) // _LEAF)
        columns = max(1, round(np.sqrt(leaves)))
        members = members[np.argsort(centres[members, 0], kind="stable")]
        for column in np.array_split(members, columns):
            column = column[np.argsort(centres[column, 1], kind="stable")]
            packed.append(np.pad(column, (0, -len(column) % _LEAF), constant_values=-1))
    return np.concatenate(packed)
