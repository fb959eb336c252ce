"""The clips of windows for a report as JPEG: the part of each that lost most detail, and lost detail over all of it."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future
from contextlib import suppress
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...imagery.clips import read_clip, read_overview
from ...imagery.errors import Message, RasterError, SeamInspectorError
from ...imagery.grids import Extent, PixelWindow, snap_window
from ...imagery.raster_pool import one_by_one, open_raster, reading_threads
from ...imagery.rasters import Raster
from ...toolkit.pictures import encoded
from ..clip_pictures import bytes_picture, stretched
from ..measure.judgement.visibility import SHOWN_PX, worst_places
from ..measure.profile.window_detail import LossPicture
from ..measure.source_images import Source
from ..measure.window.explained_window import window_lost
from ..measure.window.inspection import Block, InspectionSettings, window_request
from ..measure.window.measured_window import MeasuredWindow, measure_window
from ..words import LOSS_OPACITY, loss_rgba

REPORT_CLIP_PX = SHOWN_PX  # two of them fit beside each other on A4
MAX_REPORT_SOURCES = 2  # shown of a window, the least sharp ones; with chart and mosaic they fill a page
MAX_SEARCHED_SIDE_PX = 512  # of a window, around its centre (on the seam), where the part that lost most is looked for
_AHEAD = 4  # windows that are read or wait to be taken
_WORKERS = 2
_OVERVIEW_PX = 300  # a side of the picture of lost detail at most
_OVERVIEW_QUALITY = 75
_FRAME = (255, 255, 255), (17, 17, 17), (255, 255, 255)  # colours of the outline of a part, the outer one first


@dataclass(frozen=True)
class PlacedLoss:
    """Lost detail, and the pixels of the mosaic that it was measured on."""

    window: PixelWindow
    loss: LossPicture
    width_px: float = 0.0  # how wide its seam took detail; 0 where more did


def measured_loss(block: Block, window: PixelWindow, width_px: float = 0.0) -> PlacedLoss | None:
    """Lost detail of some pixels of a mosaic; None where that can't be told. ``width_px``: of its seam."""
    extent = block.mosaic.grid.window_extent(window)
    request = window_request(block, 0, extent, InspectionSettings())
    measured = measure_window(request, partial(one_by_one, opened=open_raster))
    loss = window_lost(measured) if isinstance(measured, MeasuredWindow) else None
    return None if loss is None or request.window is None else PlacedLoss(request.window, loss, width_px)


def most_lost(window: PixelWindow, placed: PlacedLoss | None, is_along: bool) -> PixelWindow:
    """The part of a window that lost most, on its seam where that is told; its middle, where nothing is told."""
    side = min(REPORT_CLIP_PX, window.width, window.height)
    places = [] if placed is None else worst_places(placed.loss, is_along)
    x, y = places[0] if places else (window.width / 2, window.height / 2)
    column, row = (
        min(max(round(at - side / 2), 0), length - side) for at, length in ((x, window.width), (y, window.height))
    )
    return PixelWindow(window.column + column, window.row + row, side, side)


def loss_overview(mosaic: Raster, placed: PlacedLoss, part: PixelWindow) -> tuple[bytes, int] | None:
    """A JPEG file of a window under lost detail and a frame around a part of it, and its columns; None where no small
    picture of the mosaic can be had."""
    window = placed.window
    overview = read_overview(mosaic, mosaic.grid.window_extent(window), _OVERVIEW_PX)
    if overview is None:
        return None
    picture = bytes_picture(overview[0].bands, mosaic.has_luminance, overview[0].valid)
    step = window.width / picture.shape[1]
    colours = loss_rgba(placed.loss, placed.width_px)
    cells = (np.arange(px) * step // placed.loss.cell_px for px in picture.shape[:2])
    colours = colours[np.ix_(*(np.minimum(at, most - 1).astype(int) for at, most in zip(cells, colours.shape)))]
    opacity = LOSS_OPACITY * colours[..., 3:] / 255
    painted = np.rint(picture * (1 - opacity) + colours[..., :3] * opacity).astype(np.uint8)
    row, column, side = (int(px / step) for px in (part.row - window.row, part.column - window.column, part.width))
    for inset, colour in enumerate(_FRAME):
        _draw_frame(painted, row + inset, column + inset, side - 2 * inset, colour)
    return encoded(painted, "JPEG", _OVERVIEW_QUALITY), painted.shape[1]


def _draw_frame(picture: np.ndarray, row: int, column: int, side: int, colour: tuple[int, ...]) -> None:
    bottom, right = min(row + side, len(picture)) - 1, min(column + side, picture.shape[1]) - 1
    picture[row, column : right + 1] = picture[bottom, column : right + 1] = colour
    picture[row : bottom + 1, column] = picture[row : bottom + 1, right] = colour


@dataclass(frozen=True)
class ClipJob:
    """The clips wanted of one window."""

    extent: Extent | None  # in the mosaic's reference system; None: no clips
    names: tuple[str, ...]  # file names of the sources, those to be shown first in front; empty: as they come
    loss: LossPicture | None = None  # lost detail of the whole window where it was measured already
    width_m: float = 0.0  # how wide its seam took detail; 0 where more did
    is_along: bool = False  # whether the loss that is told is that of its seam


@dataclass(frozen=True)
class PartPicture:
    """A part of one raster's clip."""

    raster: str  # file name without its folder
    is_mosaic: bool
    jpeg: bytes
    columns: int  # its width, px


@dataclass(frozen=True)
class WindowParts:
    """One part of a window, in all of its clips."""

    pictures: tuple[PartPicture, ...] = ()  # the mosaic first
    extent: Extent | None = None  # where the part lies, in the mosaic's reference system
    left_out: int = 0  # how many more sources cover the window
    problem: Message | None = None  # why there are no pictures
    loss: tuple[bytes, int] | None = None
    """Lost detail over the mosaic as JPEG, and its columns; None where nothing is told."""


def window_parts(block: Block, jobs: Iterable[ClipJob]) -> Iterator[WindowParts]:
    """The parts in the order of the jobs, read by two threads a few windows ahead."""
    with reading_threads(_WORKERS) as pool:
        waiting: list[Future[WindowParts]] = []
        try:
            for job in jobs:
                waiting.append(pool.submit(_parts, block, job))
                if len(waiting) >= _AHEAD:
                    yield waiting.pop(0).result()
            while waiting:
                yield waiting.pop(0).result()
        finally:
            for future in waiting:
                future.cancel()


def _parts(block: Block, job: ClipJob) -> WindowParts:
    if job.extent is None:
        return WindowParts()
    mosaic = block.mosaic
    try:
        window, width_px = snap_window(mosaic.grid, job.extent, levels=0), job.width_m / mosaic.ground_sample_distance
        if job.loss is None:
            window = _middle(window)
            placed = measured_loss(block, window, width_px)
        else:
            placed = PlacedLoss(window, job.loss, width_px)
        part = most_lost(window, placed, job.is_along)
        clips = [read_clip(open_raster(mosaic.ref), mosaic, part)]
        loss = None if placed is None else loss_overview(mosaic, placed, part)
    except SeamInspectorError as error:
        return WindowParts(problem=error.message)
    sources = _ordered(block.sources_over(window), job.names)
    shown = 0
    for source in sources:
        if len(clips) > MAX_REPORT_SOURCES:
            break
        shown += 1
        with suppress(RasterError):  # the inspection has said so
            clips.append(read_clip(open_raster(source.ref), mosaic, part))
    made = tuple(
        PartPicture(clip.raster.ref.name, place == 0, encoded(pixels, "JPEG"), part.width)
        for place, (clip, pixels) in enumerate(zip(clips, stretched(clips)))
    )
    return WindowParts(made, mosaic.grid.window_extent(part), len(sources) - shown, loss=loss)


def _middle(window: PixelWindow) -> PixelWindow:
    """The part of a window in which is searched."""
    width, height = min(window.width, MAX_SEARCHED_SIDE_PX), min(window.height, MAX_SEARCHED_SIDE_PX)
    column, row = window.column + (window.width - width) // 2, window.row + (window.height - height) // 2
    return PixelWindow(column, row, width, height)


def _ordered(sources: Sequence[Source], names: Sequence[str]) -> list[Source]:
    """In the order of the names; only those named, where any are."""
    places = {name: place for place, name in reversed(list(enumerate(names)))}
    named = [source for source in sources if source.ref.name in places]
    return sorted(named, key=lambda source: places[source.ref.name]) if named else list(sources)
