"""The jobs of the seam inspection, as generators of plain data: windows, seams, placing, pictures, whole scans."""
from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from concurrent.futures import wait
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import numpy as np

from ..imagery import messages as imagery_messages
from ..imagery.errors import Message
from ..imagery.gdal_calls import gdal_writing
from ..imagery.lines import find_seams
from ..imagery.open_raster import OpenRaster
from ..imagery.raster_pool import reading_threads
from ..imagery.rasters import Raster
from ..toolkit.background_tasks import Ahead, Cancelled, Job
from ..toolkit.translation import filled, tr
from .measure.blocks.block_grid import BLOCK_PX
from .measure.blocks.scan_block import BlockScan
from .measure.blocks.scan_settings import ScanSettings
from .measure.inputs.mosaic_copies import leave_out_copies
from .measure.planning.window_placing import PlacingSettings, SeamIndex, place_windows
from .measure.profile.ground import grounds
from .measure.scan.gathering import ScanResult
from .measure.scan.loss_raster import BANDS, NODATA, created_cells, loss_cells
from .measure.scan.scan_request import ScanRequest, scan_request
from .measure.scan.whole_scan import MEASURED, WholeScan, whole_scan
from .measure.seamlines.given_seams import GivenSeams, given_seams
from .measure.seamlines.seam_features import SeamFeature
from .measure.source_images import Source
from .measure.window.inspection import inspect_one, inspect_windows
from .measure.window.measured_window import MeasureWindow, measure_window
from .measure.window.window_request import WindowRequest
from .measure.window.window_result import WindowClips
from .tables.scan_layers import write_scan_file


def inspection_job(requests: Iterable[WindowRequest], count: int, measure: MeasureWindow = measure_window) -> Job:
    """Inspects ``count`` windows; yields a WindowResult each, in their order.

    Of a single window, for which somebody waits, the WindowClips come ahead, and ``measure`` may be faster.
    """

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if count == 1:
            for found in inspect_one(next(iter(requests)), measure):
                yield (0.0, Ahead(found)) if isinstance(found, WindowClips) else (1.0, found)
                if cancelled():
                    return
            return
        workers = _workers()
        with reading_threads(workers) as executor:
            results = inspect_windows(requests, executor, 2 * workers, cancelled)
            for done, result in enumerate(results, 1):
                yield done / count, result

    return job


def seams_job(lines: Iterable[bytes | None], pixel_size: float) -> Job:
    """Finds the seams of a layer of lines or polygons; yields the SeamIndex of them."""
    return lambda _cancelled: iter([(1.0, SeamIndex(find_seams(lines, pixel_size)))])


def placing_job(lines: Iterable[bytes | None], mosaic: Raster, settings: PlacingSettings) -> Job:
    """Places windows along the seams of a layer; yields the Placement."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        source = OpenRaster(mosaic.ref)
        seams = find_seams(lines, mosaic.grid.pixel_width)
        placement = place_windows(
            seams, mosaic.grid, settings, lambda window: not cancelled() and source.is_valid(window)
        )
        if not cancelled():
            yield 1.0, placement

    return job


_MINUTE_S, _HOUR_S = 60, 3600


def time_left(seconds: float) -> str:
    """Words for the time that is left, as precise as it can be told."""
    if seconds < _MINUTE_S:
        return tr("less than a minute left")
    if seconds < 1.5 * _HOUR_S:
        return filled(tr("about {count} min left"), count=round(seconds / _MINUTE_S))
    return filled(tr("about {count} h left"), count=round(seconds / _HOUR_S))


MOST_CELLS = 16_000_000  # of the picture, so that it is drawn in a moment, without overviews
_LARGEST_CELL_PX = 256
_FLUSH_S = 0.5


class PictureSoFar:
    """kept_1 of each block by its own ground; the final one knows the ground of neighbours, too.

    Uncompressed and whole from the start, so that whoever reads it meanwhile finds every pixel in its place.
    """

    def __init__(self, path: Path, mosaic: Raster, cell_px: int) -> None:
        """Makes the file, or makes it anew. Raises RasterError where none can be."""
        while mosaic.columns * mosaic.rows > MOST_CELLS * cell_px**2 and cell_px < _LARGEST_CELL_PX:
            cell_px *= 2
        self._cell_px, self._side = cell_px, BLOCK_PX // cell_px
        self._failure = imagery_messages.RASTER_NOT_WRITTEN(path=path)
        with gdal_writing(self._failure):
            dataset = created_cells(str(path), mosaic, cell_px, BANDS[:1])
            dataset.GetRasterBand(1).Fill(NODATA)
            dataset.FlushCache()
        self.has_content = False
        """Whether something was filled in."""
        self._dataset, self._flushed = dataset, -_FLUSH_S  # so that the first block is seen at once

    def add(self, scan: BlockScan) -> None:
        """Fill in what was measured in a block. Raises RasterError when the disk is full."""
        found = loss_cells(
            scan, np.zeros(scan.labels.shape, np.int32), grounds(scan.cells), self._cell_px
        )[0]
        row, column = (one * self._side for one in scan.key)
        dataset = self._dataset
        width, height = (min(self._side, size - start) for size, start in (
            (dataset.RasterXSize, column), (dataset.RasterYSize, row),
        ))
        found = found[:height, :width]
        if not (found != NODATA).any():
            return
        with gdal_writing(self._failure):
            before = dataset.GetRasterBand(1).ReadAsArray(column, row, width, height)
            dataset.GetRasterBand(1).WriteArray(np.where(found != NODATA, found, before), column, row)
            self.has_content = True
            if time.monotonic() - self._flushed > _FLUSH_S:
                self.flush()

    def flush(self) -> None:
        """Let others see what is there. Raises RasterError when the disk is full."""
        with gdal_writing(self._failure):
            self._dataset.FlushCache()
        self._flushed = time.monotonic()

    def close(self) -> None:
        """Let go of the file; the last of it is written."""
        self.flush()
        self._dataset = None


_NEWS_S = 0.2
_AHEAD = 2  # blocks under way per thread


@dataclass(frozen=True)
class ScanFiles:
    """Where a scan leaves its results. The picture is there before the layers are, so a scan with layers is whole."""

    picture: Path
    """The picture of losses, a GeoTIFF; the journal lies beside it."""
    layers: Path
    """A GeoPackage with the seams, the source cells and the worst windows."""
    so_far: Path
    """The picture while the scan is under way; whoever shows it removes it."""


@dataclass(frozen=True, eq=False)
class ScanOrder:
    """What is to be scanned, as any thread may read it."""

    mosaic: Raster
    sources: tuple[Source, ...]
    settings: ScanSettings
    read_seams: Callable[[], tuple[Iterable[SeamFeature], Message | None]] | None = None
    """The features of the seamlines' layer in the mosaic's reference system, and what is wrong with some."""


@dataclass(frozen=True, eq=False)
class ScanNews:
    """How far a scan is."""

    share: float
    """Share that is done of all there is to do, 0 to 1."""
    seconds_left: float | None
    """None while that is not known."""
    measured: bool = True
    """Whether blocks are still being measured, or already put together."""
    has_picture: bool = False
    """Whether there is something in the picture so far."""
    earlier: Message | None = None
    """What became of an earlier scan that was stopped."""
    notices: tuple[Message, ...] = ()
    """What was left out or assumed, each once."""


@dataclass(frozen=True, eq=False)
class ScanDone:
    """What a scan found, and where it is."""

    files: ScanFiles
    seam_metres: float
    failed_metres: float
    worst_kept: float | None
    """kept_1 of the piece that kept least; None where nothing could be measured."""
    worst_count: int
    """Windows of the worst places."""
    notices: tuple[Message, ...] = ()


def scan_job(order: ScanOrder, files: ScanFiles) -> Job:
    """Scans a mosaic, or goes on with a scan that was stopped; yields ScanNews, and a ScanDone in the end."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        request, notices = _request(order)
        with whole_scan(request, files.picture) as scan:
            yield 0.0, ScanNews(0.0, None, earlier=scan.notice, notices=notices)
            for news in _measured(scan, files, cancelled):
                yield news.share, news
            if cancelled():
                return
            result: ScanResult | None = None
            for share, gathered in _gathered(scan, files, cancelled):
                yield share, ScanNews(share, None, measured=False)
                result = gathered
            if result is None or cancelled():
                return
            write_scan_file(files.layers, result, request)
            scan.finish()
        yield 1.0, ScanDone(
            files, float(result.seam_metres), float(result.failed_metres), result.worst_kept, len(result.worst),
            result.notices,
        )

    return job


def _request(order: ScanOrder) -> tuple[ScanRequest, tuple[Message, ...]]:
    sources, told = leave_out_copies(order.mosaic, order.sources)
    given: GivenSeams | None = None
    if order.read_seams is not None:
        features, lost = order.read_seams()
        given = given_seams(features, order.mosaic.grid, paths=[one.ref.path for one in sources])
        told += [] if lost is None else [lost]
    request, notices = scan_request(order.mosaic, sources, order.settings, given)
    return request, (*told, *notices)


def _workers() -> int:
    """One core is left to the interface."""
    return max(1, (os.cpu_count() or 1) - 1)


def _measured(scan: WholeScan, files: ScanFiles, cancelled: Cancelled) -> Iterator[ScanNews]:
    """All blocks, each into the picture so far."""
    workers = _workers()
    request, share, told_at = scan.request, 0.0, 0.0
    told: set[str] = set()
    so_far = PictureSoFar(files.so_far, request.mosaic, request.settings.cell_px)
    with closing(so_far) as picture, reading_threads(workers) as executor:
        for step in scan.steps(executor, _AHEAD * workers, cancelled):
            if request.sources and (found := scan.block(step.key)) is not None:
                picture.add(found)
            share = max(share, MEASURED * step.share)  # a second look adds blocks
            fresh = tuple(notice for notice in step.notices if str(notice) not in told)
            told.update(map(str, fresh))
            if fresh or time.monotonic() - told_at > _NEWS_S:
                told_at = time.monotonic()
                yield ScanNews(share, step.seconds_left, has_picture=picture.has_content, notices=fresh)
        picture.flush()
        yield ScanNews(share, None, measured=False, has_picture=picture.has_content)


def _gathered(scan: WholeScan, files: ScanFiles, cancelled: Cancelled) -> Iterator[tuple[float, ScanResult | None]]:
    """The share that is done, again and again, and the result with the last one."""
    done = MEASURED

    def goes_on(share: float) -> bool:
        nonlocal done
        done = MEASURED + (1 - MEASURED) * share
        return not cancelled()

    workers = _workers()
    with reading_threads(1 + workers) as executor:  # one puts it together
        future = executor.submit(scan.result, str(files.picture), goes_on, executor, _AHEAD * workers)
        while not future.done():
            wait([future], timeout=_NEWS_S)
            yield done, None
        yield done, future.result()
