"""The jobs of the seam inspection, as generators of plain data: windows, seams, placing, pictures, whole scans."""
from __future__ import annotations

import os
import time
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

from ..imagery.errors import Message
from ..imagery.lines import find_seams
from ..imagery.open_raster import OpenRaster
from ..imagery.raster_pool import reading_threads
from ..imagery.rasters import Raster
from ..toolkit.background_tasks import Ahead, Cancelled, Job
from ..toolkit.translation import filled, tr
from .measure.blocks.block_grid import ScanSettings
from .measure.inputs.mosaic_copies import leave_out_copies
from .measure.planning.window_placing import PlacingSettings, place_windows
from .measure.scan.scan_request import ScanRequest, scan_request
from .measure.scan.whole_scan import MEASURED, WholeScan, whole_scan
from .measure.seamlines.given_seams import GivenSeams, given_seams
from .measure.seamlines.seam_features import SeamFeature
from .measure.source_images import Source
from .measure.window.inspection import inspect_in_stages, inspect_windows
from .measure.window.measured_window import MeasureWindow, WindowRequest, measure_window
from .measure.window.window_result import WindowClips
from .measure.workers import Workers
from .tables.scan_layers import scan_finding, write_scan_file


def inspection_job(requests: Iterable[WindowRequest], count: int, measure: MeasureWindow = measure_window) -> Job:
    """Inspects ``count`` windows; yields a WindowResult each, in their order.

    Of a single window, for which somebody waits, the WindowClips come ahead, and ``measure`` may be faster.
    """

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        if count == 1:
            for measured in inspect_in_stages(next(iter(requests)), measure):
                yield (0.0, Ahead(measured)) if isinstance(measured, WindowClips) else (1.0, measured)
                if cancelled():
                    return
            return
        workers = _workers()
        with reading_threads(workers) as executor:
            results = inspect_windows(requests, executor, 2 * workers, cancelled)
            for done, result in enumerate(results, 1):
                yield done / count, result

    return job


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


_NEWS_S = 0.2
_AHEAD = 2  # blocks under way per thread


@dataclass(frozen=True)
class ScanFiles:
    """The files in which a scan leaves its results. The picture is there before the layers are, so a scan with layers
    is whole."""

    picture: Path  # the picture of losses, a GeoTIFF; the journal lies beside it
    layers: Path  # a GeoPackage with the seams, the source cells and the worst windows


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

    share: float  # share that is done of all there is to do, 0 to 1
    seconds_left: float | None  # none while that is not known
    measured: bool = True  # whether blocks are still being measured, or already put together
    earlier: Message | None = None  # what became of an earlier scan that was stopped
    notices: tuple[Message, ...] = ()  # what was left out or assumed, each once


@dataclass(frozen=True, eq=False)
class ScanDone:
    """What a scan found, and where it is."""

    files: ScanFiles
    finding: Message
    worst_count: int  # windows of the worst places
    notices: tuple[Message, ...] = ()


def scan_job(order: ScanOrder, files: ScanFiles) -> Job:
    """Scans a mosaic, or goes on with a scan that was stopped; yields ScanNews, and a ScanDone in the end."""

    def job(cancelled: Cancelled) -> Iterator[tuple[float, object]]:
        request, notices = _request(order)
        with whole_scan(request, files.picture) as scan:
            yield 0.0, ScanNews(0.0, None, earlier=scan.notice, notices=notices)
            for news in _measured(scan, cancelled):
                yield news.share, news
            if cancelled():
                return
            workers = _workers()
            with reading_threads(1 + workers) as executor:  # one puts it together
                result = scan.result(str(files.picture), Workers(executor, _AHEAD * workers, cancelled))
            if result is None or cancelled():
                return
            write_scan_file(files.layers, result, request)
            scan.finish()
        yield 1.0, ScanDone(files, scan_finding(result.pieces), len(result.worst), result.notices)

    return job


def _request(order: ScanOrder) -> tuple[ScanRequest, tuple[Message, ...]]:
    sources, doubts = leave_out_copies(order.mosaic, order.sources)
    given: GivenSeams | None = None
    if order.read_seams is not None:
        features, lost = order.read_seams()
        given = given_seams(features, order.mosaic.grid, paths=[source.ref.path for source in sources])
        doubts += [] if lost is None else [lost]
    request, notices = scan_request(order.mosaic, sources, order.settings, given)
    return request, (*doubts, *notices)


def _workers() -> int:
    """One core is left to the interface."""
    return max(1, (os.cpu_count() or 1) - 1)


def _measured(scan: WholeScan, cancelled: Cancelled) -> Iterator[ScanNews]:
    """News while all blocks are measured."""
    workers = _workers()
    share, told_at = 0.0, 0.0
    sentences: set[str] = set()
    with reading_threads(workers) as executor:
        for step in scan.steps(Workers(executor, _AHEAD * workers, cancelled)):
            share = max(share, MEASURED * step.share)  # a second look adds blocks
            fresh = tuple(notice for notice in step.notices if str(notice) not in sentences)
            sentences.update(map(str, fresh))
            if fresh or time.monotonic() - told_at > _NEWS_S:
                told_at = time.monotonic()
                yield ScanNews(share, step.seconds_left, notices=fresh)
        yield ScanNews(share, None, measured=False)
