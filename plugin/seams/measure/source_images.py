"""The orthoimages that a mosaic was made from, or will be: each once, with its footprint.

Some are delivered in parts, strips or tiles that overlap: what shows the same pixels is one image. Taken one by one,
the mosaic would follow now this part and now that one where they overlap, and have a seam between.
"""
from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import combinations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from ...imagery import limits as imagery_limits
from ...imagery import messages as imagery_messages
from ...imagery.clips import Clip
from ...imagery.errors import Message, RasterError, SettingsError
from ...imagery.gdal_paths import is_remote, readable_path
from ...imagery.grids import Extent, PixelWindow, extents_meet
from ...imagery.open_raster import OpenRaster, describe, placed
from ...imagery.rasters import Raster, RasterRef
from ...imagery.reference_systems import extent_on
from . import messages


@dataclass(frozen=True)
class Source:
    """An orthoimage that may take part, with its footprint; the file itself is opened when a window needs it."""

    ref: RasterRef
    """Its place in files."""
    extent: Extent
    """Bounding box in the reference system of the windows, the mosaic's where there is one."""
    may_be_copy: bool = False
    """Whether it is the mosaic, or nearly so, wherever they were compared."""


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
    for candidate in candidates:
        ref = _in_parts(candidate.ref if isinstance(candidate, Source) else candidate)
        key = _key(ref)
        if key == mosaic_key:
            notices.append(messages.MOSAIC_AMONG_SOURCES(name=ref.name))
        elif key not in taken:
            taken.add(key)
            try:
                if isinstance(candidate, Source):
                    extent = candidate.extent
                else:
                    raster = placed(describe(ref))
                    extent = extent_on(raster.extent, raster.wkt, wkt)
                    notices += raster.notices
                kept.append(Source(ref, extent))
            except RasterError as error:
                notices.append(imagery_messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return kept, notices


def covers(footprint: Extent, extent: Extent, slack_x: float = 0.0, slack_y: float = 0.0) -> bool:
    """Whether a footprint covers a rectangle, give or take the share that may be invalid, and a slack."""
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


def _in_parts(ref: RasterRef) -> RasterRef:
    """A raster by a path that GDAL reads in parts."""
    path = readable_path(ref.path)
    return ref if path == ref.path else replace(ref, path=path)


def _key(ref: RasterRef) -> str:
    """Key of a file, equal however its path is written."""
    return os.path.realpath(ref.path) if os.path.exists(ref.path) else ref.path


class Footprints:
    """Footprints of very many sources, to be asked which of them meet a rectangle: 0.2 ms for 100,000 of them."""

    def __init__(self, sources: Iterable[Source]) -> None:
        self._edges = np.array([source.extent for source in sources], float).reshape(-1, 4).T.copy()

    def meeting(self, extent: Extent) -> list[int]:
        """The numbers of those that share more than a border with a rectangle, ascending, as ``extents_meet``."""
        xmin, ymin, xmax, ymax = extent
        left, bottom, right, top = self._edges
        return np.flatnonzero((left < xmax) & (right > xmin) & (bottom < ymax) & (top > ymin)).tolist()


_SIDE_PX = 64  # of what is compared at one place
_PLACES = 3  # along each side of what two rasters share
_SAMPLES = 256  # rows and columns of two clips that are compared
_MOST_OFF_PX = 0.01  # of pixels that lie on each other
_OPEN = 128  # rasters


def whole_images(mosaic: Raster, sources: Sequence[Source]) -> tuple[list[Source], list[Message]]:
    """The sources with the parts of one image as one, each on the place of its first part; and notices of them.

    Those on the mosaic whose footprints meet are compared at some places. Parts that come over the network are left as
    they are, as each had to be asked for.
    """
    opened = lru_cache(_OPEN)(OpenRaster)
    rasters = {number: raster for number, source in enumerate(sources) if (raster := _part(mosaic, source, opened))}
    footprints, numbers = Footprints(sources[number] for number in rasters), list(rasters)
    meeting = ((n, numbers[k]) for n in numbers for k in footprints.meeting(sources[n].extent) if numbers[k] > n)

    def show_same(*numbers: int) -> bool:
        with suppress(RasterError):  # the scan says so where it needs it
            image, other = (opened(sources[number].ref) for number in numbers)
            kinds = set()
            for place, others_place in _shared(image.raster, other.raster):
                block, beside = image.read(place), other.read(others_place)
                kinds.add(_same_content(block.bands, beside.bands, block.valid & beside.valid))
                if False in kinds:
                    break
            return True in kinds and False not in kinds
        return False

    whole = _joined(sources, (
        pair for pair in meeting if have_same_grid(*(rasters[number] for number in pair)) and show_same(*pair)
    ))
    return whole, images_in_parts(whole)


def whole_images_of_clips(sources: Sequence[Source], clips: Sequence[Clip | None]) -> list[Source]:
    """Sources, parts of one image as one, by what was read of them in a window; None where that can't be compared."""
    known = {number: clip for number, clip in enumerate(clips) if clip is not None and not clip.resampled}

    def are_same(first: int, second: int) -> bool:
        if not have_same_grid(known[first].raster, known[second].raster):
            return False
        shape = known[first].bands.shape[1:]
        rows, columns = (slice(None, None, max(length // _SAMPLES, 1)) for length in shape)
        both = np.ones(known[first].bands[0, rows, columns].shape, bool)
        for number in (first, second):
            valid = known[number].valid
            both &= True if valid is None else valid[rows, columns]
        values, others = (known[number].bands[:, rows, columns] for number in (first, second))
        return _same_content(values, others, both) is True

    return _joined(sources, (pair for pair in combinations(known, 2) if are_same(*pair)))


def images_in_parts(sources: Iterable[Source]) -> list[Message]:
    """What to tell of those."""
    refs = [source.ref for source in sources if source.ref.parts]
    return [messages.ONE_IMAGE_IN_PARTS(name=ref.name, count=len(ref.parts)) for ref in refs]


def _part(mosaic: Raster, source: Source, opened: Callable[[RasterRef], OpenRaster]) -> Raster | None:
    """What a source is if it may be a part of an image on the mosaic."""
    if is_remote(source.ref.path) or not extents_meet(source.extent, mosaic.extent):
        return None
    try:
        raster = placed(opened(source.ref).raster)
    except RasterError:
        return None
    return raster if raster.is_north_up else None


def have_same_grid(first: Raster, second: Raster) -> bool:
    """Whether the pixels of two rasters lie on one grid and hold the same bands in the same order."""
    held = [(raster.band_names, raster.band_order, raster.data_type, raster.wkt) for raster in (first, second)]
    if held[0] != held[1] or first.is_turned or second.is_turned:  # GDAL puts no turned ones together
        return False
    grid, other = first.grid, second.grid
    column, row = grid.column_at(other.left), grid.row_at(other.top)
    far = max(grid.columns, grid.rows, other.columns, other.rows)
    growth = max(abs(other.pixel_width / grid.pixel_width - 1), abs(other.pixel_height / grid.pixel_height - 1))
    return max(abs(column - round(column)), abs(row - round(row)), far * growth) < _MOST_OFF_PX


def _shared(first: Raster, second: Raster) -> Iterator[tuple[PixelWindow, PixelWindow]]:
    """Places in the pixels that two rasters on one grid share, in the pixels of each."""
    column, row = round(first.grid.column_at(second.grid.left)), round(first.grid.row_at(second.grid.top))
    shared = PixelWindow(column, row, second.columns, second.rows).cut_to(first.columns, first.rows)
    if shared.width and shared.height:
        for place in even_places(shared, _SIDE_PX, (_PLACES, _PLACES)):
            yield place, place.moved_by(-column, -row)


def even_places(window: PixelWindow, side_px: int, counts: tuple[int, int]) -> Iterator[PixelWindow]:
    """Squares in so many rows and columns that lie evenly from one end of a window to the other."""
    height, width = min(side_px, window.height), min(side_px, window.width)
    rows, columns = (
        np.linspace(0, free, count).astype(int).tolist()
        for free, count in zip((window.height - height, window.width - width), counts)
    )
    return (PixelWindow(window.column + column, window.row + row, width, height) for row in rows for column in columns)


def _same_content(first: np.ndarray, second: np.ndarray, both: np.ndarray) -> bool | None:
    """Whether two stacks (bands, rows, columns) are the same where both have pixels, (rows, columns) bool; None where
    there are none, or all are of one value as in any image of overexposed ground."""
    values = first[:, both]
    if not (values == second[:, both]).all():
        return False
    return True if values.size and (values[0] != values[0, 0]).any() else None


def _joined(sources: Sequence[Source], same: Iterable[tuple[int, int]]) -> list[Source]:
    """The sources with those as one that are the same, by pairs of their numbers, or by a chain of such pairs."""
    pairs = np.array(list(same), int).reshape(-1, 2)
    links = coo_matrix((np.ones(len(pairs)), tuple(pairs.T)), (len(sources), len(sources)))
    parts: dict[int, list[Source]] = {}
    for source, image in zip(sources, connected_components(links, directed=False)[1].tolist()):
        parts.setdefault(image, []).append(source)
    whole = []
    for image_parts in parts.values():
        if len(image_parts) > 1:
            paths = tuple(path for part in image_parts for path in part.ref.paths)
            xmin, ymin, xmax, ymax = zip(*(part.extent for part in image_parts))
            extent = min(xmin), min(ymin), max(xmax), max(ymax)
            may_be_copy = any(part.may_be_copy for part in image_parts)
            image_parts = [Source(replace(image_parts[0].ref, parts=paths[1:]), extent, may_be_copy)]
        whole += image_parts
    return whole
