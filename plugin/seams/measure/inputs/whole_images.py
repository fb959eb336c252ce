"""Orthoimages that are delivered in parts, strips or tiles that overlap: what shows the same pixels is one image.

Taken one by one, the mosaic would follow now this part and now that one where they overlap, and have a seam between.
"""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations
from typing import Callable

import numpy as np

from ....imagery.clips import Clip
from ....imagery.errors import Message, RasterError
from ....imagery.gdal_paths import is_remote
from ....imagery.grids import PixelWindow, extents_meet
from ....imagery.open_raster import OpenRaster, placed
from ....imagery.raster_pool import RasterPool
from ....imagery.rasters import Raster
from ..source_images import Footprints, Source
from . import messages
from .mosaic_copies import likeness_of, scattered

_SIDE_PX = 64
"""Side of what is compared at one place."""
_PLACES = 5
"""Along each side of what two rasters share."""
_ENOUGH = 5
"""Places that are the same. One that differs is enough too, and images of one ground do so at the first."""
_MOST_OFF_PX = 0.01  # of pixels that lie on each other
_EVERY = 16  # rows and columns of two clips that are compared first
_OPEN = 128  # rasters

_AreSame = Callable[[int, int], "bool | None"]
"""Whether two show the same; None where they share nothing that tells."""


def whole_images(mosaic: Raster, sources: Sequence[Source]) -> tuple[list[Source], list[Message]]:
    """The sources with the parts of one image as one, each on the place of its first part; and notices of them.

    Those on the mosaic whose footprints meet are compared at some places. Parts that come over the network are left as
    they are, as each had to be asked for.
    """
    with RasterPool(_OPEN) as pool:
        known = {number: one for number, source in enumerate(sources) if (one := _part(mosaic, source, pool))}
        footprints, numbers = Footprints(sources[number] for number in known), list(known)
        pairs = (
            (number, numbers[k]) for number in numbers for k in footprints.meeting(sources[number].extent)
            if numbers[k] > number and _are_alike(known[number], known[numbers[k]])
        )

        def are_same(first: int, second: int) -> bool | None:
            try:
                return _show_same(pool.open(sources[first].ref), pool.open(sources[second].ref))
            except RasterError:
                return None  # the scan says so where it needs it

        found = _joined(sources, pairs, are_same)
    return found, images_in_parts(found)


def whole_images_of_clips(sources: Sequence[Source], clips: Sequence[Clip | None]) -> list[Source]:
    """Sources, parts of one image as one, by what was read of them in a window; None where that can't be compared."""
    known = {number: clip for number, clip in enumerate(clips) if clip is not None and not clip.resampled}
    boxes = {number: _box(clip) for number, clip in known.items()}
    pairs = (
        (first, second) for first, second in combinations(known, 2)
        if extents_meet(boxes[first], boxes[second]) and _are_alike(known[first].raster, known[second].raster)
    )

    def are_same(first: int, second: int) -> bool | None:
        one, other = known[first], known[second]
        left, top, right, bottom = (
            pick(edges) for pick, edges in zip((max, max, min, min), zip(boxes[first], boxes[second]))
        )
        told = None
        for step in (_EVERY, 1):
            some = np.s_[top:bottom:step, left:right:step]
            both = np.ones(one.bands[0][some].shape, bool)
            for clip in (one, other):
                both &= True if clip.valid is None else clip.valid[some]
            told = _told(one.bands[(slice(None), *some)], other.bands[(slice(None), *some)], both)
            if told is False:
                break
        return told

    return _joined(sources, pairs, are_same)


def _box(clip: Clip) -> tuple[int, int, int, int]:
    """Around the pixels that a clip has: first column and row, last ones and one."""
    _, rows, columns = clip.bands.shape
    if clip.valid is None:
        return 0, 0, columns, rows
    across, down = (np.flatnonzero(clip.valid.any(axis=axis)).tolist() for axis in (0, 1))
    return across[0], down[0], across[-1] + 1, down[-1] + 1


def images_in_parts(sources: Iterable[Source]) -> list[Message]:
    """What to tell of those."""
    refs = [one.ref for one in sources if one.ref.parts]
    return [messages.ONE_IMAGE_IN_PARTS(name=ref.name, count=len(ref.parts)) for ref in refs]


def _part(mosaic: Raster, source: Source, pool: RasterPool) -> Raster | None:
    """What a source is if it may be a part of an image on the mosaic."""
    if is_remote(source.ref.path) or not extents_meet(source.extent, mosaic.extent):
        return None
    try:
        raster = placed(pool.open(source.ref).raster)
    except RasterError:
        return None
    return raster if raster.is_north_up else None


def _are_alike(first: Raster, second: Raster) -> bool:
    """Whether their pixels lie on one grid and hold the same bands."""
    if (first.band_names, first.data_type, first.wkt) != (second.band_names, second.data_type, second.wkt):
        return False
    one, other = first.grid, second.grid
    column, row = one.column_at(other.left), one.row_at(other.top)
    far = max(other.columns, other.rows)
    growth = max(abs(other.pixel_width / one.pixel_width - 1), abs(other.pixel_height / one.pixel_height - 1))
    return max(abs(column - round(column)), abs(row - round(row)), far * growth) < _MOST_OFF_PX


def _show_same(first: OpenRaster, second: OpenRaster) -> bool | None:
    """Whether both show the same, by some places; None where none tells. Raises RasterError where one can't be read."""
    same = 0
    for own, others in _shared(first.raster, second.raster):
        one, other = first.read(own), second.read(others)
        here = _told(one.bands, other.bands, one.valid & other.valid)
        if here is False:
            return False
        same += here is True
        if same == _ENOUGH:
            break
    return True if same else None


def _shared(first: Raster, second: Raster) -> Iterator[tuple[PixelWindow, PixelWindow]]:
    """Places in the pixels that two rasters on one grid share, in the pixels of each."""
    column = round(first.grid.column_at(second.grid.left))
    row = round(first.grid.row_at(second.grid.top))
    left, top = max(column, 0), max(row, 0)
    columns = min(first.columns, column + second.columns) - left
    rows = min(first.rows, row + second.rows) - top
    if min(columns, rows) <= 0:
        return
    width, height = min(_SIDE_PX, columns), min(_SIDE_PX, rows)
    for down, across in scattered(_PLACES):
        own = PixelWindow(left + int(across * (columns - width)), top + int(down * (rows - height)), width, height)
        yield own, own.moved_by(-column, -row)


def _told(first: np.ndarray, second: np.ndarray, both: np.ndarray) -> bool | None:
    """Whether two stacks (bands, rows, columns) are the same where both have pixels, (rows, columns) bool; None where
    there are none, or where even ground is the same in all images."""
    if not (first[:, both] == second[:, both]).all():
        return False
    band = first[:1].astype(np.float64)
    return None if np.isnan(likeness_of(band, band, both)) else True


def _joined(sources: Sequence[Source], pairs: Iterable[tuple[int, int]], are_same: _AreSame) -> list[Source]:
    """Sources that are one as one; of two groups that are known the next pair tells nothing new."""
    group_of = list(range(len(sources)))
    members = {number: [number] for number in group_of}
    apart: dict[int, set[int]] = {number: set() for number in group_of}
    for pair in pairs:
        first, second = sorted(group_of[number] for number in pair)
        if first == second or second in apart[first]:
            continue
        same = are_same(*pair)
        if same is False:
            apart[first].add(second)
            apart[second].add(first)
        elif same:
            for number in members[second]:
                group_of[number] = first
            members[first] += members.pop(second)
            for other in apart.pop(second):
                apart[other].discard(second)
                apart[other].add(first)
                apart[first].add(other)
    return [_one(sources, sorted(numbers)) for _, numbers in sorted(members.items())]


def _one(sources: Sequence[Source], numbers: Sequence[int]) -> Source:
    first, *others = (sources[number] for number in numbers)
    if not others:
        return first
    xmin, ymin, xmax, ymax = zip(*(sources[number].extent for number in numbers))
    parts = (*first.ref.parts, *(path for one in others for path in one.ref.paths))
    extent = min(xmin), min(ymin), max(xmax), max(ymax)
    return Source(replace(first.ref, parts=parts), extent, any(sources[number].may_be_copy for number in numbers))
