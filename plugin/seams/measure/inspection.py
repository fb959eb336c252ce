"""One window: request -> result."""
from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

from ...imagery import limits as imagery_limits
from ...imagery.band_curves import Directions, correlation, measure_clip, measure_directions
from ...imagery.clips import read_clip
from ...imagery.errors import NotCoveredError, RasterError, SettingsError, WindowError
from ...imagery.grids import Extent, PixelWindow, snap_window
from ...imagery.message import Message
from ...imagery.open_raster import OpenRaster
from ...imagery.rasters import Raster, RasterRef
from ...imagery.wavelets import Curve, check_decomposition
from . import messages
from .causes import Cause
from .explanation import Change, Explanation, MeasuredClip, explain
from .seam_cells import UNKNOWN, Cell, cell_labels, cells_over
from .source_images import Source, gather_sources, sources_over
from .verdicts import Judgement, Ratios, Verdict, check_max_ratio, curve_ratios, judge
from .window_records import COMPOSITE, REFERENCES


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
    """What the verdict is taken against, one of ``REFERENCES``."""
    directions: bool = False
    """Whether the detail of the mosaic and the sources is told by direction too."""

    def check(self) -> None:
        """Raise SettingsError when a value is out of its range."""
        check_decomposition(self.wavelet, self.levels)
        check_max_ratio(self.max_ratio)
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
        """Those whose footprint covers the window, give or take the share of pixels that may be invalid."""
        grid = self.mosaic.grid
        return sources_over(self.sources, grid.window_extent(window), grid.pixel_width, grid.pixel_height)


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
    clips: tuple[ClipResult, ...] = ()
    """The mosaic first, then the sources that took part."""
    pairs: tuple[PairResult, ...] = ()
    explanation: Explanation | None = None
    """Why contrast was lost; None where nothing could be compared."""
    notices: tuple[Message, ...] = field(default=(), compare=False)
    """Why a source that could not be read or compared did not take part."""

    @property
    def is_compared(self) -> bool:
        """Whether a source took part."""
        return self.judgement.verdict is not Verdict.NOT_COMPARABLE

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
        """How many sources took part."""
        return sum(clip.role == "source" for clip in self.clips)


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
    judgement = judge(mosaic.curves[band], [one.curves[band] for one in sources], request.settings.max_ratio)
    refused = (*notices, *not_covering)
    if not sources and refused and mosaic.curves[band].variance > 0:
        why = refused[: imagery_limits.MAX_REASONS]
        judgement = Judgement(judgement.verdict, judgement.ratios, messages.NO_SOURCE_COMPARABLE(why=why))
    clips = [
        _clip_result(one, role, request.settings)
        for one, role in ((mosaic, "mosaic"), *((source, "source") for source in sources))
    ]
    if judgement.verdict is Verdict.NOT_COMPARABLE:
        pairs = [pair for one in sources for pair in _pairs(mosaic, one, {})]
        return WindowResult(
            request.window_id, request.window, judgement, tuple(clips), tuple(pairs), notices=tuple(notices)
        )
    found = _explain(request, mosaic, sources)
    pairs = [pair for one, changes in zip(sources, found.changes) for pair in _pairs(mosaic, one, changes)]
    if request.settings.reference == COMPOSITE:
        # What the mosaic does not follow is cut at random, unless the cells say how.
        unknown = found.cause is Cause.UNCLEAR and not request.cells
        judgement = _against_composite(judgement, mosaic.curves[band], found.curves[band], unknown, request.settings)
    return WindowResult(request.window_id, request.window, judgement, tuple(clips), tuple(pairs), found, tuple(notices))


def _measured(ref: RasterRef, request: WindowRequest) -> MeasuredClip:
    assert request.window is not None
    clip = read_clip(OpenRaster(ref), request.mosaic, request.window)
    return MeasuredClip(clip, *measure_clip(clip, request.settings.wavelet, request.settings.levels))


def _clip_result(measured: MeasuredClip, role: str, settings: InspectionSettings) -> ClipResult:
    clip = measured.clip
    directions = measure_directions(clip, settings.wavelet, settings.levels) if settings.directions else {}
    return ClipResult(clip.raster.ref.name, role, measured.curves, directions)


def _comparable_sources(request: WindowRequest, band: str) -> tuple[list[MeasuredClip], list[Message], list[Message]]:
    """Sources that can be compared, why others can't, and which do not cover the window."""
    sources: list[MeasuredClip] = []
    notices: list[Message] = []
    not_covering: list[Message] = []
    for source in request.sources:
        try:
            one = _measured(source.ref, request)
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


def _against_composite(
    judgement: Judgement, mosaic: Curve, composite: Curve, unknown: bool, settings: InspectionSettings
) -> Judgement:
    """The ratios stay those against the sources; only the verdict is taken against the composite."""
    if unknown:
        return replace(judgement, verdict=Verdict.NOT_COMPARABLE, reason=messages.COMPOSITE_UNCLEAR())
    against = judge(mosaic, [composite], settings.max_ratio)
    return replace(judgement, verdict=against.verdict, reason=against.reason)


def _pairs(mosaic: MeasuredClip, source: MeasuredClip, changes: Mapping[str, Change]) -> list[PairResult]:
    return [
        PairResult(
            source.clip.raster.ref.name,
            name,
            curve_ratios(mosaic.curves[name], curve),
            correlation(mosaic.coarse[name], source.coarse[name]),
            source.clip.offset_x,
            source.clip.offset_y,
            source.clip.resampled,
            changes.get(name),
        )
        for name, curve in source.curves.items()
        if name in mosaic.curves
    ]


def _check_comparable(source: MeasuredClip, band: str) -> None:
    raster = source.clip.raster
    if band not in source.curves:
        raise RasterError(messages.BANDS_DIFFER(name=raster.ref.name, band=band, bands=", ".join(raster.band_names)))
    if source.curves[band].variance == 0:
        raise RasterError(messages.SOURCE_CONSTANT(name=raster.ref.name))


def not_comparable(request: WindowRequest, reason: Message | None) -> WindowResult:
    """The result of a window that could not be measured."""
    nothing = Ratios((None,) * request.settings.levels, None)
    return WindowResult(request.window_id, request.window, Judgement(Verdict.NOT_COMPARABLE, nothing, reason))
