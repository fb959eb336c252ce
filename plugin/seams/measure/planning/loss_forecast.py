"""One window of a mosaic that does not exist yet: request -> what feathering its sources would leave of their detail.

There is no mosaic whose pixels a window could lie on. It lies on those of the first source that covers it, north-up
and among the finest; the others are clipped to it as they would be to a mosaic.
"""
from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import zip_longest

import numpy as np
from osgeo import ogr

from ....imagery import limits as imagery_limits
from ....imagery import messages as imagery_messages
from ....imagery.clips import Clip, read_clip
from ....imagery.errors import Message, NotCoveredError, RasterError, SettingsError, WindowError
from ....imagery.grids import Extent, middle_of, snap_window
from ....imagery.open_raster import OpenRaster, placed
from ....imagery.raster_pool import one_by_one
from ....imagery.reference_systems import extent_on, metres_per_unit
from ....imagery.shifts import Shift, Spectra, find_shift
from ....imagery.wavelets import check_decomposition, judged_plane
from .. import messages
from ..judgement import feather_prediction as prediction
from ..judgement.feather_prediction import Feather, KeptDetail
from ..limits import COSINE, RAMPS
from ..source_images import Source, covers
from ..window.measured_window import InspectionSettings, WindowRequest, comparable, measured_clip
from ..workers import measuring


@dataclass(frozen=True)
class ForecastSettings:
    """What is foretold."""

    wavelet: str = imagery_limits.DEFAULT_WAVELET
    """Any orthogonal wavelet of PyWavelets."""
    levels: int = imagery_limits.DEFAULT_LEVELS
    """R, 1 to 8."""
    width_m: float = 0.0
    """Full width of the feather; 0: of its middle only."""
    ramp: str = COSINE
    """How it leads from one source to the other, one of ``limits.RAMPS``."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        check_decomposition(self.wavelet, self.levels)
        if not 0 <= self.width_m < np.inf:
            raise SettingsError(messages.SCAN_LENGTHS(name="width_m", value=self.width_m, least=0))
        if self.ramp not in RAMPS:
            raise SettingsError(messages.CHOICE_UNKNOWN(name="ramp", value=self.ramp, known=", ".join(RAMPS)))


@dataclass(frozen=True)
class ForecastRequest:
    """All that is needed to foretell one window, in plain data that can cross threads."""

    window_id: int
    sources: tuple[Source, ...]
    """Sources whose footprint covers the window, in the order they were named."""
    extent: Extent | None
    """The window; None when what was drawn can't be measured."""
    wkt: str
    """Reference system of the window, the footprints and the seamlines."""
    settings: ForecastSettings
    seamlines: tuple[bytes, ...] | None = None
    """WKB of all seamlines; None where nobody knows them."""
    reason: Message | None = None
    """Why there is no window."""


@dataclass(frozen=True)
class ForecastPair:
    """Two sources of one window."""

    source: str
    """File name without its folder."""
    other: str
    """File name without its folder."""
    feather: Feather
    """How their details agree, and what half of each would leave."""
    shift: Shift | None
    """How ``other`` lies on ``source`` on the ground, px; None where they show nothing in common."""
    resampled: bool
    """Whether one of them was warped to the window's grid."""
    kept: KeptDetail | None = None
    """What a feather of the width asked for would leave; None where none was."""


@dataclass(frozen=True)
class Forecast:
    """What is to be expected in one window."""

    window_id: int
    extent: Extent | None
    """The pixels that were measured, in the request's reference system; None where nothing was."""
    sources: int
    """How many sources took part."""
    band: str | None
    """The band that was looked at; None where nothing was."""
    pairs: tuple[ForecastPair, ...]
    reason: Message | None = None
    """Why nothing can be foretold."""
    notices: tuple[Message, ...] = field(default=(), compare=False)
    """Why a source that could not be read or compared did not take part."""

    @property
    def expected(self) -> tuple[float | None, ...] | None:
        """Detail variance that a 50:50 feather would leave, levels 1..R, the smallest over the pairs; None without."""
        return prediction.smallest(pair.feather.ratios for pair in self.pairs)

    @property
    def kept(self) -> KeptDetail | None:
        """What a feather of the width asked for would leave, the smallest over the pairs; None where none was."""
        known = [pair.kept for pair in self.pairs if pair.kept is not None]
        window = prediction.smallest(kept.window for kept in known)
        strip = prediction.smallest(kept.strip for kept in known)
        return KeptDetail(window, strip) if window and strip else None


@measuring()
def forecast_window(request: ForecastRequest) -> Forecast:
    """Clip the sources of one window and foretell each pair of them.

    A raster that can't be read or compared is left out with a notice; a window of which nothing can be foretold
    says why. Neither raises.
    """
    if request.extent is None:
        return not_foretold(request, request.reason)
    opened = one_by_one((source.ref, lambda raster: placed(raster.raster) and raster) for source in request.sources)
    sources = [raster for raster in opened if isinstance(raster, OpenRaster)]
    unreadable = [error.message.as_warning() for error in opened if isinstance(error, RasterError)]
    # The band that most are judged by, so that a source of other bands does not cost all the others.
    counts = Counter(source.raster.judged_band for source in sources)
    band = counts.most_common(1)[0][0] if counts else ""
    try:
        place, unfit = _place(request, [source for source in sources if source.raster.judged_band == band])
    except WindowError as error:
        return replace(not_foretold(request, error.message), notices=tuple(unreadable))
    if place is None or place.window is None:
        why = tuple([*unreadable, *unfit][: imagery_limits.MAX_REASONS])
        reason = messages.NO_SOURCE_COMPARABLE(why=why) if why else messages.NO_SOURCES()
        return replace(not_foretold(request, reason), notices=tuple(unreadable))
    measure = partial(measured_clip, request=place, partly=False, judged_only=True)
    measured, notices, _ = comparable(one_by_one([(source.ref, measure) for source in request.sources]), band)
    clips, mosaic = [source.clip for source in measured], place.mosaic
    planes = [judged_plane(clip.bands, clip.raster.band_names) for clip in clips]
    wavelet, levels = request.settings.wavelet, request.settings.levels
    pairs = prediction.feathers(planes, wavelet, levels)
    kept, assumed = _kept(request, place, planes, pairs)
    spectra = [Spectra(plane) for plane in planes]
    return Forecast(
        request.window_id,
        extent_on(mosaic.grid.window_extent(place.window), mosaic.wkt, request.wkt or mosaic.wkt),
        len(clips),
        band,
        tuple(_pair(clips, spectra, feather, detail) for feather, detail in zip_longest(pairs, kept)),
        _reason(len(clips), pairs, tuple(notices[: imagery_limits.MAX_REASONS])),
        (*notices, *assumed),
    )


def not_foretold(request: ForecastRequest, reason: Message | None) -> Forecast:
    """The result of a window of which nothing can be foretold."""
    return Forecast(request.window_id, None, 0, None, (), reason)


def _place(request: ForecastRequest, sources: Sequence[OpenRaster]) -> tuple[WindowRequest | None, list[Message]]:
    """The window on the first of the finest sources that covers it north-up, which stands in for the mosaic, and why
    those before it did not do.

    Raises WindowError when the window can't be measured on that grid.
    """
    assert request.extent is not None
    unfit: list[Message] = []
    settings = InspectionSettings(request.settings.wavelet, request.settings.levels)
    finest = min((source.raster.ground_sample_distance for source in sources), default=0.0)
    alike = (1 + imagery_limits.MAX_PIXEL_SIZE_DIFFERENCE) * finest
    for source in sorted(sources, key=lambda source: max(source.raster.ground_sample_distance, alike)):
        try:
            raster, grid = source.raster, source.raster.grid
            extent = extent_on(request.extent, request.wkt or raster.wkt, raster.wkt)
            if not covers(raster.extent, extent, grid.pixel_width, grid.pixel_height):
                raise NotCoveredError(imagery_messages.NOT_COVERED(name=raster.ref.name))
            window = snap_window(grid, extent, settings.levels)
            read_clip(source, raster, window)  # it may have holes there
            return WindowRequest(request.window_id, raster, (), window, settings, is_alone=True), unfit
        except RasterError as error:
            unfit.append(error.message)
    return None, unfit


def _kept(
    request: ForecastRequest, place: WindowRequest, planes: Sequence[np.ndarray], pairs: Sequence[Feather]
) -> tuple[list[KeptDetail], list[Message]]:
    """What a feather of the width asked for would leave of each pair, and what had to be assumed for it."""
    settings = request.settings
    if not settings.width_m or not pairs:
        return [], []
    assert place.window is not None
    grid = place.mosaic.grid
    metres_x, metres_y = metres_per_unit(place.mosaic.wkt, middle_of(grid.window_extent(place.window)))
    pixel_m = grid.pixel_height * metres_y, grid.pixel_width * metres_x
    drawn = None
    if request.seamlines is not None and request.extent is not None:
        (xmin, ymin, xmax, ymax), lines = request.extent, map(ogr.CreateGeometryFromWkb, request.seamlines)
        near = (
            line for line in lines for left, right, bottom, top in [line.GetEnvelope()]
            if left <= xmax and right >= xmin and bottom <= ymax and top >= ymin
        )
        with suppress(RasterError):
            drawn = prediction.drawn_seam(near, request.wkt or place.mosaic.wkt, place.mosaic, place.window, pixel_m)
    seams = prediction.assumed_seams(place.window.height, place.window.width, pixel_m) if drawn is None else [drawn]
    assumed = [messages.SEAM_ASSUMED()] if request.seamlines is not None and drawn is None else []
    places = [prediction.place_feather(distance, settings.ramp, settings.width_m, pixel_m) for distance in seams]
    return [
        prediction.kept_detail(planes[pair.first], planes[pair.second], places, settings.wavelet, settings.levels)
        for pair in pairs
    ], assumed


def _pair(
    clips: Sequence[Clip], spectra: Sequence[Spectra], feather: Feather, kept: KeptDetail | None
) -> ForecastPair:
    source, other = clips[feather.first], clips[feather.second]
    shift = find_shift(spectra[feather.second], spectra[feather.first])
    if shift is not None:  # their pixel grids may lie beside each other
        x, y = source.offset_x - other.offset_x, source.offset_y - other.offset_y
        shift = replace(shift, x=shift.x + x, y=shift.y + y)
    return ForecastPair(
        source.raster.ref.name, other.raster.ref.name, feather, shift, source.resampled or other.resampled, kept
    )


def _reason(count: int, pairs: Sequence[Feather], why: tuple[Message, ...]) -> Message | None:
    if count == 0:
        return messages.NO_SOURCE_COMPARABLE(why=why)
    if count == 1:
        return messages.ONE_SOURCE_COMPARABLE(why=why) if why else messages.ONE_SOURCE()
    return messages.SOURCES_WITHOUT_DETAIL() if all(pair.rho[0] is None for pair in pairs) else None
