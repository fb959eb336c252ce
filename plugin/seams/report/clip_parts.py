"""The clips of windows for a report as JPEG: the part of each that lost most detail, and lost detail over all of it."""
from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from concurrent.futures import Future
from dataclasses import dataclass
from functools import partial

import numpy as np

from ...imagery.clips import Clip, read_clip
from ...imagery.errors import Message, RasterError, SeamInspectorError
from ...imagery.grids import Extent, PixelWindow, snap_window
from ...imagery.raster_pool import one_by_one, open_raster, reading_threads
from ...toolkit.pages.picture_files import encoded
from ..clip_pictures import stretched
from ..measure.judgement.greatest_loss import SHOWN_PX
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


def most_lost(shown: PixelWindow, placed: PlacedLoss, side: int) -> tuple[int, int]:
    """Row and column, in the pixels shown, of the square in which most detail was lost."""
    shares, inside = _by_pixel(1 - np.clip(np.nan_to_num(placed.loss.kept, nan=1.0), 0, 1), shown, placed)
    sums = np.pad((shares * inside).cumsum(axis=0).cumsum(axis=1), ((1, 0), (1, 0)))
    lost = sums[side:, side:] - sums[:-side, side:] - sums[side:, :-side] + sums[:-side, :-side]
    row, column = np.unravel_index(lost.argmax(), lost.shape)
    return int(row), int(column)


def loss_overview(pixels: np.ndarray, shown: PixelWindow, placed: PlacedLoss, part: PixelWindow) -> tuple[bytes, int]:
    """A JPEG file of the pixels shown, (rows, columns, 3) uint8, under lost detail and a frame around a part of them,
    and its columns."""
    step = -(-max(shown.width, shown.height) // _OVERVIEW_PX)
    picture = _reduced(pixels, step)
    colours, inside = _by_pixel(loss_rgba(placed.loss, placed.width_px), shown, placed)
    colours = _reduced(colours * inside[..., np.newaxis], step)  # transparent beyond what was measured
    opacity = LOSS_OPACITY * colours[..., 3:] / 255
    painted = np.rint(picture * (1 - opacity) + colours[..., :3] * opacity).astype(np.uint8)
    row, column = (part.row - shown.row) // step, (part.column - shown.column) // step
    for inset, colour in enumerate(_FRAME):
        _draw_frame(painted, row + inset, column + inset, part.height // step - 2 * inset,
                    part.width // step - 2 * inset, colour)  # fmt: skip
    return encoded(painted, "JPEG", _OVERVIEW_QUALITY), painted.shape[1]


def _by_pixel(cells: np.ndarray, shown: PixelWindow, placed: PlacedLoss) -> tuple[np.ndarray, np.ndarray]:
    """What cells say of each pixel shown, and whether it lies in what was measured, both (rows, columns)."""
    side, window = placed.loss.cell_px, placed.window
    rows = np.arange(shown.row, shown.row + shown.height) - window.row
    columns = np.arange(shown.column, shown.column + shown.width) - window.column
    values = cells[np.ix_(np.clip(rows // side, 0, len(cells) - 1), np.clip(columns // side, 0, cells.shape[1] - 1))]
    inside = np.outer((rows >= 0) & (rows < window.height), (columns >= 0) & (columns < window.width))
    return values, inside


def _reduced(pixels: np.ndarray, step: int) -> np.ndarray:
    """The means of ``step`` x ``step`` pixels, float32; what is left over is cut off."""
    rows, columns = (length // step * step for length in pixels.shape[:2])
    summed = np.zeros((rows // step, columns // step, pixels.shape[2]), np.float32)
    for row in range(step):
        for column in range(step):
            summed += pixels[row:rows:step, column:columns:step]
    return summed / step**2


def _draw_frame(picture: np.ndarray, row: int, column: int, rows: int, columns: int, colour: tuple[int, ...]) -> None:
    bottom, right = min(row + rows, len(picture)) - 1, min(column + columns, picture.shape[1]) - 1
    picture[row, column : right + 1] = picture[bottom, column : right + 1] = colour
    picture[row : bottom + 1, column] = picture[row : bottom + 1, right] = colour


@dataclass(frozen=True)
class ClipJob:
    """The clips wanted of one window."""

    extent: Extent | None  # in the mosaic's reference system; None: no clips
    names: tuple[str, ...]  # file names of the sources, those to be shown first in front; empty: as they come
    loss: LossPicture | None = None  # lost detail of the whole window where it was measured already
    width_m: float = 0.0  # how wide its seam took detail; 0 where more did


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
    try:
        window = snap_window(block.mosaic.grid, job.extent, levels=0)
        searched = _middle(window)
        clips = [read_clip(open_raster(block.mosaic.ref), block.mosaic, searched)]
    except SeamInspectorError as error:
        return WindowParts(problem=error.message)
    sources = _ordered(block.sources_over(window), job.names)
    shown = 0
    for source in sources:
        if len(clips) > MAX_REPORT_SOURCES:
            break
        shown += 1
        try:
            clips.append(read_clip(open_raster(source.ref), block.mosaic, searched))
        except RasterError:  # the inspection has said so
            continue
    side = min(REPORT_CLIP_PX, searched.width, searched.height)
    width_px = job.width_m / block.mosaic.ground_sample_distance
    placed = PlacedLoss(window, job.loss, width_px) if job.loss else measured_loss(block, searched, width_px)
    row, column = (searched.height - side) // 2, (searched.width - side) // 2  # its middle, where nothing is told
    if placed is not None:
        row, column = most_lost(searched, placed, side)
    part = PixelWindow(searched.column + column, searched.row + row, side, side)
    loss = None if placed is None else loss_overview(stretched(clips[:1])[0], searched, placed, part)
    square = np.s_[:, row : row + side, column : column + side]
    parts = [Clip(clip.raster, clip.bands[square], clip.invalid_share) for clip in clips]
    made = tuple(
        PartPicture(clip.raster.ref.name, place == 0, encoded(pixels, "JPEG"), side)
        for place, (clip, pixels) in enumerate(zip(clips, stretched(parts)))
    )
    return WindowParts(made, block.mosaic.grid.window_extent(part), len(sources) - shown, loss=loss)


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
