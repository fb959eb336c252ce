"""One window: request -> result. Many windows: the same on any ``concurrent.futures.Executor``."""
from __future__ import annotations

import os
from collections import deque
from collections.abc import Iterable, Iterator
from concurrent.futures import Executor, Future, wait
from dataclasses import dataclass, field
from typing import Callable

import numpy as np

from . import messages, thresholds
from .contrast import Judgement, Ratios, Verdict, check_max_ratio, curve_ratios, judge
from .errors import NotCoveredError, RasterError, SettingsError, WindowError
from .messages import Message
from .rasters import Clip, Mosaic, Raster, RasterRef, describe, read_clip
from .systems import extent_on
from .wavelets import Curve, check_decomposition, clip_curves
from .windows import Extent, PixelWindow, snap_window

LUMINANCE = "luminance"
_PATIENCE_SECONDS = 0.2  # between two looks at whether the run was cancelled


@dataclass(frozen=True)
class Settings:
    """How windows are measured and judged."""

    wavelet: str = thresholds.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = thresholds.DEFAULT_LEVELS
    """R, 1 to 8."""
    max_ratio: float = thresholds.MAX_SIGNIFICANT_RATIO
    """Largest ratio_1 that is a significant loss."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        check_decomposition(self.wavelet, self.levels)
        check_max_ratio(self.max_ratio)


@dataclass(frozen=True)
class Source:
    """An orthoimage that may take part, with its footprint; the file itself is opened when a window needs it."""

    ref: RasterRef
    extent: Extent
    """Bounding box in the mosaic's reference system."""


@dataclass(frozen=True)
class Block:
    """A mosaic and the orthoimages it may have been made from."""

    mosaic: Mosaic
    sources: tuple[Source, ...]

    def sources_over(self, window: PixelWindow) -> tuple[Source, ...]:
        """Those whose footprint covers the window, give or take the share of pixels that may be invalid."""
        xmin, ymin, xmax, ymax = self.mosaic.grid.window_extent(window)
        slack_x = thresholds.MAX_INVALID_SHARE * (xmax - xmin) + self.mosaic.grid.pixel_width
        slack_y = thresholds.MAX_INVALID_SHARE * (ymax - ymin) + self.mosaic.grid.pixel_height
        return tuple(
            source
            for source in self.sources
            if source.extent[0] <= xmin + slack_x
            and source.extent[1] <= ymin + slack_y
            and source.extent[2] >= xmax - slack_x
            and source.extent[3] >= ymax - slack_y
        )


@dataclass(frozen=True)
class WindowRequest:
    """All that is needed to measure one window, in plain data that can cross threads and processes."""

    window_id: int
    mosaic: Mosaic
    sources: tuple[Source, ...]
    """Those that may cover the window."""
    window: PixelWindow | None
    """On the mosaic's grid; None when the drawn rectangle can't be measured."""
    settings: Settings
    reason: Message | None = None
    """Why there is no window."""


@dataclass(frozen=True)
class ClipResult:
    """The curves of one raster in one window."""

    raster: str
    """File name without its folder."""
    role: str
    """``mosaic`` or ``source``."""
    curves: dict[str, Curve]
    """By band name, ``luminance`` first where there is one."""


@dataclass(frozen=True)
class PairResult:
    """The mosaic against one source in one window and band."""

    source: str
    """File name without its folder."""
    band: str
    ratios: Ratios
    similarity: float | None
    """Correlation of the coarse components at level R; None where one of them is constant."""
    offset_x: float
    """Sub-pixel offset of the source's pixel grid, px."""
    offset_y: float
    resampled: bool
    """Whether the source was warped to the mosaic's grid."""


@dataclass(frozen=True)
class WindowResult:
    """What was measured in one window."""

    window_id: int
    window: PixelWindow | None
    """The pixels of the mosaic that were measured."""
    judgement: Judgement
    clips: tuple[ClipResult, ...] = ()
    """The mosaic first, then the sources that took part."""
    pairs: tuple[PairResult, ...] = ()
    notices: tuple[Message, ...] = field(default=(), compare=False)
    """Why a source that could not be read or compared did not take part."""

    @property
    def source_count(self) -> int:
        """How many sources took part."""
        return sum(clip.role == "source" for clip in self.clips)


def make_block(
    mosaic: Mosaic, sources: Iterable[RasterRef], indexed: Iterable[Source] = ()
) -> tuple[Block, list[Message]]:
    """A mosaic with its sources, each once, and notices about those left out.

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
    for candidate in candidates:
        ref = candidate.ref if isinstance(candidate, Source) else candidate
        key = _key(ref)
        if key == _key(mosaic.ref):
            notices.append(messages.MOSAIC_AMONG_SOURCES(name=ref.name))
        elif key not in taken:
            taken.add(key)
            try:
                kept.append(candidate if isinstance(candidate, Source) else _footprint(ref, mosaic))
            except RasterError as error:
                notices.append(messages.SOURCE_LEFT_OUT(name=ref.name, why=error.message))
    return Block(mosaic, tuple(kept)), notices


def _footprint(ref: RasterRef, mosaic: Mosaic) -> Source:
    raster = describe(ref)
    if not raster.wkt:
        raise RasterError(messages.NO_REFERENCE_SYSTEM(name=ref.name))
    return Source(ref, extent_on(raster.extent, raster.wkt, mosaic.wkt))


def window_request(block: Block, window_id: int, extent: Extent, settings: Settings) -> WindowRequest:
    """The request for a rectangle in the mosaic's reference system, snapped to the mosaic's pixels."""
    try:
        window = snap_window(block.mosaic.grid, extent, settings.levels)
    except WindowError as error:
        return WindowRequest(window_id, block.mosaic, (), None, settings, error.message)
    return WindowRequest(window_id, block.mosaic, block.sources_over(window), window, settings)


def inspect_window(request: WindowRequest) -> WindowResult:
    """Clip, decompose, compare and judge one window.

    A raster that can't be compared is left out with a notice; a window that can't be measured is
    ``not_comparable`` with the reason. Neither raises.
    """
    if request.window is None:
        return _not_comparable(request, request.reason)
    try:
        mosaic = read_clip(request.mosaic.ref, request.mosaic, request.window)
    except RasterError as error:
        return _not_comparable(request, error.message)
    mosaic_curves, mosaic_coarse = _measure(mosaic, request.settings)
    band = _judged_band(mosaic.raster)
    clips = [ClipResult(mosaic.raster.ref.name, "mosaic", mosaic_curves)]
    del mosaic  # its pixels, so that the next raster's take their place
    pairs: list[PairResult] = []
    notices: list[Message] = []
    not_covering: list[Message] = []
    for source in request.sources:
        try:
            clip = read_clip(source.ref, request.mosaic, request.window)
            curves, coarse = _measure(clip, request.settings)
            _check_comparable(clip, curves, band)
        except NotCoveredError as error:
            not_covering.append(error.message)
            continue
        except RasterError as error:
            notices.append(error.message)
            continue
        clips.append(ClipResult(source.ref.name, "source", curves))
        pairs += [
            PairResult(
                source.ref.name,
                name,
                curve_ratios(mosaic_curves[name], curve),
                _correlation(mosaic_coarse[name], coarse[name]),
                clip.offset_x,
                clip.offset_y,
                clip.resampled,
            )
            for name, curve in curves.items()
            if name in mosaic_curves
        ]
        del clip
    judgement = judge(
        mosaic_curves[band], [clip.curves[band] for clip in clips[1:]], request.settings.max_ratio
    )
    refused = (*notices, *not_covering)
    if len(clips) == 1 and refused and mosaic_curves[band].variance > 0:
        why = refused[: thresholds.MAX_REASONS]
        judgement = Judgement(judgement.verdict, judgement.ratios, messages.NO_SOURCE_COMPARABLE(why=why))
    return WindowResult(request.window_id, request.window, judgement, tuple(clips), tuple(pairs), tuple(notices))


def inspect_windows(
    requests: Iterable[WindowRequest], executor: Executor, ahead: int, cancelled: Callable[[], bool] = lambda: False
) -> Iterator[WindowResult]:
    """Results in the order of the requests, each as soon as it and those before it are ready.

    At most ``ahead`` windows are under way or waiting to be taken, so memory does not grow with their number.
    A window that fails in a way nobody foresaw becomes ``not_comparable`` with the error as its reason.
    Stops when ``cancelled`` says so, with the results that are ready by then, within a fraction of a second even
    while a window is under way.
    """
    waiting: deque[tuple[WindowRequest, Future[WindowResult]]] = deque()
    try:
        for request in requests:
            if cancelled():
                break
            waiting.append((request, executor.submit(inspect_window, request)))
            if len(waiting) >= ahead:
                yield from _ready(*waiting.popleft(), cancelled)
        while waiting:
            yield from _ready(*waiting.popleft(), cancelled)
    finally:
        for _, future in waiting:
            future.cancel()


def _ready(
    request: WindowRequest, future: Future[WindowResult], cancelled: Callable[[], bool]
) -> Iterator[WindowResult]:
    """The result as soon as it is there; nothing when ``cancelled`` says so before."""
    while not future.done():
        if cancelled():
            future.cancel()
            return
        wait([future], timeout=_PATIENCE_SECONDS)
    error = future.exception()
    if error is None:
        yield future.result()
    elif isinstance(error, Exception):
        yield _not_comparable(request, messages.WINDOW_FAILED(error=f"{type(error).__name__}: {error}"))
    else:
        raise error


def _measure(clip: Clip, settings: Settings) -> tuple[dict[str, Curve], dict[str, np.ndarray]]:
    """Curves and coarse components of a clip by band name, luminance first where there is one."""
    weights = thresholds.LUMINANCE_WEIGHTS if clip.raster.has_luminance else ()
    curves, coarse = clip_curves(clip.bands, settings.wavelet, settings.levels, weights)
    names = list(clip.raster.band_names)
    if weights:
        names, curves, coarse = [LUMINANCE, *names], [curves[-1], *curves[:-1]], [coarse[-1], *coarse[:-1]]
    return dict(zip(names, curves)), dict(zip(names, coarse))


def _judged_band(raster: Raster) -> str:
    """Luminance where there are three bands or more, else the first band."""
    return LUMINANCE if raster.has_luminance else raster.band_names[0]


def _check_comparable(clip: Clip, curves: dict[str, Curve], band: str) -> None:
    name = clip.raster.ref.name
    if band not in curves:
        raise RasterError(messages.BANDS_DIFFER(name=name, band=band, bands=", ".join(clip.raster.band_names)))
    if curves[band].variance == 0:
        raise RasterError(messages.SOURCE_CONSTANT(name=name))


def _correlation(a: np.ndarray, b: np.ndarray) -> float | None:
    a, b = (x.astype(np.float64).ravel() for x in (a, b))
    a, b = a - a.mean(), b - b.mean()
    scale = np.sqrt((a @ a) * (b @ b))
    return float(a @ b / scale) if scale > 0 else None


def _not_comparable(request: WindowRequest, reason: Message | None) -> WindowResult:
    nothing = Ratios((None,) * request.settings.levels, None)
    return WindowResult(request.window_id, request.window, Judgement(Verdict.NOT_COMPARABLE, nothing, reason))


def _key(ref: RasterRef) -> str:
    """The same for the same file, however its path is written."""
    return os.path.realpath(ref.path) if os.path.exists(ref.path) else ref.path
