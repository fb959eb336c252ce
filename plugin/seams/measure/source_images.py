"""The orthoimages that a mosaic was made from, or will be: each once, with its footprint."""
from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass, replace

import numpy as np

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.errors import Message, RasterError, SettingsError
from ...imagery.grids import Extent, extents_meet
from ...imagery.open_raster import placed
from ...imagery.raster_pool import RasterPool
from ...imagery.rasters import RasterRef
from ...imagery.reference_systems import extent_on
from ...imagery.remote_files import readable_path
from . import messages


@dataclass(frozen=True)
class Source:
    """An orthoimage that may take part, with its footprint; the file itself is opened when a window needs it."""

    ref: RasterRef
    """Where it is."""
    extent: Extent
    """Bounding box in the reference system of the windows, the mosaic's where there is one."""


def gather_sources(
    sources: Iterable[RasterRef], indexed: Iterable[Source], wkt: str, mosaic: RasterRef | None = None
) -> tuple[list[Source], list[Message]]:
    """Every source once, its footprint in a reference system, and notices about those left out.

    ``sources`` are opened for their footprints; ``indexed`` ones come with theirs and are not. The mosaic
    itself among the sources is dropped.

    Raises SettingsError when no source is named at all.
    """
    candidates: list[RasterRef | Source] = [*sources, *indexed]
    if not candidates:
        raise SettingsError(messages.NO_SOURCES_GIVEN())
    kept: list[Source] = []
    notices: list[Message] = []
    taken: set[str] = set()
    mosaic_key = None if mosaic is None else _key(_in_parts(mosaic))
    with RasterPool(most=1) as pool:
        for candidate in candidates:
            ref = _in_parts(candidate.ref if isinstance(candidate, Source) else candidate)
            key = _key(ref)
            if key == mosaic_key:
                notices.append(messages.MOSAIC_AMONG_SOURCES(name=ref.name))
            elif key not in taken:
                taken.add(key)
                try:
                    extent = candidate.extent if isinstance(candidate, Source) else _footprint(ref, wkt, pool)
                    kept.append(Source(ref, extent))
                except RasterError as error:
                    notices.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return kept, notices


def sources_over(
    sources: Iterable[Source], extent: Extent, slack_x: float = 0.0, slack_y: float = 0.0
) -> tuple[Source, ...]:
    """Those whose footprint covers a rectangle, give or take the share that may be invalid and a slack, map units."""
    return tuple(source for source in sources if covers(source.extent, extent, slack_x, slack_y))


def sources_in(sources: Iterable[Source], extent: Extent) -> tuple[Source, ...]:
    """Those whose footprint meets a rectangle."""
    return tuple(one for one in sources if extents_meet(one.extent, extent))


def covers(footprint: Extent, extent: Extent, slack_x: float = 0.0, slack_y: float = 0.0) -> bool:
    """Whether a footprint covers a rectangle that closely."""
    xmin, ymin, xmax, ymax = extent
    slack_x += imagery_limits.MAX_INVALID_SHARE * (xmax - xmin)
    slack_y += imagery_limits.MAX_INVALID_SHARE * (ymax - ymin)
    return (
        footprint[0] <= xmin + slack_x
        and footprint[1] <= ymin + slack_y
        and footprint[2] >= xmax - slack_x
        and footprint[3] >= ymax - slack_y
    )


def is_same_file(first: RasterRef, second: RasterRef) -> bool:
    """Whether two rasters are one file, however its path is written."""
    return _key(_in_parts(first)) == _key(_in_parts(second))


def _footprint(ref: RasterRef, wkt: str, pool: RasterPool) -> Extent:
    raster = placed(pool.open(ref).raster)
    return extent_on(raster.extent, raster.wkt, wkt)


def _in_parts(ref: RasterRef) -> RasterRef:
    """By a path that GDAL reads in parts."""
    path = readable_path(ref.path)
    return ref if path == ref.path else replace(ref, path=path)


def _key(ref: RasterRef) -> str:
    """The same for the same file, however its path is written."""
    return os.path.realpath(ref.path) if os.path.exists(ref.path) else ref.path


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
