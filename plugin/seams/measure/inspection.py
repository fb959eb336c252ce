"""One window: request -> result."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from ...imagery import limits as imagery_limits
from ...imagery.band_curves import Directions, correlation, measure_clip, measure_directions
from ...imagery.band_names import measured_bands
from ...imagery.clips import read_clip
from ...imagery.errors import NotCoveredError, RasterError, SettingsError, WindowError
from ...imagery.grids import Extent, PixelWindow, snap_window
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.wavelets import Curve, check_decomposition
from . import limits, messages
from .causes import Cause
from .changes import Change
from .compared_image import MeasuredClip
from .explanation import Explanation, explain
from .profile.loss_picture import LossPicture
from .profile.seam_profile import SeamProfile
from .seam_cells import UNKNOWN, Cell, cell_labels, cells_over
from .source_images import Source, gather_sources, sources_in
from .verdicts import Judgement, Ratios, Verdict, check_max_ratio, check_min_kept, curve_ratios, judge, judge_by_seam
from .window_records import COMPOSITE, REFERENCES, SEAM


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
    """What the verdict is taken by, one of ``REFERENCES``."""
    min_kept: float = limits.MAX_SIGNIFICANT_KEPT
    """Share of the finest detail along the seam, kept_1, at or below which a loss is significant."""
    directions: bool = False
    """Whether the detail of the mosaic and the sources is told by direction too."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        check_decomposition(self.wavelet, self.levels)
        check_max_ratio(self.max_ratio)
        check_min_kept(self.min_kept)
        if self.reference not in REFERENCES:
            raise SettingsError(messages.REFERENCE_UNKNOWN(reference=self.reference, known=", ".join(REFERENCES)))


@dataclass(frozen=True)
class Block:
    """A mosaic and the orthoimages it may have been made from."""

    mosaic: Raster
    sources: tuple[Source, ...]
    cells: tuple[Cell, ...] = ()
    """Which source each part of the mosaic was cut from, where that is known."""

    def sources_over(self, window: PixelWindow) -> tuple[Source, ...]:
        """Those whose footprint meets the window, wholly or in part."""
        return sources_in(self.sources, self.mosaic.grid.window_extent(window))


@dataclass(frozen=True)
class WindowRequest:
    """All that is needed to measure one window, in plain data that can cross threads and processes."""

    window_id: int
    mosaic: Raster
    sources: tuple[Source, ...]
    """Those that may cover the window."""
    window: PixelWindow | None
    """On the mosaic's grid; None when the drawn rectangle can't be measured."""
    settings: InspectionSettings
    reason: Message | None = None
    """Why there is no window."""
    cells: tuple[Cell, ...] = ()
    """Known seam cells that meet the window."""


@dataclass(frozen=True)
class ClipResult:
    """The curves of one raster in one window."""

    raster: str
    """File name without its folder."""
    role: str
    """``mosaic``, ``source`` or ``composite``."""
    curves: dict[str, Curve]
    """By band name, ``luminance`` first where there is one."""
    directions: dict[str, Directions] = field(default_factory=dict)
    """The same by direction; empty where that was not asked for."""


@dataclass(frozen=True)
class PairResult:
    """The mosaic against one source in one window and band."""

    source: str
    """File name without its folder, or ``composite``."""
    band: str
    ratios: Ratios
    similarity: float | None
    """Correlation of the coarse components at level R; None where one of them is constant."""
    offset_x: float
    """Sub-pixel offset of the source's pixel grid, px."""
    offset_y: float
    resampled: bool
    """Whether the source was warped to the mosaic's grid."""
    change: Change | None = None
    """What became of its grey values in the mosaic."""


@dataclass(frozen=True)
class WindowResult:
    """What was measured in one window."""

    window_id: int
    window: PixelWindow | None
    """The pixels of the mosaic that were measured."""
    judgement: Judgement
    """The verdict that counts, and the ratios of the paper."""
    paper_verdict: Verdict
    """By the paper's rule, whatever the verdict was taken by."""
    clips: tuple[ClipResult, ...] = ()
    """The mosaic first, then the sources that took part."""
    pairs: tuple[PairResult, ...] = ()
    explanation: Explanation | None = None
    """Why contrast was lost; None where nothing could be compared."""
    notices: tuple[Message, ...] = field(default=(), compare=False)
    """Why a source that could not be read or compared did not take part, or only in part."""
    ground_sample_distance: float = 0.0
    """The mosaic's pixel size, m."""
    reference: str = REFERENCES[0]
    """What the verdict was taken by."""

    @property
    def profile(self) -> SeamProfile | None:
        """What is kept along the seam; None without one, or where it can't be told."""
        return self.explanation.profile if self.explanation else None

    @property
    def loss(self) -> LossPicture | None:
        """The picture of where detail was lost; None where that can't be told."""
        return self.explanation.loss if self.explanation else None

    @property
    def band_width_m(self) -> float | None:
        """Full width of the band along the seam in which detail was lost."""
        return self.profile.band_width_px * self.ground_sample_distance if self.profile else None

    @property
    def causes(self) -> tuple[Cause, ...]:
        """All that were found, strongest first."""
        return self.explanation.causes if self.explanation else ()

    @property
    def explained(self) -> float | None:
        """Share of the window whose fine detail the given sources explain."""
        return self.explanation.explained if self.explanation else None

    @property
    def is_compared(self) -> bool:
        """Whether a source took part; what is known then is shown even where it is too little for a verdict."""
        return self.judgement.verdict is not Verdict.NOT_COMPARABLE or self.explanation is not None

    @property
    def with_composite(self) -> tuple[ClipResult, ...]:
        """The clips, last the sources' composite where there is one."""
        found = self.explanation
        return self.clips if found is None else (*self.clips, ClipResult(COMPOSITE, COMPOSITE, found.curves))

    @property
    def composite_pairs(self) -> tuple[PairResult, ...]:
        """The mosaic against the composite, band by band."""
        found = self.explanation
        if found is None:
            return ()
        resampled = any(pair.resampled for pair in self.pairs)
        return tuple(
            PairResult(COMPOSITE, name, ratios, found.similarity[name], 0.0, 0.0, resampled, found.changes[-1][name])
            for name, ratios in found.ratios.items()
        )

    @property
    def source_count(self) -> int:
        """How many sources took part, wholly or in part."""
        if self.explanation is None:
            return sum(clip.role == "source" for clip in self.clips)
        return len(self.explanation.changes) - 1  # the last is against the composite


def make_block(
    mosaic: Raster, sources: Iterable[RasterRef], indexed: Iterable[Source] = (), cells: Iterable[Cell] = ()
) -> tuple[Block, list[Message]]:
    """A mosaic with its sources, each once, and notices about those left out.

    ``sources`` are opened for their footprints; ``indexed`` ones come with theirs and are not. The mosaic
    itself among the sources is dropped.

    Raises SettingsError when no source is named at all.
    """
    kept, notices = gather_sources(sources, indexed, mosaic.wkt, mosaic.ref)
    return Block(mosaic, tuple(kept), tuple(cells)), notices


def window_request(block: Block, window_id: int, extent: Extent, settings: InspectionSettings) -> WindowRequest:
    """The request for a rectangle in the mosaic's reference system, snapped to the mosaic's pixels."""
    try:
        window = snap_window(block.mosaic.grid, extent, settings.levels)
    except WindowError as error:
        return WindowRequest(window_id, block.mosaic, (), None, settings, error.message)
    cells = cells_over(block.cells, block.mosaic.grid.window_extent(window))
    return WindowRequest(window_id, block.mosaic, block.sources_over(window), window, settings, cells=cells)


def inspect_window(request: WindowRequest) -> WindowResult:
    """Clip, decompose, compare, judge and explain one window.

    A raster that can't be compared is left out with a notice; a window that can't be measured is
    ``not_comparable`` with the reason. Neither raises.
    """
    if request.window is None:
        return not_comparable(request, request.reason)
    try:
        mosaic = _measured(request.mosaic.ref, request)
    except RasterError as error:
        return not_comparable(request, error.message)
    band = mosaic.clip.raster.judged_band
    sources, notices, not_covering = _comparable_sources(request, band)
    judged = [one for one in sources if not one.clip.resampled] or sources
    shown = [one for one in sources if one not in judged]
    notices += [messages.SOURCE_RESAMPLED(name=one.clip.raster.ref.name) for one in shown]
    whole = [one for one in judged if one.clip.valid is None]
    paper = judge(mosaic.curves[band], [one.curves[band] for one in whole], request.settings.max_ratio)
    refused = (*notices, *not_covering)
    if not judged and refused and mosaic.curves[band].variance > 0:
        why = refused[: imagery_limits.MAX_REASONS]
        paper = replace(paper, reason=messages.NO_SOURCE_COMPARABLE(why=why))
    clips = [
        _clip_result(one, role, request.settings)
        for one, role in ((mosaic, "mosaic"), *((source, "source") for source in sources if source.curves))
    ]
    has_no_detail = len(whole) == len(judged) and paper.verdict is Verdict.NOT_COMPARABLE
    if not judged or mosaic.curves[band].variance == 0 or has_no_detail:
        pairs = [pair for one in sources for pair in _pairs(mosaic, one, {})]
        return WindowResult(
            request.window_id, request.window, paper, paper.verdict, tuple(clips), tuple(pairs),
            notices=tuple(notices), ground_sample_distance=request.mosaic.ground_sample_distance,
            reference=request.settings.reference,
        )
    found = _explain(request, mosaic, judged)
    notices += [
        messages.SOURCE_IN_PART(name=one.clip.raster.ref.name, share=100 * (1 - one.clip.invalid_share))
        for one in judged
        if one.clip.valid is not None
    ]
    pairs = [pair for one, changes in zip(judged, found.changes) for pair in _pairs(mosaic, one, changes)]
    pairs += [pair for one in shown for pair in _pairs(mosaic, one, {})]
    judgement = _judged(paper, mosaic.curves[band], found, band, request)
    if Cause.MISSING_SOURCE in found.causes and judgement.reason is None:
        judgement = replace(judgement, reason=messages.VERDICT_OF_THE_REST(share=100 * (1 - found.explained)))
    if judged[0].clip.resampled and judgement.reason is None:
        judgement = replace(judgement, reason=messages.ALL_RESAMPLED())
    return WindowResult(
        request.window_id, request.window, judgement, paper.verdict, tuple(clips), tuple(pairs), found,
        tuple(notices), request.mosaic.ground_sample_distance, request.settings.reference,
    )


def _measured(ref: RasterRef, request: WindowRequest, partly: bool = False) -> MeasuredClip:
    assert request.window is not None
    clip = read_clip(OpenRaster(ref), request.mosaic, request.window, partly)
    if clip.valid is not None:
        return MeasuredClip(clip, {}, {})
    return MeasuredClip(clip, *measure_clip(clip, request.settings.wavelet, request.settings.levels))


def _clip_result(measured: MeasuredClip, role: str, settings: InspectionSettings) -> ClipResult:
    clip = measured.clip
    directions = measure_directions(clip, settings.wavelet, settings.levels) if settings.directions else {}
    return ClipResult(clip.raster.ref.name, role, measured.curves, directions)


def _comparable_sources(request: WindowRequest, band: str) -> tuple[list[MeasuredClip], list[Message], list[Message]]:
    """Sources that can be compared, why others can't, and which do not cover the window at all."""
    sources: list[MeasuredClip] = []
    notices: list[Message] = []
    not_covering: list[Message] = []
    for source in request.sources:
        try:
            one = _measured(source.ref, request, partly=True)
            _check_comparable(one, band)
        except NotCoveredError as error:
            not_covering.append(error.message.as_warning())
        except RasterError as error:
            notices.append(error.message.as_warning())
        else:
            sources.append(one)
    return sources, notices, not_covering


def _explain(request: WindowRequest, mosaic: MeasuredClip, sources: Sequence[MeasuredClip]) -> Explanation:
    labels = None
    if request.cells and request.window is not None:
        names = [one.clip.raster.ref.name for one in sources]
        known = cell_labels(request.cells, names, request.mosaic.grid, request.window)
        labels = known if (known != UNKNOWN).any() else None
    return explain(mosaic, sources, request.settings.wavelet, request.settings.levels, labels)


def _judged(
    paper: Judgement, mosaic: Curve, found: Explanation, band: str, request: WindowRequest
) -> Judgement:
    """The verdict by what the settings say; the ratios stay those against the sources."""
    settings = request.settings
    if settings.reference == SEAM:
        verdict, reason = judge_by_seam(
            found.profile, found.has_seam, found.sharpness, settings.min_kept, found.mixed_share, found.explained
        )
        return replace(paper, verdict=verdict, reason=reason)
    if settings.reference == COMPOSITE:
        # What the mosaic does not follow is cut at random, unless the cells say how.
        if found.cause is Cause.UNCLEAR and not request.cells:
            return replace(paper, verdict=Verdict.NOT_COMPARABLE, reason=messages.COMPOSITE_UNCLEAR())
        against = judge(mosaic, [found.curves[band]], settings.max_ratio)
        return replace(paper, verdict=against.verdict, reason=against.reason)
    return paper


def _pairs(mosaic: MeasuredClip, source: MeasuredClip, changes: Mapping[str, Change]) -> list[PairResult]:
    levels = len(next(iter(mosaic.curves.values())).detail)
    nothing = Ratios((None,) * levels, None)
    is_part = source.clip.valid is not None
    return [
        PairResult(
            source.clip.raster.ref.name,
            name,
            nothing if is_part else curve_ratios(mosaic.curves[name], source.curves[name]),
            None if is_part else correlation(mosaic.coarse[name], source.coarse[name]),
            source.clip.offset_x,
            source.clip.offset_y,
            source.clip.resampled,
            changes.get(name),
        )
        for name in (changes if is_part else source.curves)
        if name in mosaic.curves
    ]


def _check_comparable(source: MeasuredClip, band: str) -> None:
    raster = source.clip.raster
    if band not in measured_bands(raster.band_names):
        raise RasterError(messages.BANDS_DIFFER(name=raster.ref.name, band=band, bands=", ".join(raster.band_names)))
    if source.curves and source.curves[band].variance == 0:
        raise RasterError(messages.SOURCE_CONSTANT(name=raster.ref.name))


def not_comparable(request: WindowRequest, reason: Message | None) -> WindowResult:
    """The result of a window that could not be measured."""
    nothing = Ratios((None,) * request.settings.levels, None)
    judgement = Judgement(Verdict.NOT_COMPARABLE, nothing, reason)
    reference = request.settings.reference
    return WindowResult(request.window_id, request.window, judgement, judgement.verdict, reference=reference)
