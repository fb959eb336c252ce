"""The first half of an inspection: what is to be measured in a window, and the ground around it that is read with it
where it is small, to compare its seam with and to tell labels and filters by; its clips, their curves, and the paper's
verdict; also of windows that are measured before anybody asks for them, such as the one under the mouse."""
from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache, partial
from threading import Lock
from typing import Union

import numpy as np

from ....imagery import limits as imagery_limits
from ....imagery.clips import Clip
from ....imagery.errors import Message, NotCoveredError, RasterError, SettingsError
from ....imagery.grids import PixelWindow
from ....imagery.limits import LUMINANCE, measured_bands
from ....imagery.open_raster import OpenRaster
from ....imagery.raster_pool import ReadEach, one_by_one
from ....imagery.rasters import Raster
from ....imagery.wavelets import Curve, check_decomposition, judged_plane, measure_bands, measure_directions
from .. import limits, messages
from ..compared_image import MeasuredClip, read_grey_clip
from ..judgement.verdicts import Judgement, Ratios, Verdict, judge_curves
from ..profile.cell_table import CELL_PX
from ..seam_cells import Cell
from ..source_images import Source, images_in_parts, whole_images_of_clips
from ..window_records import REFERENCES
from .window_result import ClipResult, WindowResult

MARGIN_PX = 128
"""On every side, or what there is of the mosaic."""
ENOUGH_PX = 512
"""A side: a window as long has ground enough of its own."""


def surroundings(window: PixelWindow, mosaic: Raster, levels: int) -> PixelWindow:
    """A window with its margin, in whole cells and multiples of 2^R, inside the mosaic."""
    across, down = (min(MARGIN_PX, max(ENOUGH_PX - side, 0) // 2) for side in (window.width, window.height))
    wanted = PixelWindow(window.column - across, window.row - down, window.width + 2 * across, window.height + 2 * down)
    margins, step = wanted.cut_to(mosaic.columns, mosaic.rows).margins_of(window), max(CELL_PX, 2 ** int(levels))
    (top, bottom), (left, right) = ((before // step * step, after // step * step) for before, after in margins)
    return PixelWindow(
        window.column - left, window.row - top, window.width + left + right, window.height + top + bottom
    )


def place_in(window: PixelWindow, around: PixelWindow) -> tuple[slice, slice]:
    """Rows and columns of a window in a larger one."""
    row, column = window.row - around.row, window.column - around.column
    return slice(row, row + window.height), slice(column, column + window.width)


def read_with_surroundings(
    raster: OpenRaster, mosaic: Raster, window: PixelWindow, around: PixelWindow, partly: bool
) -> tuple[Clip, Clip, float]:
    """The clip of a window, that of all that is read around it, and by what both were multiplied.

    The window's own is as ``read_grey_clip`` has it. Raises RasterError.
    """
    wide: Clip | None = None
    if around != window:
        with suppress(RasterError if partly else NotCoveredError):  # the window itself may be covered, and readable
            wide, factor = read_grey_clip(raster, mosaic, around, partly=True)
    if wide is not None and wide.invalid_share == 0:
        place = place_in(window, around)
        return replace(wide, bands=np.ascontiguousarray(wide.bands[(slice(None), *place)])), wide, factor
    clip, factor = read_grey_clip(raster, mosaic, window, partly)
    if wide is None and around != window:  # which has no pixels there: mirrored, so that no edge is seen
        valid = np.zeros((around.height, around.width), bool)
        valid[place_in(window, around)] = True if clip.valid is None else clip.valid
        bands = np.pad(clip.bands, [(0, 0), *around.margins_of(window)], "symmetric")
        wide = replace(clip, bands=bands, valid=valid)
    return clip, wide or clip, factor


@dataclass(frozen=True)
class InspectionSettings:
    """How windows are measured and judged."""

    wavelet: str = imagery_limits.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """R, 1 to 8."""
    max_ratio: float = imagery_limits.MAX_SIGNIFICANT_RATIO
    """Largest ratio_1 that is a significant loss."""
    reference: str = REFERENCES[0]
    """What the verdict is taken by: ``seam``, the sources' ``composite``, or whole ``sources`` as in the paper."""
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT
    """Share of the finest detail along the seam, kept_1, at or below which a loss is significant."""
    directions: bool = False
    """Whether the detail of the mosaic and the sources is told by direction too."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        imagery_limits.check_settings(self, InspectionSettings)
        check_decomposition(self.wavelet, self.levels)
        for name, limit in (("max_ratio", self.max_ratio), ("min_kept", self.min_kept)):
            if not 0 < limit < 1:
                raise SettingsError(messages.LIMIT_OUT_OF_RANGE(name=name, limit=limit))
        if self.reference not in REFERENCES:
            known = ", ".join(REFERENCES)
            raise SettingsError(messages.CHOICE_UNKNOWN(name="reference", value=self.reference, known=known))


@dataclass(frozen=True)
class WindowRequest:
    """All that is needed to measure one window, in plain data that can cross threads and processes."""

    window_id: int
    """What its result is known by."""
    mosaic: Raster
    """Whose grid the window lies on."""
    sources: tuple[Source, ...]
    """Sources that may cover the window."""
    window: PixelWindow | None
    """On the mosaic's grid; None when the drawn rectangle can't be measured."""
    settings: InspectionSettings
    """How it is measured and judged."""
    reason: Message | None = None
    """Why there is no window."""
    cells: tuple[Cell, ...] = ()
    """Known seam cells that meet the window."""
    is_alone: bool = False
    """Whether the mosaic can't be read around it."""

    @property
    def around(self) -> PixelWindow:
        """All that is read: a small window with the ground around it."""
        assert self.window is not None
        return self.window if self.is_alone else surroundings(self.window, self.mosaic, self.settings.levels)


def not_comparable(request: WindowRequest, reason: Message | None) -> WindowResult:
    """The result of a window that could not be measured."""
    nothing = Ratios((None,) * request.settings.levels, None)
    judgement = Judgement(Verdict.NOT_COMPARABLE, nothing, reason)
    reference = request.settings.reference
    return WindowResult(request.window_id, request.window, judgement, judgement.verdict, reference=reference)


@dataclass(frozen=True, eq=False)
class MeasuredWindow:
    """The pixels of a window that can be compared, and what was measured in each raster by itself."""

    request: WindowRequest
    mosaic: MeasuredClip
    judged: tuple[MeasuredClip, ...]
    """The sources that the verdict is taken against: those of the mosaic's pixel size, or the others where none is."""
    sources: tuple[MeasuredClip, ...]
    """All that can be compared, in their order."""
    paper: Judgement
    notices: tuple[Message, ...]
    """Why a source that could not be read or compared does not take part, or is only shown."""

    @cached_property
    def result(self) -> WindowResult:
        """The curves and the paper's verdict, without the pixels."""
        request, settings = self.request, self.request.settings
        named = ((self.mosaic, "mosaic"), *((source, "source") for source in self.sources if source.curves))
        clips = []
        for measured, role in named:
            clip, curves = measured.clip, in_file_values(measured.curves, measured.grey_factor)
            directions = measure_directions(clip, settings.wavelet, settings.levels) if settings.directions else {}
            clips.append(ClipResult(clip.raster.ref.name, role, curves, directions))
        return WindowResult(
            request.window_id, request.window, self.paper, self.paper.verdict, tuple(clips), notices=self.notices,
            ground_sample_distance=request.mosaic.ground_sample_distance, reference=settings.reference,
        )

    @property
    def band(self) -> str:
        """The one that the verdict looks at."""
        return self.mosaic.clip.raster.judged_band

    @property
    def is_explicable(self) -> bool:
        """Whether there is anything that sources could explain."""
        all_whole = all(source.clip.valid is None for source in self.judged)
        has_no_detail = all_whole and self.paper.verdict is Verdict.NOT_COMPARABLE
        return bool(self.judged) and self.mosaic.curves[self.band].variance > 0 and not has_no_detail


Measured = Union["MeasuredWindow", "Message", None]
"""A window, or why there is none, as its request or its mosaic has it."""

MeasureWindow = Callable[["WindowRequest"], Measured]


def measure_window(
    request: WindowRequest, read_each: ReadEach = one_by_one, judged_only: bool = False
) -> Measured:
    """Read and measure the clips of a window; why there are none where there is no window or no mosaic.

    ``read_each`` opens the rasters, and may read them side by side. ``judged_only``: curves of the judged band alone.
    """
    if request.window is None:
        return request.reason
    refs = request.mosaic.ref, *(source.ref for source in request.sources)
    mosaic, *others = read_each([
        (ref, partial(measured_clip, request=request, partly=number > 0, judged_only=judged_only))
        for number, ref in enumerate(refs)
    ])
    if isinstance(mosaic, RasterError):
        is_last = request.around == request.window
        return mosaic.message if is_last else measure_window(replace(request, is_alone=True), read_each, judged_only)
    clips = [None if isinstance(other, RasterError) else other.around or other.clip for other in others]
    images = whole_images_of_clips(request.sources, clips)
    if len(images) < len(request.sources):
        return measure_window(replace(request, sources=tuple(images)), read_each, judged_only)
    band = mosaic.clip.raster.judged_band
    sources, notices, not_covering = comparable(others, band)
    pixel_m = mosaic.clip.raster.ground_sample_distance
    judged = [
        source for source in sources
        if abs(source.clip.raster.ground_sample_distance / pixel_m - 1) <= imagery_limits.MAX_PIXEL_SIZE_DIFFERENCE
    ] or sources
    shown = [source for source in sources if source not in judged]
    notices += [messages.SOURCE_RESAMPLED(name=source.clip.raster.ref.name) for source in shown]
    as_they_are = [source for source in judged if not source.clip.resampled] or judged
    whole = [source.curves[band] for source in as_they_are if source.clip.valid is None]
    paper = judge_curves(mosaic.curves[band], whole, request.settings.max_ratio)
    refused = (*notices, *not_covering)
    notices += images_in_parts(request.sources)
    if not judged and refused and mosaic.curves[band].variance > 0:
        why = refused[: imagery_limits.MAX_REASONS]
        paper = replace(paper, reason=messages.NO_SOURCE_COMPARABLE(why=why))
    return MeasuredWindow(request, mosaic, tuple(judged), tuple(sources), paper, tuple(notices))


def measured_clip(raster: OpenRaster, request: WindowRequest, partly: bool, judged_only: bool) -> MeasuredClip:
    """A raster's clip of a window, with its curves where it has all pixels. Raises RasterError."""
    window, around = request.window, request.around
    assert window is not None
    clip, wide, factor = read_with_surroundings(raster, request.mosaic, window, around, partly)
    inside = place_in(window, around)
    if clip.valid is not None:
        return MeasuredClip(clip, {}, {}, factor, wide, inside)
    names, band = clip.raster.band_names, request.mosaic.judged_band
    wavelet, levels = request.settings.wavelet, request.settings.levels
    if judged_only and band in measured_bands(names):
        wanted = slice(3) if band == LUMINANCE else slice(names.index(band), names.index(band) + 1)
        plane = judged_plane(clip.bands[wanted], names[wanted])[np.newaxis]
        return MeasuredClip(clip, *measure_bands(plane, (band,), wavelet, levels), factor, wide, inside)
    return MeasuredClip(clip, *measure_bands(clip.bands, clip.raster.band_names, wavelet, levels), factor, wide, inside)


def in_file_values(curves: Mapping[str, Curve], factor: float) -> dict[str, Curve]:
    """Curves of values that were multiplied, with the variance that the file's have."""
    return {name: replace(curve, variance=curve.variance / factor**2) for name, curve in curves.items()}


def comparable(
    measured: Iterable[MeasuredClip | RasterError], band: str
) -> tuple[list[MeasuredClip], list[Message], list[Message]]:
    """Sources that can be compared, why others can't, and which do not cover the window at all."""
    sources: list[MeasuredClip] = []
    notices: list[Message] = []
    not_covering: list[Message] = []
    for source in measured:
        if isinstance(source, NotCoveredError):
            not_covering.append(source.message.as_warning())
        elif isinstance(source, RasterError):
            notices.append(source.message.as_warning())
        else:
            name, bands = source.clip.raster.ref.name, source.clip.raster.band_names
            if band not in measured_bands(bands):
                notices.append(messages.BANDS_DIFFER(name=name, band=band, bands=", ".join(bands)).as_warning())
            elif source.curves and source.curves[band].variance == 0:
                notices.append(messages.SOURCE_CONSTANT(name=name).as_warning())
            else:
                sources.append(source)
    return sources, notices, not_covering


HELD_WINDOWS = 2  # windows with their pixels, some 10 MB each: the one under the mouse, and the one before


class MeasuredAhead:
    """A ``MeasureWindow`` that keeps the last windows; who asks for one that is under way waits for it."""

    def __init__(self, read_each: ReadEach) -> None:
        self._measure = lru_cache(HELD_WINDOWS)(lambda request: measure_window(request, read_each))
        self._lock = Lock()

    def __call__(self, request: WindowRequest) -> Measured:
        with self._lock:
            measured = self._measure(replace(request, window_id=0))
        return replace(measured, request=request) if isinstance(measured, MeasuredWindow) else measured

    def forget(self) -> None:
        """Let go of the pixels."""
        self._measure.cache_clear()
